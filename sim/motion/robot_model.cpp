#include "sim/motion/robot_model.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/motion/robot_dynamics.h"
#include "sim/robot/link_pairs.h"

namespace prehend {
namespace {

// What is assumed of a robot that does not say it.

// Density of links whose mass is not known: solid plastic (sim/base/material.h) [kg/m^3].
constexpr double kDensity = 1050.0;
// Force at its farthest link with which a degree of freedom closes that states no effort [N].
constexpr double kTipForce = 15.0;
// Inertia of a drive with clutches, as a part of the inertia of its joints at value 0.
constexpr double kDriveInertia = 0.1;

Eigen::Index row(int i) { return static_cast<Eigen::Index>(i); }

// Whether joint j moves what follows joint `of`.
bool moves(const Robot& robot, int j, int of) {
  while (of > j) of = robot.joints[index(of)].parent;
  return of == j;
}

// Most that a degree of freedom moves any point of its links per unit, at its initial posture [m],
// or 1 for those that slide.
double farthest_reach(const Robot& robot, int dof) {
  std::vector<Pose> X_BJ;
  joint_poses(robot, joint_values(robot, initial_dofs(robot)), X_BJ);
  double farthest = 0.0;
  for (int j = 0; j < static_cast<int>(robot.joints.size()); ++j) {
    const Joint& joint = robot.joints[index(j)];
    if (joint.dof != dof) continue;
    if (joint.type == JointType::prismatic) return std::abs(joint.ratio);
    const Vector3 center = X_BJ[index(j)] * (joint.X_JA.inverse() * Vector3::Zero());
    for (const Link& link : robot.links) {
      if (!moves(robot, j, link.joint)) continue;
      for (const Vector3& p : link.mesh.vertices) {
        const double distance = (X_BJ[index(link.joint)] * p - center).norm();
        farthest = std::max(farthest, std::abs(joint.ratio) * distance);
      }
    }
  }
  return farthest;
}

Eigen::VectorXd efforts_of(const Robot& robot) {
  Eigen::VectorXd efforts = stated_efforts(robot);
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    double& effort = efforts[row(static_cast<int>(d))];
    if (effort == 0.0) effort = kTipForce * farthest_reach(robot, static_cast<int>(d));
  }
  return efforts;
}

void complete_inertials(Robot& robot) {
  for (Link& link : robot.links) {
    if (link.mesh.empty()) throw InputError({robot.name, "link " + link.name, "has no triangles"});
    if (link.inertial.mass == 0.0) link.inertial = inertial_of_density(link.mesh, kDensity);
    const std::string defect = inertia_defect(link.inertial.inertia);
    if (link.joint >= 0 && !defect.empty()) {
      throw InputError({robot.name, "link " + link.name, defect});
    }
  }
}

void set_coordinates(RobotModel& model) {
  const Robot& robot = model.robot;
  const auto dofs = static_cast<Eigen::Index>(robot.dofs.size());
  const auto joints = static_cast<Eigen::Index>(robot.joints.size());
  const auto count = dofs + static_cast<Eigen::Index>(model.clutches.size());
  model.joints_of = Eigen::MatrixXd::Zero(joints, count);
  model.joints_of.leftCols(dofs) = coupling_matrix(robot);
  model.offset.resize(joints);
  for (Eigen::Index j = 0; j < joints; ++j) model.offset[j] = robot.joints[index(int(j))].offset;
  for (std::size_t c = 0; c < model.clutches.size(); ++c) {
    model.joints_of.col(dofs + static_cast<Eigen::Index>(c)) =
        joints_of_slip(robot, model.clutches[c]);
  }
}

bool has_clutch(const RobotModel& model, int joint) {
  return std::any_of(model.clutches.begin(), model.clutches.end(), [&](const Clutch& clutch) {
    return std::find(clutch.joints.begin(), clutch.joints.end(), joint) != clutch.joints.end();
  });
}

// Only drives with clutches need an inertia of their own: where all their clutches slip, nothing
// else would have to be accelerated.
void set_drive_inertias(RobotModel& model) {
  model.drive_inertia = Eigen::VectorXd::Zero(model.coordinates());
  const Eigen::MatrixXd mass =
      model.joints_of.transpose() * model.dynamics->mass_matrix(model.offset) * model.joints_of;
  for (const Clutch& clutch : model.clutches) {
    model.drive_inertia[clutch.dof] = kDriveInertia * mass(clutch.dof, clutch.dof);
  }
}

}  // namespace

RobotModel make_robot_model(Robot robot) {
  complete_inertials(robot);
  auto dynamics = std::make_shared<const RobotDynamics>(robot);
  RobotModel model{.robot = std::move(robot), .dynamics = std::move(dynamics)};
  for (const Link& link : model.robot.links) {
    model.shapes.push_back(make_collision_body(link.name, link.mesh, true));
    model.materials.push_back(material_named(link.material));
  }
  model.self_pairs = checked_pairs(model.robot);
  model.effort = efforts_of(model.robot);
  model.clutches = clutches_of(model.robot, model.effort);
  set_coordinates(model);
  set_drive_inertias(model);
  return model;
}

Eigen::VectorXd coordinates_at(const RobotModel& model, const std::vector<double>& dofs,
                               const std::vector<double>& joints) {
  assert(dofs.size() == model.robot.dofs.size());
  Eigen::VectorXd values = Eigen::VectorXd::Zero(model.coordinates());
  for (std::size_t d = 0; d < dofs.size(); ++d) values[row(static_cast<int>(d))] = dofs[d];
  if (joints.empty()) return values;
  // A degree of freedom follows its joints without a clutch, and clutches make up for the rest.
  const Eigen::Map<const Eigen::VectorXd> q(joints.data(), row(static_cast<int>(joints.size())));
  values = model.joints_of.colPivHouseholderQr().solve(q - model.offset);
  for (std::size_t d = 0; d < dofs.size(); ++d) {
    const Eigen::Index column = row(static_cast<int>(d));
    const bool all_slip =
        std::all_of(model.robot.joints.begin(), model.robot.joints.end(), [&](const Joint& joint) {
          return joint.dof != static_cast<int>(d) ||
                 has_clutch(model, static_cast<int>(&joint - model.robot.joints.data()));
        });
    if (!all_slip) continue;
    // Every joint has a clutch: the drive stands where it is said to be.
    const double change = dofs[d] - values[column];
    values[column] = dofs[d];
    for (std::size_t c = 0; c < model.clutches.size(); ++c) {
      if (model.clutches[c].dof != static_cast<int>(d)) continue;
      values[model.dofs() + row(static_cast<int>(c))] -= change;
    }
  }
  return values;
}

}  // namespace prehend
