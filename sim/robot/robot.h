// A robot as data: joints in chains, degrees of freedom that drive them, links with geometry.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

enum class JointType { revolute, prismatic };

// Standard (distal) Denavit-Hartenberg: the frame after the joint in the frame before it is
// Rz(theta) Tz(d) Tx(a) Rx(alpha). The joint's value is added to theta (revolute) or d (prismatic).
// Source: Denavit and Hartenberg 1955; Paul 1981, section 2.8.
struct Joint {
  std::string name;
  JointType type = JointType::revolute;
  double theta = 0.0;  // rad
  double d = 0.0;      // m
  double a = 0.0;      // m
  double alpha = 0.0;  // rad
  double lower = 0.0;  // limits of the joint's value, without theta or d [rad or m]
  double upper = 0.0;
  int dof = 0;         // the degree of freedom that drives it
  double ratio = 1.0;  // value = ratio * dof + offset
  double offset = 0.0;
  int parent = -1;  // the joint before it towards the base, -1 for none
  int chain = 0;
};

// A closed-form solution of inverse kinematics that is known for a chain.
enum class ClosedForm {
  none,
  spherical_wrist,  // six revolute joints, elbow and spherical wrist (spherical_wrist.h)
};

// Joints first_joint .. first_joint + joint_count - 1 of the robot, base to tip.
struct Chain {
  std::string name;
  // The frame before the chain's first joint, in the frame after joint `parent`.
  Pose X_PC = Pose::Identity();
  int first_joint = 0;
  int joint_count = 0;
  int parent = -1;  // -1: the robot's base; chains stand after those that carry them
  ClosedForm closed_form = ClosedForm::none;
};

// How the joints of one degree of freedom part when one of them is stopped.
enum class Coupling {
  rigid,           // all stop
  breakaway,       // the stopped joint stays, the others go on
  self_centering,  // two opposed prismatic fingers: the other goes on until it touches too, and the
                   // hand (or the object) gives way sideways until both values are equal again
};

struct DegreeOfFreedom {
  std::string name;
  double lower = 0.0;  // where every driven joint is inside its limits
  double upper = 0.0;
  double initial = 0.0;
  double closing_velocity = 0.0;  // signed; 0: auto-grasp leaves it alone [rad/s or m/s]
  double max_velocity = 0.0;      // 0: not said [rad/s or m/s]
  double max_acceleration = 0.0;  // 0: not said [rad/s^2 or m/s^2]
  Coupling coupling = Coupling::rigid;
};

// A rigid piece. Its mesh is given in the frame after `joint`, or in the base frame for joint -1.
struct Link {
  std::string name;
  std::string material;
  int joint = -1;
  TriangleMesh mesh;
};

// A named opening of a hand from which grasps start.
struct Preshape {
  std::string name;
  std::vector<double> dofs;
  double min_width = 0.0;  // sizes of object that it can close on, across the fingers [m]
  double max_width = 0.0;
  double depth = 0.0;  // from the hand's origin along the approach axis to where fingers meet [m]
};

// What makes a robot a hand.
struct Hand {
  Vector3 approach = Vector3::UnitZ();  // unit, base frame: the palm moves this way to the object
  Vector3 closing = Vector3::UnitX();   // unit, orthogonal to approach: the fingers close along it
  Vector3 origin = Vector3::Zero();     // point of the palm that is aimed, base frame [m]
  std::vector<Preshape> preshapes;
};

struct Robot {
  std::string name;
  std::vector<Chain> chains;
  std::vector<Joint> joints;
  std::vector<DegreeOfFreedom> dofs;
  std::vector<Link> links;  // links[0] is the base link
  std::optional<Hand> hand;
};

// Joint values for degrees of freedom (one each): ratio * dof + offset.
std::vector<double> joint_values(const Robot& robot, const std::vector<double>& dofs);

// Poses of all links in the robot's base frame for joint values (one each); `X_BL` is resized.
void link_poses(const Robot& robot, const std::vector<double>& joints, std::vector<Pose>& X_BL);

// Joints from the base to `joint`, in that order; none for joint -1.
std::vector<int> joints_to(const Robot& robot, int joint);

// As link_poses, for the frames after each joint.
void joint_poses(const Robot& robot, const std::vector<double>& joints, std::vector<Pose>& X_BJ);

}  // namespace prehend
