#include "sim/scene/never_collide.h"

#include <cmath>
#include <vector>

#include "sim/base/index.h"

namespace prehend {
namespace {

// The proof is a branch and bound over boxes of postures. In the middle of a box the bodies have
// some gap. From there to any posture in the box no point moves farther than the sum over the
// joints of reach times half the joint's range. If the gap is larger, the bodies are apart in the
// whole box; if not, the box is halved along the joint that contributes most, and both halves are
// proven.

// Limits to the length of a proof. Giving up is always safe: a pair that is not proven to stay
// apart is checked for collision during motions.
constexpr std::size_t kMostJoints = 4;  // the number of boxes grows exponentially with the joints
constexpr int kMostQueries = 300;       // gap queries, one for each box
constexpr double kGapError = 0.5;       // relative error of a gap query, see gap_beyond

struct JointRange {
  double lower = 0.0;
  double upper = 0.0;
};

// One range for each joint of the pair.
using PostureBox = std::vector<JointRange>;

class Proof {
 public:
  Proof(const CompiledArm& arm, const ArmPair& pair) : arm_(arm), pair_(pair), bound_(arm) {
    joints_ = joint_values(arm.robot(), arm.start);
    turns_.assign(joints_.size(), 0.0);
  }

  // Whether the bodies are proven apart in the whole box.
  bool succeeds(const PostureBox& box) {
    if (++queries_ > kMostQueries) return false;
    std::size_t widest = 0;
    double widest_motion = -1.0;
    for (std::size_t k = 0; k < box.size(); ++k) {
      joints_[index(pair_.joints[k])] = 0.5 * (box[k].lower + box[k].upper);
      turns_[index(pair_.joints[k])] = 0.5 * (box[k].upper - box[k].lower);
      const double motion = pair_.reach[k] * turns_[index(pair_.joints[k])];
      if (motion > widest_motion) {
        widest_motion = motion;
        widest = k;
      }
    }
    robot_poses(arm_.robot(), joints_, poses_);
    bound_.set(poses_, turns_, MotionBound::Motion::any);
    const GapAnswer gap = gap_beyond(arm_, pair_, poses_.X_BL, bound_.farthest(pair_), kGapError);
    if (gap == GapAnswer::larger) return true;
    // Bodies that meet in the middle make the proof impossible; without joints there is nothing to
    // halve.
    if (gap == GapAnswer::meets || box.empty()) return false;
    PostureBox low = box;
    PostureBox high = box;
    low[widest].upper = high[widest].lower = 0.5 * (box[widest].lower + box[widest].upper);
    return succeeds(low) && succeeds(high);
  }

 private:
  const CompiledArm& arm_;
  const ArmPair& pair_;
  std::vector<double> joints_;
  std::vector<double> turns_;  // from the middle of the box to its sides
  RobotPoses poses_;
  MotionBound bound_;
  int queries_ = 0;
};

}  // namespace

bool never_collide(const CompiledArm& arm, const ArmPair& pair) {
  if (pair.joints.size() > kMostJoints) return false;
  PostureBox box;
  for (const int j : pair.joints) {
    const Joint& joint = arm.robot().joints[index(j)];
    box.push_back({joint.lower, joint.upper});
  }
  if (!Proof(arm, pair).succeeds(box)) return false;
  // The proof is about surfaces and holds for a body inside another too. Since the surfaces meet in
  // no posture, one body contains the other in every posture or in none: one test tells which.
  std::vector<Pose> X_BL;
  arm_link_poses(arm, joint_values(arm.robot(), arm.start), X_BL);
  return !pair_meets(arm, pair, X_BL);
}

}  // namespace prehend
