#include "sim/soft/elastic_solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/base/random.h"

namespace prehend {
namespace {

std::vector<double> even(double lower, double upper, int cells) {
  std::vector<double> values;
  for (int i = 0; i <= cells; ++i) values.push_back(lower + (upper - lower) * i / cells);
  return values;
}

// Displacements with given values of some components and no force on the others.
Eigen::VectorXd solve_with(const Eigen::SparseMatrix<double>& stiffness,
                           const std::vector<bool>& given, const Eigen::VectorXd& values) {
  const Eigen::MatrixXd k = stiffness;
  std::vector<Eigen::Index> free;
  std::vector<Eigen::Index> known;
  for (std::size_t i = 0; i < given.size(); ++i) {
    (given[i] ? known : free).push_back(static_cast<Eigen::Index>(i));
  }
  Eigen::VectorXd u = values;
  const Eigen::VectorXd known_values = values(known);
  const Eigen::VectorXd load = -(k(free, known) * known_values);
  const Eigen::MatrixXd movable = k(free, free);
  const Eigen::VectorXd moved = movable.ldlt().solve(load);
  u(free) = moved;
  return u;
}

bool on_surface(const Vector3& p) {
  return (p.array() <= 1e-12).any() || (p.array() >= 1.0 - 1e-12).any();
}

// A strain that is the same everywhere is represented exactly, whatever the shape of the elements.
class PatchTest : public testing::TestWithParam<double> {};

TEST_P(PatchTest, IsPassedByIrregularElements) {
  const std::vector<double> lines = even(0.0, 1.0, 3);
  HexMesh mesh = block_mesh(lines, lines, lines);
  Random random(7);
  for (Vector3& p : mesh.nodes) {
    if (!on_surface(p)) {
      p += 0.08 * Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    }
  }
  Matrix3 gradient;
  gradient << 1e-3, 2e-3, -1e-3, 5e-4, -2e-3, 1e-3, 3e-4, 7e-4, 4e-4;
  const Eigen::SparseMatrix<double> stiffness =
      stiffness_matrix(mesh, {.youngs_modulus = 2e6, .poissons_ratio = GetParam()});
  std::vector<bool> given;
  Eigen::VectorXd exact(3 * std::ssize(mesh.nodes));
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    given.insert(given.end(), 3, on_surface(mesh.nodes[n]));
    exact.segment<3>(3 * static_cast<Eigen::Index>(n)) = gradient * mesh.nodes[n];
  }
  EXPECT_LT((solve_with(stiffness, given, exact) - exact).cwiseAbs().maxCoeff(), 1e-10 * 1e-3);
}

INSTANTIATE_TEST_SUITE_P(ElasticSolid, PatchTest, testing::Values(0.0, 0.3, 0.49, 0.4999));

TEST(ElasticSolid, RigidMotionsNeedNoForce) {
  const std::vector<double> lines = even(-1.0, 1.0, 2);
  const HexMesh mesh = block_mesh(lines, lines, lines);
  const Eigen::SparseMatrix<double> stiffness = stiffness_matrix(mesh, {});
  Eigen::VectorXd u(3 * std::ssize(mesh.nodes));
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    u.segment<3>(3 * static_cast<Eigen::Index>(n)) =
        Vector3(1.0, -2.0, 0.5) + Vector3(0.3, 0.2, -0.7).cross(mesh.nodes[n]);
  }
  EXPECT_LT((stiffness * u).cwiseAbs().maxCoeff(), 1e-9 * stiffness.coeffs().maxCoeff());
}

// Components held on the faces of a block: along z at its bottom, and where its sides may not move.
struct Block {
  HexMesh mesh;
  std::vector<bool> held;
  std::vector<int> top;  // components along z
};
Block block(double width, double height, int cells, int layers, bool sides_held, bool bonded) {
  Block made;
  const std::vector<double> across = even(0.0, width, cells);
  made.mesh = block_mesh(across, across, even(0.0, height, layers));
  made.held.assign(3 * made.mesh.nodes.size(), false);
  for (std::size_t n = 0; n < made.mesh.nodes.size(); ++n) {
    const Vector3& p = made.mesh.nodes[n];
    for (std::size_t k = 0; k < 2; ++k) {
      const double at = p[static_cast<Eigen::Index>(k)];
      const bool side = at == 0.0 || (sides_held && at == width);
      made.held[3 * n + k] = side || (bonded && p.z() == 0.0);
    }
    made.held[3 * n + 2] = p.z() == 0.0;
    if (p.z() == height) made.top.push_back(static_cast<int>(3 * n + 2));
  }
  return made;
}

// The force that moves all of the top down by one metre.
double stiffness_of(const Block& made, const ElasticMaterial& material) {
  const Eigen::MatrixXd compliance =
      compliance_matrix(stiffness_matrix(made.mesh, material), made.held, made.top);
  return compliance.ldlt().solve(Eigen::VectorXd::Ones(compliance.rows())).sum();
}

TEST(ElasticSolid, ABlockBetweenSlipperyPlatesIsASpring) {
  const ElasticMaterial rubber{.youngs_modulus = 2.5e6, .poissons_ratio = 0.49};
  const double width = 10e-3;
  const double height = 4e-3;
  const double expected = rubber.youngs_modulus * width * width / height;
  EXPECT_NEAR(stiffness_of(block(width, height, 3, 2, false, false), rubber), expected,
              1e-9 * expected);
}

