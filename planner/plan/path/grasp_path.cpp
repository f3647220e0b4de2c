#include "planner/plan/path/grasp_path.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "planner/plan/path/blend_transfer.h"
#include "planner/plan/path/closing_path.h"
#include "planner/plan/path/second_check.h"
#include "sim/base/index.h"
#include "sim/base/require_settings.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/approach_line.h"
#include "sim/trial/candidate.h"
#include "sim/trial/trial.h"

namespace prehend {
namespace {

// Postures whose values differ by no more than this are the same: inverse kinematics found it
// twice, or a file rounded it [rad or m].
constexpr double kSamePosture = 1e-6;

// Tries alternatives in a fixed order and returns the first path that stands: postures of the arm
// at the pre-grasp (the trial's own first), and for each the hand opened before or after the
// transfer. Collision-free geometry is found first (plan_transfer); timing comes after it, since it
// does not change where the arm passes.
class GraspPathPlanner {
 public:
  GraspPathPlanner(const CompiledScene& scene, const SecondCheck& bodies,
                   const Candidate& candidate, const Trial& trial, const GraspPathOptions& options,
                   const RunContext& context)
      : scene_(scene),
        bodies_(bodies),
        arm_(*scene.arm),
        trial_(trial),
        options_(options),
        context_(context),
        limits_(joint_limits(arm_.robot())),
        line_(approach_line(scene, candidate, trial)) {
    const std::vector<double> start = joint_values(arm_.robot(), arm_.start);
    const auto first = start.begin() + arm_.hand_part().first_joint;
    start_hand_.assign(first, first + static_cast<std::ptrdiff_t>(line_.hand_joints.size()));
    // first_blocked compares surfaces only. That no body is inside another is checked at the start
    // posture (compile_arm). It stays true, because all motions join up from there and no surfaces
    // cross on the way.
    pairs_ = arm_.arm_pairs;
    pairs_.insert(pairs_.end(), arm_.hand_pairs.begin(), arm_.hand_pairs.end());
  }

  // The trial's own line comes first: other lines cost a search by inverse kinematics, which is
  // left out where the first succeeds.
  GraspPathAttempt plan() {
    std::optional<GraspPath> path = first_path();
    if (path) return {std::move(path), {}};
    return {std::nullopt, most_in_the_way()};
  }

 private:
  std::optional<GraspPath> first_path() {
    int tried = 0;
    tell(tried);
    if (!trial_.arm_line.empty()) {
      if (std::optional<GraspPath> path = along(trial_.arm_line)) return path;
      tell(++tried);
    }
    for (const std::vector<DofValues>& line : other_lines()) {
      if (std::optional<GraspPath> path = along(line)) return path;
      tell(++tried);
    }
    return std::nullopt;
  }

  void tell(int tried) const {
    if (context_.progress) context_.progress({Stage::paths, tried, options_.alternatives, 0});
  }

  // Approaches of the arm along the same line of the hand in other inverse kinematics branches than
  // the trial's. At most `alternatives` are tried in all, that of the trial included.
  std::vector<std::vector<DofValues>> other_lines() const {
    std::vector<std::vector<DofValues>> lines;
    const std::size_t tried = trial_.arm_line.empty() ? 0 : 1;
    for (Reach& way : find_reaches(arm_, line_, options_.alternatives, options_.reach, context_)) {
      // This search may find the trial's own line again, which has already been tried.
      if (way.end != ReachEnd::reached || starts_as_the_trial(way.line)) continue;
      if (lines.size() + tried == index(options_.alternatives)) break;
      lines.push_back(std::move(way.line));
    }
    return lines;
  }

  bool starts_as_the_trial(const std::vector<DofValues>& line) const {
    if (trial_.arm_line.empty()) return false;
    const DofValues& own = trial_.arm_line.front();
    return std::equal(own.begin(), own.end(), line.front().begin(), line.front().end(),
                      [](double a, double b) { return std::abs(a - b) <= kSamePosture; });
  }

  // The path whose approach runs along `line`, with the hand taking its preshape at the start where
  // that works, else at the pre-grasp.
  std::optional<GraspPath> along(const std::vector<DofValues>& line) {
    for (const bool opens_first : {true, false}) {
      // With nothing to open, both orders are the same path.
      if (!opens_first && start_hand_ == line_.hand_joints) continue;
      std::optional<Trajectory> path = along(line, opens_first);
      if (path && is_sound(*path, 0)) {
        return lifted(*path, line.back());
      }
    }
    return std::nullopt;
  }

