#include "sim/soft/pad.h"

#include <cmath>
#include <limits>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/shape/basic_shapes.h"
#include "sim/soft/elastic_solid.h"
#include "sim/soft/pad_cache.h"
#include "sim/soft/press_pad.h"

namespace prehend {
namespace {

constexpr double kThickness = 2e-3;

// The pad covers the top of a block, z = 5 mm.
ProximityMesh finger() { return ProximityMesh(make_box({0.016, 0.012, 0.01})); }

PadShape on_top() {
  return {.outward_L = Vector3::UnitZ(),
          .thickness = kThickness,
          .material = {.youngs_modulus = 2e6, .poissons_ratio = 0.4}};
}

// Pressed along +z on the underside of a plate that is much larger.
struct Pressed {
  PadWorkspace workspace;
  PadPatch patch;
  Pose X_OL = Pose::Identity();
};
Pressed press(const TriangleMesh& object, const Pad& pad, const Pose& X_OL, double load) {
  Pressed pressed;
  pressed.X_OL = X_OL;
  press_pad(ProximityMesh(object), pad, X_OL, X_OL.linear() * Vector3::UnitZ(), load,
            pressed.workspace, pressed.patch);
  return pressed;
}

// The plate's lower face is 0.05 mm above the pad.
Pose below_plate(double height) { return translation({0.0, 0.0, -height / 2 - 5e-3 - 5e-5}); }

TEST(Pad, CoversWhatFacesOutward) {
  const PadMesh mesh = pad_mesh(finger(), on_top(), {});
  EXPECT_EQ(mesh.surface_nodes, 17 * 13);
  for (std::size_t n = 0; n < static_cast<std::size_t>(mesh.surface_nodes); ++n) {
    EXPECT_NEAR(mesh.mesh.nodes[n].z(), 5e-3, 1e-12);
    EXPECT_NEAR(mesh.normals_L[n].z(), 1.0, 1e-12);
  }
  double area = 0.0;
  for (const double part : mesh.areas) area += part;
  EXPECT_NEAR(area, 0.016 * 0.012, 0.001 * area);
  double lowest = 1.0;
  for (const Vector3& p : mesh.mesh.nodes) lowest = std::min(lowest, p.z());
  EXPECT_NEAR(lowest, 5e-3 - kThickness, 1e-12);
}

TEST(Pad, HasFewerNodesThanAsked) {
  for (const int most : {4, 50, 120}) {
    const PadMesh mesh = pad_mesh(finger(), on_top(), {.most_nodes = most});
    EXPECT_LE(mesh.surface_nodes, most);
    EXPECT_GE(mesh.surface_nodes, 4);
  }
}

TEST(Pad, FollowsARoundTip) {
  const ProximityMesh tip(make_geodesic_sphere(0.012, 24));
  const PadMesh mesh = pad_mesh(tip, on_top(), {});
  for (std::size_t n = 0; n < static_cast<std::size_t>(mesh.surface_nodes); ++n) {
    EXPECT_NEAR(mesh.mesh.nodes[n].norm(), 0.012, 1e-4);
    EXPECT_GT(mesh.normals_L[n].z(), 0.5);
  }
  EXPECT_NO_THROW(stiffness_matrix(mesh.mesh, on_top().material));
}

// Which field an InputError names.
template <typename Call>
std::string refused(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.field();
  }
  return "accepted";
}

TEST(Pad, RefusesWhatCannotBeOne) {
  PadShape thick = on_top();
  thick.thickness = 0.011;
  EXPECT_EQ(refused([&] { check_pad(finger(), thick, {}); }), "thickness");
  PadShape whole = on_top();
  whole.thickness = 0.01;  // as thick as the link
  EXPECT_EQ(refused([&] { check_pad(finger(), whole, {}); }), "accepted");
  PadShape folded = on_top();
  folded.thickness = 0.014;  // beyond the middle of a round tip of 12 mm
  EXPECT_NE(refused([&] { check_pad(ProximityMesh(make_geodesic_sphere(0.012, 24)), folded, {}); }),
            "accepted");
  PadShape rubber = on_top();
  rubber.material.poissons_ratio = 0.5;
  EXPECT_EQ(refused([&] { check_pad(finger(), rubber, {}); }), "poissons_ratio");
  rubber.material = {.youngs_modulus = 0.0};
  EXPECT_EQ(refused([&] { check_pad(finger(), rubber, {}); }), "youngs_modulus");
}

TEST(Pad, IsMadeOnceForTheSameOptions) {
  const PadCache cache(finger(), on_top());
  const auto pad = cache.get({.most_nodes = 30});
  EXPECT_EQ(cache.get({.most_nodes = 30}), pad);
  EXPECT_NE(cache.get({.most_nodes = 20}), pad);
}

// Far from its rim a thin pad cannot widen; the load is that of the whole pad.
TEST(PressPad, BearsTheLoadOnAPlate) {
  const Pad pad = make_pad(finger(), on_top(), {});
  const TriangleMesh plate = make_box({0.1, 0.1, 0.02});
  const Pressed pressed = press(plate, pad, below_plate(0.02), 20.0);
  EXPECT_NEAR(pressed.patch.load, 20.0, 1e-9);
  EXPECT_EQ(pressed.patch.points.size(), pad.nodes_L.size());
  const LimitSurface surface = limit_surface(pressed.patch.points);
  EXPECT_NEAR(surface.center.x(), 0.0, 1e-9);
  EXPECT_NEAR(surface.center.y(), 0.0, 1e-9);
  EXPECT_NEAR(surface.normal.z(), 1.0, 1e-12);
  // Between the moduli of a free and of a confined layer.
  const double pressure = 20.0 / (0.016 * 0.012);
  const double strain = pressed.patch.approach / kThickness;
  const double confined = 2e6 * 0.6 / (1.4 * 0.2);
  EXPECT_LT(strain, pressure / 2e6);
  EXPECT_GT(strain, pressure / confined);
  for (const PressedPoint& point : pressed.patch.points) {
    EXPECT_NEAR(point.position.z(), -0.01, 1e-12);
  }
}

TEST(PressPad, DoesNotDependOnWhereItHappens) {
  const Pad pad = make_pad(finger(), on_top(), {.most_nodes = 100});
  const TriangleMesh ball = make_geodesic_sphere(0.02, 40);
  const Pose X_OL = translation({1e-3, -5e-4, -0.02 - 5e-3 - 5e-5});
  const Pressed here = press(ball, pad, X_OL, 5.0);
  Pose turn(Eigen::AngleAxisd(1.1, Vector3(1, 2, -1).normalized()));
  turn.translation() = Vector3(0.3, -0.2, 0.1);
  const Pressed there = press(transformed(ball, turn), pad, turn * X_OL, 5.0);
  ASSERT_EQ(here.patch.nodes, there.patch.nodes);
  EXPECT_NEAR(here.patch.approach, there.patch.approach, 1e-9);
  EXPECT_LT(here.patch.nodes.size(), pad.nodes_L.size() / 2);
  for (std::size_t i = 0; i < here.patch.points.size(); ++i) {
    EXPECT_NEAR(here.patch.points[i].force, there.patch.points[i].force, 1e-6);
  }
}

TEST(PressPad, StopsAtTheLargestStrain) {
  const Pad pad = make_pad(finger(), on_top(), {.most_nodes = 60});
  const Pressed pressed = press(make_box({0.1, 0.1, 0.02}), pad, below_plate(0.02), 1e6);
  EXPECT_NEAR(pressed.patch.approach, kLargestStrain * kThickness, 1e-12);
  EXPECT_LT(pressed.patch.load, 1e6);
  EXPECT_GT(pressed.patch.load, 0.0);
}

TEST(PressPad, FindsNothingWhereNothingIs) {
  const Pad pad = make_pad(finger(), on_top(), {.most_nodes = 30});
  const Pressed pressed = press(make_box({0.1, 0.1, 0.02}), pad, below_plate(0.2), 1.0);
  EXPECT_TRUE(pressed.patch.points.empty());
  EXPECT_EQ(pressed.patch.load, 0.0);
}

// Small motions about a place in the pad are those of a spring: energy is never negative, and a
// wide thin pad answers to a shift like G A / t, to a good part.
TEST(PressPad, AnswersToMotionsLikeASpring) {
  const Pad pad = make_pad(finger(), on_top(), {});
  const Pressed pressed = press(make_box({0.1, 0.1, 0.02}), pad, below_plate(0.02), 20.0);
  const Eigen::Matrix<double, 6, 6> stiffness =
      patch_stiffness(pad, pressed.X_OL, pressed.patch, Vector3(0, 0, -0.01));
  EXPECT_TRUE(stiffness == stiffness.transpose());
  EXPECT_GT((Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(stiffness)
                 .eigenvalues()
                 .minCoeff()),
            0.0);
  const double shear = 2e6 / 2.8 * 0.016 * 0.012 / kThickness;
  EXPECT_LT(stiffness(0, 0), shear);
  EXPECT_GT(stiffness(0, 0), 0.8 * shear);
  EXPECT_GT(stiffness(2, 2), 20.0 / pressed.patch.approach);
}

}  // namespace
}  // namespace prehend
