// Epsilon of sets of wrenches in exact arithmetic: see README.md. Not part of the build.
//
// Beneath-beyond with integers: doubles are integers once a power of two is taken out, so normals,
// offsets and heights of facets are integers too, and every decision is exact. Doubles only decide
// what is beyond their error.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <gmpxx.h>
#include <iostream>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr int kDim = 6;
constexpr mp_bitcnt_t kBits = 512;          // of the one inexact step, the length of a normal
constexpr std::size_t kAllPoints = 64;      // sets up to this size are put into the hull whole
constexpr std::size_t kMaxFacets = 200000;  // beyond it, what has been found is a bound

using Integers = std::array<mpz_class, kDim>;
using Doubles = std::array<double, kDim>;

struct Point {
  Integers exact;
  Doubles rough;  // of size 1
};

struct Facet {
  std::array<int, kDim> corners;
  Integers normal;  // outward
  mpz_class offset;
  Doubles rough_normal;  // unit
  double rough_offset = 0.0;
  mpf_class distance{0, kBits};  // offset / |normal|, in units of the exact points
};

// Heights of points of size 1 above unit normals, in double, err by far less than this.
constexpr double kRoughError = 1e-12;

struct Set {
  std::vector<Point> points;  // distinct
  long exponent = 0;          // a coordinate is exact * 2^exponent
};

Set read_points(std::istream& in, int columns) {
  std::set<Doubles> distinct;
  for (int j = 0; j < columns; ++j) {
    Doubles values;
    for (double& value : values) {
      std::string text;
      in >> text;
      value = std::strtod(text.c_str(), nullptr);
      if (!std::isfinite(value)) throw std::runtime_error("not finite: " + text);
    }
    distinct.insert(values);
  }
  Set set;
  int lowest = std::numeric_limits<int>::max();
  int highest = std::numeric_limits<int>::min();
  for (const Doubles& values : distinct) {
    for (const double value : values) {
      int exponent = 0;
      std::frexp(value, &exponent);
      if (value != 0.0) lowest = std::min(lowest, exponent - 53);
      if (value != 0.0) highest = std::max(highest, exponent);
    }
  }
  set.exponent = lowest;
  for (const Doubles& values : distinct) {
    Point point;
    for (int i = 0; i < kDim; ++i) {
      int exponent = 0;
      const double fraction = std::frexp(values[i], &exponent);
      if (fraction != 0.0) {
        point.exact[i] = mpz_class(std::ldexp(fraction, 53)) << (exponent - 53 - lowest);
      }
      point.rough[i] = std::ldexp(values[i], -highest);
    }
    set.points.push_back(point);
  }
  return set;
}

// Gauss and Jordan without fractions (Bareiss). Returns the rank; `pivots` are the columns.
int eliminate(std::vector<Integers>& rows, std::vector<int>& pivots) {
  mpz_class previous = 1;
  std::size_t rank = 0;
  pivots.clear();
  for (int column = 0; column < kDim && rank < rows.size(); ++column) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && rows[pivot][column] == 0) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[pivot], rows[rank]);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == rank) continue;
      const mpz_class factor = rows[i][column];
      for (int k = 0; k < kDim; ++k) {
        mpz_class value = rows[rank][column] * rows[i][k] - factor * rows[rank][k];
        mpz_divexact(rows[i][k].get_mpz_t(), value.get_mpz_t(), previous.get_mpz_t());
      }
    }
    previous = rows[rank][column];
    pivots.push_back(column);
    ++rank;
  }
  return static_cast<int>(rank);
}

Integers difference(const Point& a, const Point& b) {
  Integers result;
  for (int i = 0; i < kDim; ++i) result[i] = a.exact[i] - b.exact[i];
  return result;
}

mpz_class dot(const Integers& a, const Integers& b) {
  mpz_class sum = 0;
  for (int i = 0; i < kDim; ++i) sum += a[i] * b[i];
  return sum;
}

double dot(const Doubles& a, const Doubles& b) {
  double sum = 0.0;
  for (int i = 0; i < kDim; ++i) sum += a[i] * b[i];
  return sum;
}

// A direction orthogonal to rows of rank 5.
Integers orthogonal(std::vector<Integers> rows) {
  std::vector<int> pivots;
  if (eliminate(rows, pivots) != kDim - 1) throw std::logic_error("a facet without a plane");
  int free = 0;
  while (free < kDim - 1 && pivots[free] == free) ++free;
  Integers result;
  // After elimination every pivot has the same value.
  result[free] = rows[0][pivots[0]];
  for (int i = 0; i < kDim - 1; ++i) result[pivots[i]] = -rows[i][free];
  return result;
}

