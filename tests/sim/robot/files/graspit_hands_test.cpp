// The hands of the GraspIt! paper against joint values, poses and boxes that another simulator
// printed.
#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/robot/files/robot_file.h"
#include "tests/sim/robot/files/reference_robot.h"

namespace prehend {
namespace {

struct PaperHand {
  std::string name;
  std::string reference;  // its file
  std::size_t dofs = 0;
  std::size_t chains = 0;
  double box_tolerance = 0.1;  // of the links' bounding boxes [mm]
};

void PrintTo(const PaperHand& hand, std::ostream* out) { *out << hand.name; }

class GraspitHand : public testing::TestWithParam<PaperHand> {
 protected:
  std::string file() const { return "reference/graspit/fk/" + GetParam().reference; }

  const Robot robot_ = find_robot(GetParam().name);
};

// Index in robot.links of the `k`-th link of chain `c`, whether or not every joint has one.
std::size_t nth_link(const Robot& robot, int c, int k) {
  const Chain& chain = robot.chains[static_cast<std::size_t>(c)];
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    const int joint = robot.links[l].joint - chain.first_joint;
    if (joint < 0 || joint >= chain.joint_count) continue;
    if (k-- == 0) return l;
  }
  ADD_FAILURE() << "no such link in chain " << c;
  return 0;
}

TEST_P(GraspitHand, HasAsManyFingersAndDegreesOfFreedomAsInThePaper) {
  EXPECT_EQ(robot_.dofs.size(), GetParam().dofs);
  EXPECT_EQ(robot_.chains.size(), GetParam().chains);
}

TEST_P(GraspitHand, LinkPosesAgree) {
  PREHEND_NEEDS_SHARED(file());
  const nlohmann::json json = test::reference(file());
  ASSERT_EQ(json["poses"].size(), 5U);
  for (const nlohmann::json& pose : json["poses"]) {
    const std::vector<Pose> X_BL = test::poses_at(robot_, pose["dof"].get<std::vector<double>>());
    ASSERT_EQ(pose["links"].size() + 1, robot_.links.size());
    for (const nlohmann::json& link : pose["links"]) {
      const std::size_t l = nth_link(robot_, link["chain"].get<int>(), link["link"].get<int>());
      SCOPED_TRACE(robot_.links[l].name);
      test::expect_same_pose(X_BL[l], test::pose_of(link["pose"]), 1e-6);
    }
  }
}

TEST_P(GraspitHand, JointValuesAgree) {
  PREHEND_NEEDS_SHARED(file());
  const nlohmann::json json = test::reference(file());
  for (const nlohmann::json& pose : json["poses"]) {
    const auto expected = pose["joints"].get<std::vector<double>>();
    const auto values = joint_values(robot_, pose["dof"].get<std::vector<double>>());
    ASSERT_EQ(values.size(), expected.size());
    for (std::size_t j = 0; j < values.size(); ++j) EXPECT_NEAR(values[j], expected[j], 1e-6) << j;
  }
}

TEST_P(GraspitHand, DegreesOfFreedomAgree) {
  PREHEND_NEEDS_SHARED(file());
  const nlohmann::json json = test::reference(file());
  test::expect_limits_agree(robot_, json);
  for (std::size_t d = 0; d < robot_.dofs.size(); ++d) {
    const nlohmann::json& dof = json["dofs"][d];
    EXPECT_EQ(robot_.dofs[d].closing_velocity, dof["default_velocity"].get<double>());
    EXPECT_EQ(robot_.dofs[d].coupling == Coupling::breakaway, dof["type"].get<int>() == 1);
  }
}

void expect_box(const Link& link, const nlohmann::json& json, double tolerance) {
  const Bounds box = bounds(link.mesh);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    EXPECT_NEAR(1e3 * box.lower[axis], json["aabb_min"][k].get<double>(), tolerance)
        << link.name << " "
        << "xyz"[k];
    EXPECT_NEAR(1e3 * box.upper[axis], json["aabb_max"][k].get<double>(), tolerance)
        << link.name << " "
        << "xyz"[k];
  }
}

TEST_P(GraspitHand, LinkBoxesAgree) {
  PREHEND_NEEDS_SHARED(file());
  const nlohmann::json json = test::reference(file());
  ASSERT_EQ(json["links"].size() + 1, robot_.links.size());
  expect_box(robot_.links[0], json["palm"], GetParam().box_tolerance);
  for (std::size_t l = 1; l < robot_.links.size(); ++l) {
    expect_box(robot_.links[l], json["links"][l - 1], GetParam().box_tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(All, GraspitHand,
                         testing::Values(PaperHand{"dlr", "DLR.json", 12, 4},
                                         PaperHand{"robonaut", "Robonaut.json", 14, 5},
                                         PaperHand{"rutgers", "Rutgers.json", 19, 5}),
                         [](const auto& one) { return one.param.name; });

// Distance [mm] of a place in the link's frame [mm] from the nearest plane of a triangle that faces
// the same way.
double millimetres_to_face(const TriangleMesh& mesh, const Vector3& place, const Vector3& normal) {
  double nearest = 1e9;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3 n = doubled_area_vector(mesh, t).normalized();
    if (n.dot(normal.normalized()) < 0.95) continue;
    const Vector3& corner = mesh.vertices[static_cast<std::size_t>(mesh.triangles[t][0])];
    nearest = std::min(nearest, std::abs(n.dot(place - 1e3 * corner)));
  }
  return nearest;
}

struct ContactPlace {
  std::string hand;
  std::string link;
  Vector3 place;
  Vector3 normal;
};

// Contacts published with the models, one for each kind of link.
TEST(GraspitHands, FacesPassThroughPublishedContactPlaces) {
  const std::vector<ContactPlace> places = {
      {"dlr", "palm", {-28.005, 90.469, 8.779}, {-1.0, -0.0027, 0.0}},
      {"dlr", "proximal_finger_2", {-38.825, 12.165, 0.0}, {0.0174, 0.9944, 0.1045}},
      {"dlr", "middle_finger_2", {-23.622, 11.146, 0.411}, {0.02, 0.9943, 0.1045}},
      {"dlr", "distal_finger_2", {10.124, 0.0, 39.041}, {0.9799, 0.103, 0.171}},
      {"robonaut", "palm", {44.643, 5.237, 8.223}, {0.5698, 0.2452, 0.7843}},
      {"robonaut", "thumb_proximal", {-19.409, 4.535, 0.974}, {-0.0812, 0.9967, 0.0}},
      {"robonaut", "thumb_distal", {19.787, 4.013, 0.164}, {0.2874, 0.9578, 0.0}},
      {"robonaut", "index_proximal", {-23.171, 7.469, 0.156}, {0.0554, 0.9985, 0.0}},
      {"robonaut", "ring_proximal", {-21.887, 7.53, -0.261}, {0.0648, 0.9979, 0.0}},
      {"robonaut", "index_middle", {-15.262, 6.81, -0.121}, {-0.0134, 0.9999, 0.0}},
      {"robonaut", "index_distal", {15.472, 4.266, 0.15}, {0.3003, 0.9539, 0.0}},
  };
  for (const ContactPlace& place : places) {
    const Robot robot = find_robot(place.hand);
    const auto link = std::find_if(robot.links.begin(), robot.links.end(),
                                   [&](const Link& one) { return one.name == place.link; });
    ASSERT_NE(link, robot.links.end()) << place.hand << " " << place.link;
    EXPECT_LT(millimetres_to_face(link->mesh, place.place, place.normal), 0.5)
        << place.hand << " " << place.link;
  }
}

}  // namespace
}  // namespace prehend
