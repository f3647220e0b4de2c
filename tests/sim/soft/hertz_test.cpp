// Contacts on a half-space whose closed forms are known.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/soft/limit_surface.h"
#include "sim/soft/shear.h"
#include "tests/sim/soft/half_space.h"

namespace prehend {
namespace {

using testing_support::Hertz;
using testing_support::QuarterSpace;
using testing_support::radius_by_moment;

struct HertzErrors {
  double radius = 0.0;
  double pressure = 0.0;
};

HertzErrors hertz_errors(int cells) {
  const Hertz hertz;
  const QuarterSpace space(hertz, cells);
  const NodeForces forces = space.press(hertz);
  const double pressure = forces.force[0] / space.area(0);
  return {std::abs(radius_by_moment(space.nodes, forces.force) / hertz.radius - 1.0),
          std::abs(pressure / hertz.largest_pressure() - 1.0)};
}

TEST(Hertz, ComesNearerAsTheMeshIsRefined) {
  const HertzErrors coarse = hertz_errors(2);
  const HertzErrors fine = hertz_errors(4);
  EXPECT_LT(fine.radius, 0.03);
  EXPECT_LT(fine.pressure, 0.03);
  // Of at least first order: half the size, half the error.
  EXPECT_LT(fine.radius, 0.5 * coarse.radius);
}

TEST(Hertz, HasTheTorsionOfItsPressure) {
  const Hertz hertz;
  const QuarterSpace space(hertz, 4);
  const NodeForces forces = space.press(hertz);
  std::vector<PressedPoint> points;
  for (std::size_t i = 0; i < space.nodes.size(); ++i) {
    for (const double x : {1.0, -1.0}) {
      for (const double y : {1.0, -1.0}) {
        const Vector3 p = space.nodes[i].cwiseProduct(Vector3(x, y, 1.0));
        points.push_back({p, Vector3::UnitZ(), forces.force[static_cast<Eigen::Index>(i)]});
      }
    }
  }
  const LimitSurface surface = limit_surface(points);
  EXPECT_NEAR(surface.load, hertz.load(), 1e-9 * hertz.load());
  EXPECT_NEAR(surface.torsion, 3.0 * std::numbers::pi / 16.0 * hertz.radius,
              0.02 * surface.torsion);
  EXPECT_LT(surface.center.head<2>().norm(), 1e-12);
}

// Partial slip beneath a tangential load Q: what sticks is a disc of radius
// a (1 - Q / (mu P))^(1/3). Source: Johnson, section 7.2 (Cattaneo 1938, Mindlin 1949).
TEST(Hertz, SticksInTheMiddleUnderATangentialLoad) {
  const Hertz hertz;
  const double friction = 0.5;
  const QuarterSpace space(hertz, 6);
  const NodeForces pressed = space.press(hertz);
  std::vector<std::size_t> touching;
  std::vector<Vector3> nodes;
  for (std::size_t i = 0; i < space.nodes.size(); ++i) {
    // Where y = 0 the symmetry leaves the motion along x free; x = 0 does too.
    if (pressed.force[static_cast<Eigen::Index>(i)] <= 0.0) continue;
    touching.push_back(i);
    nodes.push_back(space.nodes[i]);
  }
  const auto count = static_cast<Eigen::Index>(touching.size());
  const Eigen::MatrixXd along_x = space.shear_compliance(touching);
  ShearProblem problem;
  // The second tangent does not move: nothing couples it to the first, whose order it has.
  problem.compliance = Eigen::MatrixXd::Zero(2 * count, 2 * count);
  problem.motion = Eigen::VectorXd::Zero(2 * count);
  problem.limit.resize(count);
  const double full_slip = 3.0 * friction * hertz.load() * (2.0 - hertz.material.poissons_ratio) /
                           (16.0 * hertz.radius * hertz.shear_modulus());
  for (Eigen::Index i = 0; i < count; ++i) {
    problem.limit[i] =
        friction * pressed.force[static_cast<Eigen::Index>(touching[static_cast<std::size_t>(i)])];
    problem.compliance(2 * i + 1, 2 * i + 1) = along_x(i, i);
    for (Eigen::Index k = 0; k < count; ++k) problem.compliance(2 * i, 2 * k) = along_x(i, k);
  }
  for (const double part : {0.3, 0.5, 0.7}) {
    for (Eigen::Index i = 0; i < count; ++i) problem.motion[2 * i] = -part * full_slip;
    const ShearForces forces = shear(problem);
    ASSERT_TRUE(forces.converged);
    Eigen::VectorXd spare(count);  // what friction could bear beyond what it bears
    double load = 0.0;
    for (Eigen::Index i = 0; i < count; ++i) {
      const Eigen::Vector2d force = forces.force.segment<2>(2 * i);
      load += force.x();
      spare[i] = problem.limit[i] - force.norm();
    }
    const double share = load / problem.limit.sum();
    const double expected = hertz.radius * std::cbrt(1.0 - share);
    EXPECT_NEAR(radius_by_moment(nodes, spare), expected, 0.05 * expected) << part;
  }
  for (Eigen::Index i = 0; i < count; ++i) problem.motion[2 * i] = -1.3 * full_slip;
  const ShearForces sliding = shear(problem);
  EXPECT_TRUE(std::ranges::none_of(sliding.sticking, [](bool sticks) { return sticks; }));
}

}  // namespace
}  // namespace prehend
