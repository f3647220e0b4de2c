// The timed motion of a robot from its start posture to a grasp.
#pragma once

#include <optional>

#include "planner/path/check_path.h"
#include "planner/path/plan_transfer.h"
#include "planner/path/time_path.h"
#include "planner/path/trajectory.h"
#include "sim/trial/trial.h"

namespace prehend {

struct GraspPathOptions {
  ReachOptions reach;
  TransferOptions transfer;
  TimePathOptions timing;
  // Postures of the pre-grasp that are tried (>= 1): the trial's own first, where it has an
  // arm_line, then the others, nearest to the start first.
  int alternatives = 3;
  PathCheckOptions check;  // of the finished path
};

template <SettingsOf<GraspPathOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [reach, transfer, timing, alternatives, check] = options;
  visit("", reach);
  visit("", transfer);
  visit("", timing);
  visit("alternatives", alternatives);
  visit("check", check);
}

// Segments of a path, in order: "preshape" (the hand opens, the arm at rest; left out where the
// hand starts so), "transfer" (from the start to the pre-grasp), "approach" (straight to the
// grasp), "close". Joints are those of the platform. Proven free of collision but for the closing
// hand and what it closes on, and checked again (check_path); nothing where there is no such way.
// The scene must have an arm, and the trial be stable. Throws InputError for a degree of freedom
// that moves and has no velocity or acceleration limit, and Cancelled.
std::optional<Trajectory> plan_grasp_path(const CompiledScene& scene, const Candidate& candidate,
                                          const Trial& trial, const GraspPathOptions& options = {},
                                          const RunContext& context = {});

}  // namespace prehend
