#include "sim/scene/free_start.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "sim/robot/hand/self_collision.h"
#include "sim/scene/make_scene.h"
#include "tests/sim/robot/files/foreign_files.h"

namespace prehend {
namespace {

using test::box_link;
using test::has_note;
using test::urdf_joint;

std::string turn(const std::string& name, const std::string& parent, const std::string& child,
                 const std::string& xyz, const std::string& axis) {
  return urdf_joint(name, "revolute", parent, child,
                    "<origin xyz=\"" + xyz + "\"/><axis xyz=\"" + axis +
                        "\"/><limit lower=\"-0.1\" upper=\"2.5\" effort=\"9\" velocity=\"2\"/>");
}

// An arm of four joints with a gripper. `folded`: its third joint lays the forearm on the upper arm
// where it is at 0. `collar`: the second link has a collar that reaches around the base.
std::string arm_text(bool folded, bool collar) {
  const std::string finger_limit =
      "<limit lower=\"0\" upper=\"0.04\" effort=\"9\" velocity=\"0.1\"/>";
  return test::urdf(
      box_link("base", "0.1 0.1 0.1", "0 0 0.05") + box_link("l1", "0.06 0.06 0.04", "0 0 0.03") +
      box_link("l2", collar ? "0.2 0.2 0.2" : "0.06 0.06 0.2", collar ? "0 0 0" : "0 0 0.1") +
      box_link("l3", "0.05 0.05 0.2", "0 0 0.12") + box_link("palm", "0.1 0.04 0.02", "0 0 0.03") +
      box_link("f1", "0.01 0.02 0.05", "0.006 0 0.03") +
      box_link("f2", "0.01 0.02 0.05", "-0.006 0 0.03") +
      turn("q1", "base", "l1", "0 0 0.11", "0 0 1") + turn("q2", "l1", "l2", "0 0 0.06", "0 1 0") +
      urdf_joint("q3", "revolute", "l2", "l3",
                 std::string("<origin xyz=\"0.04 0 0.22\" rpy=\"0 ") + (folded ? "3.1" : "0") +
                     " 0\"/><axis xyz=\"0 -1 0\"/><limit lower=\"0\" upper=\"2.5\" effort=\"9\" "
                     "velocity=\"2\"/>") +
      turn("q4", "l3", "palm", "0 0 0.24", "0 0 1") +
      urdf_joint("j1", "prismatic", "palm", "f1",
                 "<origin xyz=\"0 0 0.04\"/><axis xyz=\"1 0 0\"/>" + finger_limit) +
      urdf_joint("j2", "prismatic", "palm", "f2",
                 "<origin xyz=\"0 0 0.04\"/><axis xyz=\"-1 0 0\"/>" + finger_limit +
                     "<mimic joint=\"j1\"/>"));
}

Carrier carrier_of(const std::string& text) {
  return find_carrier(test::write_text(test::test_folder() / "made.urdf", text).string());
}

bool starts_free(const Carrier& carrier) {
  const AssembledPlatform whole = assemble(carrier.platform);
  const auto met = SelfCollision(whole.robot).colliding(carrier.start);
  // The closed fingers may touch.
  return std::none_of(met.begin(), met.end(),
                      [&](const auto& pair) { return pair.first < whole.parts.back().first_link; });
}

TEST(FreeStart, StaysWhereNothingCollides) {
  const Carrier carrier = carrier_of(arm_text(false, false));
  for (std::size_t d = 0; d < 4; ++d) EXPECT_EQ(carrier.start[d], 0.0);
  EXPECT_TRUE(starts_free(carrier));
}

TEST(FreeStart, IsFoundWhereLinksCollide) {
  const Carrier carrier = carrier_of(arm_text(true, false));
  EXPECT_TRUE(starts_free(carrier));
  EXPECT_GT(carrier.start[2], 0.0);
  EXPECT_TRUE(has_note(carrier.platform.robots.front().robot, "the arm starts elsewhere"));
  EXPECT_EQ(carrier.start, carrier_of(arm_text(true, false)).start);
}

// The second link reaches through the first into the base, however it turns.
TEST(FreeStart, LinksThatAlwaysMeetAreExempt) {
  const Carrier carrier = carrier_of(arm_text(false, true));
  const Robot& arm = carrier.platform.robots.front().robot;
  ASSERT_TRUE(has_note(arm, "are not checked against each other"));
  EXPECT_TRUE(starts_free(carrier));
}

}  // namespace
}  // namespace prehend
