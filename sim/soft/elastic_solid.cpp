#include "sim/soft/elastic_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include "sim/base/index.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

// Corners of the reference cube [-1, 1]^3, in the order of a Hexahedron.
constexpr std::array<std::array<double, 3>, 8> kCorners{{{-1, -1, -1},
                                                         {1, -1, -1},
                                                         {1, 1, -1},
                                                         {-1, 1, -1},
                                                         {-1, -1, 1},
                                                         {1, -1, 1},
                                                         {1, 1, 1},
                                                         {-1, 1, 1}}};

using Corners8 = Eigen::Matrix<double, 3, 8>;
using Stiffness24 = Eigen::Matrix<double, 24, 24>;

// Derivatives of the eight trilinear functions with respect to the reference coordinates.
Corners8 reference_gradients(const Eigen::Vector3d& at) {
  Corners8 gradients;
  for (std::size_t a = 0; a < 8; ++a) {
    const auto& c = kCorners[a];
    const Eigen::Vector3d factor(1.0 + c[0] * at[0], 1.0 + c[1] * at[1], 1.0 + c[2] * at[2]);
    gradients.col(static_cast<Eigen::Index>(a)) =
        0.125 * Eigen::Vector3d(c[0] * factor[1] * factor[2], c[1] * factor[0] * factor[2],
                                c[2] * factor[0] * factor[1]);
  }
  return gradients;
}

struct GaussPoint {
  Corners8 gradients;   // of the eight functions [1/m]
  double volume = 0.0;  // [m^3]
};

void require_unfolded(double determinant, std::size_t element) {
  require(determinant > 0.0, {.field = "elements[" + std::to_string(element) + "]",
                              .problem = "is folded or turned inside out"});
}

std::array<GaussPoint, 8> gauss_points(const Corners8& corners, std::size_t element) {
  std::array<GaussPoint, 8> points;
  const double at = 1.0 / std::sqrt(3.0);
  for (std::size_t g = 0; g < 8; ++g) {
    const Eigen::Vector3d corner(kCorners[g][0], kCorners[g][1], kCorners[g][2]);
    require_unfolded((corners * reference_gradients(corner).transpose()).determinant(), element);
    const Corners8 reference = reference_gradients(at * corner);
    const Eigen::Matrix3d jacobian = corners * reference.transpose();
    const double determinant = jacobian.determinant();
    require_unfolded(determinant, element);
    points[g].volume = determinant;  // the weights of the 2 x 2 x 2 rule are 1
    points[g].gradients = jacobian.inverse().transpose() * reference;
  }
  return points;
}

// Shear of the deviatoric strain at each point, and the mean dilatation of the element: with the
// gradients g_a of the functions and their mean b_a,
// K_ab = sum over points of G ((g_a . g_b) I + g_b g_a' - 2/3 g_a g_b') + K V b_a b_b'.
Stiffness24 element_stiffness(const Corners8& corners, const ElasticMaterial& material,
                              std::size_t element) {
  const double shear = material.youngs_modulus / (2.0 * (1.0 + material.poissons_ratio));
  const double bulk = material.youngs_modulus / (3.0 * (1.0 - 2.0 * material.poissons_ratio));
  const std::array<GaussPoint, 8> points = gauss_points(corners, element);
  Stiffness24 stiffness = Stiffness24::Zero();
  Corners8 mean = Corners8::Zero();
  double volume = 0.0;
  for (const GaussPoint& point : points) {
    mean += point.volume * point.gradients;
    volume += point.volume;
    for (Eigen::Index a = 0; a < 8; ++a) {
      const Eigen::Vector3d ga = point.gradients.col(a);
      for (Eigen::Index b = 0; b < 8; ++b) {
        const Eigen::Vector3d gb = point.gradients.col(b);
        Eigen::Matrix3d block = gb * ga.transpose() - 2.0 / 3.0 * ga * gb.transpose();
        block.diagonal().array() += ga.dot(gb);
        stiffness.block<3, 3>(3 * a, 3 * b) += shear * point.volume * block;
      }
    }
  }
  const Eigen::Map<const Eigen::Matrix<double, 24, 1>> flat(mean.data());
  stiffness += bulk / volume * flat * flat.transpose();
  return stiffness;
}

}  // namespace

Eigen::SparseMatrix<double> stiffness_matrix(const HexMesh& mesh, const ElasticMaterial& material) {
  require_in(kYoungsModulus, material.youngs_modulus, "youngs_modulus");
  require_in(kPoissonsRatio, material.poissons_ratio, "poissons_ratio");
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(mesh.elements.size() * 576);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const Hexahedron& element = mesh.elements[e];
    Corners8 corners;
    for (std::size_t a = 0; a < 8; ++a) {
      corners.col(static_cast<Eigen::Index>(a)) = mesh.nodes[index(element[a])];
    }
    const Stiffness24 stiffness = element_stiffness(corners, material, e);
    for (std::size_t a = 0; a < 24; ++a) {
      for (std::size_t b = 0; b < 24; ++b) {
        entries.emplace_back(3 * element[a / 3] + static_cast<int>(a % 3),
                             3 * element[b / 3] + static_cast<int>(b % 3),
                             stiffness(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)));
      }
    }
  }
  const Eigen::Index size = 3 * std::ssize(mesh.nodes);
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Eigen::MatrixXd compliance_matrix(const Eigen::SparseMatrix<double>& stiffness,
                                  const std::vector<bool>& held, std::span<const int> loaded,
                                  const RunContext& context) {
  std::vector<int> place(held.size(), -1);  // among the components that can move
  int free = 0;
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (!held[i]) place[i] = free++;
  }
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(stiffness.nonZeros()));
  for (int column = 0; column < stiffness.outerSize(); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator it(stiffness, column); it; ++it) {
      const int row = place[index(it.row())];
      if (row >= 0 && place[index(column)] >= 0)
        entries.emplace_back(row, place[index(column)], it.value());
    }
  }
  Eigen::SparseMatrix<double> movable(free, free);
  movable.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(movable);
  const bool stiff = factors.info() == Eigen::Success && free > 0 &&
                     factors.vectorD().minCoeff() > 1e-12 * factors.vectorD().maxCoeff();
  require(stiff, {.field = "held", .problem = "lets the solid move as a whole"});

  const Eigen::Index count = std::ssize(loaded);
  Eigen::MatrixXd compliance(count, count);
  for (std::size_t b = 0; b < loaded.size(); ++b) {
    context.cancellation.check();
    const int column = place[index(loaded[b])];
    require(column >= 0, {.field = "loaded[" + std::to_string(b) + "]", .problem = "is held"});
    const Eigen::VectorXd moved = factors.solve(Eigen::VectorXd::Unit(free, column));
    for (std::size_t a = 0; a < loaded.size(); ++a) {
      compliance(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) =
          moved[place[index(loaded[a])]];
    }
  }
  return 0.5 * (compliance + compliance.transpose());
}

}  // namespace prehend
