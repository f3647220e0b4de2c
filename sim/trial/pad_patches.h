// What the pads of a hand do in a grasp: where they bear, and how stiffly they hold the object.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sim/base/run_context.h"
#include "sim/soft/limit_surface.h"
#include "sim/trial/trial.h"
#include "sim/trial/trial_options.h"

namespace prehend {

struct CompiledScene;

// The patch of one pad.
struct PadPatchReport {
  LinkId link = {};
  int nodes = 0;          // that bear on the object
  double approach = 0.0;  // of the pad's base from where the pad first touches [m]
  LimitSurface surface;   // in the object's frame
};

struct HeldByPads {
  std::vector<PadPatchReport> patches;
  // Forces and torques about WrenchFrame::torque_origin by which the pads answer to small motions
  // of the object while everything sticks and the links stand still: 6 x 6 for [translation;
  // rotation] along the axes of O [N/m, N, N m].
  Eigen::Matrix<double, 6, 6> stiffness = Eigen::Matrix<double, 6, 6>::Zero();
  // Its smallest eigenvalue, with turns measured by how far they move what lies farthest from the
  // origin: the softest motion of the object [N/m]. 0: something moves freely.
  double softest = 0.0;
};

// Of the grasp in which the trial ended, where contacts are finite elements and a pad bears; else
// none. Throws as make_pad, and Cancelled.
std::optional<HeldByPads> held_by_pads(const CompiledScene& scene, const Trial& trial,
                                       const TrialOptions& options, const RunContext& context = {});

}  // namespace prehend
