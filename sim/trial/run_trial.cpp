#include "sim/trial/run_trial.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/require_settings.h"
#include "sim/motion/dynamic_grasp/scene_world.h"
#include "sim/robot/one_finger.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/approach.h"
#include "sim/trial/approach_line.h"
#include "sim/trial/close_and_score.h"
#include "sim/trial/close_dynamic.h"
#include "sim/trial/keep_apart.h"
#include "sim/trial/resolve_overlap.h"
#include "sim/trial/settle.h"

namespace prehend {

struct TrialWorkspace::Buffers {
  std::vector<double> start_joints;
  ApproachWorkspace approaching;
  ApproachResult reached;
  ApproachResult pushed;
  GiveWayWorkspace giving_way;
  ClosingStart start;
  GraspWorkspace grasping;
  SettleWorkspace settling;
  Trial again;  // with the hand backed off
};

TrialWorkspace::TrialWorkspace() : buffers_(std::make_unique<Buffers>()) {}
TrialWorkspace::~TrialWorkspace() = default;
TrialWorkspace::TrialWorkspace(TrialWorkspace&& other) noexcept = default;
TrialWorkspace& TrialWorkspace::operator=(TrialWorkspace&& other) noexcept = default;

namespace {

// As a new trial, with the memory of its lists.
void clear(Trial& trial) {
  std::vector<double> dofs = std::move(trial.dofs);
  std::vector<double> joints = std::move(trial.joints);
  std::vector<GraspContact> contacts = std::move(trial.contacts);
  dofs.clear();
  joints.clear();
  contacts.clear();
  trial = Trial();
  trial.dofs = std::move(dofs);
  trial.joints = std::move(joints);
  trial.contacts = std::move(contacts);
}

// Adds the wall-clock time of its lifetime to `seconds`.
class Timer {
 public:
  explicit Timer(double& seconds) : seconds_(seconds) {}
  ~Timer() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double& seconds_;
  Clock::time_point start_ = Clock::now();
};

// One trial, stage by stage, the cheap and often decisive ones first: a posture of the arm at the
// pre-grasp, the approach of the hand, the arm along that approach, and last the closing of the
// hand with contacts and quality.
class TrialRun {
 public:
  TrialRun(const CompiledScene& scene, const Candidate& candidate, const TrialOptions& options,
           bool asks_arm, TrialWorkspace::Buffers& buffers, const RunContext& context)
      : scene_(scene),
        asks_arm_(asks_arm && scene.arm),
        candidate_(candidate),
        options_(options),
        context_(context),
        motion_{candidate.X_OH, candidate.approach_O, candidate.approach_distance},
        buffers_(buffers),
        start_(buffers.start) {
    start_.dofs = start_dofs(scene.scene.hand, candidate);
    start_.strategy = strategy_of(scene.scene.hand, candidate);
    if (candidate.preshape) {
      start_.joints.clear();
      start_.self_clearance = scene.preshape_gaps[index(*candidate.preshape)];
    } else {
      start_.joints = candidate.joints;
      start_.self_clearance.clear();
    }
    start_joints(scene.scene.hand, candidate, buffers.start_joints);
  }

  void run(Trial& trial) {
    clear(trial);
    try_it(trial);
    if (trial.outcome == Outcome::stable) keep_apart(trial);
    trial.seconds = seconds_;
  }

 private:
  void try_it(Trial& trial) {
    move_to_object();
    const ApproachResult& reached = buffers_.reached;
    if (reached.end == ApproachEnd::starts_in_collision && give_way_at_start()) move_to_object();
    place_hand(reached.travel, trial);
    if (reached.end == ApproachEnd::starts_in_collision) {
      trial.outcome = Outcome::hand_blocked;
      trial.blocked = reached.touch;
      trial.overlap = overlap_at_start();
    } else if (reached.end == ApproachEnd::touched_obstacle) {
      close_before_obstacle(trial);
    } else {
      close_from(reached.travel, trial);
    }
  }

  // A grasp that holds is dropped where the hand comes too near to what it must keep away from.
  void keep_apart(Trial& trial) {
    const HandWay way{motion_, trial.travel, buffers_.start_joints, trial.X_OH, trial.joints};
    trial.blocked = too_near(scene_, way, buffers_.grasping.collision);
    if (!trial.blocked) return;
    trial.outcome = Outcome::approach_blocked;
    trial.contacts.clear();
    trial.epsilon = {};
    trial.preferred = false;
  }

  // Moves the whole approach by what takes the hand out of what it overlaps at the start. Returns
  // whether it overlaps that little.
  bool give_way_at_start() {
    const Timer timer(seconds_.approach);
    const std::optional<Vector3> move =
        resolve_overlap(scene_, motion_.at(0.0), buffers_.start_joints, options_.resolve_overlap,
                        buffers_.giving_way, context_);
    if (!move) return false;
    shift(*move);
    return true;
  }

