#include "sim/trial/candidate.h"

#include "sim/base/index.h"
#include "sim/robot/robot.h"

namespace prehend {

const std::vector<double>& start_dofs(const Robot& hand, const Candidate& candidate) {
  return candidate.preshape ? hand.hand->preshapes[index(*candidate.preshape)].dofs
                            : candidate.dofs;
}

void start_joints(const Robot& hand, const Candidate& candidate, std::vector<double>& joints) {
  if (candidate.preshape || candidate.joints.empty()) {
    joint_values(hand, start_dofs(hand, candidate), joints);
  } else {
    joints = candidate.joints;
  }
}

ClosingStrategy strategy_of(const Robot& hand, const Candidate& candidate) {
  return candidate.strategy ? hand.hand->strategies[index(*candidate.strategy)] : ClosingStrategy{};
}

}  // namespace prehend