class Hull {
 public:
  Hull(const Set& set, const std::vector<int>& simplex) : set_(set), inside_(simplex) {
    for (int without = 0; without <= kDim; ++without) {
      std::array<int, kDim> corners;
      for (int i = 0, slot = 0; i <= kDim; ++i) {
        if (i != without) corners[slot++] = simplex[i];
      }
      add_facet(corners);
    }
  }

  // Adds a point; false where it is inside.
  bool add(int point) {
    std::map<std::array<int, kDim - 1>, int> ridges;
    for (std::size_t i = 0; i < facets_.size();) {
      if (height(facets_[i], point) <= 0) {
        ++i;
        continue;
      }
      for (int out = 0; out < kDim; ++out) ++ridges[ridge(facets_[i], out)];
      std::swap(facets_[i], facets_.back());
      facets_.pop_back();
    }
    const bool outside = !ridges.empty();
    for (const auto& [corners, times] : ridges) {
      if (times > 2) throw std::logic_error("a ridge of three facets");
      if (times == 2) continue;
      std::array<int, kDim> made;
      std::copy(corners.begin(), corners.end(), made.begin());
      made.back() = point;
      add_facet(made);
    }
    return outside;
  }

  // The sign of the height of a point above a facet, exactly.
  int height(const Facet& facet, int point) const {
    const Point& p = set_.points[point];
    const double rough = dot(facet.rough_normal, p.rough) - facet.rough_offset;
    if (std::abs(rough) > kRoughError) return rough > 0.0 ? 1 : -1;
    return sgn(mpz_class(dot(facet.normal, p.exact) - facet.offset));
  }

  const Facet& nearest() const {
    return *std::min_element(facets_.begin(), facets_.end(), [](const Facet& a, const Facet& b) {
      return a.distance < b.distance;
    });
  }

  // The point farthest above a facet, -1 if there is none.
  int farthest(const Facet& facet) const {
    int best = -1;
    double best_height = -1.0;
    for (int i = 0; i < static_cast<int>(set_.points.size()); ++i) {
      const double rough = dot(facet.rough_normal, set_.points[i].rough) - facet.rough_offset;
      if (rough <= best_height || height(facet, i) <= 0) continue;
      best = i;
      best_height = rough;
    }
    return best;
  }

  // How far a point reaches along a facet's normal.
  mpf_class value(const Facet& facet, int point) const {
    const mpf_class length = sqrt(mpf_class(dot(facet.normal, facet.normal), kBits));
    return mpf_class(dot(facet.normal, set_.points[point].exact), kBits) / length;
  }

  std::size_t facets() const { return facets_.size(); }

  // That the facets are the border of the hull of `points`: each supports all of them, and every
  // ridge is shared by two facets.
  void verify(const std::vector<int>& points) const {
    std::map<std::array<int, kDim - 1>, int> ridges;
    for (const Facet& facet : facets_) {
      for (int out = 0; out < kDim; ++out) ++ridges[ridge(facet, out)];
      for (const int point : points) {
        if (height(facet, point) > 0) throw std::logic_error("a point above a facet");
      }
    }
    for (const auto& [corners, times] : ridges) {
      if (times != 2) throw std::logic_error("a ridge that is not shared by two facets");
    }
  }

