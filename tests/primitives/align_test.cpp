// The axes of primitives against closed forms.
#include "primitives/align.h"

#include <cmath>

#include <gtest/gtest.h>

#include "primitives/decompose.h"
#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/object_generator.h"

namespace prehend {
namespace {

constexpr double kAlignRounding = 1e-12;

Pose turned_about(const Vector3& axis, double angle) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  return pose;
}

TEST(Align, MomentsOfABoxesSurfaceAreThoseOfItsFaces) {
  const Vector3 s(0.2, 0.3, 0.5);
  const Vector3 middle(0.1, -0.2, 0.4);
  const SurfaceMoments m = surface_moments(transformed(make_box(s, 3), translation(middle)));
  const Vector3 faces(2.0 * s.y() * s.z(), 2.0 * s.z() * s.x(), 2.0 * s.x() * s.y());
  const double area = faces.sum();
  EXPECT_NEAR(m.area, area, kAlignRounding);
  EXPECT_LT((m.first - area * middle).norm(), kAlignRounding);
  const Matrix3 about_middle = m.second - area * middle * middle.transpose();
  for (int i = 0; i < 3; ++i) {
    // Faces across i are half a side away; on the others i runs evenly from side to side.
    const double expected = s[i] * s[i] * (faces[i] / 4.0 + (area - faces[i]) / 12.0);
    EXPECT_NEAR(about_middle(i, i), expected, kAlignRounding);
  }
  EXPECT_LT((about_middle - Matrix3(about_middle.diagonal().asDiagonal())).norm(), kAlignRounding);
}

TEST(Align, ABoxNearlyAlongTheFrameIsPutAlongIt) {
  Random random(151);
  for (int i = 0; i < 100; ++i) {
    const Vector3 axis = random.direction();
    // A quarter of a turn before: the frame's axes in another order.
    const Pose quarter = turned_about(Vector3::Unit(i % 3), 0.5 * std::acos(-1.0));
    Primitive box{Box{{0.1, 0.2, 0.3}},
                  translation({0.1, 0.0, 0.2}) * turned_about(axis, 0.001) * quarter};
    const Primitive result = along_frame(box);
    EXPECT_LT((result.X_OP.linear() - quarter.linear()).norm(), kAlignRounding);
    EXPECT_EQ(result.X_OP.translation(), box.X_OP.translation());
    // Farther from it, a box stays as it is.
    box.X_OP.linear() = turned_about(axis, 0.005).linear();
    EXPECT_EQ(along_frame(box).X_OP.linear(), box.X_OP.linear());
  }
}

// A cup with its handle in any direction.
TEST(Align, XOfACylinderPointsAlongWhatIsNotRound) {
  const TriangleMesh mug = generate_object("mug", 2000);  // with its handle along x
  Random random(152);
  for (int i = 0; i < 50; ++i) {
    const Pose X_OM = random.pose(0.3);
    const SurfaceMoments surface = surface_moments(transformed(mug, X_OM));
    const double any_turn = 3.0 * i;
    const Primitive body{Cylinder{0.05, 0.1}, X_OM * translation({0.0, 0.0, 0.05}) *
                                                  turned_about(Vector3::UnitZ(), any_turn)};
    const Matrix3 axes = aligned(body, surface).X_OP.linear();
    EXPECT_LT((axes.transpose() * axes - Matrix3::Identity()).norm(), kAlignRounding);
    EXPECT_GT(axes.determinant(), 0.0);
    EXPECT_LT((axes.col(2) - X_OM.linear().col(2)).norm(), 0.03);
    EXPECT_GT(std::abs(axes.col(0).dot(X_OM.linear().col(0))), 0.999);
  }
}

TEST(Align, WhereAllIsRoundXIsAnAxisOfTheFrame) {
  const SurfaceMoments surface = surface_moments(make_cylinder(0.03, 0.1));
  for (int i = 0; i < 20; ++i) {
    const Primitive body{Cylinder{0.03, 0.1}, turned_about(Vector3::UnitZ(), 0.3 * i)};
    EXPECT_LT((aligned(body, surface).X_OP.linear() - Matrix3::Identity()).norm(), kAlignRounding);
  }
}

TEST(Align, DecompositionsOfACupFromDifferentSamplesHaveTheSameAxes) {
  const TriangleMesh mug = generate_object("mug", 2000);
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const Matrix3 axes = decompose(mug, {.seed = seed}).primitives.front().X_OP.linear().cwiseAbs();
    EXPECT_LT((axes - Matrix3::Identity()).norm(), 1e-3) << seed;
  }
}

}  // namespace
}  // namespace prehend
