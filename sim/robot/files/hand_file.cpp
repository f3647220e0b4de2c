#include <algorithm>
#include <cmath>

#include "sim/base/range.h"
#include "sim/robot/files/robot_file_parts.h"

namespace prehend {
namespace {

// Directions typed with few digits are still meant to be orthogonal.
constexpr double kOrthogonal = 1e-6;

std::size_t find_dof(const JsonField& field, const std::string& name, const Robot& robot) {
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    if (robot.dofs[d].name == name) return d;
  }
  field.fail("no degree of freedom is called " + name);
}

std::vector<double> read_dofs(const JsonField& field, const FileUnits& units, const Robot& robot) {
  std::vector<double> values = initial_dofs(robot);
  for (const std::string& name : field.keys()) {
    const std::size_t d = find_dof(field[name], name, robot);
    const DegreeOfFreedom& dof = robot.dofs[d];
    values[d] = field[name].number(kCoordinate, value_unit(robot, d, units));
    if (!within_limits(dof, values[d])) {
      field[name].fail("outside the degree of freedom's limits " + std::to_string(dof.lower) +
                       " to " + std::to_string(dof.upper) + " rad or m");
    }
    values[d] = std::clamp(values[d], dof.lower, dof.upper);
  }
  return values;
}

Preshape read_preshape(const JsonField& field, const FileUnits& units, const Robot& robot) {
  field.allow_only({"name", "dofs", "width", "depth"});
  Preshape preshape;
  preshape.name = field["name"].text();
  preshape.dofs = read_dofs(field["dofs"], units, robot);
  const JsonField width = field["width"];
  const std::vector<double> range = width.numbers(2, kDistance, units.length);
  if (range[0] > range[1]) width.fail("must be two numbers, the lower one first");
  preshape.min_width = range[0];
  preshape.max_width = range[1];
  preshape.depth = field["depth"].number(kDistance, units.length);
  return preshape;
}

ClosingStrategy read_strategy(const JsonField& field, const Robot& robot) {
  field.allow_only({"name", "first", "waits", "effort"});
  ClosingStrategy strategy;
  strategy.name = field["name"].text();
  if (field.has("first")) {
    for (const JsonField& item : field["first"].items()) {
      const std::size_t d = find_dof(item, item.text(), robot);
      if (robot.dofs[d].closing_velocity == 0.0) item.fail("has no closing velocity");
      strategy.first.push_back(static_cast<int>(d));
    }
  }
  if (field.has("waits")) strategy.waits = field["waits"].boolean();
  strategy.effort = field.number_or("effort", strategy.effort, kFractionAbove0);
  if (strategy.first.empty() && !strategy.waits && strategy.effort == 1.0) {
    field.fail("closes all at once, as every hand does: needs first, waits or effort");
  }
  return strategy;
}

// The cup's body, a link of the robot's base.
int read_cup_link(const JsonField& field, const Robot& robot) {
  const std::string name = field.text();
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    if (robot.links[l].name != name) continue;
    if (robot.links[l].joint >= 0) field.fail("moves: a cup is carried by a link of the base");
    return static_cast<int>(l);
  }
  field.fail("no link of this name");
}

SuctionCup read_cup(const JsonField& field, const FileUnits& units, const Robot& robot,
                    const Vector3& approach) {
  // Cups that look farther aside do not come to the object along the approach.
  constexpr double kFarthestAside = 0.5;  // cosine
  field.allow_only(
      {"link", "position", "axis", "radius", "lip_stiffness", "travel", "pull", "strain"});
  SuctionCup cup;
  cup.link = read_cup_link(field["link"], robot);
  cup.position = field["position"].vector3(kCoordinate, units.length);
  cup.axis = field.has("axis") ? field["axis"].direction() : approach;
  if (cup.axis.dot(approach) < kFarthestAside) {
    field["axis"].fail("must be within 60 degrees of the approach axis");
  }
  cup.radius = field["radius"].number(kLengthAbove0, units.length);
  cup.lip_stiffness = field["lip_stiffness"].number(kGainAbove0);
  cup.travel = field["travel"].number(kLengthAbove0, units.length);
  cup.pull = field["pull"].number(kEffortAbove0);
  cup.strain = field.number_or("strain", cup.strain, kFractionAbove0);
  return cup;
}

// A hand that holds by suction. It has one posture, in which it approaches, and closes along no
// axis: any will do.
void read_cups(const JsonField& field, const FileUnits& units, const Robot& robot, Hand& hand) {
  for (const char* other : {"closing", "preshapes", "strategies"}) {
    if (field.has(other)) field[other].fail("not of a hand with cups, which does not close");
  }
  double widest = 0.0;
  for (const JsonField& item : field["cups"].items()) {
    hand.cups.push_back(read_cup(item, units, robot, hand.approach));
    widest = std::max(widest, 2.0 * hand.cups.back().radius);
  }
  if (hand.cups.empty()) field["cups"].fail("needs at least one cup");
  hand.closing = any_orthogonal(hand.approach);
  hand.preshapes = {{.name = "suction", .dofs = initial_dofs(robot), .max_width = widest}};
}

// A list of what has names, no two of them the same.
template <typename T>
std::vector<T> read_named(const JsonField& list, auto read) {
  std::vector<T> named;
  for (const JsonField& item : list.items()) {
    T one = read(item);
    for (const T& other : named) {
      if (other.name == one.name) item["name"].fail("name used twice");
    }
    named.push_back(std::move(one));
  }
  return named;
}

}  // namespace

double value_unit(const Robot& robot, std::size_t dof, const FileUnits& units) {
  for (const Joint& joint : robot.joints) {
    if (joint.dof != static_cast<int>(dof)) continue;
    return joint.type == JointType::revolute ? units.angle : units.length;
  }
  return 1.0;
}

Hand read_hand(const JsonField& field, const FileUnits& units, const Robot& robot) {
  field.allow_only({"approach", "closing", "origin", "preshapes", "strategies", "cups"});
  Hand hand;
  hand.approach = field["approach"].direction();
  hand.origin = field["origin"].vector3(kCoordinate, units.length);
  hand.closing = Vector3::Zero();
  if (field.has("cups")) {
    read_cups(field, units, robot, hand);
    return hand;
  }
  if (field.has("strategies")) {
    hand.strategies = read_named<ClosingStrategy>(
        field["strategies"], [&](const JsonField& item) { return read_strategy(item, robot); });
  }
  if (!field.has("preshapes") && !field.has("closing")) return hand;
  const JsonField closing = field["closing"];
  hand.closing = closing.direction();
  if (std::abs(hand.closing.dot(hand.approach)) > kOrthogonal) {
    closing.fail("must be orthogonal to the approach axis");
  }
  if (!field.has("preshapes")) return hand;
  const JsonField preshapes = field["preshapes"];
  hand.preshapes = read_named<Preshape>(
      preshapes, [&](const JsonField& item) { return read_preshape(item, units, robot); });
  if (hand.preshapes.empty()) preshapes.fail("a hand needs at least one preshape");
  return hand;
}

}  // namespace prehend
