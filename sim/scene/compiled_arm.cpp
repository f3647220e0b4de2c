#include "sim/scene/compiled_arm.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/robot/inverse_kinematics.h"
#include "sim/scene/scene.h"
#include "sim/scene/stay_apart.h"

namespace prehend {
namespace {

constexpr double kCapBeyond = 1.01;
constexpr double kLeastCap = 1e-6;  // m

// What moves link `a` relative to link `b`, or to the base for no b: the joints that they do not
// share.
void add_motion(const CompiledLink& a, const CompiledLink* b, ArmPair& pair) {
  std::size_t shared = 0;
  if (b != nullptr) {
    while (shared < a.joints.size() && shared < b->joints.size() &&
           a.joints[shared] == b->joints[shared]) {
      ++shared;
    }
  }
  const auto add = [&](const CompiledLink& link) {
    pair.joints.insert(pair.joints.end(), link.joints.begin() + static_cast<std::ptrdiff_t>(shared),
                       link.joints.end());
    pair.reach.insert(pair.reach.end(), link.reach.begin() + static_cast<std::ptrdiff_t>(shared),
                      link.reach.end());
  };
  add(a);
  if (b != nullptr) add(*b);
}

void find_pairs(CompiledArm& arm) {
  for (const LinkPair& links : separate_pairs(arm.links)) {
    if (arm.is_hand_link(links.a) && arm.is_hand_link(links.b)) continue;
    ArmPair pair{.link = links.a, .other_link = links.b};
    add_motion(arm.links[index(links.a)], &arm.links[index(links.b)], pair);
    if (!stay_apart(arm, pair)) arm.arm_pairs.push_back(std::move(pair));
  }
  for (std::size_t l = 0; l < arm.links.size(); ++l) {
    const bool in_hand = arm.is_hand_link(static_cast<int>(l));
    for (std::size_t f = 0; f < arm.fixed.size(); ++f) {
      ArmPair pair{.link = static_cast<int>(l), .fixed = static_cast<int>(f)};
      add_motion(arm.links[l], nullptr, pair);
      // Hands are meant to come near.
      if (in_hand) {
        arm.hand_pairs.push_back(std::move(pair));
      } else if (!stay_apart(arm, pair)) {
        arm.arm_pairs.push_back(std::move(pair));
      }
    }
  }
}

void check_start(const Scene& scene, const CompiledArm& arm) {
  const Robot& robot = arm.robot();
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    if (arm.start[d] >= robot.dofs[d].lower && arm.start[d] <= robot.dofs[d].upper) continue;
    throw InputError(scene.name + ": robot.start." + robot.dofs[d].name + ": outside the limits " +
                     std::to_string(robot.dofs[d].lower) + " to " +
                     std::to_string(robot.dofs[d].upper) + " (" + std::to_string(arm.start[d]) +
                     ")");
  }
  std::vector<Pose> X_BL;
  arm_link_poses(arm, joint_values(robot, arm.start), X_BL);
  for (const auto* pairs : {&arm.arm_pairs, &arm.hand_pairs}) {
    for (const ArmPair& pair : *pairs) {
      if (!pair_meets(arm, pair, X_BL)) continue;
      throw InputError(scene.name + ": robot.start: " + first_name(arm, pair) + " collides with " +
                       second_name(arm, pair));
    }
  }
}

bool any_inside(const ProximityMesh& mesh, const std::vector<Vector3>& points, const Pose& X) {
  return std::any_of(points.begin(), points.end(),
                     [&](const Vector3& p) { return is_inside(mesh, X * p); });
}

// The second body of a pair.
struct Other {
  const ProximityMesh& mesh;
  Pose X_BF;
  const std::vector<Vector3>& probes;
  bool is_solid;
};

Other other_of(const CompiledArm& arm, const ArmPair& pair, const std::vector<Pose>& X_BL) {
  if (pair.other_link >= 0) {
    const CompiledLink& link = arm.links[index(pair.other_link)];
    return {link.mesh, X_BL[index(pair.other_link)], link.probes, true};
  }
  const FixedBody& body = arm.fixed[index(pair.fixed)];
  return {body.mesh, body.X_BF, body.probes, body.is_solid};
}

}  // namespace

