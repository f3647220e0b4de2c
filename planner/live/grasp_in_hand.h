// The grasp that a hand holds: how it may have come there, and how that is played back.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planner/live/hand_posture.h"
#include "planner/plan/path/grasp_motion.h"
#include "planner/plan/path/grasp_path.h"
#include "planner/plan/refine_grasps.h"

namespace prehend {

// The grasp of a closed hand as what was tried and its trial. The hand is opened where it is and
// moved back against its approach direction, both until it touches something (move_to_contact):
// that is where the candidate starts. `opened`: degrees of freedom to open to; without them, each
// one that closes opens to its limit. Throws Cancelled.
TriedGrasp grasp_taken_back(const CompiledScene& scene, const HandPosture& closed,
                            const std::optional<std::vector<double>>& opened,
                            const TrialOptions& options, const RunContext& context = {});

// Degrees of freedom with each one that closes at its other limit, the others as in `dofs`.
std::vector<double> opened_dofs(const Robot& hand, std::vector<double> dofs);

// How the robot comes to a grasp, for players.
struct GraspPlayback {
  bool found = false;
  std::string problem;  // why there is none; empty where there is
  GraspMotion motion;   // frames at most kPlaybackStep apart
  LiftEnd lift = LiftEnd::not_asked;
};

inline constexpr double kPlaybackStep = 0.05;  // s

// That of a path to the grasp, which was planned for it (plan_grasp_path).
GraspPlayback played_path(const CompiledScene& scene, const TriedGrasp& grasp,
                          const GraspPath& path);

// With an arm a path from its start posture (plan_grasp_path). A free hand goes straight from the
// pre-grasp to the grasp and closes (grasp_motion); that it overlaps nothing is tested at each
// frame. Tells `context` of its progress as plan_grasp_path does. Throws InputError as
// plan_grasp_path, and Cancelled.
GraspPlayback play_grasp(const CompiledScene& scene, const TriedGrasp& grasp,
                         const GraspPathOptions& options, const RunContext& context = {});

}  // namespace prehend
