// A robot made ready to move in a world: its coordinates, its masses and its surfaces.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "sim/base/material.h"
#include "sim/motion/clutches.h"
#include "sim/scene/collision_body.h"
#include "sim/scene/surface_material.h"

namespace prehend {

class RobotDynamics;

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
  std::vector<SurfaceMaterials> surfaces = {};       // of each link; empty: as `materials`
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
// the farthest link, and what clutches_of() assumes.
RobotModel make_robot_model(Robot robot);

// The coordinates at given values of the degrees of freedom and joints, which differ from those of
// the degrees of freedom by what clutches have slipped. `joints` empty: none has.
Eigen::VectorXd coordinates_at(const RobotModel& model, const std::vector<double>& dofs,
                               const std::vector<double>& joints = {});

}  // namespace prehend
