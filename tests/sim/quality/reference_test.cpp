// Wrenches, epsilon and volume against two other simulators' figures, where they are at hand.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/quality/epsilon.h"
#include "sim/quality/wrench_hull.h"
#include "tests/support/grasp_families.h"
#include "tests/support/shared_data.h"

namespace prehend::test {
namespace {

using nlohmann::json;

std::vector<json> read_folder(const std::string& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(shared(folder))) {
    if (entry.path().extension() == ".json") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<json> files;
  for (const auto& path : paths) files.push_back(json::parse(std::ifstream(path)));
  return files;
}

Eigen::Vector3d vector3(const json& values) {
  return {values.at(0).get<double>(), values.at(1).get<double>(), values.at(2).get<double>()};
}

Wrenches columns(const json& rows) {
  Wrenches wrenches(6, static_cast<Eigen::Index>(rows.size()));
  for (Eigen::Index j = 0; j < wrenches.cols(); ++j) {
    for (Eigen::Index i = 0; i < 6; ++i) {
      wrenches(i, j) = rows.at(static_cast<std::size_t>(j)).at(static_cast<std::size_t>(i));
    }
  }
  return wrenches;
}

WrenchFrame graspit_frame(const json& file) {
  return {vector3(file.at("torque_origin_cog_mm")), 1.0 / file.at("max_radius_mm").get<double>()};
}

bool is_point_contact(const json& contact) {
  return contact.at("model") == "point_contact_with_friction";
}

Wrenches own_wrenches(const json& contact, const WrenchFrame& frame) {
  const Contacts contacts = {{vector3(contact.at("position_mm")), vector3(contact.at("normal_in")),
                              contact.at("mu").get<double>()}};
  return contact_wrenches(contacts, frame, contact.at("num_friction_edges").get<int>());
}

TEST(GraspitReference, ContactWrenchesHaveItsDigits) {
  PREHEND_NEEDS_SHARED("reference/graspit");
  int compared = 0;
  for (const json& file : read_folder("reference/graspit")) {
    if (!file.contains("gws")) continue;
    for (const json& contact : file.at("contacts")) {
      if (!is_point_contact(contact)) continue;
      const Wrenches expected = columns(contact.at("wrenches_f_tau_over_maxradius"));
      const Wrenches wrenches = own_wrenches(contact, graspit_frame(file));
      ASSERT_EQ(wrenches.cols(), expected.cols()) << file.at("name");
      // Ten digits were written.
      EXPECT_LT((wrenches - expected).cwiseAbs().maxCoeff(), 2e-9) << file.at("name");
      ++compared;
    }
  }
  EXPECT_GT(compared, 40);
}

// Soft fingers have other wrenches: theirs are taken from the file.
Wrenches graspit_wrenches(const json& file) {
  Wrenches all(6, 0);
  for (const json& contact : file.at("contacts")) {
    const Wrenches more = is_point_contact(contact)
                              ? own_wrenches(contact, graspit_frame(file))
                              : columns(contact.at("wrenches_f_tau_over_maxradius"));
    all.conservativeResize(6, all.cols() + more.cols());
    all.rightCols(more.cols()) = more;
  }
  return all;
}

TEST(GraspitReference, EpsilonAndVolume) {
  PREHEND_NEEDS_SHARED("reference/graspit");
  int compared = 0;
  for (const json& file : read_folder("reference/graspit")) {
    if (!file.contains("gws")) continue;
    const json& expected = file.at("gws").at("L1");
    const Wrenches wrenches = graspit_wrenches(file);
    const EpsilonBracket bracket = epsilon_l1(wrenches);
    const WrenchHull hull = wrench_hull(wrenches);
    const std::string name = file.at("name");
    EXPECT_EQ(bracket.force_closure(), expected.at("force_closure").get<bool>()) << name;
    EXPECT_EQ(hull.force_closure(), expected.at("force_closure").get<bool>()) << name;
    const double volume = expected.at("volume");
    EXPECT_NEAR(hull.volume, volume, 2e-3 * volume) << name;
    EXPECT_EQ(hull.status == HullStatus::flat, volume == 0.0) << name;
    if (!bracket.force_closure()) continue;
    EXPECT_NEAR(bracket.upper, expected.at("epsilon").get<double>(), 1e-5) << name;
    EXPECT_NEAR(hull.min_offset, expected.at("epsilon").get<double>(), 1e-5) << name;
    ++compared;
  }
  EXPECT_GE(compared, 9);
}

// A pyramid's edges start elsewhere in these files: the cone around z is turned to the outward
// normal by the shortest rotation, and the forces are its negatives.
Wrenches simox_wrenches(const json& file) {
  const Eigen::Vector3d origin = 1e-3 * vector3(file.at("com_mm"));
  const double scale = file.at("torque_factor_per_m");
  const double friction = file.at("friction_coefficient_requested");
  const int edges = file.at("cone_samples");
  Wrenches wrenches(6, static_cast<Eigen::Index>(file.at("contacts").size()) * edges);
  Eigen::Index column = 0;
  for (const json& contact : file.at("contacts")) {
    const Eigen::Vector3d arm = scale * (1e-3 * vector3(contact.at("p_mm")) - origin);
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(
        Eigen::Vector3d::UnitZ(), vector3(contact.at("n_out")).normalized());
    for (int edge = 0; edge < edges; ++edge) {
      const double angle = 2.0 * std::numbers::pi * edge / edges;
      const Eigen::Vector3d force =
          turn * -Eigen::Vector3d(friction * std::cos(angle), friction * std::sin(angle), 1.0);
      wrenches.col(column++) << force, arm.cross(force);
    }
  }
  return wrenches;
}

TEST(SimoxReference, EpsilonAndVolume) {
  PREHEND_NEEDS_SHARED("reference/simox");
  int compared = 0;
  for (const json& file : read_folder("reference/simox")) {
    const Wrenches wrenches = simox_wrenches(file);
    const EpsilonBracket bracket = epsilon_l1(wrenches);
    const WrenchHull hull = wrench_hull(wrenches);
    const std::string name = file.at("name");
    const json& expected = file.at("independent").at("correct_cone_unit_normal_component_mu");
    if (expected.contains("error")) {
      EXPECT_EQ(hull.status, HullStatus::flat) << name;
      EXPECT_FALSE(bracket.force_closure()) << name;
      continue;
    }
    const double epsilon = expected.at("epsilon_origin");
    const double volume = expected.at("volume");
    EXPECT_EQ(bracket.force_closure(), epsilon > 0.0) << name;
    EXPECT_NEAR(hull.min_offset, epsilon, 1e-5) << name;
    EXPECT_NEAR(bracket.upper, std::max(epsilon, 0.0), 1e-5) << name;
    EXPECT_NEAR(hull.volume, volume, 2e-3 * volume) << name;
    ++compared;
  }
  EXPECT_GE(compared, 7);
}

}  // namespace
}  // namespace prehend::test
