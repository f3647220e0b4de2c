#include "sim/robot/files/graspit_joint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/range.h"
#include "sim/robot/denavit_hartenberg.h"
#include "sim/robot/files/graspit_expression.h"
#include "sim/robot/files/graspit_notes.h"
#include "sim/robot/files/graspit_transform.h"
#include "sim/robot/sound_robot.h"

namespace prehend {
namespace {

// Forces are written in 1e-6 N, torques in 1e-6 N mm.
constexpr double kGraspitForce = 1e-6;
constexpr double kGraspitTorque = 1e-9;

double unit_of_value(JointType type) {
  return type == JointType::revolute ? kGraspitAngle : kGraspitLength;
}

double unit_of_effort(JointType type) {
  return type == JointType::revolute ? kGraspitTorque : kGraspitForce;
}

JointType read_joint_type(const XmlElement& element) {
  const std::string type = element.text("type");
  if (type == "Revolute") return JointType::revolute;
  if (type == "Prismatic") return JointType::prismatic;
  element.fail("unknown type of joint, known are Revolute and Prismatic", type);
}

GraspitExpression read_expression(const XmlElement& element, int dofs) {
  const auto expression = graspit_expression(element.content());
  if (!expression) {
    element.fail("must be a number or dN*ratio+constant", element.content());
  }
  if (expression->dof && *expression->dof >= dofs) {
    element.fail("the robot has degrees of freedom d0 to d" + std::to_string(dofs - 1) + " only",
                 element.content());
  }
  return *expression;
}

double number_child(const XmlElement& parent, std::string_view tag, double otherwise) {
  const auto child = parent.child(tag);
  return child ? child->content_number() : otherwise;
}

double not_negative_child(const XmlElement& parent, std::string_view tag) {
  const double value = number_child(parent, tag, 0.0);
  if (value < 0.0) parent[tag].fail("must not be negative", parent[tag].content());
  return value;
}

void read_limits(const XmlElement& element, Joint& joint, std::vector<std::string>& notes) {
  const double unit = unit_of_value(joint.type);
  joint.lower = unit * element["minValue"].content_number();
  joint.upper = unit * element["maxValue"].content_number();
  if (joint.lower <= joint.upper) return;
  std::swap(joint.lower, joint.upper);
  notes.push_back(note_of(element["minValue"], "above maxValue, the two were exchanged"));
}

// The values of the degree of freedom at which all its joints are inside their limits.
void set_limits(const XmlElement& element, int d, Robot& robot) {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  for (const Joint& joint : robot.joints) {
    if (joint.dof != d) continue;
    const double from = joint.lower / joint.ratio;
    const double to = joint.upper / joint.ratio;
    lower = std::max(lower, std::min(from, to));
    upper = std::min(upper, std::max(from, to));
  }
  if (lower > upper) element.fail("no value keeps all its joints inside their limits");
  DegreeOfFreedom& dof = robot.dofs[index(d)];
  dof.lower = lower;
  dof.upper = upper;
  dof.initial = std::clamp(0.0, lower, upper);
}

// r: rigid, b: breakaway, c: compliant.
Coupling read_coupling(const XmlElement& element, const std::string& name,
                       std::vector<std::string>& notes) {
  const std::string type = element.text_or("type", "r");
  if (type == "r") return Coupling::rigid;
  if (type == "b") return Coupling::breakaway;
  if (type != "c") element.fail("unknown type, known are r, b and c", type);
  notes.push_back(note_of(element, name + " is compliant: its joints go on when one is stopped, "
                                          "springs are left out"));
  return Coupling::breakaway;
}

}  // namespace

Joint read_graspit_joint(const XmlElement& element, int dofs, std::vector<std::string>& notes) {
  Joint joint;
  joint.type = read_joint_type(element);
  const bool turns = joint.type == JointType::revolute;
  const GraspitExpression theta = read_expression(element["theta"], dofs);
  const GraspitExpression d = read_expression(element["d"], dofs);
  const GraspitExpression& driven = turns ? theta : d;
  const XmlElement driven_element = element[turns ? "theta" : "d"];
  const XmlElement fixed_element = element[turns ? "d" : "theta"];
  if (!driven.dof) driven_element.fail("no degree of freedom drives it", driven_element.content());
  if ((turns ? d : theta).dof) {
    fixed_element.fail("must be a number in a joint of this type", fixed_element.content());
  }
  if (!kRatioSize.contains(std::abs(driven.ratio))) {
    driven_element.fail("the size of its ratio " + kRatioSize.words(), driven_element.content());
  }
  joint.dof = *driven.dof;
  joint.ratio = driven.ratio;
  read_limits(element, joint, notes);
  const double friction = unit_of_effort(joint.type);
  joint.friction.coulomb = friction * not_negative_child(element, "CoulombFriction");
  // By rad/s, or by mm/s.
  joint.friction.viscous = (turns ? friction : friction / kGraspitLength) *
                           not_negative_child(element, "viscousFriction");
  constexpr std::array<std::string_view, 12> kKnown{"theta",
                                                    "d",
                                                    "a",
                                                    "alpha",
                                                    "minValue",
                                                    "maxValue",
                                                    "viscousFriction",
                                                    "CoulombFriction",
                                                    "restValue",
                                                    "restingValue",
                                                    "springStiffness",
                                                    "draggerScale"};
  note_unknown(element, kKnown, notes);
  return denavit_hartenberg(std::move(joint),
                            {.theta = kGraspitAngle * theta.constant,
                             .d = kGraspitLength * d.constant,
                             .a = kGraspitLength * element["a"].content_number(),
                             .alpha = kGraspitAngle * element["alpha"].content_number()});
}

void read_graspit_dof(const XmlElement& element, int d, Robot& robot) {
  DegreeOfFreedom& dof = robot.dofs[index(d)];
  dof.coupling = read_coupling(element, dof.name, robot.notes);
  const auto driven = [d](const Joint& joint) { return joint.dof == d; };
  const auto first = std::find_if(robot.joints.begin(), robot.joints.end(), driven);
  if (first == robot.joints.end()) element.fail("no joint is driven by " + dof.name);
  for (Joint& joint : robot.joints) {
    if (!driven(joint)) continue;
    if (joint.type != first->type) {
      element.fail(dof.name + " drives joints of two types, which have no unit in common");
    }
    joint.max_effort = unit_of_effort(joint.type) * not_negative_child(element, "maxEffort");
  }
  // Velocities are in rad/s, or in mm/s.
  dof.closing_velocity = (first->type == JointType::revolute ? 1.0 : kGraspitLength) *
                         number_child(element, "defaultVelocity", 0.0);
  set_limits(element, d, robot);
  constexpr std::array<std::string_view, 6> kKnown{"defaultVelocity", "maxEffort",      "Kp", "Kd",
                                                   "draggerScale",    "breakAwayTorque"};
  note_unknown(element, kKnown, robot.notes);
}

}  // namespace prehend
