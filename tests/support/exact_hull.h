// Epsilon of sets of wrenches in exact arithmetic: a judge of the library's, without any code in
// common with it. Slow: some 20,000 facets a second.
//
// Beneath-beyond with integers: doubles are integers once a power of two is taken out, so normals,
// offsets and heights of facets are integers too, and every decision is exact. Doubles only decide
// what is beyond their error.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace prehend::test::exact {

namespace multiprecision = boost::multiprecision;
using Integer = multiprecision::number<multiprecision::cpp_int_backend<>, multiprecision::et_off>;
// Of the one inexact step, the length of a normal.
using Real =
    multiprecision::number<multiprecision::cpp_bin_float<256, multiprecision::digit_base_2>,
                           multiprecision::et_off>;
using Columns = Eigen::Matrix<double, 6, Eigen::Dynamic>;

inline constexpr std::size_t kDim = 6;
// Heights of points of size 1 above unit normals, in double, err by far less than this.
inline constexpr double kRoughError = 1e-12;

using Integers = std::array<Integer, kDim>;
using Doubles = std::array<double, kDim>;

struct Point {
  Integers exact;
  Doubles rough;  // of size 1
};

struct Facet {
  std::array<std::size_t, kDim> corners;  // indices of points
  Integers normal;                        // outward
  Integer offset;
  Doubles rough_normal;  // unit
  double rough_offset = 0.0;
  Real distance;  // offset / |normal|, in units of the exact points
};

struct Set {
  std::vector<Point> points;  // distinct
  int exponent = 0;           // a coordinate is exact * 2^exponent
};

// The distinct columns. Throws std::runtime_error for a number that is not finite.
inline Set exact_set(const Columns& columns) {
  std::set<Doubles> distinct;
  for (Eigen::Index j = 0; j < columns.cols(); ++j) {
    Doubles values;
    for (std::size_t i = 0; i < kDim; ++i) values[i] = columns(static_cast<Eigen::Index>(i), j);
    distinct.insert(values);
  }
  Set set;
  int lowest = std::numeric_limits<int>::max();
  int highest = std::numeric_limits<int>::min();
  for (const Doubles& values : distinct) {
    for (const double value : values) {
      if (!std::isfinite(value)) throw std::runtime_error("a wrench that is not finite");
      int exponent = 0;
      std::frexp(value, &exponent);
      if (value != 0.0) lowest = std::min(lowest, exponent - 53);
      if (value != 0.0) highest = std::max(highest, exponent);
    }
  }
  set.exponent = lowest;
  for (const Doubles& values : distinct) {
    Point point;
    for (std::size_t i = 0; i < kDim; ++i) {
      int exponent = 0;
      const double fraction = std::frexp(values[i], &exponent);
      if (fraction != 0.0) {
        const auto digits = static_cast<long long>(std::ldexp(fraction, 53));
        point.exact[i] = Integer(digits) * (Integer(1) << (exponent - 53 - lowest));
      }
      point.rough[i] = std::ldexp(values[i], -highest);
    }
    set.points.push_back(std::move(point));
  }
  return set;
}

// Gauss and Jordan without fractions (Bareiss). Returns the rank; `pivots` are the columns.
inline std::size_t eliminate(std::vector<Integers>& rows, std::vector<std::size_t>& pivots) {
  Integer previous = 1;
  std::size_t rank = 0;
  pivots.clear();
  for (std::size_t column = 0; column < kDim && rank < rows.size(); ++column) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && rows[pivot][column] == 0) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[pivot], rows[rank]);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == rank) continue;
      const Integer factor = rows[i][column];
      for (std::size_t k = 0; k < kDim; ++k) {
        rows[i][k] = (rows[rank][column] * rows[i][k] - factor * rows[rank][k]) / previous;
      }
    }
    previous = rows[rank][column];
    pivots.push_back(column);
    ++rank;
  }
  return rank;
}

inline Integers difference(const Point& a, const Point& b) {
  Integers result;
  for (std::size_t i = 0; i < kDim; ++i) result[i] = a.exact[i] - b.exact[i];
  return result;
}

template <typename Number>
Number dot(const std::array<Number, kDim>& a, const std::array<Number, kDim>& b) {
  Number sum = 0;
  for (std::size_t i = 0; i < kDim; ++i) sum += a[i] * b[i];
  return sum;
}

inline Real length(const Integers& a) { return sqrt(Real(dot(a, a))); }

