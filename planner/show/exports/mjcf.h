// Grasps as models of the simulator MuJoCo (docs/reference/exports.md).
#pragma once

#include <string>
#include <vector>

#include "planner/show/exports/export_grasp.h"
#include "planner/show/exports/hand_drives.h"
#include "planner/show/exports/mjcf_geoms.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {

struct MjcfOptions {
  bool obstacles = true;              // whether those of the scene are there
  std::vector<Clutch> clutches = {};  // of the hand (hand_drives)
  double time_step = 1e-3;            // s
  double contact_time = 2e-3;  // within which contacts push bodies apart, >= 2 time steps [s]
  // Speed that a drive has without a load where the robot file states none; damping makes it so.
  double slide_speed = 0.1;  // m/s
  double turn_speed = 2.0;   // rad/s
  // Within which a drive comes near that speed: its inertia, which no robot file states, is its
  // damping times this. Less than some time steps would spoil the contacts of fingers [s].
  double drive_time = 5e-3;
  // Inertia of joints without a drive of their own.
  double slide_inertia = 0.01;  // kg
  double turn_inertia = 1e-4;   // kg m^2
};

// "grasp_RANK.xml".
std::string mjcf_file_name(int rank);

// The grasp as one MJCF file without others beside it. The hand's base is a free body that a weld
// holds to a mocap body; links and joints have their names, and joints their values as in the
// grasp when the model is loaded. Coefficients of friction are those of the scene for every pair of
// bodies. Throws InputError where a number is not finite.
// Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html
std::string mjcf_text(const CompiledScene& scene, const MjcfShapes& shapes,
                      const ExportGrasp& grasp, const MjcfOptions& options = {});

}  // namespace prehend
