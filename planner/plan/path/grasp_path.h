// Planning of the timed motion of a robot from its start posture to a grasp.
#pragma once

#include <optional>

#include "planner/plan/path/check_path.h"
#include "planner/plan/path/lift_object.h"
#include "planner/plan/path/plan_transfer.h"
#include "sim/base/settings.h"
#include "sim/motion/control/time_path.h"
#include "sim/motion/control/trajectory.h"
#include "sim/scene/reach/reach_options.h"
#include "sim/trial/trial.h"

namespace prehend {

struct Candidate;
struct CompiledScene;

struct GraspPathOptions {
  static constexpr AboutSettings kAbout{"GraspPathOptions", "The whole path of an arm to a grasp."};
  ReachOptions reach;
  TransferOptions transfer;
  TimePathOptions timing;
  // First comes the posture of the trial, where it has an arm_line, then other inverse kinematics
  // solutions, nearest to the start first.
  int alternatives = 3;
  PathCheckOptions check;
  LiftOptions lift;
};

template <SettingsOf<GraspPathOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [reach, transfer, timing, alternatives, check, lift] = options;
  visit({"reach", ""}, reach, "How the arm follows the hand's approach.");
  visit({"transfer", ""}, transfer, "The way to the pre-grasp.");
  visit({"timing", ""}, timing, "How the path is timed.");
  visit("alternatives", alternatives, kCountAbove0, "",
        "Postures of the arm at the pre-grasp that are tried.");
  visit("check", check, "The check of the finished path.");
  visit("lift", lift, "What comes after the grasp.");
}

// The path of a grasp, and whether the object is lifted at its end.
struct GraspPath {
  Trajectory motion;
  LiftEnd lift = LiftEnd::not_asked;
};

// Plans the timed motion of arm and hand from the scene's start posture to the grasp of a trial.
//
// Segments of the path: "preshape" (the hand takes its preshape while the arm rests; before or
// after the transfer, left out where the hand starts in it), "transfer" (from the start to the
// pre-grasp), "approach" (the hand moves straight to the grasp), "close", then as far as they were
// asked for and found "lift" (straight up) and "retreat" (back to the start posture, the hand
// closed), both with the object in the hand. Joints are those of the platform, in its order.
//
// All but the closing is proven free of collision (first_blocked), and the whole path is tested
// again by check_path. `context` is told how many of the alternatives were tried (Stage::paths). A
// path is one also where lift or retreat fail: GraspPath::lift says so. Returns nothing when no
// such path was found. The scene must have an arm, and the trial must be stable. Throws InputError
// for a degree of freedom that moves and has no velocity or acceleration limit, and Cancelled.
std::optional<GraspPath> plan_grasp_path(const CompiledScene& scene, const Candidate& candidate,
                                         const Trial& trial, const GraspPathOptions& options = {},
                                         const RunContext& context = {});

// A path, or what was in the way most often; no names where no posture of the arm was found.
struct GraspPathAttempt {
  std::optional<GraspPath> path;
  CollisionNames in_the_way;
};

// As plan_grasp_path, with the bodies of scene.arm prepared for check_path already, for several
// grasps.
GraspPathAttempt try_grasp_path(const CompiledScene& scene, const SecondCheck& bodies,
                                const Candidate& candidate, const Trial& trial,
                                const GraspPathOptions& options, const RunContext& context);

}  // namespace prehend