// A direction orthogonal to rows of rank 5.
inline Integers orthogonal(std::vector<Integers> rows) {
  std::vector<std::size_t> pivots;
  if (eliminate(rows, pivots) != kDim - 1) throw std::logic_error("a facet without a plane");
  std::size_t free = 0;
  while (free < kDim - 1 && pivots[free] == free) ++free;
  Integers result;
  // After elimination every pivot has the same value.
  result[free] = rows[0][pivots[0]];
  for (std::size_t i = 0; i < kDim - 1; ++i) result[pivots[i]] = -rows[i][free];
  return result;
}

// The convex hull of the points that were added.
class Hull {
 public:
  // `simplex`: seven affinely independent points.
  Hull(const Set& set, const std::vector<std::size_t>& simplex) : set_(set), inside_(simplex) {
    for (std::size_t without = 0; without <= kDim; ++without) {
      std::array<std::size_t, kDim> corners{};
      for (std::size_t i = 0, slot = 0; i <= kDim; ++i) {
        if (i != without) corners[slot++] = simplex[i];
      }
      add_facet(corners);
    }
  }

  // Adds a point; false where it is inside.
  bool add(std::size_t point) {
    std::map<Ridge, int> ridges;
    for (std::size_t i = 0; i < facets_.size();) {
      if (height(facets_[i], point) <= 0) {
        ++i;
        continue;
      }
      for (std::size_t out = 0; out < kDim; ++out) ++ridges[ridge(facets_[i], out)];
      std::swap(facets_[i], facets_.back());
      facets_.pop_back();
    }
    for (const auto& [corners, times] : ridges) {
      if (times > 2) throw std::logic_error("a ridge of three facets");
      if (times == 2) continue;
      std::array<std::size_t, kDim> made{};
      std::copy(corners.begin(), corners.end(), made.begin());
      made.back() = point;
      add_facet(made);
    }
    return !ridges.empty();
  }

  // The sign of the height of a point above a facet, exactly.
  int height(const Facet& facet, std::size_t point) const {
    const Point& p = set_.points[point];
    const double rough = dot(facet.rough_normal, p.rough) - facet.rough_offset;
    if (std::abs(rough) > kRoughError) return rough > 0.0 ? 1 : -1;
    return (dot(facet.normal, p.exact) - facet.offset).sign();
  }

  const Facet& nearest() const {
    return *std::min_element(facets_.begin(), facets_.end(), [](const Facet& a, const Facet& b) {
      return a.distance < b.distance;
    });
  }

  // The point farthest above a facet; the number of points if there is none.
  std::size_t farthest(const Facet& facet) const {
    std::size_t best = set_.points.size();
    double best_height = -1.0;
    for (std::size_t i = 0; i < set_.points.size(); ++i) {
      const double rough = dot(facet.rough_normal, set_.points[i].rough) - facet.rough_offset;
      if (rough <= best_height || height(facet, i) <= 0) continue;
      best = i;
      best_height = rough;
    }
    return best;
  }

  // How far a point reaches along a facet's normal.
  Real value(const Facet& facet, std::size_t point) const {
    return Real(dot(facet.normal, set_.points[point].exact)) / length(facet.normal);
  }

  std::size_t facets() const { return facets_.size(); }

  // That the facets are the border of the hull of `points`: each supports all of them, and every
  // ridge is shared by two facets. Throws std::logic_error otherwise.
  void verify(const std::vector<std::size_t>& points) const {
    std::map<Ridge, int> ridges;
    for (const Facet& facet : facets_) {
      for (std::size_t out = 0; out < kDim; ++out) ++ridges[ridge(facet, out)];
      for (const std::size_t point : points) {
        if (height(facet, point) > 0) throw std::logic_error("a point above a facet");
      }
    }
    for (const auto& [corners, times] : ridges) {
      if (times != 2) throw std::logic_error("a ridge that is not shared by two facets");
    }
  }

 private:
  using Ridge = std::array<std::size_t, kDim - 1>;

