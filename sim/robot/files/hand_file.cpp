#include <algorithm>
#include <cmath>

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
    values[d] = field[name].number() * value_unit(robot, d, units);
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
  const std::vector<double> range = width.numbers(2);
  if (range[0] < 0.0 || range[0] > range[1]) {
    width.fail("must be two numbers from 0, the lower one first");
  }
  preshape.min_width = range[0] * units.length;
  preshape.max_width = range[1] * units.length;
  const JsonField depth = field["depth"];
  if (depth.number() < 0.0) depth.fail("must not be negative");
  preshape.depth = depth.number() * units.length;
  return preshape;
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
  field.allow_only({"approach", "closing", "origin", "preshapes"});
  Hand hand;
  hand.approach = field["approach"].direction();
  hand.origin = field["origin"].vector3() * units.length;
  hand.closing = Vector3::Zero();
  if (!field.has("preshapes") && !field.has("closing")) return hand;
  const JsonField closing = field["closing"];
  hand.closing = closing.direction();
  if (std::abs(hand.closing.dot(hand.approach)) > kOrthogonal) {
    closing.fail("must be orthogonal to the approach axis");
  }
  if (!field.has("preshapes")) return hand;
  const JsonField preshapes = field["preshapes"];
  for (const JsonField& item : preshapes.items()) {
    Preshape preshape = read_preshape(item, units, robot);
    for (const Preshape& other : hand.preshapes) {
      if (other.name == preshape.name) item["name"].fail("name used twice");
    }
    hand.preshapes.push_back(std::move(preshape));
  }
  if (hand.preshapes.empty()) preshapes.fail("a hand needs at least one preshape");
  return hand;
}

}  // namespace prehend