bool CompiledArm::is_hand_link(int link) const {
  return link >= hand_part().first_link && link < hand_part().first_link + hand_link_count;
}

CompiledArm compile_arm(const Scene& scene, std::vector<FixedBody> fixed) {
  const Carrier& carrier = *scene.carrier;
  CompiledArm arm;
  arm.platform = assemble(carrier.platform);
  arm.hand = carrier.hand;
  arm.X_WB = carrier.X_WB;
  arm.X_BO = carrier.X_WB.inverse() * scene.object.X_WO;
  arm.dofs = dofs_to(arm.robot(), arm.hand_part().joint);
  arm.start = carrier.start;
  arm.links = compile_links(scene, arm.robot());
  arm.hand_link_count = static_cast<int>(scene.hand.links.size());
  arm.fixed = std::move(fixed);
  find_pairs(arm);
  check_start(scene, arm);
  return arm;
}

std::vector<double> arm_joints(const CompiledArm& arm, const std::vector<double>& dofs,
                               const std::vector<double>& hand_joints) {
  std::vector<double> joints = joint_values(arm.robot(), dofs);
  std::copy(hand_joints.begin(), hand_joints.end(), joints.begin() + arm.hand_part().first_joint);
  return joints;
}

void arm_link_poses(const CompiledArm& arm, const std::vector<double>& joints,
                    std::vector<Pose>& X_BL) {
  link_poses(arm.robot(), joints, X_BL);
}

GapAnswer gap_beyond(const CompiledArm& arm, const ArmPair& pair, const std::vector<Pose>& X_BL,
                     double distance) {
  const CompiledLink& link = arm.links[index(pair.link)];
  const Pose& X = X_BL[index(pair.link)];
  const Other other = other_of(arm, pair, X_BL);
  const double apart = (X * link.mesh.ball_center() - other.X_BF * other.mesh.ball_center()).norm();
  if (apart - link.mesh.ball_radius() - other.mesh.ball_radius() > distance) {
    return GapAnswer::larger;
  }
  // A little more than is asked, so that a gap at the cap is an answer.
  const GapOptions options{
      .cap = kCapBeyond * distance + kLeastCap, .relative_error = 0.5, .hint = {}};
  const Gap gap = find_gap(other.mesh, link.mesh, other.X_BF.inverse() * X, options);
  if (gap.lower > distance) return GapAnswer::larger;
  return gap.lower <= 0.0 ? GapAnswer::meets : GapAnswer::not_proven;
}

bool pair_meets(const CompiledArm& arm, const ArmPair& pair, const std::vector<Pose>& X_BL) {
  const CompiledLink& link = arm.links[index(pair.link)];
  const Pose& X = X_BL[index(pair.link)];
  const Other other = other_of(arm, pair, X_BL);
  const double apart = (X * link.mesh.ball_center() - other.X_BF * other.mesh.ball_center()).norm();
  if (apart > link.mesh.ball_radius() + other.mesh.ball_radius()) return false;
  const Pose X_FL = other.X_BF.inverse() * X;
  if (surfaces_cross(other.mesh, link.mesh, X_FL)) return true;
  if (other.is_solid && any_inside(other.mesh, link.probes, X_FL)) return true;
  return any_inside(link.mesh, other.probes, X_FL.inverse());
}

std::string first_name(const CompiledArm& arm, const ArmPair& pair) {
  return arm.links[index(pair.link)].name;
}

std::string second_name(const CompiledArm& arm, const ArmPair& pair) {
  return pair.other_link >= 0 ? arm.links[index(pair.other_link)].name
                              : arm.fixed[index(pair.fixed)].name;
}

}  // namespace prehend
