// A grasp with all values that the export formats need, independent of any format.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planner/show/exports/end_effector.h"
#include "sim/base/pose.h"
#include "sim/motion/control/trajectory.h"
#include "sim/robot/robot.h"

namespace prehend {

// What all grasps of a file have in common.
struct ExportHeader {
  std::string object;
  std::string hand;
  std::vector<std::string> hand_dofs;
  std::vector<std::string> hand_joints;
  std::vector<std::string> driver_joints;  // hand_joints as the driver of the real hand calls them
  EndEffector end_effector;
};

// One grasp.
struct ExportGrasp {
  int rank = 1;         // 1 is the best
  std::string outcome;  // as in grasps.json: "stable", ...
  double epsilon = 0.0;
  double volume = 0.0;
  Pose X_OH = Pose::Identity();         // the hand's base in the object's frame
  Pose X_WH = Pose::Identity();         // and in the world's
  std::string preshape;                 // empty: none
  ClosingStrategy strategy;             // how the hand closes
  std::vector<double> dofs;             // of the closed hand, in the order of hand_dofs [rad or m]
  std::vector<double> pregrasp_joints;  // in the order of hand_joints [rad or m]
  std::vector<double> closed_joints;
  Vector3 approach_O = Vector3::UnitZ();  // unit, object frame: the hand came this way
  double approach_distance = 0.0;         // m
  std::optional<Trajectory> path;
};

// Throws InputError that names the grasp's rank when it has another number of dofs or joints than
// the header.
void check_sizes(const ExportHeader& header, const ExportGrasp& grasp);

// Throws InputError when a sample is not of the path's joints.
void check_sizes(const Trajectory& path);

}  // namespace prehend
