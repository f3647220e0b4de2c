#include "sim/robot/hand/posture_survey.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/robot/hand/fingers.h"
#include "sim/robot/hand/self_collision.h"

namespace prehend {
namespace {

// A point that a joint moves.
struct SurveyedTip {
  std::string name;
  int joint = -1;
  Vector3 p_J = Vector3::Zero();  // in the frame after the joint
};

std::vector<SurveyedTip> tips_of(const Robot& robot) {
  std::vector<SurveyedTip> tips;
  for (const Finger& finger : find_hand_parts(robot).fingers) {
    const Link& link = robot.links[index(finger.tip_link)];
    tips.push_back({link.name, link.joint, finger.tip});
  }
  if (!tips.empty()) return tips;
  for (const Chain& chain : robot.chains) {
    if (chain.joint_count == 0) continue;
    tips.push_back({chain.name, chain.first_joint + chain.joint_count - 1, Vector3::Zero()});
  }
  return tips;
}

bool turns(const Robot& robot, std::size_t dof) {
  return std::any_of(robot.joints.begin(), robot.joints.end(), [&](const Joint& joint) {
    return index(joint.dof) == dof && joint.type == JointType::revolute;
  });
}

// The values from which each degree of freedom is drawn.
std::vector<std::pair<double, double>> ranges_of(const Robot& robot) {
  std::vector<std::pair<double, double>> ranges;
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    const DegreeOfFreedom& dof = robot.dofs[d];
    if (std::isfinite(dof.lower) && std::isfinite(dof.upper)) {
      ranges.emplace_back(dof.lower, dof.upper);
    } else {
      const double half = turns(robot, d) ? std::numbers::pi : 0.0;
      ranges.emplace_back(dof.initial - half, dof.initial + half);
    }
  }
  return ranges;
}

std::vector<CollidingLinks> most_often_first(const std::map<std::pair<int, int>, int>& counts) {
  std::vector<CollidingLinks> pairs;
  for (const auto& [pair, count] : counts) pairs.push_back({pair.first, pair.second, count});
  std::stable_sort(
      pairs.begin(), pairs.end(),
      [](const CollidingLinks& a, const CollidingLinks& b) { return a.postures > b.postures; });
  return pairs;
}

}  // namespace

PostureSurvey survey_postures(const Robot& robot, int postures, std::uint64_t seed) {
  require(
      postures >= 1,
      {.field = "postures", .problem = "must be at least 1", .value = std::to_string(postures)});
  const SelfCollision collision(robot);
  const std::vector<SurveyedTip> tips = tips_of(robot);
  const std::vector<std::pair<double, double>> ranges = ranges_of(robot);
  Random random(seed);
  std::map<std::pair<int, int>, int> counts;
  PostureSurvey survey;
  survey.postures = postures;
  for (const SurveyedTip& tip : tips) survey.tips.push_back({tip.name, {}, {}, 0.0});
  std::vector<Pose> X_BJ;
  for (int i = 0; i < postures; ++i) {
    std::vector<double> dofs;
    for (const auto& [lower, upper] : ranges) dofs.push_back(random.uniform(lower, upper));
    const std::vector<std::pair<int, int>> colliding = collision.colliding(dofs);
    for (const auto& pair : colliding) ++counts[pair];
    if (!colliding.empty()) {
      ++survey.colliding;
      continue;
    }
    joint_poses(robot, joint_values(robot, dofs), X_BJ);
    for (std::size_t t = 0; t < tips.size(); ++t) {
      const Vector3 p_B =
          tips[t].joint < 0 ? tips[t].p_J : X_BJ[index(tips[t].joint)] * tips[t].p_J;
      TipWorkspace& tip = survey.tips[t];
      tip.box.lower = tip.box.lower.cwiseMin(p_B);
      tip.box.upper = tip.box.upper.cwiseMax(p_B);
      tip.points.push_back(p_B);
      tip.farthest = std::max(tip.farthest, p_B.norm());
    }
  }
  survey.pairs = most_often_first(counts);
  return survey;
}

}  // namespace prehend
