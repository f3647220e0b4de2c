// Profiles are polygons with rounded corners, sampled to points; turning every point about the z
// axis gives rings, and bands of triangles join neighbouring rings.
#include "sim/shape/revolve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace prehend {
namespace {

using Eigen::Vector2d;

// The direction turned by 90 degrees to the left.
Vector2d left_of(const Vector2d& direction) { return {-direction.y(), direction.x()}; }

// Signed angle from direction a to b, left positive.
double turn_angle(const Vector2d& a, const Vector2d& b) {
  return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

// Appends points from points.back() to `to`, about `edge` apart.
void add_line(std::vector<Vector2d>& points, const Vector2d& to, double edge) {
  const Vector2d from = points.back();
  const double length = (to - from).norm();
  if (length < 1e-9) return;
  const int cells = std::max(1, static_cast<int>(std::lround(length / edge)));
  for (int i = 1; i < cells; ++i) points.push_back(from + (to - from) * i / cells);
  points.push_back(to);
}

// Appends the arc of the given radius that starts at points.back() along `direction` and turns by
// `angle` (positive to the left).
void add_arc(std::vector<Vector2d>& points, const Vector2d& direction, double radius, double angle,
             double edge) {
  const double side = angle > 0.0 ? 1.0 : -1.0;
  const Vector2d center = points.back() + side * radius * left_of(direction);
  const Vector2d spoke = points.back() - center;
  const double turned = std::abs(angle);
  // Largest angle of a segment: 60 degrees, so that a quarter circle has two segments; 108 degrees
  // for arcs shorter than half an edge, so that it has one.
  const double step =
      radius * turned < 0.5 * edge ? 0.6 * std::numbers::pi : std::numbers::pi / 3.0;
  const int shortest = static_cast<int>(std::ceil(turned / step));
  const int cells = std::max(shortest, static_cast<int>(std::lround(radius * turned / edge)));
  for (int i = 1; i <= cells; ++i) {
    points.push_back(center + Eigen::Rotation2Dd(angle * i / cells) * spoke);
  }
}

// Joins two rings, which may have different numbers of vertices, or be a single vertex on the axis.
void add_band(Revolved& made, const Ring& low, const Ring& high, bool half_step) {
  const int phase = half_step ? 1 : 0;
  const auto add = [&](int a, int b, int c) { made.mesh.triangles.push_back({a, b, c}); };
  const int n = low.count;
  const int m = high.count;
  if (n == 1 && m == 1) return;
  int i = 0;
  int j = 0;
  // Goes around both rings at once. Each step adds a triangle on the next edge of one ring, the
  // edge whose middle comes first in angle; this keeps the triangles upright. The angles are
  // compared as integers (multiplied by 2 n m), so that rings of equal count alternate exactly.
  while (i < (n > 1 ? n : 0) || j < (m > 1 ? m : 0)) {
    const bool low_left = n > 1 && i < n;
    const bool high_left = m > 1 && j < m;
    const long long low_middle = static_cast<long long>(2 * i + 1 + phase) * m;
    const long long high_middle = static_cast<long long>(2 * j + 1 + phase) * n;
    if (low_left && (!high_left || low_middle <= high_middle)) {
      add(low.first + i, low.first + (i + 1) % n, high.first + j % m);
      ++i;
    } else {
      add(low.first + i % n, high.first + (j + 1) % m, high.first + j);
      ++j;
    }
  }
}

}  // namespace

std::vector<ProfileCorner> inner_side(const std::vector<ProfileCorner>& outer, double wall) {
  std::vector<ProfileCorner> inner;
  for (std::size_t i = outer.size(); i-- > 0;) {
    const bool first = i == 0;
    const bool last = i + 1 == outer.size();
    const Vector2d in =
        (first ? outer[1].at - outer[0].at : outer[i].at - outer[i - 1].at).normalized();
    const Vector2d out = last ? in : Vector2d((outer[i + 1].at - outer[i].at).normalized());
    // Offset corner (miter): both adjacent sides move by `wall`, so the corner moves along the
    // bisector by wall / cos(half of the turn).
    const Vector2d middle = (left_of(in) + left_of(out)).normalized();
    const double miter = wall / middle.dot(left_of(in));
    const double turned = turn_angle(in, out);
    // The offset of an arc has the same centre: its radius shrinks by the wall on the inner side of
    // the turn and grows on the outer side.
    const double fillet = outer[i].fillet > 0.0
                              ? std::max(0.0, outer[i].fillet + (turned > 0.0 ? -wall : wall))
                              : 0.0;
    inner.push_back({outer[i].at + miter * middle, last ? outer[i].fillet : fillet});
  }
  return inner;
}

std::vector<Vector2d> profile_points(const std::vector<ProfileCorner>& corners, double edge) {
  const std::size_t n = corners.size();
  std::vector<Vector2d> side(n, Vector2d::Zero());  // from corner i to i + 1
  for (std::size_t i = 0; i + 1 < n; ++i) side[i] = corners[i + 1].at - corners[i].at;
  // An arc of radius r that replaces a corner with turning angle t shortens both sides by r tan(t /
  // 2). Where the fillets at the two ends of a side want more than its length, both are reduced by
  // the same factor.
  std::vector<double> half_tangent(n, 0.0);
  std::vector<double> wanted(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    half_tangent[i] = std::tan(0.5 * std::abs(turn_angle(side[i - 1], side[i])));
    wanted[i] = corners[i].fillet * half_tangent[i];
  }
  std::vector<double> cut = wanted;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double sum = wanted[i] + wanted[i + 1];
    const double share = sum > 0.0 ? std::min(1.0, side[i].norm() / sum) : 1.0;
    cut[i] = std::min(cut[i], share * wanted[i]);
    cut[i + 1] = std::min(cut[i + 1], share * wanted[i + 1]);
  }
  std::vector<Vector2d> points{corners.front().at};
  for (std::size_t i = 1; i + 1 < n; ++i) {
    // A fillet much smaller than the edges would only produce sliver triangles.
    if (cut[i] < std::max(1e-9, edge / 12.0)) {
      add_line(points, corners[i].at, edge);
      continue;
    }
    const Vector2d direction = side[i - 1].normalized();
    add_line(points, corners[i].at - cut[i] * direction, edge);
    add_arc(points, direction, cut[i] / half_tangent[i], turn_angle(side[i - 1], side[i]), edge);
  }
  add_line(points, corners.back().at, edge);
  return points;
}

