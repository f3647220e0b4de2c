#include "sim/scene/reach/motion_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "sim/base/index.h"
#include "sim/scene/compiled_arm.h"

namespace prehend {
namespace {

// Levels of the bisection that are searched breadth first: up to 15 postures of the path.
constexpr int kCoarseLevels = 4;

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
// pair by one distance query in its middle, or else halved. Large gaps settle long stretches, so
// that queries concentrate where bodies come close. All pairs share the bisection, so that
// the poses of the links in the middle are computed once for all of them.
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
      : arm_(arm), pairs_(pairs), path_(path), options_(options), context_(context) {
    for (const ArmPair& pair : pairs) {
      sway_.push_back(0.0);
      for (std::size_t k = 0; k < pair.joints.size(); ++k) {
        sway_.back() += pair.reach[k] * sway[index(pair.joints[k])];
      }
    }
  }

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
    std::vector<Stretch> halves;
    std::optional<std::size_t> blocked = halve(stretch, halves);
    for (auto of = halves.begin(); of != halves.end() && !blocked; ++of) blocked = first_in(*of);
    return blocked;
  }

  // Settles pairs of a stretch by one query each in its middle, and appends its halves with the
  // pairs that this did not settle. A pair that is blocked ends it.
  std::optional<std::size_t> halve(const Stretch& stretch, std::vector<Stretch>& halves) {
    double middle = 0.5 * (stretch.from + stretch.to);
    // A stretch over several waypoints is divided at one of them: no blend is needed there, and the
    // halves contain no more bends than necessary.
    if (stretch.to - stretch.from > 1.0) middle = std::round(middle);
    path_.way(stretch.from, before_);
    path_.way(middle, here_);
    path_.way(stretch.to, after_);
    path_.posture(middle, joints_);
    arm_link_poses(arm_, joints_, X_BL_);
    std::vector<std::size_t> left;  // pairs neither free nor blocked after the query in the middle
    for (const std::size_t p : stretch.open) {
      context_.cancellation.check();
      const double farthest = farthest_in(pairs_[p]);
      const GapAnswer gap =
          gap_beyond(arm_, pairs_[p], X_BL_, farthest + sway_[p], kMotionGapError);
      if (gap == GapAnswer::larger) continue;
      // Each half of the stretch moves the bodies by `farthest` at most, the whole by twice that.
      if (gap == GapAnswer::meets || farthest <= 0.5 * options_.tightest) return p;
      left.push_back(p);
    }
    if (left.empty()) return std::nullopt;
    halves.push_back({stretch.from, middle, left});
    halves.push_back({middle, stretch.to, std::move(left)});
    return std::nullopt;
  }

  // Upper bound of how far a point of one body of a pair moves relative to the other, from the
  // middle of the stretch to either end: each joint between them contributes its motion times its
  // reach, the largest distance from its axis of a point that it moves.
  double farthest_in(const ArmPair& pair) const {
    double back = 0.0;
    double ahead = 0.0;
    for (std::size_t k = 0; k < pair.joints.size(); ++k) {
      const std::size_t j = index(pair.joints[k]);
      back += pair.reach[k] * (here_[j] - before_[j]);
      ahead += pair.reach[k] * (after_[j] - here_[j]);
    }
    return std::max(back, ahead);
  }

  const CompiledArm& arm_;
  const std::vector<ArmPair>& pairs_;
  const MeasuredPath path_;
  const MotionCheckOptions& options_;
  const RunContext& context_;
  std::vector<double> sway_;    // how far each pair may move beside the lines [m]
  std::vector<double> before_;  // ways at the start, the middle and the end of a stretch
  std::vector<double> here_;
  std::vector<double> after_;
  std::vector<double> joints_;
  std::vector<Pose> X_BL_;
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
