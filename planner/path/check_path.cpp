#include "planner/path/check_path.h"

#include <algorithm>
#include <cmath>

#include "sim/base/formatted.h"
#include "sim/base/index.h"

namespace prehend {
namespace {

// The planner proves its paths free of collision by bounds on distances and motions
// (motion_check.h). This check samples postures along the cubics between the samples and tests all
// triangles for intersection, without any such bound. It is not a proof: a collision between two
// postures that are less than PathCheckOptions::step apart can be missed.

// Excess over a limit that is taken for rounding: relative for velocities and accelerations, in rad
// or m for positions.
constexpr double kRounding = 1e-6;

// Joint values at the fraction `part` (0..1) of the time between samples i and i + 1, on the cubic
// Hermite polynomial of their positions and velocities. The four weights are the Hermite basis; the
// tangents are scaled by h because the basis is written for an interval of length 1.
std::vector<double> between(const Trajectory& path, std::size_t i, double part) {
  const double h = path.times[i + 1] - path.times[i];
  const double s = part;
  const double from = (1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s);
  const double to = s * s * (3.0 - 2.0 * s);
  const double leave = s * (1.0 - s) * (1.0 - s) * h;
  const double arrive = s * s * (s - 1.0) * h;
  std::vector<double> joints(path.joints.size());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    joints[j] = from * path.positions[i][j] + to * path.positions[i + 1][j] +
                leave * path.velocities[i][j] + arrive * path.velocities[i + 1][j];
  }
  return joints;
}

// The corners of each link's bounding box, in the link's frame. A link lies in the convex hull of
// its corners, so no point of it moves farther from one pose to another than the farthest corner:
// the difference of two rigid motions is affine, and its norm is largest at a corner of the hull.
// This measures the motion with 8 points instead of all vertices.
std::vector<std::vector<Vector3>> box_corners(const CompiledArm& arm) {
  std::vector<std::vector<Vector3>> corners;
  for (const CompiledLink& link : arm.links) {
    const Bounds box = bounds(link.mesh.mesh());
    std::vector<Vector3> points;
    for (const double x : {box.lower.x(), box.upper.x()}) {
      for (const double y : {box.lower.y(), box.upper.y()}) {
        for (const double z : {box.lower.z(), box.upper.z()}) points.emplace_back(x, y, z);
      }
    }
    corners.push_back(std::move(points));
  }
  return corners;
}

class PathChecker {
 public:
  PathChecker(const CompiledScene& scene, const Trajectory& path, const PathCheckOptions& options,
              const RunContext& context)
      : arm_(*scene.arm),
        path_(path),
        options_(options),
        context_(context),
        hand_joints_(scene.scene.hand.joints.size()),
        pairs_(separate_pairs(arm_.links, arm_.robot())),
        corners_(box_corners(arm_)) {}

  PathCheck run() {
    check_limits();
    // walk(i) tests the postures after sample i. The one before all of them is tested here.
    look(path_.positions.front(), path_.times.front());
    for (std::size_t i = 0; i + 1 < path_.times.size(); ++i) walk(i);
    return check_;
  }

 private:
  // Limits are stated for degrees of freedom, the path has joint values. A joint moves `ratio`
  // times as fast as its degree of freedom, so its rates are divided by the ratio. Velocities are
  // compared at the samples, accelerations as mean values between two samples, which is also what
  // time_path keeps inside the limits.
  void check_limits() {
    const Robot& robot = arm_.robot();
    for (std::size_t i = 0; i < path_.times.size(); ++i) {
      for (std::size_t j = 0; j < robot.joints.size(); ++j) {
        const Joint& joint = robot.joints[j];
        const DegreeOfFreedom& dof = robot.dofs[index(joint.dof)];
        const double value = path_.positions[i][j];
        check_.beyond_limits =
            std::max({check_.beyond_limits, joint.lower - value, value - joint.upper});
        // A scene may narrow the limits of a degree of freedom below those of its joints. Joints of
        // the hand are left out: when a finger is stopped, the joints of one degree of freedom
        // no longer follow from a common value.
        if (!is_in_hand(j)) {
          const double dof_value = (value - joint.offset) / joint.ratio;
          check_.beyond_limits =
              std::max({check_.beyond_limits, dof.lower - dof_value, dof_value - dof.upper});
        }
        const double speed = std::abs(path_.velocities[i][j] / joint.ratio);
        // Joints at rest are skipped: their limits may be missing (0), which would give 0 / 0.
        if (speed > 0.0) check_.velocity = std::max(check_.velocity, speed / dof.max_velocity);
        if (i == 0) continue;
        const double change = std::abs(path_.velocities[i][j] - path_.velocities[i - 1][j]);
        const double rate = change / std::abs(joint.ratio) / (path_.times[i] - path_.times[i - 1]);
        if (change > 0.0) {
          check_.acceleration = std::max(check_.acceleration, rate / dof.max_acceleration);
        }
      }
    }
  }

