#include <algorithm>
#include <string>
#include <vector>

#include "sim/base/index.h"
#include "sim/base/range.h"
#include "sim/robot/files/robot_file_parts.h"

namespace prehend {
namespace {

// Directions typed with few digits are still meant to be opposite [length of their sum].
constexpr double kOpposed = 1e-6;

// What one finger gives up the other must be able to take, so that the hand may shift between them.
bool can_center(const std::vector<const Joint*>& fingers) {
  if (fingers.size() != 2 || fingers[0]->parent != fingers[1]->parent) return false;
  Vector3 sum = Vector3::Zero();
  for (const Joint* joint : fingers) {
    if (joint->type != JointType::prismatic) return false;
    sum += joint->X_PJ.linear() * joint->axis;
  }
  return sum.norm() < kOpposed;
}

Coupling read_coupling(const JsonField& field, int dof, const Robot& robot) {
  const std::string name = field.text();
  if (name == "rigid") return Coupling::rigid;
  if (name == "breakaway") return Coupling::breakaway;
  if (name == "by_finger") return Coupling::by_finger;
  if (name != "self_centering") {
    field.fail("unknown coupling, known are rigid, breakaway, by_finger and self_centering");
  }
  std::vector<const Joint*> fingers;
  for (const Joint& joint : robot.joints) {
    if (joint.dof == dof) fingers.push_back(&joint);
  }
  if (!can_center(fingers)) {
    field.fail("needs two prismatic joints on one parent that slide in opposite directions");
  }
  return Coupling::self_centering;
}

}  // namespace

void read_motion(const JsonField& field, const FileUnits& units, int dof, Robot& robot) {
  DegreeOfFreedom& motion = robot.dofs[index(dof)];
  const double unit = value_unit(robot, index(dof), units);
  if (field.has("initial")) {
    const double value = field["initial"].number(kCoordinate, unit);
    if (!within_limits(motion, value)) {
      field["initial"].fail("outside the limits " + std::to_string(motion.lower) + " to " +
                            std::to_string(motion.upper) + " rad or m");
    }
    motion.initial = std::clamp(value, motion.lower, motion.upper);
  }
  const bool turns = std::any_of(robot.joints.begin(), robot.joints.end(), [&](const Joint& j) {
    return j.dof == dof && j.type == JointType::revolute;
  });
  const double rate = turns ? units.angular_velocity : units.length;
  if (field.has("closing_velocity")) {
    motion.closing_velocity = field["closing_velocity"].number(kVelocity, rate);
  }
  if (field.has("velocity")) motion.max_velocity = field["velocity"].number(kRateAbove0, rate);
  if (field.has("acceleration")) {
    motion.max_acceleration = field["acceleration"].number(kRateAbove0, rate);
  }
  if (field.has("coupling")) motion.coupling = read_coupling(field["coupling"], dof, robot);
  if (field.has("breakaway_effort")) {
    motion.breakaway_effort = field["breakaway_effort"].number(kEffortAbove0);
  }
  if (field.has("stiffness")) motion.stiffness = field["stiffness"].number(kGain);
  if (field.has("damping")) motion.damping = field["damping"].number(kGain);
}

}  // namespace prehend