TEST(ElasticSolid, ALayerThatCannotWidenHasTheOedometricModulus) {
  const double nu = 0.49;
  const ElasticMaterial rubber{.youngs_modulus = 2.5e6, .poissons_ratio = nu};
  const double width = 10e-3;
  const double height = 2e-3;
  const double modulus = rubber.youngs_modulus * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
  const double expected = modulus * width * width / height;
  EXPECT_NEAR(stiffness_of(block(width, height, 3, 2, true, false), rubber), expected,
              1e-9 * expected);
}

// A long strip bonded between rigid plates bulges at its free edges: in the middle plane of a thin
// one the pressure obeys p'' = k^2 (p - p_0), so that its stiffness over an area is
// K (1 - tanh(k w) / (k w)) / t, with k^2 = 12 G / (K t^2), half-width w and thickness t. Source:
// Chalhoub and Kelly, "Analysis of infinite-strip-shaped base isolator with elastomer bonded
// between rigid plates", 1991; K is the modulus of a layer that cannot widen.
TEST(ElasticSolid, AThinBondedStripStiffensAsItsEdgesAllow) {
  const double nu = 0.499;
  const ElasticMaterial rubber{.youngs_modulus = 2e6, .poissons_ratio = nu};
  const double thickness = 1e-3;
  const double half_width = 10e-3;
  const double length = 0.5e-3;  // between planes that do not let it move along the strip
  const HexMesh mesh =
      block_mesh(even(0.0, half_width, 40), even(0.0, length, 1), even(0.0, thickness, 8));
  std::vector<bool> held(3 * mesh.nodes.size(), false);
  std::vector<int> top;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const Vector3& p = mesh.nodes[n];
    const bool bonded = p.z() == 0.0 || p.z() == thickness;
    held[3 * n] = bonded || p.x() == 0.0;
    held[3 * n + 1] = true;
    held[3 * n + 2] = p.z() == 0.0;
    if (p.z() == thickness) top.push_back(static_cast<int>(3 * n + 2));
  }
  const Eigen::MatrixXd compliance = compliance_matrix(stiffness_matrix(mesh, rubber), held, top);
  const double force = compliance.ldlt().solve(Eigen::VectorXd::Ones(compliance.rows())).sum();
  const double shear = rubber.youngs_modulus / (2.0 * (1.0 + nu));
  const double modulus = rubber.youngs_modulus * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
  const double k = std::sqrt(12.0 * shear / modulus) / thickness;
  const double share = 1.0 - std::tanh(k * half_width) / (k * half_width);
  EXPECT_NEAR(force / (half_width * length), modulus * share / thickness,
              0.03 * modulus * share / thickness);
}

TEST(ElasticSolid, IsSymmetricAndPositive) {
  const Block made = block(4e-3, 2e-3, 3, 2, false, true);
  const Eigen::MatrixXd compliance =
      compliance_matrix(stiffness_matrix(made.mesh, {}), made.held, made.top);
  EXPECT_TRUE(compliance == compliance.transpose());
  EXPECT_EQ(compliance.llt().info(), Eigen::Success);
}

TEST(ElasticSolid, RefusesFoldedElementsByNumber) {
  const std::vector<double> lines = even(0.0, 1.0, 2);
  HexMesh mesh = block_mesh(lines, lines, lines);
  std::swap(mesh.elements[5][0], mesh.elements[5][1]);
  try {
    stiffness_matrix(mesh, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.field(), "elements[5]");
  }
  HexMesh tangled = block_mesh(lines, lines, lines);
  tangled.nodes[13] = Vector3(2.0, 2.0, 2.0);  // the middle node, outside of the block
  EXPECT_THROW(stiffness_matrix(tangled, {}), InputError);
}

TEST(ElasticSolid, RefusesMaterialsThatAreNone) {
  const std::vector<double> lines = even(0.0, 1.0, 1);
  const HexMesh mesh = block_mesh(lines, lines, lines);
  for (const double nu : {0.5, 0.6, -0.1, std::nan("")}) {
    EXPECT_THROW(stiffness_matrix(mesh, {.youngs_modulus = 2e6, .poissons_ratio = nu}), InputError);
  }
  for (const double modulus : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(stiffness_matrix(mesh, {.youngs_modulus = modulus}), InputError);
  }
}

TEST(ElasticSolid, RefusesASolidThatNothingHolds) {
  const std::vector<double> lines = even(0.0, 1.0, 1);
  const HexMesh mesh = block_mesh(lines, lines, lines);
  const std::vector<int> loaded{0};
  EXPECT_THROW(compliance_matrix(stiffness_matrix(mesh, {}), std::vector<bool>(24, false), loaded),
               InputError);
}

TEST(HexMesh, RefusesLinesThatDoNotAscend) {
  const std::vector<double> good{0.0, 1.0};
  for (const std::vector<double>& bad : {std::vector<double>{0.0}, {1.0, 0.0}, {0.0, 0.0, 1.0}}) {
    EXPECT_THROW(block_mesh(bad, good, good), InputError);
    EXPECT_THROW(block_mesh(good, good, bad), InputError);
  }
}

}  // namespace
}  // namespace prehend
