#include "sim/quality/wrench_hull.h"

#include <limits>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "tests/sim/quality/known_sets.h"
#include "tests/support/grasp_families.h"

namespace prehend::test {
namespace {

TEST(WrenchHull, KnownSets) {
  for (const KnownSet& set : known_sets()) {
    const WrenchHull hull = wrench_hull(set.wrenches);
    const double scale = set.wrenches.cwiseAbs().maxCoeff();
    EXPECT_EQ(hull.status, HullStatus::solid) << set.name;
    EXPECT_NEAR(hull.min_offset, set.epsilon, 1e-9 * std::abs(set.epsilon) + 1e-13 * scale)
        << set.name;
    EXPECT_NEAR(hull.volume, set.volume, 1e-9 * set.volume) << set.name;
    EXPECT_EQ(hull.force_closure(), set.epsilon > 0.0) << set.name;
    EXPECT_NEAR(hull.weakest.norm(), std::abs(hull.min_offset), 1e-12 * scale) << set.name;
  }
}

TEST(WrenchHull, OriginOnTheBorderIsNoForceClosure) {
  EXPECT_FALSE(wrench_hull(moved(box(Wrench::Ones()), 1.0).wrenches).force_closure());
}

TEST(WrenchHull, WeakestPointsIntoTheNearestFacet) {
  const WrenchHull hull = wrench_hull(moved(box(Wrench::Ones()), 0.25).wrenches);
  EXPECT_NEAR((hull.weakest - 0.75 * Wrench::Unit(0)).norm(), 0.0, 1e-12);
}

// The facets are those of the wrenches as they are, whatever their size.
TEST(WrenchHull, FacetsBoundTheWrenches) {
  for (const double size : {1.0, 1e80, 1e-80}) {
    const Wrenches wrenches = size * simplex().wrenches;
    const PointHull hull = wrench_hull(wrenches).points;
    ASSERT_EQ(hull.status, PointHullStatus::solid);
    ASSERT_EQ(hull.offsets.size(), 7);
    for (Eigen::Index f = 0; f < 7; ++f) {
      EXPECT_NEAR(hull.normals.col(f).norm(), 1.0, 1e-12);
      for (Eigen::Index i = 0; i < 7; ++i) {
        const bool corner = (hull.corners.col(f).array() == static_cast<int>(i)).any();
        const double slack = hull.offsets[f] - hull.normals.col(f).dot(wrenches.col(i));
        EXPECT_GE(slack, corner ? -1e-12 * size : 0.1 * size);
        if (corner) {
          EXPECT_LE(slack, 1e-12 * size);
        }
      }
    }
  }
  EXPECT_EQ(wrench_hull(Wrenches::Identity(6, 6)).points.status, PointHullStatus::flat);
}

TEST(WrenchHull, FlatInputs) {
  EXPECT_EQ(wrench_hull(Wrenches(6, 0)).status, HullStatus::flat);
  EXPECT_EQ(wrench_hull(Wrenches::Zero(6, 12)).status, HullStatus::flat);
  EXPECT_EQ(wrench_hull(Wrenches::Identity(6, 6)).status, HullStatus::flat);
  EXPECT_EQ(wrench_hull(contact_wrenches(ring_grasp(2, 0.5), {})).status, HullStatus::flat);
  const WrenchHull hull = wrench_hull(contact_wrenches(octahedron_grasp(0.0), {}));
  EXPECT_EQ(hull.status, HullStatus::flat);
  EXPECT_EQ(hull.volume, 0.0);
  EXPECT_FALSE(hull.force_closure());
}

TEST(WrenchHull, RejectsNonFinite) {
  Wrenches wrenches = box(Wrench::Ones()).wrenches;
  wrenches(0, 3) = std::numeric_limits<double>::quiet_NaN();
  try {
    wrench_hull(wrenches);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "wrenches[3]: not finite");
  }
}

TEST(WrenchHull, IsSilent) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  for (const NamedGrasp& grasp : grasp_families(13, 2)) {
    wrench_hull(contact_wrenches(grasp.contacts, {}, grasp.edges));
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(WrenchHull, SameInParallel) {
  std::vector<Wrenches> inputs;
  for (const NamedGrasp& grasp : grasp_families(14, 2)) {
    inputs.push_back(contact_wrenches(grasp.contacts, {}, grasp.edges));
  }
  std::vector<WrenchHull> serial;
  for (const Wrenches& wrenches : inputs) serial.push_back(wrench_hull(wrenches));
  std::vector<std::vector<WrenchHull>> parallel(4);
  std::vector<std::thread> threads;
  for (std::vector<WrenchHull>& hulls : parallel) {
    threads.emplace_back([&] {
      for (const Wrenches& wrenches : inputs) hulls.push_back(wrench_hull(wrenches));
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<WrenchHull>& hulls : parallel) {
    ASSERT_EQ(hulls.size(), serial.size());
    for (std::size_t i = 0; i < serial.size(); ++i) {
      EXPECT_EQ(hulls[i].status, serial[i].status);
      EXPECT_EQ(hulls[i].min_offset, serial[i].min_offset);
      EXPECT_EQ(hulls[i].volume, serial[i].volume);
    }
  }
}

}  // namespace
}  // namespace prehend::test
