#include "sim/scene/reach/motion_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "sim/base/index.h"
#include "sim/scene/compiled_arm.h"
#include "sim/scene/motion_bound.h"

namespace prehend {
namespace {

// Levels of the bisection that are searched breadth first: up to 15 postures of the path.
constexpr int kCoarseLevels = 4;

// Of the part of a stretch that a gap settles, this much is taken, against rounding.
constexpr double kProvenPart = 0.999;

// A path and the way of each joint along it: the sum of its motions back and forth since the start.
// A position on the path is a number from 0 to end(), whole at the waypoints. The difference of the
// ways at two positions bounds how far the joint is from one of them anywhere between, also where
// the path turns back at a waypoint.
class MeasuredPath {
 public:
  explicit MeasuredPath(const JointPath& path) : path_(path), way_(path.size()) {
    way_[0].assign(path[0].size(), 0.0);
    for (std::size_t i = 1; i < path.size(); ++i) {
      way_[i] = way_[i - 1];
      for (std::size_t j = 0; j < path[i].size(); ++j) {
        way_[i][j] += std::abs(path[i][j] - path[i - 1][j]);
      }
    }
  }

  double end() const { return static_cast<double>(path_.size() - 1); }

  // At waypoint `at`, or between two of them.
  void posture(double at, std::vector<double>& joints) const { blend(path_, at, joints); }
  void way(double at, std::vector<double>& way) const { blend(way_, at, way); }

 private:
  static void blend(const JointPath& values, double at, std::vector<double>& result) {
    const double whole = std::min(std::floor(at), static_cast<double>(values.size() - 1));
    const auto i = static_cast<std::size_t>(whole);
    const double rest = at - whole;
    result = values[i];
    if (rest <= 0.0) return;
    for (std::size_t j = 0; j < result.size(); ++j) {
      result[j] += rest * (values[i + 1][j] - values[i][j]);
    }
  }

  const JointPath& path_;
  JointPath way_;
};

// Adaptive bisection (Schwarzer, Saha and Latombe 2005): a stretch of the path is settled for a
// pair by one distance query in its middle, or else divided. Large gaps settle long stretches, so
// that queries concentrate where bodies come close. All pairs share the first levels, so that the
// poses of the links in the middle are computed once for all of them; few are left after these, and
// each divides its stretches where its own gaps end.
//
// Most of a search's time goes into motions that are blocked. Depth first, a collision at the end
// of a motion would be found only after all that lies before it is proven free; the first levels
// are therefore searched breadth first. Not all levels: a motion that grazes would divide all of
// its stretches down to the finest before the first of them could refuse it.
class MotionCheck {
 public:
  MotionCheck(const CompiledArm& arm, const std::vector<ArmPair>& pairs, const JointPath& path,
              const std::vector<double>& sway, const MotionCheckOptions& options,
              const RunContext& context)
      : arm_(arm),
        pairs_(pairs),
        path_(path),
        options_(options),
        context_(context),
        sway_(sway),
        sways_(std::any_of(sway.begin(), sway.end(), [](double by) { return by > 0.0; })),
        bound_(arm),
        way_bound_(arm) {}

