// How far joints move links, and which links are tested against each other, in trees.
#include "sim/scene/compiled_link.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "tests/support/scenes.h"
#include "tests/support/trees.h"

namespace prehend {
namespace {

std::vector<CompiledLink> compiled_links(const Robot& robot) {
  return compile_links(test::scene_with(robot, make_box({0.1, 0.1, 0.1})), robot);
}

// Farthest vertex of the link from the joint's axis, or 1 for a slide.
double distance_from_axis(const Robot& robot, const std::vector<Pose>& X_BJ, const Link& link,
                          int j) {
  const Joint& joint = robot.joints[index(j)];
  if (joint.type == JointType::prismatic) return 1.0;
  const Pose X_BF = (joint.parent < 0 ? Pose::Identity() : X_BJ[index(joint.parent)]) * joint.X_PJ;
  double farthest = 0.0;
  for (const Vector3& p : link.mesh.vertices) {
    const Vector3 q = X_BF.inverse() * X_BJ[index(link.joint)] * p;
    farthest = std::max(farthest, (q - joint.axis.dot(q) * joint.axis).norm());
  }
  return farthest;
}

TEST(CompiledLink, NoPostureTakesALinkBeyondItsReach) {
  Random random(331);
  double nearest = 0.0;
  for (int i = 0; i < 40; ++i) {
    const Robot robot = test::random_tree(random, 5);
    const std::vector<CompiledLink> links = compiled_links(robot);
    for (int k = 0; k < 100; ++k) {
      std::vector<Pose> X_BJ;
      joint_poses(robot, test::random_posture(robot, random), X_BJ);
      for (std::size_t l = 1; l < links.size(); ++l) {
        ASSERT_EQ(links[l].joints, joints_to(robot, robot.links[l].joint));
        for (std::size_t n = 0; n < links[l].joints.size(); ++n) {
          const double found = distance_from_axis(robot, X_BJ, robot.links[l], links[l].joints[n]);
          ASSERT_LE(found, links[l].reach[n] * (1.0 + 1e-12)) << i << " " << l << " " << n;
          if (n + 2 == links[l].joints.size())
            nearest = std::max(nearest, found / links[l].reach[n]);
        }
      }
    }
  }
  EXPECT_GT(nearest, 0.9) << "the bound is near what is reached";
}

TEST(CompiledLink, OfTheLastJointTheReachIsExact) {
  Random random(332);
  for (int i = 0; i < 40; ++i) {
    const Robot robot = test::random_tree(random, 3);
    std::vector<Pose> X_BJ;
    joint_poses(robot, test::random_posture(robot, random), X_BJ);
    const std::vector<CompiledLink> links = compiled_links(robot);
    for (std::size_t l = 1; l < links.size(); ++l) {
      const double found = distance_from_axis(robot, X_BJ, robot.links[l], links[l].joints.back());
      EXPECT_NEAR(links[l].reach.back(), found, 1e-12);
    }
  }
}

// A point moves no farther than the reaches of the joints times their motions.
TEST(CompiledLink, ReachBoundsTheMotionOfEveryVertex) {
  Random random(333);
  for (int i = 0; i < 40; ++i) {
    const Robot robot = test::random_tree(random, 5);
    const std::vector<CompiledLink> links = compiled_links(robot);
    const std::vector<double> from = test::random_posture(robot, random);
    const std::vector<double> to = test::random_posture(robot, random);
    std::vector<Pose> X_from;
    std::vector<Pose> X_to;
    link_poses(robot, from, X_from);
    link_poses(robot, to, X_to);
    for (std::size_t l = 0; l < links.size(); ++l) {
      double bound = 0.0;
      for (std::size_t n = 0; n < links[l].joints.size(); ++n) {
        const std::size_t j = index(links[l].joints[n]);
        bound += links[l].reach[n] * std::abs(to[j] - from[j]);
      }
      for (const Vector3& p : robot.links[l].mesh.vertices) {
        EXPECT_LE((X_to[l] * p - X_from[l] * p).norm(), bound + 1e-12);
      }
    }
  }
}

std::set<std::string> untested_pairs(const Robot& robot) {
  const std::vector<CompiledLink> links = compiled_links(robot);
  std::set<std::string> untested;
  for (std::size_t a = 0; a < links.size(); ++a) {
    for (std::size_t b = a + 1; b < links.size(); ++b) {
      untested.insert(links[a].name + " " + links[b].name);
    }
  }
  for (const LinkPair& pair : collision_pairs(links, robot)) {
    untested.erase(links[index(pair.a)].name + " " + links[index(pair.b)].name);
  }
  return untested;
}

TEST(SeparatePairs, BranchesAreTestedAgainstEachOther) {
  EXPECT_EQ(untested_pairs(test::branching_hand()),
            (std::set<std::string>{"palm stem", "stem upper", "stem lower", "upper nail_a",
                                   "upper nail_b"}));
}

TEST(SeparatePairs, JointsWithoutALinkAreNoNeighbours) {
  Robot robot = test::branching_hand();
  robot.links.erase(robot.links.begin() + 1);  // the stem: now the palm carries both branches
  EXPECT_EQ(untested_pairs(robot),
            (std::set<std::string>{"palm upper", "palm lower", "upper nail_a", "upper nail_b"}));
}

TEST(CompiledLink, RefusesJointsThatAreNoTree) {
  Robot robot = test::branching_hand();
  robot.joints[1].parent = 2;
  try {
    compiled_links(robot);
    FAIL() << "no complaint";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "branching: joint upper: must stand after its parent joint");
  }
}

}  // namespace
}  // namespace prehend
