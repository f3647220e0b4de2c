#include "planner/bulk/design/vary_hand.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/base/range.h"
#include "sim/robot/hand/derive_hand.h"

namespace prehend {
namespace {

constexpr const char* kOption = "--vary";
constexpr const char* kForm =
    "must be PART.MEASURE=FROM:TO or PART.MEASURE=FROM:TO:COUNT, such as finger.length=0.8:1.2";
constexpr double kNoLine = 1e-4;  // a shorter way between two joints has no direction [m]

bool is_factor(HandMeasure measure) {
  return measure == HandMeasure::length || measure == HandMeasure::size;
}

[[noreturn]] void refuse(const std::string& problem, const std::string& value) {
  throw InputError({.field = kOption, .problem = problem, .value = value});
}

template <typename Number>
Number number_in(std::string_view text, const std::string& words) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) refuse(kForm, words);
  return value;
}

std::vector<std::string_view> parts_between(std::string_view text, char sign) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t at = text.find(sign);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

HandMeasure measure_in(std::string_view word, const std::string& words) {
  for (const HandMeasure measure : kAll<HandMeasure>) {
    if (name_of(measure) == word) return measure;
  }
  std::vector<std::string> known;
  for (const HandMeasure measure : kAll<HandMeasure>) known.emplace_back(name_of(measure));
  refuse("has no such measure; there is " + joined(known), words);
}

// A map of the frame after a joint that keeps one point and makes lengths along a line larger.
struct Stretch {
  Vector3 from_A = Vector3::Zero();
  Vector3 along_A = Vector3::UnitZ();  // unit
  double factor = 1.0;

  Vector3 operator()(const Vector3& p_A) const {
    return p_A + (factor - 1.0) * along_A.dot(p_A - from_A) * along_A;
  }
};

// The middle of what lies farthest from a point of the link's frame.
Vector3 far_end(const TriangleMesh& mesh, const Vector3& from) {
  double farthest = 0.0;
  for (const Vector3& p : mesh.vertices) farthest = std::max(farthest, (p - from).norm());
  Vector3 sum = Vector3::Zero();
  double count = 0.0;
  for (const Vector3& p : mesh.vertices) {
    if ((p - from).norm() < 0.9 * farthest) continue;
    sum += p;
    count += 1.0;
  }
  return count > 0.0 ? Vector3(sum / count) : from;
}

// Along the line from the link's joint to the joints that it carries, or to its end; nothing where
// the next joint's axis meets its own.
std::optional<Stretch> stretch_of(const Robot& robot, const Link& link, double factor) {
  const Vector3 from = robot.joints[index(link.joint)].X_JA.inverse().translation();
  Vector3 to = Vector3::Zero();
  double carried = 0.0;
  for (const Joint& joint : robot.joints) {
    if (joint.parent != link.joint) continue;
    to += joint.X_PJ.translation();
    carried += 1.0;
  }
  to = carried > 0.0 ? Vector3(to / carried) : far_end(link.mesh, from);
  const Vector3 way = to - from;
  if (way.norm() < kNoLine) return {};
  return Stretch{from, way.normalized(), factor};
}

void require_plain(const Robot& hand, const Link& link) {
  if (link.pad) refuse("the link has a pad, whose region would not fit any more", link.name);
  if (hand.hand && !hand.hand->cups.empty()) {
    refuse("the hand has suction cups, whose places would not fit any more", hand.name);
  }
}

void lengthen(Robot& robot, std::size_t l, double factor) {
  Link& link = robot.links[l];
  require_plain(robot, link);
  const std::optional<Stretch> stretch = stretch_of(robot, link, factor);
  if (!stretch) return;
  for (Vector3& p : link.mesh.vertices) p = (*stretch)(p);
  link.inertial = {};
  for (Joint& joint : robot.joints) {
    if (joint.parent == link.joint) {
      joint.X_PJ.translation() = (*stretch)(joint.X_PJ.translation());
    }
  }
  for (RobotFrame& frame : robot.frames) {
    if (frame.joint == link.joint) frame.X_AF.translation() = (*stretch)(frame.X_AF.translation());
  }
}

std::vector<std::size_t> links_called(const Robot& hand, const std::string& part) {
  std::vector<std::size_t> found;
  std::vector<std::string> known{"finger"};
  for (std::size_t l = 0; l < hand.links.size(); ++l) {
    const Link& link = hand.links[l];
    if (link.joint < 0) continue;
    known.push_back(link.name);
    if (part == "finger" || part == link.name) found.push_back(l);
  }
  if (found.empty()) refuse("no link that moves has this name; there is " + joined(known), part);
  return found;
}