  bool is_in_hand(std::size_t joint) const {
    const auto first = index(arm_.hand_part().first_joint);
    return joint >= first && joint < first + hand_joints_;
  }

  // Tests the postures after sample i up to and including sample i + 1. The number of steps is
  // doubled until the longest of them is short enough: how far a link moves in a step is known only
  // once its poses are computed. 4096 steps (8 m between samples at the default step) is a guard
  // against paths whose samples are absurdly far apart.
  void walk(std::size_t i) {
    int steps = 1;
    while (steps < 4096 && longest_step(i, steps) > options_.step) steps *= 2;
    for (int k = 1; k <= steps; ++k) {
      const double part = static_cast<double>(k) / steps;
      look(between(path_, i, part), path_.times[i] + part * (path_.times[i + 1] - path_.times[i]));
    }
  }

  // The farthest that any corner of any link moves [m] in one of `steps` equal steps of time.
  double longest_step(std::size_t i, int steps) {
    double longest = 0.0;
    std::vector<Pose> before;
    std::vector<Pose> after;
    arm_link_poses(arm_, between(path_, i, 0.0), before);
    for (int k = 1; k <= steps; ++k) {
      context_.cancellation.check();
      arm_link_poses(arm_, between(path_, i, static_cast<double>(k) / steps), after);
      for (std::size_t l = 0; l < corners_.size(); ++l) {
        for (const Vector3& p : corners_[l]) {
          longest = std::max(longest, (after[l] * p - before[l] * p).norm());
        }
      }
      before.swap(after);
    }
    return longest;
  }

  // Tests one posture and records the result; the description is kept of the first collision only.
  void look(const std::vector<double>& joints, double time) {
    context_.cancellation.check();
    ++check_.postures;
    arm_link_poses(arm_, joints, X_BL_);
    const std::string met = what_meets();
    if (met.empty()) return;
    if (++check_.collisions > 1) return;
    check_.first_collision = met + formatted(" at %.3f s", time);
  }

  // "LINK meets BODY" for the first collision in the current posture, empty if there is none.
  std::string what_meets() const {
    for (const LinkPair& pair : pairs_) {
      const CompiledLink& a = arm_.links[index(pair.a)];
      const CompiledLink& b = arm_.links[index(pair.b)];
      if (meet(a.mesh, b.mesh, X_BL_[index(pair.a)], X_BL_[index(pair.b)])) {
        return a.name + " meets " + b.name;
      }
    }
    for (std::size_t l = 0; l < arm_.links.size(); ++l) {
      for (const PlacedBody& body : arm_.bodies) {
        if (meet(body.mesh, arm_.links[l].mesh, body.X_RB, X_BL_[l])) {
          return arm_.links[l].name + " meets " + body.name;
        }
      }
    }
    return "";
  }

  // Whether the surfaces intersect. Bounding balls first: they rule out most pairs cheaply.
  static bool meet(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_A,
                   const Pose& X_B) {
    const double apart = (X_A * a.ball_center() - X_B * b.ball_center()).norm();
    return apart <= a.ball_radius() + b.ball_radius() && surfaces_cross(a, b, X_A.inverse() * X_B);
  }

  const CompiledArm& arm_;
  const Trajectory& path_;
  const PathCheckOptions& options_;
  const RunContext& context_;
  const std::size_t hand_joints_;
  const std::vector<LinkPair> pairs_;
  const std::vector<std::vector<Vector3>> corners_;
  std::vector<Pose> X_BL_;
  PathCheck check_;
};

}  // namespace

bool PathCheck::ok() const {
  return collisions == 0 && velocity <= 1.0 + kRounding && acceleration <= 1.0 + kRounding &&
         beyond_limits <= kRounding;
}

PathCheck check_path(const CompiledScene& scene, const Trajectory& path,
                     const PathCheckOptions& options, const RunContext& context) {
  return PathChecker(scene, path, options, context).run();
}

}  // namespace prehend
