#include "planner/show/telling_postures.h"

#include <algorithm>
#include <utility>

#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/scene/compiled_scene.h"
#include "sim/shape/basic_shapes.h"
#include "sim/trial/close_hand.h"

namespace prehend {
namespace {

// Half closed: the mean of the joints open and closed.
std::vector<double> half_way(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> half(a.size());
  for (std::size_t j = 0; j < a.size(); ++j) half[j] = 0.5 * (a[j] + b[j]);
  return half;
}

// A cylinder of this diameter between the fingers of the preshape, across the plane in which they
// close.
PlacedMesh cylinder_between(const Hand& hand, const Preshape& preshape, double diameter) {
  Matrix3 R_HM;
  R_HM << hand.approach, hand.closing, hand.approach.cross(hand.closing);
  Pose X_HM = translation(hand.origin + std::max(preshape.depth, 0.5 * diameter) * hand.approach);
  X_HM.linear() = R_HM;
  return {make_cylinder(0.5 * diameter, 2.0 * diameter), X_HM};
}

// The hand that closes from the preshape, on the body or on what is far from it.
ClosedHand closed_on(const Robot& robot, const Preshape& preshape, const PlacedMesh& body,
                     const RunContext& context) {
  Scene scene;
  scene.name = robot.name;
  scene.hand = robot;
  scene.object = make_graspable("cylinder", body.mesh, Material::plastic);
  const CompiledScene compiled = compile(std::move(scene), context);
  ClosingStart start;
  start.X_OH = body.X_BM.inverse();
  start.dofs = preshape.dofs;
  return close_hand(compiled, start, TrialOptions{}, context);
}

void add_closed(const Robot& robot, std::vector<NamedPosture>& postures,
                const RunContext& context) {
  const Preshape& open = robot.hand->preshapes.front();
  const double diameter = 0.5 * open.max_width;
  if (!(diameter > 0.0) || robot.hand->closing.norm() == 0.0) return;
  PlacedMesh cylinder = cylinder_between(*robot.hand, open, diameter);
  constexpr double kFarAway = 1e3;  // of the hand's width
  PlacedMesh far = cylinder;
  far.X_BM.translation() += kFarAway * open.max_width * robot.hand->approach;
  const ClosedHand closed = closed_on(robot, open, far, context);
  const std::vector<double> joints = joint_values(robot, open.dofs);
  postures.push_back({open.name + ", half closed", half_way(joints, closed.joints)});
  postures.push_back({open.name + ", closed", closed.joints});
  ClosedHand grasp = closed_on(robot, open, cylinder, context);
  if (grasp.joints == joints) return;
  postures.push_back({formatted("on a cylinder of %.0f mm", 1e3 * diameter),
                      std::move(grasp.joints), std::move(cylinder)});
}

}  // namespace

std::vector<NamedPosture> telling_postures(const Robot& robot, const RunContext& context) {
  constexpr std::size_t kMost = 3;
  std::vector<NamedPosture> postures;
  if (robot.hand) {
    for (const Preshape& preshape : robot.hand->preshapes) {
      if (postures.size() == kMost) break;
      postures.push_back({preshape.name, joint_values(robot, preshape.dofs)});
    }
  }
  if (postures.empty()) {
    postures.push_back({robot.name, joint_values(robot, initial_dofs(robot))});
  } else if (robot.hand->cups.empty()) {
    add_closed(robot, postures, context);
  }
  return postures;
}

}  // namespace prehend
