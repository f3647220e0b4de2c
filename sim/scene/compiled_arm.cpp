#include "sim/scene/compiled_arm.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/robot/inverse_kinematics.h"
#include "sim/scene/never_collide.h"
#include "sim/scene/scene.h"
#include "sim/scene/sunk_object.h"
#include "sim/shape/cover_shapes.h"
#include "sim/shape/proximity.h"

namespace prehend {
namespace {

// The cap of a gap query is this multiple of the distance asked for, plus kLeastCap [m]. It must be
// above the distance, with room for rounding; a larger cap would give the same answers and take
// longer.
constexpr double kCapBeyond = 1.01;
constexpr double kLeastCap = 1e-6;

// Adds to `pair` the joints that move link `a` relative to link `b` (without b: relative to the
// base). Joints on the common part of both paths move the links together and are left out.
void add_motion(const CompiledLink& a, const CompiledLink* b, ArmPair& pair) {
  const std::size_t shared = b != nullptr ? shared_joints(a, *b) : 0;
  const auto add = [&](const CompiledLink& link) {
    pair.joints.insert(pair.joints.end(), link.joints.begin() + static_cast<std::ptrdiff_t>(shared),
                       link.joints.end());
    pair.reach.insert(pair.reach.end(), link.reach.begin() + static_cast<std::ptrdiff_t>(shared),
                      link.reach.end());
  };
  add(a);
  if (b != nullptr) add(*b);
}

// Pairs of links, without those that are proven to stay apart.
void find_link_pairs(CompiledArm& arm) {
  for (const LinkPair& links : collision_pairs(arm.links, arm.robot())) {
    if (arm.is_hand_link(links.a) && arm.is_hand_link(links.b)) continue;
    ArmPair pair = arm_pair(arm, links.a, links.b);
    if (!never_collide(arm, pair)) arm.arm_pairs.push_back(std::move(pair));
  }
}

// Whether a pair has to be checked of which so much is known already.
using IsChecked = std::function<bool(const ArmPair& pair)>;

// Pairs of links with bodies, behind those of links.
void find_body_pairs(CompiledArm& arm, const IsChecked& is_checked) {
  std::vector<Pose> X_BL;
  arm_link_poses(arm, joint_values(arm.robot(), arm.start), X_BL);
  const auto is_screwed_to = [&](std::size_t l, std::size_t b) {
    if (!arm.links[l].joints.empty() || BodyId::at(b).is_object()) return false;
    PlacedBody body = arm.bodies[b];
    body.X_RB = X_BL[l].inverse() * body.X_RB;
    const Matrix3 R_WL = arm.X_WB.linear() * X_BL[l].linear();
    return stands_in(arm.links[l], body, R_WL.transpose() * Vector3::UnitZ());
  };
  for (std::size_t l = 0; l < arm.links.size(); ++l) {
    for (std::size_t b = 0; b < arm.bodies.size(); ++b) {
      if (is_screwed_to(l, b)) continue;
      ArmPair pair = arm_pair(arm, link_id(l), BodyId::at(b));
      // The hand is meant to come near the object and what it stands on: a proof that it stays
      // away in all postures would fail, at some cost.
      if (arm.is_hand_link(pair.link)) {
        arm.hand_pairs.push_back(std::move(pair));
      } else if (is_checked(pair)) {
        arm.arm_pairs.push_back(std::move(pair));
      }
    }
  }
}

// Throws InputError for a start posture outside the limits or with a collision.
void check_start(const Scene& scene, const CompiledArm& arm) {
  const Robot& robot = arm.robot();
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    if (arm.start[d] >= robot.dofs[d].lower && arm.start[d] <= robot.dofs[d].upper) continue;
    throw InputError({scene.name, "robot.start." + robot.dofs[d].name,
                      "outside the limits " + std::to_string(robot.dofs[d].lower) + " to " +
                          std::to_string(robot.dofs[d].upper),
                      std::to_string(arm.start[d])});
  }
  std::vector<Pose> X_BL;
  arm_link_poses(arm, joint_values(robot, arm.start), X_BL);
  for (const auto* pairs : {&arm.arm_pairs, &arm.hand_pairs}) {
    for (const ArmPair& pair : *pairs) {
      if (!pair_meets(arm, pair, X_BL)) continue;
      throw InputError({scene.name, "robot.start",
                        first_name(arm, pair) + " collides with " + second_name(arm, pair)});
    }
  }
}

// The second body of a pair and its pose.
struct OtherBody {
  const CollisionBody& body;
  const Pose& X_BF;
};

OtherBody other_of(const CompiledArm& arm, const ArmPair& pair, const std::vector<Pose>& X_BL) {
  if (const LinkId* link = std::get_if<LinkId>(&pair.other)) {
    return {arm.links[index(*link)], X_BL[index(*link)]};
  }
  const PlacedBody& body = arm.body(std::get<BodyId>(pair.other));
  return {body, body.X_RB};
}

}  // namespace

