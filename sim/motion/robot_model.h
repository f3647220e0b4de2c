// A robot made ready to move in a world: its coordinates, its masses and its surfaces.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "sim/base/material.h"
#include "sim/robot/robot.h"
#include "sim/scene/collision_body.h"

namespace prehend {

class RobotDynamics;

// A clutch between a degree of freedom and some of its joints (all of one finger, or a single
// joint): they may slip against their drive where the clutch bears no more.
struct Clutch {
  int dof = 0;
  std::vector<int> joints;
  double effort = 0.0;  // up to which it holds, in units of the degree of freedom [N m or N]
  // Direction of the joints that close (1 or -1) where a gear behind the clutch keeps them from
  // being pushed back unless their drive opens, as the worm gears of breakaway fingers do; else 0.
  double locks = 0.0;
  // What the gear bears besides the clutch, of the first joint, and how it gives way: without that,
  // gear and contact could press on each other with any force [N m or N, N m/rad or N/m].
  double gear_effort = 0.0;
  double gear_stiffness = 0.0;
};

// Immutable once made, so that worlds and their copies share it.
//
// Its coordinates are the values of the degrees of freedom, followed by the slips of the clutches:
//
//   joint values = joints_of * coordinates + offset
//
// so that coupled joints follow each other exactly, without a force that could drift.
struct RobotModel {
  Robot robot;
  std::shared_ptr<const RobotDynamics> dynamics;     // not null
  std::vector<CollisionBody> shapes = {};            // of each link
  std::vector<Material> materials = {};              // of each link
  std::vector<std::pair<int, int>> self_pairs = {};  // links that may collide
  std::vector<Clutch> clutches = {};
  Eigen::MatrixXd joints_of = {};      // joints x coordinates
  Eigen::VectorXd offset = {};         // joints
  Eigen::VectorXd drive_inertia = {};  // coordinates: added to the diagonal of the mass matrix
  Eigen::VectorXd effort = {};         // the largest of each degree of freedom [N m or N]

  Eigen::Index dofs() const { return effort.size(); }
  Eigen::Index coordinates() const { return joints_of.cols(); }
};

// Throws InputError that names the joint or link for a robot that is no tree, has a joint that
// moves no mass, an unknown material, a link without triangles or with an inertia that no body has.
// What the robot does not say is assumed: links of solid plastic, drives that press with 15 N at
// the farthest link, breakaway clutches that bear a fifth of their drive's effort, and gears behind
// them with which a finger holds a third more than its drive presses.
RobotModel make_robot_model(Robot robot);

// The coordinates at given values of the degrees of freedom and joints, which differ from those of
// the degrees of freedom by what clutches have slipped. `joints` empty: none has.
Eigen::VectorXd coordinates_at(const RobotModel& model, const std::vector<double>& dofs,
                               const std::vector<double>& joints = {});

}  // namespace prehend
