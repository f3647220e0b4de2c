#include "sim/scene/sunk_object.h"

#include <array>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/scene/compiled_scene.h"
#include "tests/support/refusal_of.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

constexpr double kHalf = 0.03;  // of the height of the object
constexpr double kTop = 0.4;    // of the table, in the world

// A box on a table, `depth` too low, which stands with any of its sides upwards.
Scene sunk_by(double depth, const Matrix3& R_WO) {
  const TriangleMesh table = make_box({1.0, 1.0, 0.04});
  Scene scene =
      test::scene_with(find_robot("parallel_jaw"), make_box(Vector3::Constant(2.0 * kHalf)),
                       {test::obstacle(table, {0.0, 0.0, kTop - 0.02})});
  scene.object.X_WO = pose_from(R_WO, {0.1, 0.2, kTop + kHalf - depth});
  return scene;
}

const std::array<Matrix3, 3> kTurns = {
    Matrix3::Identity(), Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3::UnitX()).matrix(),
    Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3::UnitY()).matrix()};

// To 0.01 mm, above the surface by 0.1 mm.
TEST(SunkObject, IsRaisedToTheSurface) {
  for (const Matrix3& R_WO : kTurns) {
    for (const double depth : {1e-6, 1e-4, 1e-3, 2.9e-3}) {
      Scene scene = sunk_by(depth, R_WO);
      raise_sunk_object(scene);
      const double above = scene.object.X_WO.translation().z() - kTop - kHalf;
      EXPECT_GT(above, 0.9e-4) << depth;
      EXPECT_LT(above, 1.7e-4) << depth;
      ASSERT_EQ(scene.notes.size(), 1U) << depth;
      EXPECT_NE(scene.notes[0].find("object is sunk into obstacle by"), std::string::npos);
      EXPECT_NO_THROW((void)compile(scene));
    }
  }
}

TEST(SunkObject, StaysWhereItIsFreeOrFarIn) {
  for (const double depth : {-1e-6, -1e-3, 4e-3, 0.03}) {
    Scene scene = sunk_by(depth, kTurns[0]);
    raise_sunk_object(scene);
    EXPECT_EQ(scene.object.X_WO.translation().z(), kTop + kHalf - depth);
    EXPECT_TRUE(scene.notes.empty());
  }
  const std::string complaint =
      test::refusal_of([] { (void)compile(sunk_by(0.012, kTurns[0])); }).what();
  EXPECT_EQ(
      complaint,
      "test: object: object overlaps the obstacle obstacle, and would be free of it 12 mm higher");
}

}  // namespace
}  // namespace prehend