bool CompiledArm::is_hand_link(LinkId link) const {
  const int in_hand = static_cast<int>(link) - hand_part().first_link;
  return in_hand >= 0 && in_hand < hand_link_count;
}

CompiledArm compile_arm(const Scene& scene, std::vector<PlacedBody> bodies) {
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
  arm.bodies = std::move(bodies);
  for (const CompiledLink& link : arm.links) cover_of(link.mesh);
  find_link_pairs(arm);
  find_body_pairs(arm, [&](const ArmPair& pair) { return !never_collide(arm, pair); });
  check_start(scene, arm);
  return arm;
}

void move_bodies(const Scene& scene, std::vector<PlacedBody> bodies, const std::vector<bool>& moved,
                 CompiledArm& arm) {
  arm.X_BO = arm.X_WB.inverse() * scene.object.X_WO;
  arm.bodies = std::move(bodies);
  std::vector<ArmPair> before = std::move(arm.arm_pairs);
  arm.arm_pairs.clear();
  arm.hand_pairs.clear();
  std::vector<std::vector<bool>> was_checked(arm.links.size(), std::vector<bool>(moved.size()));
  for (ArmPair& pair : before) {
    if (const auto* body = std::get_if<BodyId>(&pair.other)) {
      was_checked[index(pair.link)][index(*body)] = true;
    } else {
      arm.arm_pairs.push_back(std::move(pair));
    }
  }
  find_body_pairs(arm, [&](const ArmPair& pair) {
    const std::size_t body = index(std::get<BodyId>(pair.other));
    return moved[body] ? !never_collide(arm, pair) : was_checked[index(pair.link)][body];
  });
  check_start(scene, arm);
}

ArmPair arm_pair(const CompiledArm& arm, LinkId link, const std::variant<LinkId, BodyId>& other) {
  ArmPair pair{.link = link, .other = other};
  const LinkId* second = std::get_if<LinkId>(&other);
  add_motion(arm.links[index(link)], second != nullptr ? &arm.links[index(*second)] : nullptr,
             pair);
  return pair;
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
                     double distance, double relative_error) {
  return find_gap_beyond(arm, pair, X_BL, distance, relative_error, {}).answer;
}

GapBeyond find_gap_beyond(const CompiledArm& arm, const ArmPair& pair,
                          const std::vector<Pose>& X_BL, double distance, double relative_error,
                          const TrianglePair& hint) {
  const CompiledLink& link = arm.links[index(pair.link)];
  const Pose& X = X_BL[index(pair.link)];
  const auto [other, X_BF] = other_of(arm, pair, X_BL);
  // The gap of the bounding balls is a lower bound of the gap and settles most queries.
  const double apart = (X * link.mesh.ball_center() - X_BF * other.mesh.ball_center()).norm();
  const double of_balls = apart - link.mesh.ball_radius() - other.mesh.ball_radius();
  if (of_balls > distance) return {GapAnswer::larger, of_balls, {}};
  // The cap is a little beyond the distance: a gap that reaches the cap is then proven to be larger
  // than the distance.
  const GapOptions options{
      .cap = kCapBeyond * distance + kLeastCap, .relative_error = relative_error, .hint = hint};
  const Gap gap = find_gap(other.mesh, link.mesh, X_BF.inverse() * X, options);
  if (gap.lower > distance) return {GapAnswer::larger, gap.lower, gap.pair};
  return {gap.lower <= 0.0 ? GapAnswer::meets : GapAnswer::not_proven, gap.lower, gap.pair};
}

bool pair_meets(const CompiledArm& arm, const ArmPair& pair, const std::vector<Pose>& X_BL) {
  const auto [other, X_BF] = other_of(arm, pair, X_BL);
  const Pose X_FL = X_BF.inverse() * X_BL[index(pair.link)];
  return bodies_overlap(other, arm.links[index(pair.link)], X_FL);
}

std::string first_name(const CompiledArm& arm, const ArmPair& pair) {
  return arm.links[index(pair.link)].name;
}

std::string second_name(const CompiledArm& arm, const ArmPair& pair) {
  const LinkId* link = std::get_if<LinkId>(&pair.other);
  return link != nullptr ? arm.links[index(*link)].name
                         : arm.body(std::get<BodyId>(pair.other)).name;
}

}  // namespace prehend