Revolved revolve(const std::vector<Vector2d>& profile, double wanted_edge, bool half_step) {
  double widest = 0.0;
  for (const Vector2d& p : profile) widest = std::max(widest, p.x());
  const double edge = std::min(wanted_edge, 2.0 * std::numbers::pi * widest / 16.0);

  Revolved made;
  for (const Vector2d& p : profile) {
    Ring ring{static_cast<int>(made.mesh.vertices.size()), 1};
    if (p.x() > 1e-9) {
      // Rounded to a multiple of 1e-9 first: radii that are equal up to rounding error get the same
      // count even where `wanted` is halfway between two integers.
      const double wanted = 2.0 * std::numbers::pi * p.x() / edge;
      ring.count = std::max(6, static_cast<int>(std::lround(std::round(wanted * 1e9) * 1e-9)));
    }
    for (int j = 0; j < ring.count; ++j) {
      const double step = j + (half_step ? 0.5 : 0.0);
      const double angle = 2.0 * std::numbers::pi * step / ring.count;
      const double radius = ring.count == 1 ? 0.0 : p.x();
      made.mesh.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), p.y()});
    }
    made.rings.push_back(ring);
  }
  for (std::size_t i = 0; i + 1 < made.rings.size(); ++i) {
    made.first_triangle.push_back(static_cast<int>(made.mesh.triangles.size()));
    add_band(made, made.rings[i], made.rings[i + 1], half_step);
  }
  return made;
}

}  // namespace prehend
