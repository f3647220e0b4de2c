// A robot as other programs' formats describe it, links joined by joints, and what becomes of it:
// a Robot.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/robot/robot.h"

namespace prehend {

// A rigid body. A link without triangles is a frame only.
struct TreeLink {
  std::string name;
  std::string material = "plastic";
  TriangleMesh mesh = {};  // link frame [m]
  Inertial inertial = {};  // link frame; mass 0: not known
  std::string place = {};  // in the file, for messages: "line 12, <link>"
};

enum class TreeJointType { fixed, revolute, prismatic };

// value = ratio * (value of the other joint) + offset, and of a linkage Joint::across, a joint of
// the tree, and Joint::ahead.
struct Mimic {
  int joint = -1;
  double ratio = 1.0;
  double offset = 0.0;  // rad or m
  int across = -1;
  double ahead = 1.0;
};

// Joins a link L to its child link C: X_LC = X_LJ * motion(axis, value).
struct TreeJoint {
  std::string name;
  TreeJointType type = TreeJointType::fixed;
  int parent = -1;  // links
  int child = -1;
  Pose X_LJ = Pose::Identity();
  Vector3 axis = Vector3::UnitX();  // unit, in J
  double lower = 0.0;               // rad or m
  double upper = 0.0;
  double max_effort = 0.0;        // 0: not said, as for the next two
  double max_velocity = 0.0;      // rad/s or m/s
  double max_acceleration = 0.0;  // rad/s^2 or m/s^2
  JointFriction friction = {};
  JointSpring spring = {};
  std::optional<double> initial = {};  // inside the limits; empty: 0, or the limit nearest to it
  std::optional<Mimic> mimic = {};
  std::string place = {};  // in the file, for messages: "line 12, <joint>"
};

// The links and joints of a file. Every joint's links are there; all else that makes them a tree is
// checked by root_of and to_robot.
struct JointTree {
  std::string file;
  std::string name;
  std::vector<TreeLink> links = {};
  std::vector<TreeJoint> joints = {};
  std::vector<std::pair<int, int>> exempt_pairs = {};  // of links, never checked for collision
  std::vector<std::string> notes = {};                 // as in Robot
};

// Multiplies all lengths, those of sliding joints too, and moments of inertia by the square;
// masses, forces and torques stay.
void scale_lengths(JointTree& tree, double factor);

// The one link that is no joint's child. Throws InputError that names file and line: a link with
// two parents, two roots, a cycle.
int root_of(const JointTree& tree);

// The joint that carries each link, -1: the root; an index into joints.
std::vector<int> carriers_of(const JointTree& tree);

// The joints by which each link carries others, in the order of the file; indices into joints.
std::vector<std::vector<int>> joints_below(const JointTree& tree);

// Joint values as functions of those of joints that mimic none: for each joint the mimicked one at
// the end of its row of mimics (itself where there is none), ratio and offset. Throws InputError
// for joints that mimic each other in a circle, or one of another type.
std::vector<Mimic> resolved_mimics(const JointTree& tree);

// The robot: links that fixed joints hold together follow the same joint; a joint that mimics none
// is a degree of freedom, which also drives those that mimic it; paths without branches are chains,
// called after their last links. The base frame is that of the root link. Links without triangles
// are left out; where the base has none, a cube of 1 mm stands for it. Two opposed sliding fingers
// on one drive are taken as self-centering. What was assumed is in the notes.
// Throws InputError as the functions above, and for couplings that no value satisfies in a row of
// limits.
Robot to_robot(const JointTree& tree);

}  // namespace prehend
