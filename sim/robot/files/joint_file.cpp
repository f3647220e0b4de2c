#include "sim/base/range.h"
#include "sim/robot/denavit_hartenberg.h"
#include "sim/robot/files/robot_file_parts.h"

namespace prehend {
namespace {

JointType read_type(const JsonField& field) {
  if (field.text() == "revolute") return JointType::revolute;
  if (field.text() == "prismatic") return JointType::prismatic;
  field.fail("unknown joint type, known are revolute and prismatic");
}

JointFriction read_friction(const JsonField& field) {
  field.allow_only({"coulomb", "viscous"});
  JointFriction friction;
  if (field.has("coulomb")) friction.coulomb = field["coulomb"].number(kEffort);
  if (field.has("viscous")) friction.viscous = field["viscous"].number(kGain);
  return friction;
}

double unit_of(JointType type, const FileUnits& units) {
  return type == JointType::revolute ? units.angle : units.length;
}

// As in URDF: the frame after the joint is the joint frame, moved about or along the axis.
void place_by_axis(const JsonField& field, const FileUnits& units, Joint& joint) {
  for (const char* key : {"theta", "d", "a", "alpha"}) {
    if (field.has(key)) {
      field[key].fail("a joint has theta, d, a and alpha, or an origin and an axis, not both");
    }
  }
  joint.axis = field["axis"].direction();
  if (field.has("origin")) joint.X_PJ = read_pose(field["origin"], units);
  if (field.has("zero")) joint.zero = field["zero"].number(kCoordinate, unit_of(joint.type, units));
  if (field.has("after")) joint.X_JA = read_pose(field["after"], units);
}

}  // namespace

JointSpring read_spring(const JsonField& field, JointType type, const FileUnits& units) {
  field.allow_only({"stiffness", "rest"});
  JointSpring spring;
  spring.stiffness = field["stiffness"].number(kGain);
  spring.rest = field.number_or("rest", 0.0, kCoordinate, unit_of(type, units));
  return spring;
}

Joint read_joint(const JsonField& field, const FileUnits& units) {
  field.allow_only({"name", "type", "theta", "d", "a", "alpha", "origin", "axis", "zero", "after",
                    "limits", "effort", "friction", "spring", "driver_name"});
  Joint joint{.name = field["name"].text(), .type = read_type(field["type"])};
  if (field.has("axis") || field.has("origin")) {
    place_by_axis(field, units, joint);
  } else {
    for (const char* key : {"zero", "after"}) {
      if (field.has(key)) field[key].fail("only beside an axis");
    }
    joint = denavit_hartenberg(joint, {.theta = field["theta"].number(kCoordinate, units.angle),
                                       .d = field["d"].number(kCoordinate, units.length),
                                       .a = field["a"].number(kCoordinate, units.length),
                                       .alpha = field["alpha"].number(kCoordinate, units.angle)});
  }
  const JsonField limits = field["limits"];
  const std::vector<double> range = limits.numbers(2, kCoordinate, unit_of(joint.type, units));
  if (range[0] > range[1]) limits.fail("the lower limit must be at most the upper one");
  joint.lower = range[0];
  joint.upper = range[1];
  if (field.has("effort")) joint.max_effort = field["effort"].number(kEffortAbove0);
  joint.driver_name = field.text_or("driver_name", "");
  if (field.has("friction")) joint.friction = read_friction(field["friction"]);
  if (field.has("spring")) joint.spring = read_spring(field["spring"], joint.type, units);
  return joint;
}

}  // namespace prehend
