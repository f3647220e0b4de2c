#include "sim/robot/files/mjcf_fitting.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/shape/basic_shapes.h"
#include "tests/sim/robot/files/foreign_files.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

const Pose kAnywhere = Pose(translation({0.1, -0.2, 0.3}) *
                            Eigen::AngleAxisd(0.7, Vector3(1.0, 2.0, -1.0).normalized()));

// A box has the moments of itself, wherever it is and however it is turned.
TEST(MjcfFitting, ABoxIsFittedToItself) {
  const TriangleMesh box = transformed(make_box({0.02, 0.04, 0.06}), kAnywhere);
  for (const bool to_bounds : {false, true}) {
    const FittedGeom fitted = fitted_geom(box, "box", to_bounds);
    EXPECT_NEAR(fitted.size[0], 0.01, 1e-12);
    EXPECT_NEAR(fitted.size[1], 0.02, 1e-12);
    EXPECT_NEAR(fitted.size[2], 0.03, 1e-12);
    EXPECT_LT((fitted.X_MG.translation() - kAnywhere.translation()).norm(), 1e-12);
    const Vector3 longest = kAnywhere.linear() * Vector3::UnitZ();
    EXPECT_NEAR(std::abs(longest.dot(fitted.X_MG.linear().col(2))), 1.0, 1e-12);
  }
}

// Of the same box: means of its half sizes.
TEST(MjcfFitting, OtherShapesTakeTheMeansOfTheBox) {
  const TriangleMesh box = transformed(make_box({0.02, 0.04, 0.06}), kAnywhere);
  EXPECT_NEAR(fitted_geom(box, "sphere", false).size[0], 0.02, 1e-12);
  const FittedGeom capsule = fitted_geom(box, "capsule", false);
  EXPECT_NEAR(capsule.size[0], 0.015, 1e-12);
  EXPECT_NEAR(capsule.size[1], 0.03 - 0.0075, 1e-12);
  const FittedGeom cylinder = fitted_geom(box, "cylinder", false);
  EXPECT_NEAR(cylinder.size[0], 0.015, 1e-12);
  EXPECT_NEAR(cylinder.size[1], 0.03, 1e-12);
  const FittedGeom ellipsoid = fitted_geom(box, "ellipsoid", false);
  EXPECT_NEAR(ellipsoid.size[2], 0.03, 1e-12);
}

// Around the corners: the ball through them, the tube through those of the ends.
TEST(MjcfFitting, ShapesThatHoldTheMesh) {
  const TriangleMesh box = transformed(make_box({0.02, 0.04, 0.06}), kAnywhere);
  EXPECT_NEAR(fitted_geom(box, "sphere", true).size[0], 0.01 * std::sqrt(14.0), 1e-12);
  const double across = 0.01 * std::sqrt(5.0);
  const FittedGeom cylinder = fitted_geom(box, "cylinder", true);
  EXPECT_NEAR(cylinder.size[0], across, 1e-12);
  EXPECT_NEAR(cylinder.size[1], 0.03, 1e-12);
  // The corners are where the balls at the ends begin.
  const FittedGeom capsule = fitted_geom(box, "capsule", true);
  EXPECT_NEAR(capsule.size[0], across, 1e-12);
  EXPECT_NEAR(capsule.size[1], 0.03, 1e-6);
}

TEST(MjcfFitting, AFlatMeshIsHeldByItsBounds) {
  TriangleMesh flat;
  flat.vertices = {{0.0, 0.0, 0.0}, {0.2, 0.0, 0.0}, {0.0, 0.1, 0.0}};
  flat.triangles = {{0, 1, 2}};
  const FittedGeom fitted = fitted_geom(flat, "cylinder", false);
  EXPECT_GT(fitted.size[1], 0.05);
  EXPECT_EQ(test::refusal_of([&] { (void)fitted_geom(flat, "hfield", false); }).value(), "hfield");
}

// The file of a user: a capsule for a finger of 20 x 10 x 60 mm that stands on its frame.
TEST(MjcfFitting, GeomsOfAFile) {
  const std::filesystem::path folder = test::test_folder();
  std::string obj = test::kUnitCubeObj;
  test::write_text(folder / "cube.obj", obj);
  const auto read = [&](const std::string& compiler, const std::string& geom) {
    const std::filesystem::path file = test::write_text(
        folder / "made.xml",
        "<mujoco model=\"made\"><compiler " + compiler +
            "/><asset><mesh name=\"m\" file=\"cube.obj\" scale=\"0.02 0.01 0.06\"/></asset>"
            "<worldbody><body name=\"palm\"><geom size=\"0.02\"/><body name=\"a\"><joint "
            "name=\"j\" type=\"slide\" range=\"0 1\"/><geom mesh=\"m\" " +
            geom + "/></body></body></worldbody></mujoco>");
    return bounds(read_foreign_robot(file)->robots.at(0).robot.links[1].mesh);
  };
  const Bounds capsule = read("angle=\"radian\"", "type=\"capsule\"");
  EXPECT_NEAR(capsule.center().z(), 0.03, 1e-9);
  EXPECT_NEAR(capsule.size().z(), 2.0 * (0.03 - 0.00375 + 0.0075), 1e-9);
  const Bounds box = read("fitaabb=\"true\"", "type=\"box\" fitscale=\"0.5\"");
  EXPECT_NEAR(box.size().x(), 0.01, 1e-9);
  EXPECT_NEAR(box.size().z(), 0.03, 1e-9);
}

}  // namespace
}  // namespace prehend
