#include "sim/scene/stay_apart.h"

#include <cmath>
#include <vector>

#include "sim/base/index.h"

namespace prehend {
namespace {

// Limits to the length of a proof. They cost time only, never a collision: a pair that is not
// proven to stay apart is tested as it moves.
constexpr std::size_t kMostJoints = 4;  // with more of them the boxes get too many
constexpr int kMostQueries = 300;
constexpr double kGapError = 0.5;  // of a query, see gap_beyond

struct Range {
  double lower = 0.0;
  double upper = 0.0;
};

// One range for each joint of the pair.
using PostureBox = std::vector<Range>;

class Proof {
 public:
  Proof(const CompiledArm& arm, const ArmPair& pair) : arm_(arm), pair_(pair) {
    joints_ = joint_values(arm.robot(), arm.start);
  }

  bool succeeds(const PostureBox& box) {
    if (++queries_ > kMostQueries) return false;
    double farthest = 0.0;  // any point from where it is in the middle
    std::size_t widest = 0;
    double widest_motion = -1.0;
    for (std::size_t k = 0; k < box.size(); ++k) {
      joints_[index(pair_.joints[k])] = 0.5 * (box[k].lower + box[k].upper);
      const double motion = pair_.reach[k] * 0.5 * (box[k].upper - box[k].lower);
      farthest += motion;
      if (motion > widest_motion) {
        widest_motion = motion;
        widest = k;
      }
    }
    arm_link_poses(arm_, joints_, X_BL_);
    const GapAnswer gap = gap_beyond(arm_, pair_, X_BL_, farthest, kGapError);
    if (gap == GapAnswer::larger) return true;
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
  std::vector<Pose> X_BL_;
  int queries_ = 0;
};

}  // namespace

bool stay_apart(const CompiledArm& arm, const ArmPair& pair) {
  if (pair.joints.size() > kMostJoints) return false;
  PostureBox box;
  for (const int j : pair.joints) {
    const Joint& joint = arm.robot().joints[index(j)];
    box.push_back({joint.lower, joint.upper});
  }
  if (!Proof(arm, pair).succeeds(box)) return false;
  // Surfaces that never meet: if one body holds the other, it does so in every posture.
  std::vector<Pose> X_BL;
  arm_link_poses(arm, joint_values(arm.robot(), arm.start), X_BL);
  return !pair_meets(arm, pair, X_BL);
}

}  // namespace prehend
