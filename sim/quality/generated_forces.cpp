#include "sim/quality/generated_forces.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "sim/base/index.h"
#include "sim/quality/conic/conic_program.h"

// The wrenches that forces of measure at most 1 can exert form a convex set, and the smallest
// measure that balances the wrench w is the smallest factor by which the set must be scaled to hold
// -w. In terms of points p_j of the set that is a linear program with six rows:
//
//   minimise  sum of l_j   subject to  sum of l_j p_j = -w,  l_j >= 0.
//
// The set has far too many extreme points to list. They are made as they are needed: with the
// multipliers u of the program over the points so far, the point that could improve it most is the
// one of the set with the lowest u . p, which is found contact by contact. Where that value is at
// least -1, no point improves the program, and u proves that. Where the points so far cannot
// balance w, u is a certificate of it, and a point with negative u . p refutes the certificate.
namespace prehend {
namespace {

// Each point costs a small program more. Polyhedral sets take some tens of points, sets with curved
// borders a hundred and more.
constexpr int kMostRounds = 400;
// Points that the solution does not use are dropped when there are more than this: they make the
// programs slow and may be made again.
constexpr std::size_t kMostPoints = 120;
// With shared forces (sum_of_normals), each contact alone reaches the border of the set, so that
// several contacts can give a point in a round.
constexpr std::size_t kPointsARound = 6;

// A point of the set: its wrench, and the forces that exert it, of the contacts that push.
struct Point {
  Wrench wrench = Wrench::Zero();
  std::vector<std::pair<Eigen::Index, Eigen::Vector4d>> forces;
};

class Generation {
 public:
  Generation(const ForceBalance& balance, ForceMeasure measure, double gap_tolerance)
      : balance_(balance), measure_(measure), gap_tolerance_(gap_tolerance) {}

  GeneratedForces run() {
    GeneratedForces result{Eigen::Matrix4Xd::Zero(4, balance_.contacts()), {}};
    for (const double sign : {1.0, -1.0}) {
      for (int axis = 0; axis < 6; ++axis) add_points(sign * Wrench::Unit(axis));
    }
    add_points(balance_.wrench());
    double lowest = 0.0;
    for (int round = 0; round < kMostRounds && !points_.empty(); ++round) {
      const ConicSolution solution = solve(program(), {.tolerance = 1e-12});
      const bool balanced = solution.status == ConicStatus::optimal;
      const Wrench multipliers = solution.y;
      if (balanced) result.components = forces(solution.x);
      const ForceBalance::Separation separation{multipliers, Eigen::VectorXd()};
      const double bound = balance_.lower_bound(separation, measure_);
      if (bound >= lowest) {
        lowest = bound;
        result.separation = separation;
      }
      const double reached = balance_.measure(result.components);
      if (balanced && reached - lowest <= 0.5 * gap_tolerance_ * reached) break;
      if (points_.size() > kMostPoints && balanced) drop_unused(solution.x);
      // Without an improving point the multipliers stand, for an optimum or an impossibility.
      if (!add_points(multipliers, balanced ? -1.0 : 0.0)) break;
    }
    return result;
  }

 private:
  ConicProgram program() const {
    const Eigen::Index n = std::ssize(points_);
    ConicProgram program;
    program.c = Eigen::VectorXd::Ones(n);
    program.A.resize(6, n);
    for (Eigen::Index j = 0; j < n; ++j) program.A.col(j) = points_[index(j)].wrench;
    program.b = -balance_.wrench();
    program.G = -Eigen::MatrixXd::Identity(n, n);
    program.h = Eigen::VectorXd::Zero(n);
    program.cone.orthant = static_cast<int>(n);
    return program;
  }

  // Adds points of the set that are lowest along u, if lower than `least`; whether there are any.
  bool add_points(const Wrench& u, double least = 0.0) {
    constexpr double kImprovement = 1e-12;
    // How far each contact can push down along u with unit normal force.
    std::vector<std::pair<double, Eigen::Index>> depths;
    for (Eigen::Index i = 0; i < balance_.contacts(); ++i) {
      const double value = balance_.cones()[index(i)].lowest(balance_.map(i).transpose() * u);
      if (value < 0.0) depths.emplace_back(value, i);
    }
    const std::size_t before = points_.size();
    if (measure_ == ForceMeasure::sum_of_normals) {
      std::sort(depths.begin(), depths.end());
      for (std::size_t k = 0; k < std::min(kPointsARound, depths.size()); ++k) {
        if (depths[k].first < least - kImprovement) points_.push_back(point({depths[k]}, u));
      }
    } else {
      double sum = 0.0;
      for (const auto& [depth, contact] : depths) sum += depth;
      if (sum < least - kImprovement) points_.push_back(point(depths, u));
    }
    return points_.size() > before;
  }

  // The point at which these contacts push with unit normal force, as far down along u as they can.
  Point point(const std::vector<std::pair<double, Eigen::Index>>& depths, const Wrench& u) const {
    Point made;
    for (const auto& [depth, i] : depths) {
      const Eigen::Vector4d force =
          balance_.cones()[index(i)].lowest_force(balance_.map(i).transpose() * u);
      made.wrench += balance_.map(i) * force;
      made.forces.emplace_back(i, force);
    }
    return made;
  }

  // The sum of the points' forces; in the friction cones, because each of them is.
  Eigen::Matrix4Xd forces(const Eigen::VectorXd& factors) const {
    Eigen::Matrix4Xd components = Eigen::Matrix4Xd::Zero(4, balance_.contacts());
    for (std::size_t j = 0; j < points_.size(); ++j) {
      const double factor = std::max(0.0, factors[static_cast<Eigen::Index>(j)]);
      for (const auto& [i, force] : points_[j].forces) components.col(i) += factor * force;
    }
    return components;
  }

  void drop_unused(const Eigen::VectorXd& factors) {
    const double unused = 1e-9 * factors.maxCoeff();
    std::vector<Point> kept;
    for (std::size_t j = 0; j < points_.size(); ++j) {
      if (factors[static_cast<Eigen::Index>(j)] > unused) kept.push_back(std::move(points_[j]));
    }
    points_ = std::move(kept);
  }

  const ForceBalance& balance_;
  ForceMeasure measure_;
  double gap_tolerance_;
  std::vector<Point> points_;
};

}  // namespace

GeneratedForces generate_forces(const ForceBalance& balance, ForceMeasure measure,
                                double gap_tolerance) {
  return Generation(balance, measure, gap_tolerance).run();
}

}  // namespace prehend