  static Ridge ridge(const Facet& facet, std::size_t out) {
    Ridge corners{};
    for (std::size_t i = 0, slot = 0; i < kDim; ++i) {
      if (i != out) corners[slot++] = facet.corners[i];
    }
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  void add_facet(const std::array<std::size_t, kDim>& corners) {
    Facet facet;
    facet.corners = corners;
    std::vector<Integers> edges;
    for (std::size_t i = 1; i < kDim; ++i) {
      edges.push_back(difference(set_.points[corners[i]], set_.points[corners[0]]));
    }
    facet.normal = orthogonal(std::move(edges));
    facet.offset = dot(facet.normal, set_.points[corners[0]].exact);
    // Outward: the centre of the first simplex, times its seven corners, is below.
    Integer centre = Integer(-7) * facet.offset;
    for (const std::size_t i : inside_) centre += dot(facet.normal, set_.points[i].exact);
    if (centre == 0) throw std::logic_error("a facet through the centre");
    if (centre > 0) {
      for (Integer& value : facet.normal) value = -value;
      facet.offset = -facet.offset;
    }
    round(facet);
    facets_.push_back(std::move(facet));
  }

  void round(Facet& facet) const {
    const Real norm = length(facet.normal);
    facet.distance = Real(facet.offset) / norm;
    for (std::size_t i = 0; i < kDim; ++i) {
      facet.rough_normal[i] = (Real(facet.normal[i]) / norm).convert_to<double>();
    }
    // By way of a corner: in units of size 1.
    facet.rough_offset = dot(facet.rough_normal, set_.points[facet.corners[0]].rough);
  }

  const Set& set_;
  std::vector<std::size_t> inside_;
  std::vector<Facet> facets_;
};

// Affinely independent points, as many as there are: greedy, exact.
inline std::vector<std::size_t> independent(const Set& set) {
  std::vector<std::size_t> chosen;
  std::vector<Integers> edges;
  for (std::size_t i = 0; i < set.points.size() && chosen.size() <= kDim; ++i) {
    if (chosen.empty()) {
      chosen.push_back(i);
      continue;
    }
    std::vector<Integers> rows = edges;
    rows.push_back(difference(set.points[i], set.points[chosen.front()]));
    std::vector<std::size_t> pivots;
    if (eliminate(rows, pivots) == rows.size()) {
      edges.push_back(difference(set.points[i], set.points[chosen.front()]));
      chosen.push_back(i);
    }
  }
  return chosen;
}

// Epsilon of the hull of a set of wrenches.
struct Epsilon {
  int dimension = -1;  // of the hull; below 6 there is no force closure
  bool force_closure = false;
  Real lower = 0;           // epsilon, 0 without force closure
  Real upper = 0;           // more than `lower` where the facets did not suffice: bounds only
  std::size_t points = 0;   // distinct wrenches
  std::size_t corners = 0;  // points put into the hull
  std::size_t facets = 0;
};

// When the hull is whole, and when it is left unfinished.
struct EpsilonLimits {
  std::size_t whole = 0;  // sets of up to this many points are put into the hull whole
  std::size_t most_facets = 200000;
};

// The hull of some points, more of them until its nearest facet supports the whole set, or there
// are too many facets. A smaller set's ball is no larger, and no ball reaches beyond a supporting
// plane: so that facet's distance is the whole set's.
inline Epsilon epsilon(const Columns& columns, const EpsilonLimits& limits = {}) {
  const Set set = exact_set(columns);
  const std::size_t count = set.points.size();
  Epsilon answer;
  answer.points = count;
  const std::vector<std::size_t> simplex = independent(set);
  answer.dimension = static_cast<int>(simplex.size()) - 1;
  if (simplex.size() <= kDim) return answer;
  Hull hull(set, simplex);
  std::vector<std::size_t> used = simplex;
  bool whole = count <= limits.whole;
  for (std::size_t i = 0; whole && i < count; ++i) {
    if (hull.add(i)) used.push_back(i);
    if (hull.facets() > limits.most_facets) whole = false;
  }
  Real upper = 0;
  while (true) {
    const std::size_t point = hull.farthest(hull.nearest());
    if (point == count) {
      upper = hull.nearest().distance;
      break;
    }
    const Real value = hull.value(hull.nearest(), point);
    if (upper == 0 || value < upper) upper = value;
    if (hull.facets() > limits.most_facets) break;
    hull.add(point);
    used.push_back(point);
  }
  if (whole) {
    used.resize(count);
    for (std::size_t i = 0; i < count; ++i) used[i] = i;
  }
  hull.verify(used);
  answer.corners = used.size();
  answer.facets = hull.facets();
  const Real& distance = hull.nearest().distance;
  answer.force_closure = distance > 0;
  if (!answer.force_closure) return answer;
  answer.lower = ldexp(distance, set.exponent);
  answer.upper = ldexp(upper, set.exponent);
  return answer;
}

}  // namespace prehend::test::exact
