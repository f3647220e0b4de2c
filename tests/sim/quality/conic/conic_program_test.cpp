#include "sim/quality/conic/conic_program.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "tests/support/grasp_families.h"

namespace prehend::test {
namespace {

constexpr double kClose = 1e-8;  // what a relative gap of 1e-10 leaves of a value of about one

// Minimise c'x with A x = b and G x <= h.
ConicProgram linear_program(const Eigen::VectorXd& c, const Eigen::MatrixXd& A,
                            const Eigen::VectorXd& b, const Eigen::MatrixXd& G,
                            const Eigen::VectorXd& h) {
  return {c, A, b, G, h, {static_cast<int>(h.size()), {}}};
}

// What proves the status, in the units of the program.
void expect_proved(ConicProgram p, const ConicSolution& solution, double tolerance) {
  if (p.A.rows() == 0) p.A.resize(0, p.c.size());
  if (p.G.rows() == 0) p.G.resize(0, p.c.size());
  const Eigen::VectorXd dual = p.A.transpose() * solution.y + p.G.transpose() * solution.z;
  switch (solution.status) {
    case ConicStatus::optimal:
      EXPECT_LE((p.A * solution.x - p.b).norm(), tolerance);
      EXPECT_LE((p.G * solution.x + solution.s - p.h).norm(), tolerance);
      EXPECT_LE((dual + p.c).norm(), tolerance);
      EXPECT_GE(cone_margin(p.cone, solution.s), 0.0);
      EXPECT_GE(cone_margin(p.cone, solution.z), 0.0);
      EXPECT_NEAR(p.c.dot(solution.x), -p.b.dot(solution.y) - p.h.dot(solution.z), tolerance);
      break;
    case ConicStatus::primal_infeasible:
      EXPECT_LE(dual.norm(), tolerance);
      EXPECT_GE(cone_margin(p.cone, solution.z), 0.0);
      EXPECT_NEAR(p.b.dot(solution.y) + p.h.dot(solution.z), -1.0, 1e-12);
      break;
    case ConicStatus::dual_infeasible:
      EXPECT_LE((p.A * solution.x).norm(), tolerance);
      EXPECT_LE((p.G * solution.x + solution.s).norm(), tolerance);
      EXPECT_GE(cone_margin(p.cone, solution.s), 0.0);
      EXPECT_NEAR(p.c.dot(solution.x), -1.0, 1e-12);
      break;
    case ConicStatus::limit:
      ADD_FAILURE() << "limit";
  }
}

void expect_value(const ConicProgram& p, double value) {
  const ConicSolution solution = solve(p);
  ASSERT_EQ(solution.status, ConicStatus::optimal);
  expect_proved(p, solution, kClose);
  EXPECT_NEAR(solution.primal_value, value, kClose);
  EXPECT_NEAR(solution.dual_value, value, kClose);
}

// Minimise c'x over the ball |x - centre| <= radius.
ConicProgram ball_program(const Eigen::VectorXd& c, const Eigen::VectorXd& centre, double radius) {
  const Eigen::Index n = c.size();
  ConicProgram p;
  p.c = c;
  p.A.resize(0, n);
  p.G = Eigen::MatrixXd::Zero(n + 1, n);
  p.G.bottomRows(n) = -Eigen::MatrixXd::Identity(n, n);
  p.h = Eigen::VectorXd::Zero(n + 1);
  p.h[0] = radius;
  p.h.tail(n) = -centre;
  p.cone.second_order = {static_cast<int>(n) + 1};
  return p;
}

TEST(ConicProgram, LinearProgramWithKnownCorner) {
  // Dantzig's: maximise 3 x + 5 y, x <= 4, 2 y <= 12, 3 x + 2 y <= 18: 36 at (2, 6).
  Eigen::MatrixXd G(5, 2);
  G << 1, 0, 0, 2, 3, 2, -1, 0, 0, -1;
  Eigen::VectorXd h(5);
  h << 4, 12, 18, 0, 0;
  const ConicProgram p =
      linear_program(Eigen::Vector2d(-3, -5), Eigen::MatrixXd(0, 2), Eigen::VectorXd(0), G, h);
  expect_value(p, -36.0);
  EXPECT_NEAR((solve(p).x - Eigen::Vector2d(2, 6)).norm(), 0.0, kClose);
}

TEST(ConicProgram, SimplexPicksTheSmallestCost) {
  Random random(1);
  for (int n = 1; n <= 20; ++n) {
    Eigen::VectorXd c(n);
    for (int i = 0; i < n; ++i) c[i] = random.uniform(-3.0, 3.0);
    expect_value(linear_program(c, Eigen::RowVectorXd::Ones(n), Eigen::VectorXd::Ones(1),
                                -Eigen::MatrixXd::Identity(n, n), Eigen::VectorXd::Zero(n)),
                 c.minCoeff());
  }
}

TEST(ConicProgram, LinearOverABall) {
  Random random(2);
  for (int i = 0; i < 40; ++i) {
    const Eigen::Vector3d c = random.vector(0.1, 4.0);
    const Eigen::Vector3d centre = random.vector(0.0, 2.0);
    const double radius = random.uniform(0.01, 2.0);
    const ConicProgram p = ball_program(c, centre, radius);
    expect_value(p, c.dot(centre) - radius * c.norm());
    EXPECT_NEAR((solve(p).x - (centre - radius * c.normalized())).norm(), 0.0, 1e-5);
  }
}

TEST(ConicProgram, DistanceFromAnAffineSubspace) {
  // Minimise t with |x| <= t and a'x = b: |b| / |a|.
  Random random(3);
  for (int i = 0; i < 40; ++i) {
    const Eigen::Vector3d a = random.vector(0.1, 5.0);
    const double b = random.uniform(-3.0, 3.0);
    ConicProgram p;
    p.c = Eigen::Vector4d(1, 0, 0, 0);
    p.A = Eigen::RowVector4d(0, a.x(), a.y(), a.z());
    p.b = Eigen::VectorXd::Constant(1, b);
    p.G = -Eigen::Matrix4d::Identity();
    p.h = Eigen::Vector4d::Zero();
    p.cone.second_order = {4};
    expect_value(p, std::abs(b) / a.norm());
  }
}

TEST(ConicProgram, MixedCones) {
  // The lowest point of the unit disc with x >= 0.6 and x + y >= 0.
  ConicProgram p;
  p.c = Eigen::Vector2d(0, 1);
  p.G.resize(5, 2);
  p.G << -1, 0, -1, -1, 0, 0, -1, 0, 0, -1;
  p.h.resize(5);
  p.h << -0.6, 0, 1, 0, 0;
  p.cone = {2, {3}};
  expect_value(p, -std::sqrt(0.5));
}

TEST(ConicProgram, NoConesAtAll) {
  ConicProgram p;
  p.c = Eigen::Vector2d(1, 2);
  p.A = Eigen::Matrix2d::Identity();
  p.b = Eigen::Vector2d(3, 4);
  expect_value(p, 11.0);
}

TEST(ConicProgram, DependentRowsAndUnseenDirections) {
  // x + y = 1 three times over, a third variable nobody asks about.
  ConicProgram p =
      linear_program(Eigen::Vector3d(1, 2, 0), Eigen::MatrixXd(3, 3), Eigen::Vector3d(1, 2, -0.1),
                     Eigen::MatrixXd(2, 3), Eigen::Vector2d::Zero());
  p.A << 1, 1, 0, 2, 2, 0, -0.1, -0.1, 0;
  p.G << -1, 0, 0, 0, -1, 0;
  expect_value(p, 1.0);
  p.b[1] = 2.5;  // no longer the same row
  ConicSolution solution = solve(p);
  EXPECT_EQ(solution.status, ConicStatus::primal_infeasible);
  expect_proved(p, solution, 1e-12);
  p.b[1] = 2.0;
  p.c[2] = -0.5;  // now the third variable pays
  solution = solve(p);
  EXPECT_EQ(solution.status, ConicStatus::dual_infeasible);
  expect_proved(p, solution, 1e-12);
}

TEST(ConicProgram, InfeasibleIsProved) {
  // x <= -margin and x >= margin; a disc that a half plane misses by a margin.
  for (const double margin : {1e-4, 1e-2, 1.0, 100.0}) {
    const ConicProgram line =
        linear_program(Eigen::VectorXd::Ones(1), Eigen::MatrixXd(0, 1), Eigen::VectorXd(0),
                       Eigen::Vector2d(1, -1), Eigen::Vector2d(-margin, -margin));
    const ConicSolution first = solve(line);
    EXPECT_EQ(first.status, ConicStatus::primal_infeasible) << margin;
    expect_proved(line, first, 1e-8 / margin);

    ConicProgram disc;
    disc.c = Eigen::Vector2d(1, 1);
    disc.G.resize(4, 2);
    disc.G << -0.6, -0.8, 0, 0, -1, 0, 0, -1;
    disc.h.resize(4);
    disc.h << -1 - margin, 1, 0, 0;
    disc.cone = {1, {3}};
    const ConicSolution second = solve(disc);
    EXPECT_EQ(second.status, ConicStatus::primal_infeasible) << margin;
    expect_proved(disc, second, 1e-8 / margin);
  }
}

TEST(ConicProgram, UnboundedIsProved) {
  // Down a ray of the orthant, and of the cone.
  const ConicProgram orthant = linear_program(
      Eigen::Vector2d(1, -1), Eigen::RowVector2d(1, -1), Eigen::VectorXd::Constant(1, 0.3),
      -Eigen::Matrix2d::Identity(), Eigen::Vector2d::Zero());
  expect_value(orthant, 0.3);
  ConicProgram ray = orthant;
  ray.c = Eigen::Vector2d(-1, 0);
  ConicSolution solution = solve(ray);
  EXPECT_EQ(solution.status, ConicStatus::dual_infeasible);
  expect_proved(ray, solution, kClose);

  ConicProgram cone;
  cone.c = Eigen::Vector3d(1, 2, 0);
  cone.G = -Eigen::Matrix3d::Identity();
  cone.h = Eigen::Vector3d::Zero();
  cone.cone.second_order = {3};
  solution = solve(cone);
  EXPECT_EQ(solution.status, ConicStatus::dual_infeasible);
  expect_proved(cone, solution, kClose);
}

// Random programs made with their solution: complementary s and z on the border of the cones.
TEST(ConicProgram, RandomWithKnownValue) {
  Random random(4);
  for (int round = 0; round < 100; ++round) {
    ConicProgram p;
    p.cone.orthant = random.integer(0, 6);
    for (int k = random.integer(1, 5); k > 0; --k) {
      p.cone.second_order.push_back(random.integer(2, 5));
    }
    const int m = p.cone.rows();
    const int n = random.integer(1, m);
    const int rows = random.integer(0, n - 1);
    const auto fill = [&](Eigen::MatrixXd& matrix, int height, int width) {
      matrix.resize(height, width);
      for (double& value : matrix.reshaped()) value = random.uniform(-1.0, 1.0);
    };
    fill(p.A, rows, n);
    fill(p.G, m, n);
    Eigen::VectorXd s = Eigen::VectorXd::Zero(m);
    Eigen::VectorXd z = Eigen::VectorXd::Zero(m);
    for (int i = 0; i < p.cone.orthant; ++i) (random.uniform() < 0.5 ? s : z)[i] = random.uniform();
    for_each_second_order(p.cone, [&](Eigen::Index first, Eigen::Index height) {
      for (Eigen::Index i = 1; i < height; ++i) s[first + i] = random.uniform(-1.0, 1.0);
      s[first] = s.segment(first + 1, height - 1).norm();
      z.segment(first, height) = -random.uniform() * s.segment(first, height);
      z[first] = -z[first];
    });
    Eigen::MatrixXd x;
    Eigen::MatrixXd y;
    fill(x, n, 1);
    fill(y, rows, 1);
    p.b = p.A * x;
    p.h = p.G * x + s;
    p.c = -p.A.transpose() * y - p.G.transpose() * z;
    expect_value(p, (p.c.transpose() * x).value());
  }
}

TEST(ConicProgram, BadlyScaled) {
  // The ball and the simplex in units that differ by up to 1e9: the same accuracy.
  for (const double unit : {1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9}) {
    const Eigen::Vector3d c(1, -2, 2);
    const ConicSolution ball = solve(ball_program(c / unit, unit * Eigen::Vector3d::Ones(), unit));
    EXPECT_EQ(ball.status, ConicStatus::optimal) << unit;
    EXPECT_NEAR(ball.primal_value, 1.0 - 3.0, kClose) << unit;

    const Eigen::Vector3d units(1.0, unit, 1.0);
    const Eigen::Vector3d costs(3, 1, 2);
    const ConicSolution simplex =
        solve(linear_program(costs.cwiseProduct(units), units.transpose(), Eigen::VectorXd::Ones(1),
                             -Eigen::MatrixXd::Identity(3, 3), Eigen::VectorXd::Zero(3)));
    EXPECT_EQ(simplex.status, ConicStatus::optimal) << unit;
    EXPECT_NEAR(simplex.primal_value, 1.0, kClose) << unit;
    EXPECT_NEAR(simplex.x[1] * unit, 1.0, kClose) << unit;
  }
}

TEST(ConicProgram, SameInputSameBytes) {
  const ConicProgram p =
      ball_program(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(0.1, 0.2, 0.3), 0.7);
  const ConicSolution first = solve(p);
  const ConicSolution second = solve(p);
  EXPECT_EQ(first.x, second.x);
  EXPECT_EQ(first.z, second.z);
  EXPECT_EQ(first.iterations, second.iterations);
}

TEST(ConicProgram, LimitIsReported) {
  const ConicProgram p = ball_program(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d::Ones(), 0.7);
  const ConicSolution solution = solve(p, {.max_iterations = 2});
  EXPECT_EQ(solution.status, ConicStatus::limit);
  EXPECT_TRUE(solution.x.allFinite());
}

TEST(ConicProgram, RejectsWrongShapesAndValues) {
  const ConicProgram good = ball_program(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d::Ones(), 0.7);
  const auto rejects = [&](auto change) {
    ConicProgram bad = good;
    change(bad);
    EXPECT_THROW(solve(bad), InputError);
  };
  rejects([](ConicProgram& p) { p.c.conservativeResize(2); });
  rejects([](ConicProgram& p) { p.h.conservativeResize(3); });
  rejects([](ConicProgram& p) { p.b = Eigen::VectorXd::Ones(1); });
  rejects([](ConicProgram& p) { p.cone.second_order = {3}; });
  rejects([](ConicProgram& p) { p.cone.second_order = {4, 0}; });
  rejects([](ConicProgram& p) { p.cone = {-1, {5}}; });
  rejects([](ConicProgram& p) { p.c[0] = std::numeric_limits<double>::quiet_NaN(); });
  rejects([](ConicProgram& p) { p.G(0, 0) = std::numeric_limits<double>::infinity(); });
  EXPECT_THROW(solve(good, {.tolerance = 0.0}), InputError);
  EXPECT_THROW(solve(good, {.max_iterations = 0}), InputError);
}

}  // namespace
}  // namespace prehend::test
