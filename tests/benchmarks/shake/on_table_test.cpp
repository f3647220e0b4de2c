#include "benchmarks/shake/on_table.h"

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/scene/make_scene.h"
#include "sim/shape/basic_shapes.h"

namespace prehend::bench {
namespace {

Scene box_at(const Pose& X_WO) {
  Scene scene = make_scene(
      make_graspable("box", make_box({0.08, 0.05, 0.03}), Material::plastic, 0.2), "parallel_jaw");
  scene.object.X_WO = X_WO;
  return scene;
}

// It stands as it stood, on the plate with at most the gap that bodies at rest keep.
TEST(OnTable, ABoxThatLiesFlatStaysAsItIs) {
  Scene scene = box_at(translation({0.1, -0.2, 0.7}));
  put_on_table(scene);
  ASSERT_EQ(scene.obstacles.size(), 1U);
  EXPECT_EQ(scene.obstacles[0].name, "table");
  EXPECT_LT((scene.object.X_WO.linear() - Matrix3::Identity()).norm(), 1e-3);
  const double top = scene.obstacles[0].X_WB.translation().z() + 0.025;
  const double bottom = scene.object.X_WO.translation().z() - 0.015;
  EXPECT_GT(bottom, top);
  EXPECT_LT(bottom, top + 2e-4);
  const Vector3 off = scene.object.X_WO.translation() - Vector3(0.1, -0.2, 0.0);
  EXPECT_LT(off.head<2>().norm(), 1e-3);
}

TEST(OnTable, ABoxOnAnEdgeFallsOntoAFace) {
  Pose X_WO = Pose::Identity();
  X_WO.linear() = Eigen::AngleAxisd(0.5, Vector3::UnitX()).toRotationMatrix();
  Scene scene = box_at(X_WO);
  put_on_table(scene);
  EXPECT_GT(std::abs(scene.object.X_WO.linear()(2, 2)), 1.0 - 1e-4);
}

}  // namespace
}  // namespace prehend::bench
