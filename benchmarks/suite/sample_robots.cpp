#include "benchmarks/suite/sample_robots.h"

#include <algorithm>
#include <utility>

namespace prehend::bench {

std::vector<IkTarget> reachable_targets(const Robot& robot, int joint, const Pose& X_JT,
                                        int count) {
  constexpr double kRoom = 10.0;  // of a base that could roll farther [m]
  Random random(1);
  std::vector<IkTarget> targets;
  for (int i = 0; i < count; ++i) {
    DofValues values;
    for (const DegreeOfFreedom& dof : robot.dofs) {
      values.push_back(random.uniform(dof.lower, std::min(dof.upper, dof.lower + kRoom)));
    }
    std::vector<Pose> X_BJ;
    joint_poses(robot, joint_values(robot, values), X_BJ);
    targets.push_back({joint, X_JT, X_BJ[static_cast<std::size_t>(joint)] * X_JT});
  }
  return targets;
}

Robot without_closed_form(Robot robot) {
  for (Chain& chain : robot.chains) chain.closed_form = ClosedForm::none;
  return robot;
}

}  // namespace prehend::bench
