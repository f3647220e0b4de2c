// The Barrett hand against poses and boxes that another simulator printed. Its joints begin where
// the maker's model says, not where that simulator does.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/robot/files/robot_file.h"
#include "tests/sim/robot/files/reference_robot.h"

namespace prehend {
namespace {

constexpr const char* kBarrettReference = "reference/graspit/fk/Barrett.json";

// With all joints of fingers turned to where that simulator has them at the same values.
TEST(BarrettReference, LinkPosesAgree) {
  PREHEND_NEEDS_SHARED(kBarrettReference);
  Robot robot = find_robot("barrett");
  for (Joint& joint : robot.joints) {
    if (joint.name.ends_with("proximal")) joint.offset = (5.0 - 2.46) * test::kDegree;
    if (joint.name.ends_with("distal")) joint.offset = (40.0 - 37.54) * test::kDegree;
  }
  test::expect_link_poses_agree(robot, test::reference(kBarrettReference));
}

// The maker's model (bhand_model.urdf) has the distal joint at (-69.936, 3) mm in the proximal
// link, and the distal link's face 40 degrees from the palm where all joints are at 0; its data
// sheets say 140 and 48 degrees of range.
TEST(BarrettHand, BeginsAndEndsAsItsMakerSays) {
  const Robot robot = find_robot("barrett");
  std::vector<Pose> X_BJ;
  joint_poses(robot, std::vector<double>(robot.joints.size(), 0.0), X_BJ);
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    if (!joint.name.ends_with("distal")) continue;
    const Joint& proximal = robot.joints[j - 1];
    const Pose X_BP =
        (proximal.parent < 0 ? Pose::Identity() : X_BJ[static_cast<std::size_t>(proximal.parent)]) *
        proximal.X_PJ;
    const Vector3 way = X_BJ[j - 1].translation() - X_BP.translation();
    EXPECT_NEAR(way.norm(), 0.070, 1e-4);
    EXPECT_NEAR(way.z(), 0.003, 1e-5) << joint.name;
    EXPECT_NEAR(std::abs(X_BJ[j].linear().col(0).z()), std::sin(40.0 * test::kDegree), 1e-9);
    EXPECT_NEAR(proximal.upper, 140.0 * test::kDegree, 1e-9);
    EXPECT_NEAR(joint.upper, 48.0 * test::kDegree, 1e-9);
  }
}

TEST(BarrettReference, JointValuesAgree) {
  PREHEND_NEEDS_SHARED(kBarrettReference);
  const Robot robot = find_robot("barrett");
  const nlohmann::json json = test::reference(kBarrettReference);
  ASSERT_EQ(json["poses"].size(), 5U);
  for (const nlohmann::json& pose : json["poses"]) {
    const auto expected = pose["joints"].get<std::vector<double>>();
    const auto values = joint_values(robot, pose["dof"].get<std::vector<double>>());
    ASSERT_EQ(values.size(), expected.size());
    for (std::size_t j = 0; j < values.size(); ++j) EXPECT_NEAR(values[j], expected[j], 1e-8);
  }
}

TEST(BarrettReference, DegreesOfFreedomAgree) {
  PREHEND_NEEDS_SHARED(kBarrettReference);
  const Robot robot = find_robot("barrett");
  const nlohmann::json json = test::reference(kBarrettReference);
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    const nlohmann::json& dof = json["dofs"][d];
    EXPECT_EQ(robot.dofs[d].closing_velocity, dof["default_velocity"].get<double>());
    EXPECT_EQ(robot.dofs[d].coupling == Coupling::breakaway, dof["type"].get<int>() == 1);
  }
}

void expect_same_box(const Link& link, const nlohmann::json& json) {
  const Bounds box = bounds(link.mesh);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    EXPECT_NEAR(1e3 * box.lower[axis], json["aabb_min"][k].get<double>(), 0.1) << link.name;
    EXPECT_NEAR(1e3 * box.upper[axis], json["aabb_max"][k].get<double>(), 0.1) << link.name;
  }
}

TEST(BarrettReference, LinkBoxesAgree) {
  PREHEND_NEEDS_SHARED(kBarrettReference);
  const Robot robot = find_robot("barrett");
  const nlohmann::json json = test::reference(kBarrettReference);
  expect_same_box(robot.links[0], json["palm"]);
  ASSERT_EQ(json["links"].size() + 1, robot.links.size());
  for (std::size_t l = 1; l < robot.links.size(); ++l) {
    expect_same_box(robot.links[l], json["links"][l - 1]);
  }
}

// Distance of p_L from the surface of the link along the normal, signed: 0 when p_L lies on a face
// whose normal is close to `normal`.
double distance_to_face(const TriangleMesh& mesh, const Vector3& p_L, const Vector3& normal) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3 n = doubled_area_vector(mesh, t).normalized();
    if (n.dot(normal) < 0.98) continue;
    const Vector3& corner = mesh.vertices[static_cast<std::size_t>(mesh.triangles[t][0])];
    const double distance = n.dot(p_L - corner);
    if (std::abs(distance) < std::abs(best)) best = distance;
  }
  return best;
}

// Published contact places: millimetres in the link's frame.
TEST(BarrettShape, InnerFacesPassThroughPublishedContactPlaces) {
  const Robot robot = find_robot("barrett");
  const Vector3 tilted = Vector3(0.0459, 0.9989, 0.0).normalized();
  const Vector3 chamfer = Vector3(1.0, 1.0, 0.0).normalized();
  for (const int chain : {0, 1, 2}) {
    const int proximal = chain == 2 ? 0 : 1;
    const TriangleMesh& link2 = robot.links[test::link_index(robot, chain, proximal)].mesh;
    const TriangleMesh& link3 = robot.links[test::link_index(robot, chain, proximal + 1)].mesh;
    EXPECT_NEAR(distance_to_face(link2, 1e-3 * Vector3(-19.861, 13.340, 0.0), tilted), 0.0, 2e-5);
    EXPECT_NEAR(distance_to_face(link2, 1e-3 * Vector3(-51.138, 14.778, 0.0), tilted), 0.0, 2e-5);
    EXPECT_NEAR(distance_to_face(link3, 1e-3 * Vector3(-5.399, 10.73, 0.0), Vector3::UnitY()), 0.0,
                1e-5);
    EXPECT_NEAR(distance_to_face(link3, 1e-3 * Vector3(-41.735, 10.734, 0.0), Vector3::UnitY()),
                0.0, 1e-5);
    EXPECT_NEAR(distance_to_face(link3, 1e-3 * Vector3(0.975, 9.755, 0.0), chamfer), 0.0, 2e-5);
  }
  const TriangleMesh& palm = robot.links[0].mesh;
  EXPECT_NEAR(distance_to_face(palm, 1e-3 * Vector3(20.0, 9.636, 0.0), Vector3::UnitZ()), 0.0,
              1e-6);
}

}  // namespace
}  // namespace prehend