  // The path with what comes after the grasp, as far as that stands.
  GraspPath lifted(const Trajectory& path, const DofValues& held) const {
    GraspPath whole{path};
    const LiftedPath then = lift_object({scene_, trial_, held}, options_.lift, options_.reach,
                                        options_.transfer, limits_, options_.timing, context_);
    whole.lift = then.end;
    if (!then.lift) return whole;
    const std::size_t from = path.times.size() - 1;
    append(whole.motion, kLift, *then.lift);
    if (then.retreat) {
      GraspPath back = whole;
      append(back.motion, kRetreat, *then.retreat);
      if (is_sound(back.motion, from)) return back;
      whole.lift = LiftEnd::retreat_blocked;
    }
    if (is_sound(whole.motion, from)) return whole;
    return {path, LiftEnd::lift_blocked};
  }

  // Whether the second check finds nothing from sample `first` on: the proof is not the only one to
  // say so.
  bool is_sound(const Trajectory& path, std::size_t first) const {
    return check_path(scene_, bodies_, path, first, options_.check, context_).ok();
  }

  // Both orders are worth trying: there may be no room to open the hand at the start, or none to
  // carry it open.
  std::optional<Trajectory> along(const std::vector<DofValues>& line, bool opens_first) {
    const std::vector<double>& carried = opens_first ? line_.hand_joints : start_hand_;
    // The quick check of the opening comes before the search for a transfer, which is expensive.
    const DofValues& opens_at = opens_first ? arm_.start : line.front();
    const JointPath opening = {arm_joints(arm_, opens_at, start_hand_),
                               arm_joints(arm_, opens_at, line_.hand_joints)};
    const MotionCheckOptions& motion = options_.transfer.motion;
    if (const auto blocked = first_blocked(arm_, pairs_, opening, motion, context_)) {
      count(*blocked);
      return std::nullopt;
    }
    const TransferPath transfer =
        plan_transfer(arm_, {arm_.start, line.front(), carried}, options_.transfer, context_);
    if (transfer.waypoints.empty()) {
      if (transfer.bottleneck) count(*transfer.bottleneck);
      return std::nullopt;
    }
    Trajectory path;
    for (const Joint& joint : arm_.robot().joints) path.joints.push_back(joint.name);
    const bool opens = start_hand_ != line_.hand_joints;
    if (opens && opens_first) add(path, "preshape", opening, PathKind::corners);
    append(path, "transfer",
           blend_transfer(arm_, transfer.waypoints, carried, limits_, options_.transfer,
                          options_.timing, context_));
    if (opens && !opens_first) add(path, "preshape", opening, PathKind::corners);
    // The line is densely sampled along a smooth motion, so it is run through without stops.
    add(path, "approach", with_hand(line, line_.hand_joints), PathKind::smooth);
    // The arm rests while the fingers close. The closing is not proven free: it ends at gaps that
    // are smaller than the proof resolves (MotionCheckOptions::tightest). check_path tests it.
    JointPath closing;
    for (const auto& hand :
         closing_path(scene_.scene.hand, line_.hand_joints, trial_.joints).postures) {
      closing.push_back(arm_joints(arm_, line.back(), hand));
    }
    add(path, "close", closing, PathKind::corners);
    return path;
  }

  void count(const ArmPair& pair) {
    ++in_the_way_[{first_name(arm_, pair), second_name(arm_, pair)}];
  }

  // Of several that were in the way as often, the first by name.
  CollisionNames most_in_the_way() const {
    const auto most =
        std::max_element(in_the_way_.begin(), in_the_way_.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most == in_the_way_.end()) return {};
    return {most->first.first, most->first.second};
  }

  // Joints of the platform along the postures of the arm, the hand's the same all the way.
  JointPath with_hand(const std::vector<DofValues>& dofs, const std::vector<double>& hand) const {
    JointPath path;
    for (const DofValues& values : dofs) path.push_back(arm_joints(arm_, values, hand));
    return path;
  }

  void add(Trajectory& path, const char* segment, const JointPath& waypoints, PathKind kind) const {
    append(path, segment, time_path(waypoints, kind, limits_, options_.timing));
  }

  const CompiledScene& scene_;
  const SecondCheck& bodies_;
  const CompiledArm& arm_;
  const Trial& trial_;
  const GraspPathOptions& options_;
  const RunContext& context_;
  const JointLimits limits_;
  const HandLine line_;
  std::vector<double> start_hand_;
  std::vector<ArmPair> pairs_;
  std::map<std::pair<std::string, std::string>, int> in_the_way_;  // of the alternatives tried
};

}  // namespace

std::optional<GraspPath> plan_grasp_path(const CompiledScene& scene, const Candidate& candidate,
                                         const Trial& trial, const GraspPathOptions& options,
                                         const RunContext& context) {
  return try_grasp_path(scene, SecondCheck(*scene.arm), candidate, trial, options, context).path;
}

GraspPathAttempt try_grasp_path(const CompiledScene& scene, const SecondCheck& bodies,
                                const Candidate& candidate, const Trial& trial,
                                const GraspPathOptions& options, const RunContext& context) {
  require_settings(options);
  return GraspPathPlanner(scene, bodies, candidate, trial, options, context).plan();
}

}  // namespace prehend
