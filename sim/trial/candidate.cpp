#include "sim/trial/candidate.h"

#include "sim/base/index.h"
#include "sim/robot/robot.h"

namespace prehend {

void start_joints(const Robot& hand, const Candidate& candidate, std::vector<double>& joints) {
  if (candidate.preshape) {
    joint_values(hand, hand.hand->preshapes[index(*candidate.preshape)].dofs, joints);
  } else if (candidate.joints.empty()) {
    joint_values(hand, candidate.dofs, joints);
  } else {
    joints = candidate.joints;
  }
}

}  // namespace prehend