  std::optional<double> overlap_at_start() {
    const Timer timer(seconds_.approach);
    return overlap_depth(scene_, motion_.at(0.0), buffers_.start_joints, options_.resolve_overlap,
                         buffers_.giving_way, context_);
  }

  // The hand at this travel of its approach, open.
  void place_hand(double travel, Trial& trial) const {
    trial.X_OH = motion_.at(travel);
    trial.travel = travel;
    trial.overlap_shift = gave_way_;
    trial.dofs = start_.dofs;
    trial.joints = buffers_.start_joints;
  }

  // What lies on a table, or stands in front of a wall, can often be grasped only with the fingers
  // next to the table: as far as the hand comes may be far enough. If not, the obstacle is why. A
  // hand that starts at the obstacle moves away from it.
  void close_before_obstacle(Trial& trial) {
    if (buffers_.reached.travel < options_.obstacle_clearance) start_farther_back();
    const double travel = buffers_.reached.travel - options_.obstacle_clearance;
    if (travel >= 0.0) {
      close_from(travel, trial);
      if (trial.outcome == Outcome::stable) return;
    }
    clear(trial);
    place_hand(buffers_.reached.travel, trial);
    trial.outcome = Outcome::approach_blocked;
    trial.blocked = buffers_.reached.touch;
  }

  // Moves the start of the approach back until the clearance fits before the obstacle, if the hand
  // is free there and an obstacle may move it by that much.
  void start_farther_back() {
    const double by = options_.obstacle_clearance - buffers_.reached.travel;
    const Vector3 move = -by * candidate_.approach_O;
    if ((gave_way_ + move).norm() > options_.resolve_overlap.obstacle) return;
    if (hand_collision(scene_, translation(move) * motion_.at(0.0), buffers_.start_joints,
                       buffers_.grasping.collision)) {
      return;
    }
    shift(move);
    // Not a sum, which rounding could leave short of the clearance.
    buffers_.reached.travel = options_.obstacle_clearance;
  }

  void shift(const Vector3& move) {
    gave_way_ += move;
    motion_.X_OH_end = translation(move) * motion_.X_OH_end;
  }

  // Closes the hand at `travel`, and farther back where that does not hold.
  void close_from(double travel, Trial& trial) {
    place_hand(travel, trial);
    // The arm is asked once the hand's own way is known to be free, which costs far less than the
    // inverse kinematics of a pose that the arm does not reach, and before the hand closes.
    if (asks_arm_ && !arm_follows(trial)) return;
    close_at(travel, trial);
    // A hand that went as far as it could may close beyond the widest part of the object, or touch
    // it with the palm only. Closing a little farther out often holds what the first try did not.
    for (int back = 1; back <= options_.back_off_tries && trial.outcome != Outcome::stable;
         ++back) {
      const double retreat = back * options_.back_off_step;
      if (retreat > travel) break;
      Trial& again = buffers_.again;
      again = trial;
      close_at(travel - retreat, again);
      again.back_offs = back;
      if (again.outcome == Outcome::stable) trial = again;
    }
    if (asks_arm_) follow_to_the_grasp(trial);
  }

  void move_to_object() {
    const Timer timer(seconds_.approach);
    approach(scene_, buffers_.start_joints, motion_, options_, buffers_.approaching,
             buffers_.reached, context_);
  }

  // Moves the arm along the approach to the trial's X_OH; where it cannot, the trial ends with the
  // arm's outcome and without contacts. Remembers for which line that was computed.
  bool arm_follows(Trial& trial) {
    const Timer timer(seconds_.reach);
    followed_travel_ = trial.travel;
    followed_X_OH_ = hand_in_scene(trial);
    const Reach reach =
        find_reach(*scene_.arm, approach_line(scene_, candidate_, trial), options_.reach, context_);
    trial.arm_line = reach.line;
    trial.arm_dofs = reach.line.empty() ? DofValues{} : reach.line.back();
    if (reach.end == ReachEnd::reached) return true;
    trial.outcome = reach.end == ReachEnd::blocked ? Outcome::arm_blocked : Outcome::unreachable;
    trial.arm_pair = reach.pair;
    trial.contacts.clear();
    trial.epsilon = {};
    return false;
  }

