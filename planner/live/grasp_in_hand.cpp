#include "planner/live/grasp_in_hand.h"

#include <cmath>
#include <utility>

#include "planner/live/grasp_score.h"
#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/trial/close_and_score.h"

namespace prehend {
namespace {

// How far the hand is moved back at most [m].
constexpr double kTakenBack = 0.1;

MotionFrame frame_between(const MotionFrame& from, const MotionFrame& to, double share) {
  MotionFrame frame = from;
  frame.time += share * (to.time - from.time);
  frame.X_OH = StraightMotion(from.X_OH, to.X_OH).at(share);
  frame.X_OC = StraightMotion(from.X_OC, to.X_OC).at(share);
  for (std::size_t j = 0; j < frame.joints.size(); ++j) {
    frame.joints[j] += share * (to.joints[j] - from.joints[j]);
  }
  for (std::size_t j = 0; j < frame.arm_joints.size(); ++j) {
    frame.arm_joints[j] += share * (to.arm_joints[j] - from.arm_joints[j]);
  }
  return frame;
}

// The motion with more frames, so that none is later than kPlaybackStep after the one before.
GraspMotion divided(const GraspMotion& motion) {
  GraspMotion fine;
  fine.is_simulated = motion.is_simulated;
  std::vector<int> place;  // of each frame of `motion`
  for (std::size_t i = 0; i < motion.frames.size(); ++i) {
    if (i > 0) {
      const MotionFrame& before = motion.frames[i - 1];
      const double time = motion.frames[i].time - before.time;
      const int steps = static_cast<int>(std::ceil(time / kPlaybackStep - 1e-9));
      for (int s = 1; s < steps; ++s) {
        fine.frames.push_back(
            frame_between(before, motion.frames[i], static_cast<double>(s) / steps));
      }
    }
    place.push_back(static_cast<int>(fine.frames.size()));
    fine.frames.push_back(motion.frames[i]);
  }
  for (const TrajectorySegment& segment : motion.segments) {
    fine.segments.push_back(
        {segment.name, place[index(segment.first)], place[index(segment.last)]});
  }
  return fine;
}

// The first overlap of a free hand that moves so, in words; empty: none.
std::string overlap_on_the_way(const CompiledScene& scene, const GraspMotion& motion,
                               const RunContext& context) {
  for (const MotionFrame& frame : motion.frames) {
    context.cancellation.check();
    const Pose X_CH = frame.X_OC.inverse() * frame.X_OH;
    const std::vector<Overlap> overlaps = overlaps_of(scene, X_CH, frame.joints);
    if (overlaps.empty()) continue;
    return formatted("%s meets %s at %.2f s", overlaps.front().link.c_str(),
                     overlaps.front().by.c_str(), frame.time);
  }
  return "";
}

}  // namespace

std::vector<double> opened_dofs(const Robot& hand, std::vector<double> dofs) {
  for (std::size_t d = 0; d < dofs.size(); ++d) {
    if (hand.dofs[d].closing_velocity > 0.0) dofs[d] = hand.dofs[d].lower;
    if (hand.dofs[d].closing_velocity < 0.0) dofs[d] = hand.dofs[d].upper;
  }
  return dofs;
}

TriedGrasp grasp_taken_back(const CompiledScene& scene, const HandPosture& closed,
                            const std::optional<std::vector<double>>& opened,
                            const TrialOptions& options, const RunContext& context) {
  const Robot& hand = scene.scene.hand;
  HandPosture open = closed;
  open.dofs = opened ? *opened : opened_dofs(hand, closed.dofs);
  open.joints = joint_values(hand, open.dofs);
  open = move_to_contact(scene, closed, open, options, context).posture;
  HandPosture back = open;
  back.X_OH = closed.X_OH * translation(-kTakenBack * hand.hand->approach);
  const double distance = kTakenBack * move_to_contact(scene, open, back, options, context).share;

  TriedGrasp grasp;
  grasp.candidate.X_OH = closed.X_OH;
  grasp.candidate.approach_O = closed.X_OH.linear() * hand.hand->approach;
  grasp.candidate.approach_distance = distance;
  grasp.candidate.dofs = open.dofs;
  // Joints that follow from the degrees of freedom are left to them.
  if (open.joints != joint_values(hand, open.dofs)) grasp.candidate.joints = open.joints;
  grasp.trial.X_OH = closed.X_OH;
  grasp.trial.travel = distance;
  grasp.trial.dofs = closed.dofs;
  grasp.trial.joints = closed.joints;
  ScoringWorkspace workspace;
  score_contacts(scene, options, workspace, grasp.trial);
  return grasp;
}

GraspPlayback played_path(const CompiledScene& scene, const TriedGrasp& grasp,
                          const GraspPath& path) {
  GraspPlayback playback;
  playback.found = true;
  playback.lift = path.lift;
  playback.motion = divided(grasp_motion(scene, grasp.candidate, grasp.trial, &path.motion));
  return playback;
}

GraspPlayback play_grasp(const CompiledScene& scene, const TriedGrasp& grasp,
                         const GraspPathOptions& options, const RunContext& context) {
  GraspPlayback playback;
  if (!scene.arm) {
    playback.motion = divided(grasp_motion(scene, grasp.candidate, grasp.trial, nullptr));
    playback.problem = overlap_on_the_way(scene, playback.motion, context);
    playback.found = playback.problem.empty();
    return playback;
  }
  const auto path = plan_grasp_path(scene, grasp.candidate, grasp.trial, options, context);
  if (!path) {
    playback.problem = "no path from the start posture of the robot was found";
    return playback;
  }
  return played_path(scene, grasp, *path);
}

}  // namespace prehend
