#include "benchmarks/suite/trial_stages.h"

#include <algorithm>
#include <numeric>

#include "benchmarks/support/resources.h"
#include "sim/trial/approach.h"
#include "sim/trial/close_and_score.h"
#include "sim/trial/self_centering.h"
#include "sim/trial/settle.h"

namespace prehend::bench {
namespace {

// The stages of one closing.
struct ClosingSeconds {
  double closing = 0.0;
  double settling = 0.0;
  double contacts = 0.0;
  double quality = 0.0;
};

// Processor seconds of a call, added to `sum`.
template <typename Call>
void timed(double& sum, const Call& call) {
  sum += 1e-3 * benchmark::processor_milliseconds(call);
}

void close_once(const CompiledScene& scene, const ClosingStart& start, const TrialOptions& options,
                ClosingSeconds& seconds) {
  Pose X_OH = start.X_OH;
  ClosedHand closed;
  timed(seconds.closing, [&] {
    closed = close_hand(scene, start, options);
    center_hand(scene, X_OH, closed);
  });
  std::vector<GraspContact> contacts;
  timed(seconds.contacts, [&] { contacts = grasp_contacts(scene, X_OH, closed.joints, options); });
  if (contacts.empty()) return;
  timed(seconds.quality, [&] {
    (void)epsilon_l1(
        contact_wrenches(contacts_of(contacts), scene.wrench_frame, options.cone_edges));
  });
  Trial trial;
  GraspWorkspace grasping;
  SettleWorkspace settling;
  close_and_score(scene, start, options, grasping, trial);
  timed(seconds.settling, [&] { settle(scene, options, settling, grasping, trial); });
}

// Every closing that the trial made: one where the approach ended, and one for each time that it
// backed off.
ClosingSeconds close_again(const CompiledScene& scene, const Candidate& candidate,
                           const Trial& trial, const TrialOptions& options) {
  const Robot& hand = scene.scene.hand;
  ClosingStart start;
  std::vector<double> joints = candidate.joints;
  if (candidate.preshape) {
    start.dofs = hand.hand->preshapes[index(*candidate.preshape)].dofs;
    start.self_clearance = scene.preshape_gaps[index(*candidate.preshape)];
  } else {
    start.dofs = candidate.dofs;
    start.joints = candidate.joints;
  }
  if (joints.empty()) joints = joint_values(hand, start.dofs);
  const ApproachMotion motion{candidate.X_OH, candidate.approach_O, candidate.approach_distance};
  const ApproachResult reached = approach(scene, joints, motion, options);
  const bool stopped = reached.end == ApproachEnd::touched_obstacle;
  const double foremost = reached.travel - (stopped ? options.obstacle_clearance : 0.0);
  const int backs = trial.outcome == Outcome::stable ? trial.back_offs : options.back_off_tries;
  ClosingSeconds seconds;
  for (int back = 0; back <= backs; ++back) {
    const double travel = foremost - back * options.back_off_step;
    if (travel < 0.0) break;
    start.X_OH = motion.at(travel);
    start.object_clearance = reached.object_clearance;
    for (double& clearance : start.object_clearance) {
      clearance = std::max(0.0, clearance - (reached.travel - travel));
    }
    close_once(scene, start, options, seconds);
  }
  return seconds;
}

}  // namespace

StageSeconds stage_seconds(const CompiledScene& scene, const Candidate& candidate,
                           const Trial& trial, const TrialOptions& options) {
  const ClosingSeconds again = close_again(scene, candidate, trial, options);
  const double sum = again.closing + again.settling + again.contacts + again.quality;
  const double scale = sum > 0.0 ? trial.seconds.close / sum : 0.0;
  return {trial.seconds.approach, trial.seconds.reach,    scale * again.closing,
          scale * again.settling, scale * again.contacts, scale * again.quality};
}

}  // namespace prehend::bench
