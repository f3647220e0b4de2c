// A quarter of a block so large that a small contact on it is one on a half-space.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "sim/soft/elastic_solid.h"
#include "sim/soft/press.h"

namespace prehend::testing_support {

// The contact of a sphere with an elastic half-space. Source: Johnson, "Contact Mechanics", 1985,
// section 4.2.
struct Hertz {
  ElasticMaterial material{.youngs_modulus = 2e6, .poissons_ratio = 0.48};
  double sphere = 10e-3;  // radius [m]
  double radius = 1e-3;   // of the contact

  double shear_modulus() const {
    return material.youngs_modulus / (2.0 * (1.0 + material.poissons_ratio));
  }
  double load() const {
    const double plane = material.youngs_modulus / (1.0 - std::pow(material.poissons_ratio, 2));
    return 4.0 / 3.0 * plane * std::pow(radius, 3) / sphere;
  }
  double largest_pressure() const { return 1.5 * load() / (std::numbers::pi * radius * radius); }
};

// Nodes beneath the sphere with its axis at the origin, `cells` elements a contact radius, coarser
// away from it. Planes x = 0 and y = 0 cut the block where loads along the axis are symmetric.
class QuarterSpace {
 public:
  QuarterSpace(const Hertz& hertz, int cells) : cell_(hertz.radius / cells) {
    const double end = 7.0 * hertz.radius;
    across_ = graded(cells + cells / 2, end);
    std::vector<double> down = graded(cells, end);
    std::vector<double> z;
    for (auto it = down.rbegin(); it != down.rend(); ++it) z.push_back(-*it);
    const HexMesh mesh = block_mesh(across_, across_, z);
    stiffness_ = stiffness_matrix(mesh, hertz.material);
    near_ = static_cast<std::size_t>(cells + cells / 2 + 1);
    const std::size_t top = mesh.nodes.size() - across_.size() * across_.size();
    for (std::size_t j = 0; j < near_; ++j) {
      for (std::size_t i = 0; i < near_; ++i) {
        const std::size_t node = top + j * across_.size() + i;
        nodes.push_back(mesh.nodes[node]);
        components_.push_back(static_cast<int>(3 * node));
      }
    }
    pressed_.assign(3 * mesh.nodes.size(), false);
    sheared_ = pressed_;
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      const Vector3& p = mesh.nodes[n];
      for (std::size_t k = 0; k < 3; ++k) {
        const bool bottom = p.z() == z.front();
        pressed_[3 * n + k] = bottom || (k == 0 && p.x() == 0.0) || (k == 1 && p.y() == 0.0);
        // A load along x is turned round by the plane x = 0.
        sheared_[3 * n + k] = bottom || (k != 0 && p.x() == 0.0) || (k == 1 && p.y() == 0.0);
      }
    }
  }

  std::vector<Vector3> nodes;  // near the contact [m]

  // Of displacements along z.
  Eigen::MatrixXd normal_compliance() const {
    std::vector<int> loaded;
    for (const int first : components_) loaded.push_back(first + 2);
    return compliance_matrix(stiffness_, pressed_, loaded);
  }
  // Of displacements along x by forces along x, of nodes with these indices.
  Eigen::MatrixXd shear_compliance(const std::vector<std::size_t>& at) const {
    std::vector<int> loaded;
    for (const std::size_t i : at) loaded.push_back(components_[i]);
    return compliance_matrix(stiffness_, sheared_, loaded);
  }
  // Area that belongs to node i in this quarter [m^2].
  double area(std::size_t i) const {
    return cell_ * cell_ * (nodes[i].x() == 0.0 ? 0.5 : 1.0) * (nodes[i].y() == 0.0 ? 0.5 : 1.0);
  }

  // The nodes pressed by the sphere with a quarter of its load.
  NodeForces press(const Hertz& hertz) const {
    PressProblem problem;
    problem.compliance = normal_compliance();
    problem.gap.resize(std::ssize(nodes));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      problem.gap[static_cast<Eigen::Index>(i)] =
          nodes[i].head<2>().squaredNorm() / (2.0 * hertz.sphere);
    }
    problem.weight = Eigen::VectorXd::Ones(problem.gap.size());
    return press_with(problem, hertz.load() / 4.0, hertz.sphere);
  }

 private:
  std::vector<double> graded(int fine, double end) const {
    std::vector<double> lines;
    for (int i = 0; i <= fine; ++i) lines.push_back(cell_ * i);
    double step = cell_;
    while (lines.back() < end) {
      step *= 1.6;
      lines.push_back(std::min(end, lines.back() + step));
    }
    return lines;
  }

  double cell_;
  std::vector<double> across_;
  Eigen::SparseMatrix<double> stiffness_;
  std::size_t near_ = 0;
  std::vector<int> components_;  // along x, of `nodes`
  std::vector<bool> pressed_;
  std::vector<bool> sheared_;
};

// The radius of a disc whose pressure, as in Hertz' contact, falls off like sqrt(a^2 - r^2) and has
// these values at these distances from its middle: the mean of r^2 is then 2 a^2 / 5.
inline double radius_by_moment(const std::vector<Vector3>& nodes, const Eigen::VectorXd& forces) {
  double sum = 0.0;
  double moment = 0.0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double force = forces[static_cast<Eigen::Index>(i)];
    sum += force;
    moment += force * nodes[i].head<2>().squaredNorm();
  }
  return std::sqrt(2.5 * moment / sum);
}

}  // namespace prehend::testing_support
