// A robot made ready to move in a world: its coordinates, its masses and its surfaces.
#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "sim/base/material.h"
#include "sim/motion/robot_dynamics.h"
#include "sim/robot/robot.h"
#include "sim/scene/collision_body.h"

namespace prehend {

// A clutch between a degree of freedom and some of its joints (all of one finger, or a single
// joint): they may slip against their drive where the clutch bears no more.
struct Clutch {
  int dof = 0;
  std::vector<int> joints;
  double effort = 0.0;  // up to which it holds, in units of the degree of freedom [N m or N]
  // Direction of the joints that close (1 or -1) where a gear behind the clutch keeps them from
  // being pushed back unless their drive opens, as the worm gears of breakaway fingers do; else 0.
  double locks = 0.0;
};

// What is assumed of a robot that does not say it.
struct RobotModelOptions {
  // Density of links whose mass is not known: solid plastic (material.h) [kg/m^3].
  double density = 1050.0;
  // Force at its farthest link with which a degree of freedom closes that states no effort [N].
  double tip_force = 15.0;
  // Part of the effort of a degree of freedom that each breakaway clutch bears that does not say:
  // as in the Barrett hand, 0.5 of 2.5 N m. Fingers that share a drive share its effort evenly.
  double clutch_part = 0.2;
  // Inertia of a drive with clutches, as a part of the inertia of its joints at value 0.
  double drive_inertia = 0.1;
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
  RobotDynamics dynamics;
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
RobotModel make_robot_model(Robot robot, const RobotModelOptions& options = {});

// The coordinates at given values of the degrees of freedom and joints, which differ from those of
// the degrees of freedom by what clutches have slipped. `joints` empty: none has.
Eigen::VectorXd coordinates_at(const RobotModel& model, const std::vector<double>& dofs,
                               const std::vector<double>& joints = {});

}  // namespace prehend
