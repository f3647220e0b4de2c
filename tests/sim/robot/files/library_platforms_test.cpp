// What every platform of the library promises, and where the robots of the known ones are.
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "sim/robot/files/platform_file.h"
#include "sim/robot/files/robot_file.h"
#include "sim/shape/mesh_checks.h"
#include "tests/sim/robot/files/reference_robot.h"

namespace prehend {
namespace {

std::size_t index_of(const Robot& robot, const std::string& link) {
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    if (robot.links[l].name == link) return l;
  }
  ADD_FAILURE() << "no link " << link;
  return 0;
}

class LibraryPlatform : public testing::TestWithParam<std::string> {
 protected:
  const Platform platform_ = find_platform(GetParam());
  const Robot robot_ = assemble(platform_).robot;

  double gap_between(const std::string& a, const std::string& b) const {
    const std::vector<Pose> X_BL = test::poses_at(robot_, initial_dofs(robot_));
    const std::size_t i = index_of(robot_, a);
    const std::size_t j = index_of(robot_, b);
    return find_gap(ProximityMesh(robot_.links[i].mesh), ProximityMesh(robot_.links[j].mesh),
                    X_BL[i].inverse() * X_BL[j])
        .upper;
  }
};

TEST_P(LibraryPlatform, IsNamedAfterItsFolderAndHasAReadme) {
  EXPECT_EQ(platform_.name, GetParam());
  const std::filesystem::path folder =
      std::filesystem::path(PREHEND_SOURCE_DIR) / "robots" / GetParam();
  EXPECT_TRUE(std::filesystem::exists(folder / "README.md"));
}

TEST_P(LibraryPlatform, HasOneHand) { EXPECT_NO_THROW(hand_of(platform_)); }

TEST_P(LibraryPlatform, LinksAreClosedAndOutward) {
  for (const Link& link : robot_.links) {
    const MeshChecks checks = check_mesh(link.mesh);
    EXPECT_TRUE(checks.solid()) << link.name;
    EXPECT_FALSE(checks.inward) << link.name;
  }
}

TEST_P(LibraryPlatform, InitialPostureIsFreeOfSelfCollision) {
  EXPECT_EQ(test::self_collisions(robot_, initial_dofs(robot_)), "");
}

TEST_P(LibraryPlatform, TheMountFillsTheSpaceBetweenFlangeAndPalm) {
  const auto is_mount = [](const Link& link) { return link.name == "hand/mount"; };
  if (std::none_of(robot_.links.begin(), robot_.links.end(), is_mount)) {
    const auto hand = std::find_if(robot_.links.begin(), robot_.links.end(),
                                   [](const Link& link) { return link.name.starts_with("hand/"); });
    EXPECT_LT(gap_between("arm/flange", hand->name), 2e-4);
    return;
  }
  for (const char* neighbour : {"arm/flange", "hand/palm"}) {
    const double gap = gap_between("hand/mount", neighbour);
    EXPECT_GT(gap, 0.0) << neighbour;
    EXPECT_LT(gap, 2e-4) << neighbour;
  }
}

INSTANTIATE_TEST_SUITE_P(All, LibraryPlatform, testing::ValuesIn(library_platform_names()),
                         [](const auto& one) { return one.param; });

TEST(PlatformLibrary, HoldsThePlatformsOfTheManual) {
  EXPECT_EQ(library_platform_names(),
            (std::vector<std::string>{"obelix", "panda", "puma560_barrett", "ur5e_2f85",
                                      "ur5e_suction"}));
}

TEST(PlatformLibrary, PlatformsAreNoRobots) {
  const std::vector<std::string> names = library_robot_names();
  EXPECT_EQ(std::find(names.begin(), names.end(), "obelix"), names.end());
}

// At zero: the drum's top at 845 mm, the shoulder 686.8 above, the wrist 452.1, -149, 431.8 from
// there, the palm 175.05 above the wrist.
TEST(Obelix, PalmAtZero) {
  const Robot robot = assemble(find_platform("obelix")).robot;
  const std::vector<Pose> X_BL = test::poses_at(robot, std::vector<double>(robot.dofs.size(), 0.0));
  const Pose X_BF = X_BL[index_of(robot, "arm/flange")];
  test::expect_same_pose(X_BF, translation(Vector3(0.4521, -0.149, 0.845 + 0.6868 + 0.4318)), 1e-9);
  const Bounds palm = bounds(robot.links[index_of(robot, "hand/palm")].mesh);
  EXPECT_NEAR(palm.lower.z(), 0.17505 - 0.0829, 1e-6);
}

TEST(Obelix, StandsItsArmOnItsDrum) {
  const Robot robot = assemble(find_platform("obelix")).robot;
  const Bounds drum = bounds(robot.links[index_of(robot, "base/drum")].mesh);
  const Bounds pedestal = bounds(robot.links[index_of(robot, "arm/pedestal")].mesh);
  EXPECT_NEAR(pedestal.lower.z() - drum.upper.z(), 1e-3, 1e-6);
}

}  // namespace
}  // namespace prehend
