#include "planner/plan/propose/approach_limit.h"

#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/range.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/candidate.h"
#include "sim/trial/trial.h"

namespace prehend {
namespace {

constexpr double kDegree = 0.017453292519943295;

// The first name of a direction is the one that is written.
const std::array<std::pair<std::string_view, Vector3>, 8>& named_directions() {
  static const std::array<std::pair<std::string_view, Vector3>, 8> names = {
      {{"down", Vector3(0.0, 0.0, -1.0)},
       {"up", Vector3::UnitZ()},
       {"+x", Vector3::UnitX()},
       {"-x", Vector3(-1.0, 0.0, 0.0)},
       {"+y", Vector3::UnitY()},
       {"-y", Vector3(0.0, -1.0, 0.0)},
       {"+z", Vector3::UnitZ()},
       {"-z", Vector3(0.0, 0.0, -1.0)}}};
  return names;
}

[[noreturn]] void refuse_approach(const char* problem, const std::string& words) {
  throw InputError({.problem = problem, .value = words});
}

// The number at the beginning of `rest`, which then begins behind it.
bool take_number(std::string_view& rest, double& number) {
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  return error == std::errc();
}

Vector3 direction_of(std::string_view text, const std::string& words) {
  constexpr const char* kProblem =
      "the direction must be down, up, +x, -x, +y, -y, +z, -z or three numbers such as 1,0,-1";
  for (const auto& [name, direction] : named_directions()) {
    if (text == name) return direction;
  }
  Vector3 direction;
  for (int k = 0; k < 3; ++k) {
    if (k > 0 && !text.starts_with(',')) refuse_approach(kProblem, words);
    if (k > 0) text.remove_prefix(1);
    if (!take_number(text, direction[k]) || !kCoordinate.contains(direction[k])) {
      refuse_approach(kProblem, words);
    }
  }
  if (!text.empty()) refuse_approach(kProblem, words);
  if (!(direction.norm() > kShortestApproach)) {
    refuse_approach("the direction must not be zero", words);
  }
  return direction;
}

double angle_of(std::string_view text, const std::string& words) {
  constexpr const char* kProblem = "the angle must be 0deg to 180deg, or in rad: 30deg, 0.5rad";
  double number = 0.0;
  if (!take_number(text, number)) refuse_approach(kProblem, words);
  if (text != "deg" && text != "rad") refuse_approach(kProblem, words);
  const double angle = text == "deg" ? number * kDegree : number;
  if (!kApproachAngle.contains(angle)) refuse_approach(kProblem, words);
  return angle;
}

}  // namespace

ApproachLimit approach_limit(const std::string& words) {
  ApproachLimit limit;
  std::string_view rest = words;
  if (const std::size_t colon = rest.find(':'); colon != std::string_view::npos) {
    const auto frame = value_named<ApproachFrame>(rest.substr(0, colon));
    if (!frame) refuse_approach("the frame before \":\" must be world or object", words);
    limit.frame = *frame;
    rest.remove_prefix(colon + 1);
  }
  const std::size_t slash = rest.find('/');
  limit.direction = direction_of(rest.substr(0, slash), words);
  if (slash != std::string_view::npos) limit.angle = angle_of(rest.substr(slash + 1), words);
  return limit;
}

std::string approach_text(const ApproachLimit& limit) {
  const Vector3& d = limit.direction;
  std::string text = formatted("%.6g,%.6g,%.6g", d.x(), d.y(), d.z());
  for (const auto& [name, direction] : named_directions()) {
    if (direction != d) continue;
    text = name;
    break;
  }
  const std::string frame = limit.frame == ApproachFrame::object ? "object:" : "";
  return frame + text + formatted("/%.6gdeg", limit.angle / kDegree);
}

bool allows(const ApproachLimit& limit, const CompiledScene& scene, const Vector3& approach_O) {
  // The cosine of a small angle is 1 less half its square: this allows for rounding up to 1e-6 rad.
  constexpr double kRounding = 1e-12;
  const Vector3 approach = limit.frame == ApproachFrame::object
                               ? approach_O
                               : Vector3(scene.scene.object.X_WO.linear() * approach_O);
  return approach.dot(limit.direction.normalized()) >= std::cos(limit.angle) - kRounding;
}

bool allows(const ApproachLimit& limit, const CompiledScene& scene, const Candidate& candidate,
            const Trial& trial) {
  const Vector3 pointing_O = hand_in_scene(trial).linear() * scene.scene.hand.hand->approach;
  return allows(limit, scene, candidate.approach_O) && allows(limit, scene, pointing_O);
}

}  // namespace prehend
