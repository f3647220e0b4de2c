// What every robot of the library promises.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/robot/files/robot_file.h"
#include "sim/shape/mesh_checks.h"
#include "tests/sim/robot/files/hand_shape.h"

namespace prehend {
namespace {

class LibraryRobot : public testing::TestWithParam<std::string> {
 protected:
  const Robot robot_ = find_robot(GetParam());

  // None for arms and bases.
  std::vector<Preshape> preshapes() const {
    return robot_.hand ? robot_.hand->preshapes : std::vector<Preshape>{};
  }
};

TEST_P(LibraryRobot, IsNamedAfterItsFolderAndHasAReadme) {
  EXPECT_EQ(robot_.name, GetParam());
  const std::filesystem::path folder =
      std::filesystem::path(PREHEND_SOURCE_DIR) / "robots" / GetParam();
  EXPECT_TRUE(std::filesystem::exists(folder / "README.md"));
}

TEST_P(LibraryRobot, LinksAreClosedOutwardAndLight) {
  for (const Link& link : robot_.links) {
    const MeshChecks checks = check_mesh(link.mesh);
    EXPECT_TRUE(checks.solid()) << link.name;
    EXPECT_FALSE(checks.inward) << link.name;
    EXPECT_EQ(checks.degenerate_triangles, 0) << link.name;
    EXPECT_LE(checks.triangles, link.joint < 0 ? 250 : 100) << link.name;
  }
}

// A needle of a triangle makes a poor contact: no height under 0.3 mm.
TEST_P(LibraryRobot, LinksHaveNoSlivers) {
  for (const Link& link : robot_.links) {
    for (std::size_t t = 0; t < link.mesh.triangles.size(); ++t) {
      double longest = 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& corners = link.mesh.triangles[t];
        const Vector3& from = link.mesh.vertices[static_cast<std::size_t>(corners[k])];
        const Vector3& to = link.mesh.vertices[static_cast<std::size_t>(corners[(k + 1) % 3])];
        longest = std::max(longest, (to - from).norm());
      }
      EXPECT_GT(doubled_area_vector(link.mesh, t).norm() / longest, 3e-4)
          << link.name << " triangle " << t;
    }
  }
}

TEST_P(LibraryRobot, InitialPostureIsInsideLimitsAndFreeOfSelfCollision) {
  for (const DegreeOfFreedom& dof : robot_.dofs) {
    EXPECT_GE(dof.initial, dof.lower) << dof.name;
    EXPECT_LE(dof.initial, dof.upper) << dof.name;
  }
  EXPECT_EQ(test::self_collisions(robot_, initial_dofs(robot_)), "");
}

TEST_P(LibraryRobot, SaysHowFastItMoves) {
  for (const DegreeOfFreedom& dof : robot_.dofs) {
    EXPECT_GT(dof.max_velocity, 0.0) << dof.name;
    EXPECT_GE(dof.max_velocity, std::abs(dof.closing_velocity)) << dof.name;
    EXPECT_GT(dof.max_acceleration, dof.max_velocity) << dof.name;  // full speed within 1 s
  }
}

TEST_P(LibraryRobot, PreshapesAreInsideLimitsAndFreeOfSelfCollision) {
  for (const Preshape& preshape : preshapes()) {
    ASSERT_EQ(preshape.dofs.size(), robot_.dofs.size());
    for (std::size_t d = 0; d < robot_.dofs.size(); ++d) {
      EXPECT_GE(preshape.dofs[d], robot_.dofs[d].lower) << preshape.name;
      EXPECT_LE(preshape.dofs[d], robot_.dofs[d].upper) << preshape.name;
    }
    EXPECT_EQ(test::self_collisions(robot_, preshape.dofs), "") << preshape.name;
  }
}

TEST_P(LibraryRobot, PreshapesLeaveRoomToClose) {
  for (const Preshape& preshape : preshapes()) {
    EXPECT_LT(preshape.min_width, preshape.max_width) << preshape.name;
    for (std::size_t d = 0; d < robot_.dofs.size(); ++d) {
      const DegreeOfFreedom& dof = robot_.dofs[d];
      const double end = dof.closing_velocity > 0.0 ? dof.upper : dof.lower;
      if (dof.closing_velocity == 0.0) continue;
      EXPECT_GT(std::abs(end - preshape.dofs[d]), 0.01) << preshape.name << " " << dof.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, LibraryRobot, testing::ValuesIn(library_robot_names()),
                         [](const auto& one) { return one.param; });

TEST(RobotLibrary, HoldsTheRobotsOfTheManual) {
  const std::vector<std::string> expected = {
      "allegro",      "barrett",           "dlr",         "franka_hand", "panda_arm",
      "parallel_jaw", "parallel_jaw_wide", "puma560",     "robonaut",    "robotiq_2f85",
      "robotiq_3f",   "rutgers",           "shadow_like", "ur5e",        "xr4000"};
  const std::vector<std::string> names = library_robot_names();
  for (const std::string& name : expected) {
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  }
}

TEST(RobotLibrary, FindsARobotByItsFile) {
  const auto file = std::filesystem::path(PREHEND_SOURCE_DIR) / "robots/barrett/robot.json";
  EXPECT_EQ(find_robot(file.string()).name, "barrett");
}

TEST(RobotLibrary, UnknownNameListsTheKnownOnes) {
  try {
    find_robot("barett");
    FAIL() << "no complaint";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("franka_hand, obelix, panda, panda_arm, parallel_jaw, "),
              std::string::npos)
        << message;
    EXPECT_NE(message.find("(barett)"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace prehend