 private:
  static std::array<int, kDim - 1> ridge(const Facet& facet, int out) {
    std::array<int, kDim - 1> corners;
    for (int i = 0, slot = 0; i < kDim; ++i) {
      if (i != out) corners[slot++] = facet.corners[i];
    }
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  void add_facet(const std::array<int, kDim>& corners) {
    Facet facet;
    facet.corners = corners;
    std::vector<Integers> edges;
    for (int i = 1; i < kDim; ++i) {
      edges.push_back(difference(set_.points[corners[i]], set_.points[corners[0]]));
    }
    facet.normal = orthogonal(std::move(edges));
    facet.offset = dot(facet.normal, set_.points[corners[0]].exact);
    // Outward: the centre of the first simplex, times its seven corners, is below.
    mpz_class centre = -(kDim + 1) * facet.offset;
    for (const int i : inside_) centre += dot(facet.normal, set_.points[i].exact);
    if (centre == 0) throw std::logic_error("a facet through the centre");
    if (centre > 0) {
      for (mpz_class& value : facet.normal) value = -value;
      facet.offset = -facet.offset;
    }
    round(facet);
    facets_.push_back(std::move(facet));
  }

  void round(Facet& facet) const {
    const mpf_class length = sqrt(mpf_class(dot(facet.normal, facet.normal), kBits));
    facet.distance = mpf_class(facet.offset, kBits) / length;
    for (int i = 0; i < kDim; ++i) {
      facet.rough_normal[i] = mpf_class(mpf_class(facet.normal[i], kBits) / length).get_d();
    }
    // By way of a corner: in units of size 1.
    facet.rough_offset = dot(facet.rough_normal, set_.points[facet.corners[0]].rough);
  }

  const Set& set_;
  std::vector<int> inside_;
  std::vector<Facet> facets_;
};

// Affinely independent points, as many as there are: greedy, exact.
std::vector<int> independent(const Set& set) {
  std::vector<int> chosen;
  std::vector<Integers> edges;
  for (int i = 0; i < static_cast<int>(set.points.size()) && chosen.size() <= kDim; ++i) {
    if (chosen.empty()) {
      chosen.push_back(i);
      continue;
    }
    std::vector<Integers> rows = edges;
    rows.push_back(difference(set.points[i], set.points[chosen.front()]));
    std::vector<int> pivots;
    if (eliminate(rows, pivots) == static_cast<int>(rows.size())) {
      edges.push_back(difference(set.points[i], set.points[chosen.front()]));
      chosen.push_back(i);
    }
  }
  return chosen;
}

struct Answer {
  int dimension = -1;
  bool force_closure = false;
  std::string epsilon = "0";
  std::string upper = "0";  // more than epsilon where the facets did not suffice: bounds only
  std::size_t corners = 0;  // points put into the hull
  std::size_t facets = 0;
};

std::string decimal(const mpf_class& distance, long exponent) {
  mpf_class value(distance, kBits);
  if (exponent < 0) {
    mpf_div_2exp(value.get_mpf_t(), value.get_mpf_t(), static_cast<mp_bitcnt_t>(-exponent));
  } else {
    mpf_mul_2exp(value.get_mpf_t(), value.get_mpf_t(), static_cast<mp_bitcnt_t>(exponent));
  }
  char text[64];
  gmp_snprintf(text, sizeof text, "%.19Fe", value.get_mpf_t());
  return text;
}

// Small sets: the whole hull. Large ones: the hull of some points, more of them until its nearest
// facet supports the whole set. A smaller set's ball is no larger, and no ball reaches beyond a
// supporting plane: so that facet's distance is the whole set's.
Answer solve(const Set& set) {
  Answer answer;
  const std::vector<int> simplex = independent(set);
  answer.dimension = static_cast<int>(simplex.size()) - 1;
  if (answer.dimension < kDim) return answer;
  Hull hull(set, simplex);
  std::vector<int> used = simplex;
  if (set.points.size() <= kAllPoints) {
    for (int i = 0; i < static_cast<int>(set.points.size()); ++i) {
      if (hull.add(i)) used.push_back(i);
    }
  }
  mpf_class upper(0, kBits);
  while (true) {
    const int point = hull.farthest(hull.nearest());
    if (point < 0) {
      upper = hull.nearest().distance;
      break;
    }
    const mpf_class value = hull.value(hull.nearest(), point);
    if (upper == 0 || value < upper) upper = value;
    if (hull.facets() > kMaxFacets) break;
    hull.add(point);
    used.push_back(point);
  }
  if (set.points.size() <= kAllPoints) {
    used.resize(set.points.size());
    for (std::size_t i = 0; i < used.size(); ++i) used[i] = static_cast<int>(i);
  }
  hull.verify(used);
  answer.corners = used.size();
  answer.facets = hull.facets();
  const mpf_class& distance = hull.nearest().distance;
  answer.force_closure = distance > 0;
  if (!answer.force_closure) return answer;
  answer.epsilon = decimal(distance, set.exponent);
  answer.upper = decimal(upper, set.exponent);
  return answer;
}

}  // namespace

int main() {
  std::string name;
  const char* separator = "[\n";
  while (std::getline(std::cin >> std::ws, name)) {
    int columns = 0;
    std::cin >> columns;
    const Set set = read_points(std::cin, columns);
    std::cerr << name << ": " << set.points.size() << " points" << std::flush;
    const Answer answer = solve(set);
    std::cerr << ", " << answer.facets << " facets, " << answer.epsilon << "\n";
    std::printf(
        "%s  {\"name\": \"%s\", \"force_closure\": %s, \"epsilon\": \"%s\", \"upper\": \"%s\",\n"
        "   \"dimension\": %d, \"points\": %zu, \"points_used\": %zu, \"facets\": %zu}",
        separator, name.c_str(), answer.force_closure ? "true" : "false", answer.epsilon.c_str(),
        answer.upper.c_str(), answer.dimension, set.points.size(), answer.corners, answer.facets);
    std::fflush(stdout);
    separator = ",\n";
  }
  std::printf("\n]\n");
}
