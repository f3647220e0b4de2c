#include "sim/trial/trial.h"

#include <algorithm>

#include "sim/trial/approach.h"
#include "sim/trial/grasp_at.h"
#include "sim/trial/settle.h"

namespace prehend {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

class TrialRun {
 public:
  TrialRun(const CompiledScene& scene, const Candidate& candidate, const TrialOptions& options)
      : scene_(scene),
        options_(options),
        motion_{candidate.X_OH, candidate.approach_O, candidate.approach_distance} {
    const Robot& hand = scene.scene.hand;
    if (candidate.preshape >= 0) {
      start_.dofs = hand.hand->preshapes[index(candidate.preshape)].dofs;
      start_.self_clearance = scene.preshape_gaps[index(candidate.preshape)];
    } else {
      start_.dofs = candidate.dofs;
      start_.joints = candidate.joints;
    }
    start_joints_ = start_.joints.empty() ? joint_values(hand, start_.dofs) : start_.joints;
  }

  Trial run() {
    Trial trial;
    const ApproachResult reached = approach(scene_, start_joints_, motion_, options_);
    trial.X_OH = motion_.at(reached.travel);
    trial.travel = reached.travel;
    trial.dofs = start_.dofs;
    trial.joints = start_joints_;
    if (reached.end == ApproachEnd::starts_in_collision ||
        reached.end == ApproachEnd::touched_obstacle) {
      trial.outcome = reached.end == ApproachEnd::touched_obstacle ? Outcome::approach_blocked
                                                                   : Outcome::hand_blocked;
      trial.link = reached.link;
      trial.obstacle = reached.obstacle;
      return trial;
    }
    close_at(reached.travel, reached.object_clearance, trial);
    for (int back = 1; back <= options_.back_off_tries && trial.outcome != Outcome::stable;
         ++back) {
      const double retreat = back * options_.back_off_step;
      if (retreat > reached.travel) break;
      // Backing off changes every gap by at most the retreat.
      std::vector<double> clearance = reached.object_clearance;
      for (double& c : clearance) c = std::max(0.0, c - retreat);
      Trial again = trial;
      close_at(reached.travel - retreat, clearance, again);
      again.back_offs = back;
      if (again.outcome == Outcome::stable) trial = again;
    }
    return trial;
  }

 private:
  void close_at(double travel, const std::vector<double>& clearance, Trial& trial) {
    start_.X_OH = motion_.at(travel);
    start_.object_clearance = clearance;
    trial.travel = travel;
    grasp_at(scene_, start_, options_, trial);
    settle(scene_, options_, trial);
  }

  const CompiledScene& scene_;
  const TrialOptions& options_;
  ApproachMotion motion_;
  ClosingStart start_;
  std::vector<double> start_joints_;
};

}  // namespace

Trial run_trial(const CompiledScene& scene, const Candidate& candidate,
                const TrialOptions& options) {
  return TrialRun(scene, candidate, options).run();
}

}  // namespace prehend
