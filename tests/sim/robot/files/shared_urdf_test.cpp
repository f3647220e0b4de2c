// URDF files of other projects, where they are at hand.
#include <cmath>
#include <numbers>
#include <random>

#include "sim/base/index.h"
#include "sim/robot/files/foreign_robot.h"
#include "tests/sim/robot/files/foreign_files.h"
#include "tests/support/shared_data.h"

namespace prehend {
namespace {

constexpr const char* kBarrett = "data/robots/urdf/barrett_hand/bhand_model.urdf";
constexpr const char* kPanda = "data/robots/urdf/franka_description/urdf/panda_arm_hand.urdf";
constexpr const char* kPandaHand = "data/robots/urdf/franka_description/urdf/panda_hand.urdf";

// The modified parameters of Denavit and Hartenberg that Franka Emika publishes for the Panda
// (Franka Control Interface, "Denavit-Hartenberg parameters"): a, d, alpha of each joint.
struct PandaRow {
  double a, d, alpha;
};
constexpr double kRight = 0.5 * std::numbers::pi;
constexpr std::array<PandaRow, 7> kPandaRows = {{{0.0, 0.333, 0.0},
                                                 {0.0, 0.0, -kRight},
                                                 {0.0, 0.316, kRight},
                                                 {0.0825, 0.0, kRight},
                                                 {-0.0825, 0.384, -kRight},
                                                 {0.0, 0.0, kRight},
                                                 {0.088, 0.0, kRight}}};
constexpr double kFlange = 0.107;  // m

Pose panda_flange(const std::vector<double>& q) {
  Pose X = Pose::Identity();
  for (std::size_t i = 0; i < kPandaRows.size(); ++i) {
    const PandaRow& row = kPandaRows[i];
    X = X * Eigen::AngleAxisd(row.alpha, Vector3::UnitX()) * translation({row.a, 0.0, 0.0}) *
        Eigen::AngleAxisd(q[i], Vector3::UnitZ()) * translation({0.0, 0.0, row.d});
  }
  return X * translation({0.0, 0.0, kFlange});
}

// The file has right angles with 11 digits after the point.
TEST(SharedUrdf, PandaMovesAsItsDataSheetSays) {
  PREHEND_NEEDS_SHARED(kPanda);
  const Platform platform = *read_foreign_robot(test::shared(kPanda));
  ASSERT_EQ(platform.robots.size(), 2U);
  const Robot& arm = platform.robots[0].robot;
  const MountedRobot& hand = platform.robots[1];
  ASSERT_EQ(arm.joints.size(), 7U);
  EXPECT_EQ(arm.dofs[3].max_velocity, 2.175);
  EXPECT_EQ(arm.dofs[3].max_acceleration, 12.5);
  EXPECT_EQ(arm.joints[6].max_effort, 12.0);
  EXPECT_EQ(hand.robot.links[0].name, "panda_hand");
  EXPECT_EQ(hand.robot.dofs.size(), 2U);
  std::mt19937 random(7);
  for (int n = 0; n < 100; ++n) {
    std::vector<double> q;
    for (const DegreeOfFreedom& dof : arm.dofs) {
      q.push_back(dof.lower +
                  (dof.upper - dof.lower) * (static_cast<double>(random()) / 4294967296.0));
    }
    const Pose X_BH = joint_pose(arm, 6, joint_values(arm, q)) * hand.X_MR;
    const Pose wanted = panda_flange(q) * Eigen::AngleAxisd(-0.5 * kRight, Vector3::UnitZ());
    EXPECT_LT((X_BH.translation() - wanted.translation()).norm(), 1e-10);
    EXPECT_LT((X_BH.linear() - wanted.linear()).norm(), 1e-10);
  }
}

TEST(SharedUrdf, PandaExemptsWhatItsFileExempts) {
  PREHEND_NEEDS_SHARED(kPanda);
  const Robot arm = read_foreign_robot(test::shared(kPanda))->robots.at(0).robot;
  std::vector<std::string> pairs;
  for (const auto& [a, b] : arm.exempt_pairs) {
    pairs.push_back(arm.links[index(a)].name + " " + arm.links[index(b)].name);
  }
  EXPECT_EQ(pairs,
            (std::vector<std::string>{"panda_link5 panda_link7", "panda_link6 panda_link8"}));
}

TEST(SharedUrdf, PandaHandIsAHandAlone) {
  PREHEND_NEEDS_SHARED(kPandaHand);
  const Platform platform = *read_foreign_robot(test::shared(kPandaHand));
  ASSERT_EQ(platform.robots.size(), 1U);
  const Robot& robot = platform.robots[0].robot;
  EXPECT_EQ(robot.links.size(), 3U);
  EXPECT_FALSE(robot.hand);
  for (const DegreeOfFreedom& dof : robot.dofs) EXPECT_EQ(dof.upper - dof.lower, 0.045);
}

TEST(SharedUrdf, BarrettHasThreeFingersAndEightJoints) {
  PREHEND_NEEDS_SHARED(kBarrett);
  const Platform platform = *read_foreign_robot(test::shared(kBarrett));
  ASSERT_EQ(platform.robots.size(), 1U);
  const Robot& robot = platform.robots[0].robot;
  EXPECT_EQ(robot.joints.size(), 8U);
  EXPECT_EQ(robot.dofs.size(), 8U);
  EXPECT_EQ(robot.links.size(), 9U);
  EXPECT_EQ(robot.chains.size(), 3U);
  EXPECT_NEAR(robot.links[0].inertial.mass, 0.377966381303299, 1e-15);
  EXPECT_LT(bounds(robot.links[0].mesh).diagonal(), 0.2);
}

}  // namespace
}  // namespace prehend