  // Checks the arm again if the grasp is not at the end of the approach that was checked: a
  // back-off shortens the approach, and self-centering fingers move the hand sideways. A stable
  // grasp that the arm cannot reach gets the arm's outcome. A grasp that does not hold keeps its
  // own outcome; where the arm cannot reach it, it only has no postures.
  void follow_to_the_grasp(Trial& trial) {
    const bool same = trial.travel == followed_travel_ &&
                      hand_in_scene(trial).matrix() == followed_X_OH_.matrix();
    if (same) return;
    if (trial.outcome == Outcome::stable) {
      arm_follows(trial);
      return;
    }
    Trial moved = trial;
    const bool reached = arm_follows(moved);
    trial.arm_line = reached ? std::move(moved.arm_line) : std::vector<DofValues>{};
    trial.arm_dofs = reached ? std::move(moved.arm_dofs) : DofValues{};
  }

  // Closes the hand at this travel of its approach.
  void close_at(double travel, Trial& trial) {
    const Timer timer(seconds_.close);
    // A hand that closes in time pushes the object as it closes.
    const bool pushes = scene_.pushing_H && !options_.formation.dynamic;
    if (pushes) travel = std::max(0.0, travel - kSlidingRoom);
    trial.travel = travel;
    start_.X_OH = motion_.at(travel);
    // Backing off changes every gap by at most the retreat.
    start_.object_clearance = buffers_.reached.object_clearance;
    for (double& clearance : start_.object_clearance) {
      clearance = std::max(0.0, clearance - (buffers_.reached.travel - travel));
    }
    const Vector3 before = start_.X_OH.translation();
    if (pushes) push_to_fixed_jaw(*scene_.pushing_H);
    close_from_start(trial);
    trial.pushed += before - start_.X_OH.translation();
  }

  void close_from_start(Trial& trial) {
    if (options_.formation.dynamic) {
      close_dynamic(scene_, hand_model(scene_), start_, options_, buffers_.grasping, trial,
                    context_);
      return;
    }
    if (options_.contacts == ContactKind::fem) {
      close_pads(trial);
      return;
    }
    close_and_score(scene_, start_, options_, buffers_.grasping, trial, context_);
    settle(scene_, options_, buffers_.settling, buffers_.grasping, trial, context_);
  }

  // The only finger of a hand pushes the object until it meets the part that does not move. It is
  // the hand that moves here, the other way and with its finger open, as far as it opens at most.
  void push_to_fixed_jaw(const Vector3& pushing_H) {
    double farthest = 0.0;
    for (const Preshape& preshape : scene_.scene.hand.hand->preshapes) {
      farthest = std::max(farthest, preshape.max_width);
    }
    const Vector3 way_O = -(start_.X_OH.linear() * pushing_H);
    const ApproachMotion push{translation(farthest * way_O) * start_.X_OH, way_O, farthest};
    ApproachResult& pushed = buffers_.pushed;
    approach(scene_, buffers_.start_joints, push, options_, buffers_.approaching, pushed, context_);
    if (pushed.end != ApproachEnd::touched_object) return;
    start_.X_OH = push.at(pushed.travel);
    start_.object_clearance = pushed.object_clearance;
  }

  // Pads press once the object has settled: how it settles follows from where the fingers touch
  // first, and would take many times as long if they pressed at each step.
  void close_pads(Trial& trial) {
    TrialOptions settling = options_;
    settling.contacts = ContactKind::soft;
    close_and_score(scene_, start_, settling, buffers_.grasping, trial, context_);
    settle(scene_, settling, buffers_.settling, buffers_.grasping, trial, context_);
    if (trial.outcome == Outcome::stable || trial.outcome == Outcome::not_force_closure) {
      score_contacts(scene_, options_, buffers_.grasping.scoring, trial);
    }
  }

  const CompiledScene& scene_;
  bool asks_arm_;
  const Candidate& candidate_;
  const TrialOptions& options_;
  const RunContext& context_;
  ApproachMotion motion_;
  TrialWorkspace::Buffers& buffers_;
  ClosingStart& start_;
  Vector3 gave_way_ = Vector3::Zero();
  double followed_travel_ = 0.0;  // of the line that the arm was last asked to follow
  Pose followed_X_OH_ = Pose::Identity();
  TrialSeconds seconds_;
};

}  // namespace

Trial run_trial(const CompiledScene& scene, const Candidate& candidate, const TrialOptions& options,
                const RunContext& context) {
  TrialWorkspace workspace;
  Trial trial;
  run_trial(scene, candidate, options, workspace, trial, context);
  return trial;
}

void run_trial(const CompiledScene& scene, const Candidate& candidate, const TrialOptions& options,
               TrialWorkspace& workspace, Trial& trial, const RunContext& context) {
  require_settings(options);
  TrialRun(scene, candidate, options, true, workspace.buffers(), context).run(trial);
}

void run_hand_trial(const CompiledScene& scene, const Candidate& candidate,
                    const TrialOptions& options, TrialWorkspace& workspace, Trial& trial,
                    const RunContext& context) {
  require_settings(options);
  TrialRun(scene, candidate, options, false, workspace.buffers(), context).run(trial);
}

}  // namespace prehend
