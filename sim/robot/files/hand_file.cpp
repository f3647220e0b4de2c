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
  field.allow_only({"approach", "closing", "origin", "preshapes", "strategies"});
  Hand hand;
  hand.approach = field["approach"].direction();
  hand.origin = field["origin"].vector3(kCoordinate, units.length);
  hand.closing = Vector3::Zero();
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
