// No point leaves its place farther than the bound says, in random trees with joints that turn and
// slide.
#include "sim/scene/motion_bound.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "sim/base/random.h"
#include "sim/scene/compiled_arm.h"
#include "tests/support/scenes.h"
#include "tests/support/trees.h"

namespace prehend {
namespace {

using Motion = MotionBound::Motion;

CompiledArm arm_of(Random& random) {
  CompiledArm arm;
  arm.platform.robot = test::random_tree(random, 5);
  arm.links = compile_links(test::scene_with(arm.robot(), make_box({0.1, 0.1, 0.1})), arm.robot());
  return arm;
}

// All pairs of two links, and each link against something that does not move.
std::vector<ArmPair> pairs_of_tree(const CompiledArm& arm) {
  std::vector<ArmPair> pairs;
  for (std::size_t a = 0; a < arm.links.size(); ++a) {
    pairs.push_back(arm_pair(arm, link_id(a), BodyId::object()));
    for (std::size_t b = 0; b < a; ++b) pairs.push_back(arm_pair(arm, link_id(a), link_id(b)));
  }
  return pairs;
}

// Farthest that a vertex of the link is from where it was, in the frame after its joint number
// `shared` from the base.
double moved(const CompiledArm& arm, LinkId link, std::size_t shared, const RobotPoses& before,
             const RobotPoses& after) {
  const CompiledLink& of = arm.links[index(link)];
  const auto pose = [&](const RobotPoses& poses) -> Pose {
    const Pose& X_BL = poses.X_BL[index(link)];
    return shared == 0 ? X_BL : poses.X_BJ[index(of.joints[shared - 1])].inverse() * X_BL;
  };
  const Pose X_before = pose(before);
  const Pose X_after = pose(after);
  double most = 0.0;
  for (const Vector3& p : of.mesh.mesh().vertices)
    most = std::max(most, (X_after * p - X_before * p).norm());
  return most;
}

double moved(const CompiledArm& arm, const ArmPair& pair, const RobotPoses& before,
             const RobotPoses& after) {
  const auto* other = std::get_if<LinkId>(&pair.other);
  if (other == nullptr) return moved(arm, pair.link, 0, before, after);
  const std::size_t shared = shared_joints(arm.links[index(pair.link)], arm.links[index(*other)]);
  return moved(arm, pair.link, shared, before, after) + moved(arm, *other, shared, before, after);
}

// By the reach of the links alone, in whatever posture.
double by_reach(const ArmPair& pair, const std::vector<double>& turns) {
  double sum = 0.0;
  for (std::size_t k = 0; k < pair.joints.size(); ++k)
    sum += pair.reach[k] * std::abs(turns[index(pair.joints[k])]);
  return sum;
}

struct Shares {
  double nearest = 0.0;  // largest of a motion over its bound
  double tighter = 0.0;  // sums of the bounds, and of those by reach
  double reach = 0.0;
};

Shares shares_of(Motion motion) {
  Random random(907);
  Shares shares;
  for (int i = 0; i < 400; ++i) {
    const CompiledArm arm = arm_of(random);
    const std::vector<double> posture = test::random_posture(arm.robot(), random);
    RobotPoses poses;
    robot_poses(arm.robot(), posture, poses);
    const double size = std::pow(10.0, random.uniform(-3.0, 0.0));
    std::vector<double> turns(posture.size());
    for (std::size_t j = 0; j < turns.size(); ++j) {
      const Joint& joint = arm.robot().joints[j];
      const double most = std::min(joint.upper - posture[j], posture[j] - joint.lower);
      const double turn = size * random.uniform(-1.0, 1.0);
      turns[j] = std::clamp(turn, -most, most);
    }
    // Of motions that are no line the bound has the sizes only.
    std::vector<double> sizes = turns;
    if (motion == Motion::any) {
      for (double& turn : sizes) turn = std::abs(turn);
    }
    MotionBound bound(arm);
    bound.set(poses, sizes, motion);
    for (const ArmPair& pair : pairs_of_tree(arm)) {
      const double most = bound.farthest(pair);
      shares.tighter += most;
      shares.reach += by_reach(pair, turns);
      EXPECT_LE(most, by_reach(pair, turns) * (1.0 + 1e-12));
      for (int k = 0; k < 8; ++k) {
        const double part = k == 0 ? 1.0 : random.uniform(-1.0, 1.0);
        std::vector<double> there = posture;
        for (std::size_t j = 0; j < there.size(); ++j) {
          const double own = motion == Motion::line ? part : random.uniform(-1.0, 1.0);
          there[j] += own * turns[j];
        }
        RobotPoses after;
        robot_poses(arm.robot(), there, after);
        const double way = moved(arm, pair, poses, after);
        EXPECT_LE(way, most * (1.0 + 1e-9) + 1e-14) << i;
        if (most > 0.0) shares.nearest = std::max(shares.nearest, way / most);
      }
    }
  }
  return shares;
}

TEST(MotionBound, HoldsForAllMotions) {
  const Shares shares = shares_of(Motion::any);
  EXPECT_GT(shares.nearest, 0.9);
  EXPECT_LT(shares.tighter, 0.9 * shares.reach);
}

TEST(MotionBound, HoldsOnLinesAndIsTighterThere) {
  const Shares shares = shares_of(Motion::line);
  EXPECT_GT(shares.nearest, 0.95);
  EXPECT_LT(shares.tighter, shares_of(Motion::any).tighter);
}

}  // namespace
}  // namespace prehend
