// Robots whose joints form a tree: random trees, and a hand whose finger branches twice.
#pragma once

#include <string>
#include <utility>

#include "sim/base/random.h"
#include "sim/robot/robot.h"
#include "sim/shape/basic_shapes.h"

namespace prehend::test {

// A robot of `count` joints, revolute or prismatic, about random axes. The parent of each is a
// random earlier joint or the base; each has its own chain, degree of freedom and link.
inline Robot random_tree(Random& random, int count) {
  Robot robot;
  robot.name = "tree";
  robot.links = {{"base", "metal", -1, make_box({0.1, 0.1, 0.1})}};
  for (int j = 0; j < count; ++j) {
    const std::string name = std::to_string(j);
    Joint joint{.name = "joint_" + name,
                .type = random.uniform() < 0.3 ? JointType::prismatic : JointType::revolute,
                .X_PJ = random.pose(0.2),
                .axis = random.direction(),
                .zero = random.uniform(-0.3, 0.3),
                .X_JA = random.pose(0.2)};
    const double reach = joint.type == JointType::prismatic ? 0.2 : 2.0;
    joint.lower = random.uniform(-reach, 0.5 * reach);
    joint.upper = random.uniform(joint.lower, reach);
    joint.dof = joint.chain = j;
    joint.parent = random.integer(-1, j - 1);
    robot.dofs.push_back({.name = "dof_" + name, .lower = joint.lower, .upper = joint.upper});
    robot.chains.push_back({.name = "chain_" + name, .first_joint = j, .joint_count = 1});
    robot.joints.push_back(std::move(joint));
    const TriangleMesh mesh = transformed(make_box({0.05, 0.02, 0.03}), random.pose(0.1));
    robot.links.push_back({"link_" + name, "plastic", j, mesh});
  }
  return robot;
}

// One value for each joint, uniform between its limits.
inline std::vector<double> random_posture(const Robot& robot, Random& random) {
  std::vector<double> joints;
  for (const Joint& joint : robot.joints)
    joints.push_back(random.uniform(joint.lower, joint.upper));
  return joints;
}

// A palm at x < 0 and a finger along x whose joints turn about z. At x = 50 mm it branches into
// `upper` (z = 20 mm) and `lower` (z = -20 mm), and `upper` again at x = 100 mm into `nail_a` and
// `nail_b`. Each joint has a degree of freedom of its own; all but those of the nails close.
inline Robot branching_hand() {
  struct Part {
    const char* name;
    int parent;
    Vector3 at;     // in the frame after the parent
    double length;  // m
    double height;  // m
    double velocity;
  };
  const Part parts[] = {{"stem", -1, {0.0, 0.0, 0.0}, 0.05, 0.02, 0.5},
                        {"upper", 0, {0.0, 0.0, 0.02}, 0.05, 0.02, 1.0},
                        {"lower", 0, {0.0, 0.0, -0.02}, 0.05, 0.02, 1.0},
                        {"nail_a", 1, {0.0, 0.0, 0.006}, 0.02, 0.006, 0.0},
                        {"nail_b", 1, {0.0, 0.0, -0.006}, 0.02, 0.006, 0.0}};
  Robot robot;
  robot.name = "branching";
  const TriangleMesh palm = transformed(make_box({0.03, 0.03, 0.03}), translation({-0.03, 0, 0}));
  robot.links = {{"palm", "plastic", -1, palm}};
  for (const Part& part : parts) {
    const int j = static_cast<int>(robot.joints.size());
    robot.joints.push_back({.name = part.name,
                            .X_PJ = translation(part.at),
                            .X_JA = translation({part.length, 0.0, 0.0}),
                            .upper = 1.5,
                            .dof = j,
                            .parent = part.parent,
                            .chain = j});
    robot.chains.push_back({.name = part.name, .first_joint = j, .joint_count = 1});
    robot.dofs.push_back({.name = part.name, .upper = 1.5, .closing_velocity = part.velocity});
    const TriangleMesh bar = transformed(make_box({part.length - 0.006, 0.01, part.height}),
                                         translation({-0.5 * part.length, 0.0, 0.0}));
    robot.links.push_back({part.name, "plastic", j, bar});
  }
  robot.hand = Hand{
      .approach = Vector3::UnitX(),
      .closing = Vector3::UnitY(),
      .preshapes = {{.name = "straight", .dofs = std::vector<double>(5, 0.0), .max_width = 0.05}}};
  return robot;
}

}  // namespace prehend::test