  std::optional<ArmPair> run() {
    std::vector<std::size_t> all(pairs_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    std::vector<Stretch> level = {{0.0, path_.end(), std::move(all)}};
    std::optional<std::size_t> blocked;
    for (int k = 0; k < kCoarseLevels && !blocked; ++k) {
      std::vector<Stretch> halves;
      for (auto of = level.begin(); of != level.end() && !blocked; ++of)
        blocked = halve(*of, halves);
      level = std::move(halves);
    }
    for (auto of = level.begin(); of != level.end() && !blocked; ++of) blocked = first_in(*of);
    if (!blocked) return std::nullopt;
    return pairs_[*blocked];
  }

 private:
  // A part of the path, and the pairs that are not settled on it.
  struct Stretch {
    double from = 0.0;
    double to = 0.0;
    std::vector<std::size_t> open;
  };

  // The first pair that is not proved free on a stretch.
  std::optional<std::size_t> first_in(const Stretch& stretch) {
    for (const std::size_t p : stretch.open) {
      if (!is_free(p, stretch.from, stretch.to, {})) return p;
    }
    return std::nullopt;
  }

  // Whether a pair is proven free on a stretch. A gap that does not settle all of it settles a part
  // around its middle, and what is left on both sides of that is asked for again, with the nearest
  // triangles as a hint.
  bool is_free(std::size_t p, double from, double to, const TrianglePair& hint) {
    context_.cancellation.check();
    const double middle = look_at(from, to);
    const double farthest = bound_.farthest(pairs_[p]);
    const GapBeyond gap =
        find_gap_beyond(arm_, pairs_[p], poses_.X_BL, farthest, kMotionGapError, hint);
    if (gap.answer == GapAnswer::larger) return true;
    if (gap.answer == GapAnswer::meets) return false;
    if (is_finest(pairs_[p])) return false;
    // Where a joint sways, or turns back, what a gap settles is not in proportion to it.
    const double free = is_line(from, to) ? kProvenPart * gap.at_least / farthest : 0.0;
    return is_free(p, from, middle - free * (middle - from), gap.nearest) &&
           is_free(p, middle + free * (to - middle), to, gap.nearest);
  }

  // Settles pairs of a stretch by one query each in its middle, and appends its halves with the
  // pairs that this did not settle. A pair that is blocked ends it.
  std::optional<std::size_t> halve(const Stretch& stretch, std::vector<Stretch>& halves) {
    const double middle = look_at(stretch.from, stretch.to);
    std::vector<std::size_t> left;  // pairs neither free nor blocked after the query in the middle
    for (const std::size_t p : stretch.open) {
      context_.cancellation.check();
      const GapAnswer gap =
          gap_beyond(arm_, pairs_[p], poses_.X_BL, bound_.farthest(pairs_[p]), kMotionGapError);
      if (gap == GapAnswer::larger) continue;
      if (gap == GapAnswer::meets) return p;
      if (is_finest(pairs_[p])) return p;
      left.push_back(p);
    }
    if (left.empty()) return std::nullopt;
    halves.push_back({stretch.from, middle, left});
    halves.push_back({middle, stretch.to, std::move(left)});
    return std::nullopt;
  }

  // Whether the motion on a stretch is a straight line in joint space.
  bool is_line(double from, double to) const {
    return !sways_ && std::ceil(to) - std::floor(from) <= 1.0;
  }

  // Takes the posture in the middle of a stretch, and bounds how far points move from there to
  // either end, with the sway and without it. Returns where the middle is.
  double look_at(double from, double to) {
    double middle = 0.5 * (from + to);
    // A stretch over several waypoints is divided at one of them: no blend is needed there, and the
    // halves contain no more bends than necessary.
    if (to - from > 1.0) middle = std::round(middle);
    path_.posture(middle, joints_);
    robot_poses(arm_.robot(), joints_, poses_);
    turns_.resize(joints_.size());
    if (is_line(from, to)) {
      path_.posture(from, start_);
      for (std::size_t j = 0; j < turns_.size(); ++j) turns_[j] = joints_[j] - start_[j];
      bound_.set(poses_, turns_, MotionBound::Motion::line);
      return middle;
    }
    path_.way(from, before_);
    path_.way(middle, here_);
    path_.way(to, after_);
    ways_.resize(joints_.size());
    for (std::size_t j = 0; j < turns_.size(); ++j) {
      ways_[j] = std::max(here_[j] - before_[j], after_[j] - here_[j]);
      turns_[j] = ways_[j] + sway_[j];
    }
    bound_.set(poses_, turns_, MotionBound::Motion::any);
    if (sways_) way_bound_.set(poses_, ways_, MotionBound::Motion::any);
    return middle;
  }

  // Whether a stretch that was looked at is not divided further for a pair: to each of its ends the
  // bodies move by half of what they do on all of it.
  bool is_finest(const ArmPair& pair) {
    return (sways_ ? way_bound_ : bound_).farthest(pair) <= 0.5 * options_.tightest;
  }

  const CompiledArm& arm_;
  const std::vector<ArmPair>& pairs_;
  const MeasuredPath path_;
  const MotionCheckOptions& options_;
  const RunContext& context_;
  const std::vector<double>& sway_;  // how far each joint may leave the lines [rad or m]
  const bool sways_;

  // Of the stretch that is looked at.
  std::vector<double> joints_;  // the posture in its middle
  std::vector<double> start_;   // that where it starts
  std::vector<double> before_;  // ways at the start, the middle and the end
  std::vector<double> here_;
  std::vector<double> after_;
  std::vector<double> ways_;   // of each joint to either end, at most
  std::vector<double> turns_;  // the same with its sway
  RobotPoses poses_;
  MotionBound bound_;      // by the turns
  MotionBound way_bound_;  // by the ways, where they differ
};

}  // namespace

std::optional<ArmPair> first_blocked(const CompiledArm& arm, const std::vector<ArmPair>& pairs,
                                     const JointPath& path, const MotionCheckOptions& options,
                                     const RunContext& context) {
  if (path.empty()) return std::nullopt;
  return first_blocked(arm, pairs, path, std::vector<double>(path.front().size(), 0.0), options,
                       context);
}

std::optional<ArmPair> first_blocked(const CompiledArm& arm, const std::vector<ArmPair>& pairs,
                                     const JointPath& path, const std::vector<double>& sway,
                                     const MotionCheckOptions& options, const RunContext& context) {
  if (path.empty() || pairs.empty()) return std::nullopt;
  return MotionCheck(arm, pairs, path, sway, options, context).run();
}

std::optional<ArmPair> first_meeting(const CompiledArm& arm, const std::vector<ArmPair>& pairs,
                                     const std::vector<double>& joints) {
  std::vector<Pose> X_BL;
  arm_link_poses(arm, joints, X_BL);
  for (const ArmPair& pair : pairs) {
    if (pair_meets(arm, pair, X_BL)) return pair;
  }
  return std::nullopt;
}

}  // namespace prehend
