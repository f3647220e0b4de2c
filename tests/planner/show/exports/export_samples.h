// Grasps and a path to be exported.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "planner/show/exports/export_grasp.h"
#include "sim/base/random.h"

namespace prehend::test {

// Names that a careless writer would break: quotes, separators, words that YAML takes for
// something.
inline constexpr const char* kObject = "mug, \"large\": #1\nno";
inline constexpr const char* kBase = "~";

// No two frames of the hand are the same, nor are names of joints those of the driver.
inline ExportHeader sample_header() {
  Random random(77);
  ExportHeader header{.object = kObject,
                      .hand = "hand",
                      .hand_dofs = {"spread", "close"},
                      .hand_joints = {"1.0", "finger: a", "true"},
                      .driver_joints = {"2.0", "b: a", "no"}};
  header.end_effector = {.base = {kBase, random.pose(0.1)},
                         .parent = {"flange\n- a: 1", random.pose(0.1)},
                         .tool = HandFrame{"tcp", random.pose(0.1)}};
  return header;
}

inline Trajectory sample_path() {
  Trajectory path;
  path.joints = {"arm/1, 1", "hand/2"};
  path.times = {0.0, 0.02, 0.04, 1.999999999999, 3.0 + 1.0 / 3.0};
  path.positions = {{0.1, -0.2}, {1.0 / 3.0, 1e-7}, {0.5, 0.0}, {-2.0, 1e22}, {-2.5, 5e-324}};
  path.velocities = {{0.0, 0.0}, {0.7, -1.0 / 7.0}, {1e-9, 2.0}, {3.0, 4.0}, {0.0, -0.0}};
  path.segments = {{"transfer", 0, 2}, {"approach", 2, 4}, {"close", 4, 4}};
  return path;
}

// The object stands turned in the world, so that no frame can be taken for another.
struct Sample {
  Pose X_WO;
  ExportGrasp grasp;
};

inline Sample sample_grasp(std::uint64_t seed) {
  Random random(seed);
  Sample sample;
  sample.X_WO = random.pose(2.0);
  ExportGrasp& grasp = sample.grasp;
  grasp.rank = static_cast<int>(seed);
  grasp.outcome = "stable";
  grasp.epsilon = random.uniform(0.0, 0.5);
  grasp.volume = random.uniform(0.0, 1e-3);
  grasp.X_OH = random.pose(0.3);
  grasp.X_WH = sample.X_WO * grasp.X_OH;
  grasp.preshape = "wide, open";
  grasp.dofs = {random.uniform(-1.0, 1.0), 0.1};
  grasp.pregrasp_joints = {random.uniform(-1.0, 1.0), 2.0, 0.3};
  grasp.closed_joints = {random.uniform(-1.0, 1.0), 1e-9, -0.0};
  grasp.approach_O = random.direction();
  grasp.approach_distance = random.uniform(0.05, 0.2);
  return sample;
}

inline std::vector<ExportGrasp> sample_grasps() {
  std::vector<ExportGrasp> grasps;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) grasps.push_back(sample_grasp(seed).grasp);
  grasps[1].path = sample_path();
  return grasps;
}

}  // namespace prehend::test