void enlarge(Robot& robot, double factor) {
  for (Joint& joint : robot.joints) {
    joint.X_PJ.translation() *= factor;
    joint.X_JA.translation() *= factor;
    if (joint.type != JointType::prismatic) continue;
    for (double* length : {&joint.zero, &joint.lower, &joint.upper, &joint.offset})
      *length *= factor;
  }
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    if (!slides(robot, d)) continue;
    DegreeOfFreedom& dof = robot.dofs[d];
    for (double* length : {&dof.lower, &dof.upper, &dof.initial}) *length *= factor;
  }
  for (Link& link : robot.links) {
    require_plain(robot, link);
    for (Vector3& p : link.mesh.vertices) p *= factor;
    link.inertial = {};
  }
  for (RobotFrame& frame : robot.frames) frame.X_AF.translation() *= factor;
  if (robot.hand) robot.hand->origin *= factor;
}

void limit(Robot& robot, const HandVariation& variation, double value) {
  std::vector<std::string> known;
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    DegreeOfFreedom& dof = robot.dofs[d];
    known.push_back(dof.name);
    if (dof.name != variation.part) continue;
    (variation.measure == HandMeasure::lower ? dof.lower : dof.upper) = value;
    if (!(dof.lower < dof.upper)) refuse("the limits exclude each other", variation.name());
    dof.initial = std::clamp(dof.initial, dof.lower, dof.upper);
    for (Joint& joint : robot.joints) {
      if (index(joint.dof) != d) continue;
      const double there = joint.ratio * value + joint.offset;
      joint.lower = std::min(joint.lower, there);
      joint.upper = std::max(joint.upper, there);
    }
    return;
  }
  refuse("no degree of freedom has this name; there is " + joined(known), variation.part);
}

}  // namespace

std::string HandVariation::name() const { return part + "." + std::string(name_of(measure)); }

double HandVariation::value(int i) const {
  return i + 1 == count ? to : from + (to - from) * i / (count - 1);
}

HandVariation hand_variation(const std::string& words) {
  const std::size_t sign = words.find('=');
  const std::size_t point = words.rfind('.', sign);
  if (sign == std::string::npos || point == std::string::npos || point == 0) refuse(kForm, words);
  const std::string_view text = words;
  HandVariation variation{.part = words.substr(0, point)};
  variation.measure = measure_in(text.substr(point + 1, sign - point - 1), words);
  const std::vector<std::string_view> numbers = parts_between(text.substr(sign + 1), ':');
  if (numbers.size() < 2 || numbers.size() > 3) refuse(kForm, words);
  variation.from = number_in<double>(numbers[0], words);
  variation.to = number_in<double>(numbers[1], words);
  if (numbers.size() == 3) variation.count = number_in<int>(numbers[2], words);
  if (variation.count < 2 || variation.count > 100) refuse("takes 2 to 100 values", words);
  constexpr Range kFactor{.lower = 0.1, .upper = 10.0};
  constexpr Range kLimit{.lower = -100.0, .upper = 100.0};
  constexpr Range kCoefficient{.upper = 100.0};
  const Range& range = is_factor(variation.measure)                 ? kFactor
                       : variation.measure == HandMeasure::friction ? kCoefficient
                                                                    : kLimit;
  for (const double value : {variation.from, variation.to}) {
    if (!range.contains(value)) refuse(range.words(), words);
  }
  const bool of_hand =
      variation.measure == HandMeasure::size || variation.measure == HandMeasure::friction;
  if (of_hand && variation.part != "hand") refuse("size and friction are of the \"hand\"", words);
  return variation;
}

Robot with_measure(const Robot& hand, const HandVariation& variation, double value) {
  if (variation.measure == HandMeasure::friction) return hand;
  Robot changed = hand;
  switch (variation.measure) {
    case HandMeasure::length:
      for (const std::size_t l : links_called(hand, variation.part)) lengthen(changed, l, value);
      break;
    case HandMeasure::size:
      enlarge(changed, value);
      break;
    default:
      limit(changed, variation, value);
  }
  if (changed.hand) changed.hand->preshapes.clear();
  return with_hand(std::move(changed));
}

}  // namespace prehend
