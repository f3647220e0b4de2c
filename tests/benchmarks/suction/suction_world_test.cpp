#include "benchmarks/suction/suction_world.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/gravity.h"
#include "sim/base/input_error.h"
#include "sim/shape/basic_shapes.h"

namespace prehend::bench {
namespace {

constexpr double kEdge = 0.08;     // of the cube [m]
constexpr double kRadius = 0.015;  // of the lip [m]
constexpr double kPull = 40.0;     // N
constexpr double kStiffness = 14000.0;
constexpr double kFriction = 0.5;

// A cube whose centre is at the origin, with a cup above the middle of its top.
HangingObject hanging_cube(double weight, const Vector3& down) {
  HangingObject object;
  const TriangleMesh cube = make_box(Vector3::Constant(kEdge));
  object.inertial = inertial_of_mass(cube, weight / kStandardGravity);
  object.pieces = {cube};
  object.cups = {{.center_O = {0.0, 0.0, 0.5 * kEdge},
                  .axis_O = -Vector3::UnitZ(),
                  .radius = kRadius,
                  .travel = 0.01,
                  .stiffness = kStiffness,
                  .friction = kFriction,
                  .pull = kPull}};
  object.down_O = down;
  return object;
}

// Along the axis a cup holds its pull, and gives way by the weight over its stiffness.
TEST(SuctionWorld, ACupHoldsItsPullAlongItsAxis) {
  for (const double part : {0.5, 0.9}) {
    const HangingEnd end =
        hang_in_mujoco(hanging_cube(part * kPull, -Vector3::UnitZ()), LiftedLip::leaks);
    EXPECT_TRUE(end.held) << part;
    EXPECT_FALSE(end.lifted) << part;
    // Contacts give way a little as well.
    EXPECT_NEAR(end.moved, part * kPull / kStiffness, 0.1 * kPull / kStiffness) << part;
    EXPECT_LT(end.tilted, 1e-3) << part;
  }
  for (const LiftedLip lifted : {LiftedLip::adheres, LiftedLip::leaks}) {
    const HangingEnd end = hang_in_mujoco(hanging_cube(1.05 * kPull, -Vector3::UnitZ()), lifted);
    EXPECT_FALSE(end.held);
    EXPECT_TRUE(end.lifted);
  }
}

// The weight at the middle of the lip, in place of the cube's own: friction holds mu times the
// pull.
TEST(SuctionWorld, ACupHoldsItsFrictionAcrossItsAxis) {
  for (const double part : {0.9, 1.1}) {
    HangingObject object = hanging_cube(part * kFriction * kPull, Vector3::UnitX());
    object.inertial.center_of_mass = {0.0, 0.0, 0.5 * kEdge};
    EXPECT_EQ(hang_in_mujoco(object, LiftedLip::leaks).held, part < 1.0) << part;
  }
}

// A torque about a tangent relaxes one side of the lip at radius times the force that presses it
// over 2, and tilts the lip by itself over stiffness times radius^2 / 2.
TEST(SuctionWorld, ATorqueLiftsTheLip) {
  for (const double part : {0.8, 1.25}) {
    const double weight = 4.0;  // N
    HangingObject object = hanging_cube(weight, -Vector3::UnitZ());
    const double lever = part * 0.5 * kRadius * (kPull - weight) / weight;
    object.inertial.center_of_mass = {lever, 0.0, 0.0};
    const HangingEnd end = hang_in_mujoco(object, LiftedLip::leaks);
    EXPECT_EQ(end.held, part < 1.0) << part;
    EXPECT_EQ(end.lifted, part > 1.0) << part;
    // Its points are at 16 angles, of which one is that of the tilt or nearly so.
    EXPECT_NEAR(end.linear_margin, kPull / (weight + 2.0 * lever * weight / kRadius), 0.02);
    if (part < 1.0) {
      const double tilt = lever * weight / (0.5 * kStiffness * kRadius * kRadius);
      EXPECT_NEAR(end.tilted, tilt, 0.15 * tilt);
    }
  }
}

TEST(SuctionWorld, ALipBesideTheObjectIsRefused) {
  HangingObject object = hanging_cube(1.0, -Vector3::UnitZ());
  object.cups[0].center_O.x() = 0.5 * kEdge;
  EXPECT_THROW(hang_in_mujoco(object, LiftedLip::leaks), InputError);
}

}  // namespace
}  // namespace prehend::bench
