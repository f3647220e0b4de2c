#include "sim/quality/start_simplex.h"

#include <algorithm>
#include <limits>

namespace prehend {
namespace {

// Points farther from the span than this part of the scale are taken as they are. If none is, a
// new one is asked for along a direction orthogonal to the span: a simplex thinner than that would
// start the search with ill-conditioned facets.
constexpr double kThinStart = 1e-2;

// Support along a unit direction; keeps the smallest value in `start`.
Wrench probe(const SupportMap& set, const Wrench& direction, StartSimplex& start) {
  const Wrench point = set.support(direction);
  const double value = direction.dot(point);
  if (value < start.upper) {
    start.upper = value;
    start.upper_normal = direction;
  }
  return point;
}

// A unit vector orthogonal to the first `rank` columns of `basis`.
Wrench orthogonal_direction(const Eigen::Matrix<double, 6, 6>& basis, int rank) {
  const auto span = basis.leftCols(rank);
  Eigen::Index axis = 0;
  span.rowwise().squaredNorm().minCoeff(&axis);
  Wrench direction = Wrench::Unit(axis);
  for (int pass = 0; pass < 2; ++pass) {
    direction -= span * (span.transpose() * direction);
    direction.normalize();
  }
  return direction;
}

// Distance vector of a point from the affine span of the points so far.
Wrench residual(const Wrench& point, const Wrench& origin, const Eigen::Matrix<double, 6, 6>& basis,
                int rank) {
  const auto span = basis.leftCols(rank);
  Wrench rest = point - origin;
  for (int pass = 0; pass < 2; ++pass) rest -= span * (span.transpose() * rest);
  return rest;
}

// Support points from which the corners are taken: at most those along the axes both ways, and two
// more for each further corner.
class Candidates {
 public:
  void push_back(const Wrench& point) { points_[size_++] = point; }
  void pop_back() { --size_; }
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  Wrench& operator[](std::size_t i) { return points_[i]; }
  Wrench& front() { return points_[0]; }
  Wrench& back() { return points_[size_ - 1]; }

 private:
  std::array<Wrench, 24> points_;
  std::size_t size_ = 0;
};

// The candidate farthest from the span, moved to the end of the list, and its residual.
Wrench take_farthest(Candidates& candidates, const Wrench& origin,
                     const Eigen::Matrix<double, 6, 6>& basis, int rank) {
  Wrench best_rest = Wrench::Zero();
  std::size_t best = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Wrench rest = residual(candidates[i], origin, basis, rank);
    if (rest.squaredNorm() > best_rest.squaredNorm()) {
      best_rest = rest;
      best = i;
    }
  }
  if (!candidates.empty()) std::swap(candidates[best], candidates.back());
  return best_rest;
}

}  // namespace

// Gram-Schmidt with pivoting: starts with the extreme points along the six axes, and takes from
// them, one after the other, the point farthest from the affine span of those taken before.
// Projections are subtracted twice, since once leaves a remainder of the order of rounding times
// the cancellation.
StartSimplex start_simplex(const SupportMap& set, bool stop_outside) {
  StartSimplex start;
  start.upper = std::numeric_limits<double>::infinity();
  Candidates candidates;
  for (int axis = 0; axis < 6; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      candidates.push_back(probe(set, sign * Wrench::Unit(axis), start));
      start.scale = std::max(start.scale, candidates.back().cwiseAbs().maxCoeff());
      // A direction without a positive support value: the set does not surround the origin.
      if (stop_outside && start.upper <= 0.0) return start;
    }
  }
  Eigen::Matrix<double, 6, 6> basis = Eigen::Matrix<double, 6, 6>::Zero();
  start.points[0] = candidates.front();
  for (int rank = 0; rank < 6; ++rank) {
    Wrench rest = take_farthest(candidates, start.points[0], basis, rank);
    if (rest.norm() <= kThinStart * start.scale) {
      const Wrench direction = orthogonal_direction(basis, rank);
      candidates.push_back(probe(set, direction, start));
      candidates.push_back(probe(set, -direction, start));
      if (stop_outside && start.upper <= 0.0) return start;
      // The two points are extreme along +direction and -direction: where both are in one
      // hyperplane orthogonal to it, so is the whole set.
      const std::size_t last = candidates.size() - 1;
      if (direction.dot(candidates[last - 1] - candidates[last]) <= kFlatness * start.scale) {
        return start;
      }
      rest = take_farthest(candidates, start.points[0], basis, rank);
    }
    const auto next = static_cast<std::size_t>(rank) + 1;
    start.points[next] = candidates.back();
    basis.col(rank) = rest.normalized();
    candidates.pop_back();
  }
  start.flat = false;
  return start;
}

}  // namespace prehend
