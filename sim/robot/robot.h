// A robot as data: a tree of joints, degrees of freedom that drive them, links with geometry and
// mass.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/base/named_enum.h"
#include "sim/robot/inertial.h"
#include "sim/shape/triangle_mesh.h"
#include "sim/soft/pad_shape.h"

namespace prehend {

// A revolute joint turns about its axis [rad], a prismatic one slides along it [m].
enum class JointType { revolute, prismatic };

// Friction that opposes a joint's motion at the speed v: coulomb * sign(v) + viscous * v. 0: none
// or not known.
struct JointFriction {
  double coulomb = 0.0;  // >= 0 [N m, prismatic: N]
  double viscous = 0.0;  // >= 0 [N m s/rad, prismatic: N s/m]
};

// A spring that pulls a joint with stiffness * (rest - value).
struct JointSpring {
  double stiffness = 0.0;  // >= 0, 0: none [N m/rad, prismatic: N/m]
  double rest = 0.0;       // the joint's value at which it is relaxed, any [rad or m]
};

// One axis of motion. With the frames P (after the parent joint, or the robot's base), J (the joint
// frame, fixed in P) and A (after the joint):
//
//   X_PA = X_PJ * motion(axis, value + zero) * X_JA
//
// where motion turns about the axis (revolute) or slides along it (prismatic). URDF's joints have
// zero = 0 and X_JA = identity; denavit_hartenberg.h writes those of Denavit and Hartenberg.
struct Joint {
  std::string name;
  JointType type = JointType::revolute;
  Pose X_PJ = Pose::Identity();
  Vector3 axis = Vector3::UnitZ();  // unit, through the origin of J, in J
  // Added to the value. It could be a part of X_JA instead, but adding angles is more accurate than
  // multiplying rotations.
  double zero = 0.0;  // rad or m
  Pose X_JA = Pose::Identity();
  double lower = 0.0;  // limits of the joint's value, without zero [rad or m]
  double upper = 0.0;
  // What the driver of the real robot calls it ("panda_joint1"); empty: as `name`.
  std::string driver_name = {};
  int dof = 0;         // the degree of freedom that drives it
  double ratio = 1.0;  // value = ratio * dof + offset; 0 only with `across`
  double offset = 0.0;
  // Another joint of the same degree of freedom that its drive passes, by cables or gears which
  // begin before that joint or by the bars of a linkage; -1: none. For what contact or a clutch
  // makes that one fall behind, `ahead` times as much is added to this one.
  int across = -1;
  double ahead = 1.0;
  int parent = -1;          // the joint before it towards the base, -1: none; parents stand first
  int chain = 0;            // the chain that it is part of
  double max_effort = 0.0;  // largest torque or force of its drive, 0: not said [N m or N]
  JointFriction friction = {};
  JointSpring spring = {};
};

// The closed-form inverse kinematics that applies to a chain.
enum class ClosedForm {
  none,
  spherical_wrist,  // six revolute joints, elbow and spherical wrist (spherical_wrist.h)
  ur,               // six revolute joints, built like the arms of Universal Robots (ur_arm.h)
};

// A named path in the tree: joints first_joint .. first_joint + joint_count - 1 of the robot, each
// the parent of the next. The parent of its first joint is a joint of an earlier chain or, for a
// chain that begins at the base, none. Other robots are mounted on the ends of chains, and chains
// may have closed-form inverse kinematics; forward kinematics uses only the parents of joints.
struct Chain {
  std::string name;
  int first_joint = 0;
  int joint_count = 0;
  ClosedForm closed_form = ClosedForm::none;
};

// What the joints of one degree of freedom do when contact stops one of them.
enum class Coupling {
  rigid,           // all stop
  breakaway,       // the stopped joint stays, the others go on
  by_finger,       // all joints of the stopped finger stay, those of the other fingers go on
                   // (joint_course.h: what a finger is, and linkages that close further)
  self_centering,  // two opposed prismatic fingers on one body: the other goes on until it touches
                   // too, and the hand (or the object) gives way sideways until both values are
                   // equal again
};

// A motor or drive: one value that sets the values of one or more joints of the same type. Units
// are those of its joints: rad where they are revolute, m where prismatic.
struct DegreeOfFreedom {
  std::string name;
  double lower = 0.0;  // between the limits every driven joint is inside its own [rad or m]
  double upper = 0.0;
  double initial = 0.0;           // value that a file or program starts from [rad or m]
  double closing_velocity = 0.0;  // signed; 0: auto-grasp leaves it alone [rad/s or m/s]
  double max_velocity = 0.0;      // 0: not said [rad/s or m/s]
  double max_acceleration = 0.0;  // 0: not said [rad/s^2 or m/s^2]
  Coupling coupling = Coupling::rigid;
  // Of a breakaway or by_finger coupling: the torque or force of a joint (at a ratio of 1) from
  // which on its clutch slips; 0: not said [N m or N].
  double breakaway_effort = 0.0;
  // Gains of the PD controller that holds it (stated_gains.h), both >= 0; empty: not said.
  std::optional<double> stiffness = std::nullopt;  // N m/rad or N/m
  std::optional<double> damping = std::nullopt;    // N m s/rad or N s/m
};

// Whether a value is inside the limits of its degree of freedom, to 1e-9 rad or m: a limit itself
// counts as inside although limits and values come from different sums.
bool within_limits(const DegreeOfFreedom& dof, double value);

// A rigid body of the robot. Its mesh is given in the frame after `joint`, or in the base frame for
// joint -1.
struct Link {
  std::string name;
  std::string material;              // glass, metal, plastic, wood or rubber
  int joint = -1;                    // the joint that moves it, -1: it belongs to the base
  TriangleMesh mesh;                 // [m]
  Inertial inertial = {};            // in the link's frame; mass 0: not known
  std::optional<PadShape> pad = {};  // of its surface that gives way (sim/soft/pad.h)
  // What the description of the real robot calls the link that it is a part of
  // ("panda_leftfinger"); empty: as `name`.
  std::string driver_name = {};
};

// What a frame is there for.
enum class FrameRole {
  none,
  base,    // of a hand: the frame of its base as its maker publishes it
  flange,  // of an arm: where it carries a tool; of a hand: that frame of the arm that carries it
  tool,    // of a hand: the tool centre point
};

// The role's name in files.
constexpr auto enum_names(FrameRole /*of*/) {
  return std::to_array<std::string_view>({"none", "base", "flange", "tool"});
}

// A frame by the name that the real robot's driver gives it, without a body of its own.
struct RobotFrame {
  std::string name;
  FrameRole role = FrameRole::none;
  int joint = -1;                // as of a Link
  Pose X_AF = Pose::Identity();  // in the frame after the joint, or the base frame
};

// A named posture of a hand, with open fingers, from which it closes on objects.
struct Preshape {
  std::string name;
  std::vector<double> dofs;  // one value per degree of freedom of the hand [rad or m]
  double min_width = 0.0;    // sizes of object that it can grasp, along Hand::closing [m]
  double max_width = 0.0;
  double depth = 0.0;  // from Hand::origin along the approach axis to where the fingers meet [m]
};

// A way to close a hand other than all of it at once with its largest efforts: first some of it, or
// all gently, and at the end all of it with its largest efforts (closing.h).
struct ClosingStrategy {
  std::string name;
  std::vector<int> first =
      {};               // degrees of freedom that close before the others; none: all at once
  bool waits = false;   // what touches the object stays where it is until all else has come to it
  double effort = 1.0;  // until then, part of the largest efforts, above 0, at most 1
};

// A suction cup, relaxed. Its frame is the hand's base frame.
struct SuctionCup {
  int link = 0;                        // index of the link that is its body, on the base
  Vector3 position = Vector3::Zero();  // centre of the lip [m]
  Vector3 axis = Vector3::UnitZ();     // unit, out of the cup towards the object
  double radius = 0.0;                 // of the lip, > 0 [m]
  double lip_stiffness = 0.0;          // force to compress the whole lip along the axis, > 0 [N/m]
  double travel = 0.0;                 // by which lip and bellows give way along the axis [m]
  double pull = 0.0;                   // force of the vacuum on a sealed cup, > 0 [N]
  double strain = 0.1;                 // largest elongation of the lip that still seals, > 0
};

// What makes a robot a hand. Without preshapes the rest may be known nevertheless, and is derived
// before planning with the hand (sim/robot/hand/derive_hand.h).
struct Hand {
  // Direction in which the palm moves to the object: unit, base frame.
  Vector3 approach = Vector3::UnitZ();
  // Direction along which the fingers close: unit, base frame, orthogonal to `approach`. Zero where
  // it is not known, without preshapes.
  Vector3 closing = Vector3::UnitX();
  // The point of the palm that is aimed at the object, base frame [m].
  Vector3 origin = Vector3::Zero();
  std::vector<Preshape> preshapes;
  std::vector<ClosingStrategy> strategies = {};  // to be tried where closing all at once fails
  std::vector<SuctionCup> cups = {};  // a hand with cups holds by these alone; closing is any axis
};

// An arm, a hand, a mobile base, or several of them joined into one (platform.h).
struct Robot {
  std::string name;
  std::vector<Chain> chains;
  std::vector<Joint> joints;
  std::vector<DegreeOfFreedom> dofs;
  std::vector<Link> links;  // links[0] is the base link
  std::optional<Hand> hand;
  // Frames without bodies. One that has the name of a link is the frame of that link in the file
  // that the robot was read from.
  std::vector<RobotFrame> frames = {};
  // Links (indices, the lower one first) that are never checked for collision with each other,
  // besides those that share a joint or follow each other.
  std::vector<std::pair<int, int>> exempt_pairs = {};
  // What the reader of its file assumed, left out or repaired, for people: one line each.
  std::vector<std::string> notes = {};
};

// What the real robot's driver calls a joint or link.
const std::string& driver_name(const Joint& joint);
const std::string& driver_name(const Link& link);

// The first frame with that role; nullptr where there is none.
const RobotFrame* frame_with(const Robot& robot, FrameRole role);

// X_AL: the frame that the link had in the file from which the robot was read, in the frame after
// its joint; the identity where that is the same or not known, and for the first link.
Pose own_frame(const Robot& robot, std::size_t link);

// The initial value of every degree of freedom [rad or m].
std::vector<double> initial_dofs(const Robot& robot);

// Whether a degree of freedom moves joints along lines, and so is in m.
bool slides(const Robot& robot, std::size_t dof);

// The value of every joint, ratio * dof + offset, for one value per degree of freedom [rad or m].
std::vector<double> joint_values(const Robot& robot, const std::vector<double>& dofs);
// The same; `values` is resized to the number of joints.
void joint_values(const Robot& robot, const std::vector<double>& dofs, std::vector<double>& values);

// X_JA, the pose of the frame A after a joint in its joint frame J, at a joint value [rad or m]:
// motion(axis, value + zero) * joint.X_JA.
Pose across(const Joint& joint, double value);

// Forward kinematics: the poses of the frames after each joint in the robot's base frame B, for one
// value per joint [rad or m]. `X_BJ` is resized to the number of joints.
void joint_poses(const Robot& robot, const std::vector<double>& joints, std::vector<Pose>& X_BJ);

// As joint_poses, for the frames of all links; `X_BL` is resized to the number of links.
void link_poses(const Robot& robot, const std::vector<double>& joints, std::vector<Pose>& X_BL);

// Both at once. Passing the same one again saves allocations.
struct RobotPoses {
  std::vector<Pose> X_BJ;
  std::vector<Pose> X_BL;
};
void robot_poses(const Robot& robot, const std::vector<double>& joints, RobotPoses& poses);

// Joints from the base to `joint`, in that order; none for joint -1.
std::vector<int> joints_to(const Robot& robot, int joint);

// X_BL, as in link_poses, of the links that the last joint of `chain` (from joints_to) moves: of
// one link in less time than of all.
Pose link_pose(const Robot& robot, const std::vector<int>& chain,
               const std::vector<double>& joints);

// X_BJ, as in joint_poses, of one joint.
Pose joint_pose(const Robot& robot, int joint, const std::vector<double>& joints);

}  // namespace prehend
