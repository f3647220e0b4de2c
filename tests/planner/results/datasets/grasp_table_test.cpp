#include "planner/results/datasets/grasp_table.h"

#include <sstream>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "tests/planner/results/datasets/sample_sets.h"

namespace prehend {
namespace {

TEST(GraspTable, HasARowForEachGrasp) {
  GraspSet set;
  set.object.file = "mug, large.obj";
  set.object.scale = 0.5;
  set.object.friction = 0.25;
  set.hand = "franka_hand";
  set.dofs = {"a", "b"};
  set.links = {"finger"};
  set.grasps.resize(2);
  set.grasps[0].outcome = Outcome::stable;
  set.grasps[0].epsilon = {0.125, 0.5};
  set.grasps[0].dofs = {0.25, -1.0};
  set.grasps[0].contacts.resize(3);
  set.grasps[0].X_OH = translation({1.0, 2.0, 3.0});
  std::ostringstream stream;
  write_grasp_table_header(stream);
  write_grasp_table_rows(stream, "first", set);
  EXPECT_EQ(stream.str(),
            "set,object,hand,scale,friction,index,outcome,epsilon_lower,epsilon_upper,contacts,"
            "object_hand_x,object_hand_y,object_hand_z,object_hand_qw,object_hand_qx,"
            "object_hand_qy,object_hand_qz,dofs\n"
            "first,\"mug, large.obj\",franka_hand,0.5,0.25,0,stable,0.125,0.5,3,"
            "1.0,2.0,3.0,1.0,0.0,0.0,0.0,0.25 -1.0\n"
            "first,\"mug, large.obj\",franka_hand,0.5,0.25,1,no_contact,0.0,0.0,0,"
            "0.0,0.0,0.0,1.0,0.0,0.0,0.0,\n");
}

TEST(GraspTable, SetsStandOneBehindTheOther) {
  Random random(5);
  const GraspSet first = test::random_set(random, 20);
  const GraspSet second = test::random_set(random, 30);
  std::ostringstream both;
  write_grasp_table_rows(both, "1", first);
  write_grasp_table_rows(both, "2", second);
  std::ostringstream one;
  write_grasp_table_rows(one, "1", first);
  std::ostringstream other;
  write_grasp_table_rows(other, "2", second);
  EXPECT_EQ(both.str(), one.str() + other.str());
}

TEST(GraspTable, WritesNothingOfASetThatIsNotSound) {
  GraspSet set;
  set.grasps.resize(2);
  set.grasps[1].epsilon.lower = std::numeric_limits<double>::infinity();
  std::ostringstream stream;
  EXPECT_THROW(write_grasp_table_rows(stream, "a", set), InputError);
  EXPECT_TRUE(stream.str().empty());
}

}  // namespace
}  // namespace prehend
