// Sets of grasps for tests: random ones with everything that a set can hold, and whether two are
// the same to the bit.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "planner/results/datasets/grasp_set.h"
#include "sim/base/random.h"

namespace prehend::test {

inline Pose random_pose(Random& random) { return random.pose(0.3); }

inline std::optional<ObjectShift> random_motion(Random& random, double known) {
  if (random.uniform(0.0, 1.0) >= known) return {};
  return ObjectShift{random.uniform(0.0, 0.1), random.uniform(0.0, 3.0)};
}

inline GraspSetEntry random_entry(Random& random, const GraspSet& set, double known) {
  GraspSetEntry grasp;
  grasp.X_OH = random_pose(random);
  grasp.X_OH_aim = random_pose(random);
  if (random.uniform(0.0, 1.0) < known) grasp.approach_O = random.direction();
  grasp.outcome = kAll<Outcome>.at(random.index(kAll<Outcome>.size()));
  grasp.epsilon = {random.uniform(0.0, 0.1), random.uniform(0.1, 0.2)};
  for (std::size_t c = random.index(6); c > 0 && !set.links.empty(); --c) {
    grasp.contacts.push_back(
        {random.in_box(0.1), random.direction(), static_cast<int>(random.index(set.links.size()))});
  }
  if (random.uniform(0.0, 1.0) < known) {
    for (std::size_t j = 0; j < set.joints.size(); ++j) {
      grasp.joints.push_back(random.uniform(-1.0, 1.0));
    }
    for (std::size_t d = 0; d < set.dofs.size(); ++d) {
      grasp.dofs.push_back(random.uniform(-1.0, 1.0));
    }
    for (std::size_t f = 0; f < set.feature_names.size(); ++f) {
      grasp.features.push_back(static_cast<float>(random.uniform(-1e3, 1e3)));
    }
  }
  grasp.closing = random_motion(random, known);
  grasp.shaking = random_motion(random, known);
  return grasp;
}

// `known`: of what may be unknown of a grasp, the fraction that is known.
inline GraspSet random_set(Random& random, std::size_t grasps, double known = 0.7) {
  GraspSet set;
  set.object.file = "meshes/Mug/\xC3\xA4" + std::to_string(grasps) + ".obj";
  set.object.scale = random.uniform(1e-4, 2.0);
  set.object.density = random.uniform(10.0, 1000.0);
  set.object.friction = random.uniform(0.0, 2.0);
  set.object.mass = random.uniform(0.0, 2.0);
  set.object.volume = random.uniform(0.0, 1e-2);
  set.object.com_O = random.in_box(0.1);
  for (double& value : set.object.inertia.reshaped()) value = random.uniform(-1e-3, 1e-3);
  set.hand = "hand, \"quoted\"";
  if (random.index(2) == 0) set.configuration = random.uniform(0.01, 0.2);
  for (std::size_t d = random.index(5); d > 0; --d) set.dofs.push_back("dof " + std::to_string(d));
  for (std::size_t j = random.index(7); j > 0; --j)
    set.joints.push_back("joint " + std::to_string(j));
  for (std::size_t l = random.index(4); l > 0; --l) set.links.push_back("link" + std::to_string(l));
  for (std::size_t f = random.index(9); f > 0; --f) {
    set.feature_names.push_back("feature" + std::to_string(f));
  }
  set.version = random.index(2) == 0 ? "" : "prehend 0.1.0";
  set.settings = random.index(2) == 0 ? "" : R"({"seed": 1, "friction": 0.5})";
  for (std::size_t g = 0; g < grasps; ++g) set.grasps.push_back(random_entry(random, set, known));
  return set;
}

template <typename Matrix>
bool same_bits(const Matrix& a, const Matrix& b) {
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    const auto bits = [i](const Matrix& m) {
      return std::bit_cast<std::uint64_t>(m.derived().data()[i]);
    };
    if (bits(a) != bits(b)) return false;
  }
  return true;
}

inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

inline void expect_same(const std::optional<ObjectShift>& a, const std::optional<ObjectShift>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  EXPECT_TRUE(same_bits(a->linear, b->linear));
  EXPECT_TRUE(same_bits(a->angular, b->angular));
}

inline void expect_same(const GraspSetEntry& a, const GraspSetEntry& b) {
  EXPECT_TRUE(same_bits(a.X_OH.matrix(), b.X_OH.matrix()));
  EXPECT_TRUE(same_bits(a.X_OH_aim.matrix(), b.X_OH_aim.matrix()));
  EXPECT_TRUE(same_bits(a.approach_O, b.approach_O));
  EXPECT_EQ(a.outcome, b.outcome);
  EXPECT_TRUE(same_bits(a.epsilon.lower, b.epsilon.lower));
  EXPECT_TRUE(same_bits(a.epsilon.upper, b.epsilon.upper));
  EXPECT_EQ(a.dofs, b.dofs);
  EXPECT_EQ(a.joints, b.joints);
  EXPECT_EQ(a.features, b.features);
  expect_same(a.closing, b.closing);
  expect_same(a.shaking, b.shaking);
  ASSERT_EQ(a.contacts.size(), b.contacts.size());
  for (std::size_t c = 0; c < a.contacts.size(); ++c) {
    EXPECT_TRUE(same_bits(a.contacts[c].p_O, b.contacts[c].p_O));
    EXPECT_TRUE(same_bits(a.contacts[c].n_O, b.contacts[c].n_O));
    EXPECT_EQ(a.contacts[c].link, b.contacts[c].link);
  }
}

inline void expect_same(const GraspSet& a, const GraspSet& b) {
  EXPECT_EQ(a.object.file, b.object.file);
  EXPECT_TRUE(same_bits(a.object.scale, b.object.scale));
  EXPECT_TRUE(same_bits(a.object.density, b.object.density));
  EXPECT_TRUE(same_bits(a.object.friction, b.object.friction));
  EXPECT_TRUE(same_bits(a.object.mass, b.object.mass));
  EXPECT_TRUE(same_bits(a.object.volume, b.object.volume));
  EXPECT_TRUE(same_bits(a.object.com_O, b.object.com_O));
  EXPECT_TRUE(same_bits(a.object.inertia, b.object.inertia));
  EXPECT_EQ(a.hand, b.hand);
  EXPECT_EQ(a.configuration, b.configuration);
  EXPECT_EQ(a.dofs, b.dofs);
  EXPECT_EQ(a.joints, b.joints);
  EXPECT_EQ(a.links, b.links);
  EXPECT_EQ(a.feature_names, b.feature_names);
  EXPECT_EQ(a.version, b.version);
  EXPECT_EQ(a.settings, b.settings);
  ASSERT_EQ(a.grasps.size(), b.grasps.size());
  for (std::size_t g = 0; g < a.grasps.size(); ++g) {
    SCOPED_TRACE("grasp " + std::to_string(g));
    expect_same(a.grasps[g], b.grasps[g]);
  }
}

// A file of the running test with these bytes.
inline std::filesystem::path file_with(const std::string& bytes, const std::string& ending) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(test->test_suite_name()) + "." + test->name() + ending;
  std::replace(name.begin(), name.end(), '/', '_');
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / name;
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

}  // namespace prehend::test
