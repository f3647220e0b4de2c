// What is called free is looked at in steps of half a millimetre; what is called blocked must come
// close to something.
#include "sim/scene/reach/motion_check.h"

#include <iostream>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "tests/sim/scene/reach/arm_among_boxes.h"

namespace prehend {
namespace {

using test::Motion;

// No point moves more than this from one posture to the next.
constexpr double kStep = 5e-4;

void expect_free(const CompiledArm& arm, const std::vector<ArmPair>& pairs, const Motion& motion) {
  const int parts = motion.parts(kStep);
  std::vector<Pose> before = motion.at(0.0);
  for (int i = 0; i <= parts; ++i) {
    const std::vector<Pose> X_BL = motion.at(static_cast<double>(i) / parts);
    ASSERT_LE(motion.apart(before, X_BL), kStep);
    for (const ArmPair& pair : pairs) {
      ASSERT_FALSE(test::crosses(arm, pair, X_BL))
          << first_name(arm, pair) << " meets " << second_name(arm, pair) << " at " << i << " of "
          << parts;
    }
    before = X_BL;
  }
}

// Smallest gap of a pair along the motion: in steps of half a millimetre, and in far smaller ones
// around each that may be next to the smallest.
double smallest_gap(const CompiledArm& arm, const ArmPair& pair, const Motion& motion) {
  constexpr int kFiner = 50;
  const int parts = motion.parts(kStep);
  std::vector<double> gaps;
  for (int i = 0; i <= parts; ++i) {
    gaps.push_back(test::gap_of(arm, pair, motion.at(static_cast<double>(i) / parts)));
    if (gaps.back() == 0.0) return 0.0;
  }
  double least = *std::min_element(gaps.begin(), gaps.end());
  const double near = least + 2.0 * kStep;
  for (int i = 0; i < parts; ++i) {
    if (std::min(gaps[index(i)], gaps[index(i + 1)]) > near) continue;
    for (int k = 1; k < kFiner; ++k) {
      const double part = (i + static_cast<double>(k) / kFiner) / parts;
      least = std::min(least, test::gap_of(arm, pair, motion.at(part)));
    }
  }
  return least;
}

// A posture that meets nothing.
std::vector<double> free_dofs(const CompiledArm& arm, const std::vector<ArmPair>& pairs,
                              Random& random) {
  while (true) {
    std::vector<double> dofs = test::random_dofs(arm.robot(), random);
    if (!first_meeting(arm, pairs, joint_values(arm.robot(), dofs))) return dofs;
  }
}

TEST(MotionCheck, FreeMotionsAreFreeAndBlockedOnesComeClose) {
  Random random(81);
  const MotionCheckOptions options;
  int free = 0;
  int blocked = 0;
  for (int scene_number = 0; scene_number < 10; ++scene_number) {
    const CompiledScene scene = test::among_random_boxes(random, 8);
    const CompiledArm& arm = *scene.arm;
    const std::vector<ArmPair> pairs = test::pairs_of(arm);
    for (int i = 0; i < 24; ++i) {
      SCOPED_TRACE("scene " + std::to_string(scene_number) + ", motion " + std::to_string(i));
      const std::vector<double> from = free_dofs(arm, pairs, random);
      std::vector<double> to = test::random_dofs(arm.robot(), random);
      const double length = random.uniform(0.02, 0.3);
      for (std::size_t d = 0; d < to.size(); ++d) to[d] = from[d] + length * (to[d] - from[d]);
      const Motion motion(arm, joint_values(arm.robot(), from), joint_values(arm.robot(), to));
      if (const auto pair = first_blocked(arm, pairs, motion.path(), options)) {
        ++blocked;
        EXPECT_LT(smallest_gap(arm, *pair, motion), options.tightest)
            << first_name(arm, *pair) << " and " << second_name(arm, *pair);
      } else {
        ++free;
        expect_free(arm, pairs, motion);
      }
      if (HasFailure()) return;
    }
  }
  std::cout << free << " motions free, " << blocked << " blocked\n";
  EXPECT_GE(free + blocked, 200);
  EXPECT_GE(5 * free, free + blocked);
  EXPECT_GE(5 * blocked, free + blocked);
}

TEST(MotionCheck, APathIsFreeWhenEachOfItsStretchesIs) {
  Random random(82);
  const CompiledScene scene = test::among_random_boxes(random, 4);
  const CompiledArm& arm = *scene.arm;
  const std::vector<ArmPair> pairs = test::pairs_of(arm);
  int free = 0;
  for (int i = 0; i < 60; ++i) {
    JointPath path = {joint_values(arm.robot(), free_dofs(arm, pairs, random))};
    const std::size_t stretches = 1 + random.index(5);
    for (std::size_t k = 0; k < stretches; ++k) {
      const auto next = joint_values(arm.robot(), test::random_dofs(arm.robot(), random));
      path.push_back(path.back());
      for (std::size_t j = 0; j < next.size(); ++j) {
        path.back()[j] += 0.05 * (next[j] - path.back()[j]);
      }
    }
    bool each = true;
    for (std::size_t k = 1; k < path.size(); ++k) {
      each = each && !first_blocked(arm, pairs, {path[k - 1], path[k]});
    }
    EXPECT_EQ(!first_blocked(arm, pairs, path), each) << i;
    free += each ? 1 : 0;
  }
  EXPECT_GE(free, 12);
  EXPECT_LE(free, 48);
}

TEST(MotionCheck, NoMotionIsFree) {
  Random random(83);
  const CompiledScene scene = test::among_random_boxes(random, 2);
  const CompiledArm& arm = *scene.arm;
  const auto joints = joint_values(arm.robot(), arm.start);
  EXPECT_FALSE(first_blocked(arm, test::pairs_of(arm), {joints}));
  EXPECT_FALSE(first_blocked(arm, test::pairs_of(arm), {joints, joints, joints}));
  EXPECT_FALSE(first_blocked(arm, test::pairs_of(arm), {}));
  EXPECT_FALSE(first_blocked(arm, {}, {joints, joints}));
}

// The stretched arm turns one joint, in both directions from where the wrist is bent a little.
Motion sweep(const CompiledArm& arm, std::size_t dof) {
  std::vector<double> from(arm.robot().dofs.size(), 0.0);
  from[4] = 0.1;
  std::vector<double> to = from;
  from[dof] -= 0.8;
  to[dof] += 0.8;
  return {arm, joint_values(arm.robot(), from), joint_values(arm.robot(), to)};
}

// A frame at the vertex that moves fastest: x away from the centre of its circle, y the way it
// goes.
Pose at_the_fastest(const CompiledArm& arm, const Motion& motion, double part) {
  constexpr double kShort = 1e-3;
  const auto before = motion.at(part - kShort);
  const auto here = motion.at(part);
  const auto after = motion.at(part + kShort);
  double fastest = 0.0;
  Pose X = Pose::Identity();
  for (std::size_t l = 0; l < arm.links.size(); ++l) {
    for (const Vector3& v : arm.links[l].mesh.mesh().vertices) {
      const Vector3 way = after[l] * v - before[l] * v;
      if (way.norm() <= fastest) continue;
      fastest = way.norm();
      const Vector3 p = here[l] * v;
      const Vector3 outward = (2.0 * p - before[l] * v - after[l] * v).normalized();
      X.translation() = p;
      X.linear() << outward, way.normalized(), outward.cross(way.normalized());
    }
  }
  return X;
}

// The outermost point of the moving arm goes through a plate of 0.2 mm, between two postures of a
// look every `step`. It is 2 mm inside the plate.
void expect_plate_seen(std::size_t dof, double step) {
  const CompiledScene empty = compile(test::arm_scene({}));
  const Motion in_the_open = sweep(*empty.arm, dof);
  ASSERT_FALSE(first_blocked(*empty.arm, test::pairs_of(*empty.arm), in_the_open.path()));
  const int coarse = in_the_open.parts(step);
  const Pose X_BP = at_the_fastest(*empty.arm, in_the_open, (coarse / 2 + 0.5) / coarse);
  const Pose X_plate = X_BP * translation(Vector3(0.003, 0.0, 0.0));
  const CompiledScene scene =
      compile(test::arm_scene({test::box("plate", {0.01, 2e-4, 0.01}, X_plate)}));
  const CompiledArm& arm = *scene.arm;
  const std::vector<ArmPair> pairs = test::pairs_of(arm);
  const Motion motion = sweep(arm, dof);
  for (int i = 0; i <= coarse; ++i) {
    const auto X_BL = motion.at(static_cast<double>(i) / coarse);
    for (const ArmPair& pair : pairs) {
      ASSERT_FALSE(test::crosses(arm, pair, X_BL)) << "a coarse look sees it";
    }
  }
  const auto blocked = first_blocked(arm, pairs, motion.path());
  ASSERT_TRUE(blocked.has_value());
  EXPECT_EQ(second_name(arm, *blocked), "plate");
}

TEST(MotionCheck, AThinPlateInTheWayOfTheTurningArmIsSeen) { expect_plate_seen(0, 0.05); }
// Only the ends are free here.
TEST(MotionCheck, AThinPlateInTheWayOfTheTurningWristIsSeen) { expect_plate_seen(4, 1.0); }

}  // namespace
}  // namespace prehend
