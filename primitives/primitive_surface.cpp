#include "primitives/primitive_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

// Each part of the surface (face, side, cap) gets points by its share of the area. They are spread
// by a rank-1 lattice: the i-th of n points has the coordinates ((i + 1/2) / n, (i + 1/2) times the
// golden ratio, modulo 1) in the unit square, which is mapped to the part by a map that preserves
// areas. The points are evenly spread for any n, and the same in every run.
namespace prehend {
namespace {

using std::numbers::pi;

// Successive multiples of the golden ratio, modulo 1, fill an interval evenly for any number of
// points. Only the fraction of the ratio matters.
constexpr double kTurn = std::numbers::phi - 1.0;

double fraction(double x) { return x - std::floor(x); }

int share(double area, double total, int count) {
  return std::max(1, static_cast<int>(std::lround(count * area / total)));
}

// Calls place(i-th even fraction, i-th golden fraction) for `n` points that stand for `area`.
template <class Place>
void spread(std::vector<PatchPoint>& points, double area, int n, const Place& place) {
  for (int i = 0; i < n; ++i) {
    points.push_back({place((i + 0.5) / n, fraction((i + 0.5) * kTurn)), area / n});
  }
}

void spread_over(const Box& box, int count, std::vector<PatchPoint>& points) {
  const double total = surface_area(Shape(box));
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const double area = box.size[u] * box.size[v];
    for (const double side : {-0.5, 0.5}) {
      spread(points, area, share(area, total, count), [&](double s, double t) {
        Vector3 p;
        p[axis] = side * box.size[axis];
        p[u] = (s - 0.5) * box.size[u];
        p[v] = (t - 0.5) * box.size[v];
        return p;
      });
    }
  }
}

void spread_over(const Sphere& sphere, int count, std::vector<PatchPoint>& points) {
  spread(points, surface_area(Shape(sphere)), count, [&](double s, double t) {
    // Zones of equal height on a sphere have equal areas (Archimedes).
    const double z = 2.0 * s - 1.0;
    const double rho = std::sqrt(1.0 - z * z);
    const double angle = 2.0 * pi * t;
    return Vector3(sphere.radius * Vector3(rho * std::cos(angle), rho * std::sin(angle), z));
  });
}

void spread_over(const Cylinder& cylinder, int count, std::vector<PatchPoint>& points) {
  const double total = surface_area(Shape(cylinder));
  const double r = cylinder.radius;
  const double side = 2.0 * pi * r * cylinder.height;
  const double cap = pi * r * r;
  spread(points, side, share(side, total, count), [&](double s, double t) {
    const double angle = 2.0 * pi * t;
    return Vector3(r * std::cos(angle), r * std::sin(angle), (s - 0.5) * cylinder.height);
  });
  for (const double end : {-0.5, 0.5}) {
    spread(points, cap, share(cap, total, count), [&](double s, double t) {
      // The area within a radius grows with its square, hence the root.
      const double rho = r * std::sqrt(s);
      const double angle = 2.0 * pi * t;
      return Vector3(rho * std::cos(angle), rho * std::sin(angle), end * cylinder.height);
    });
  }
}

void spread_over(const Cone& cone, int count, std::vector<PatchPoint>& points) {
  const double total = surface_area(Shape(cone));
  const double low = cone.radius_low;
  const double high = cone.radius_high;
  const double side = pi * (low + high) * std::hypot(cone.height, high - low);
  spread(points, side, share(side, total, count), [&](double s, double t) {
    // The area up to a radius grows with the difference of the squares; (r - low) / (high - low),
    // without a difference that may be 0.
    const double r = std::sqrt(low * low + s * (high * high - low * low));
    const double u = low + r > 0.0 ? s * (low + high) / (low + r) : 0.0;
    const double angle = 2.0 * pi * t;
    return Vector3(r * std::cos(angle), r * std::sin(angle), (u - 0.5) * cone.height);
  });
  for (const double end : {-0.5, 0.5}) {
    const double radius = end < 0.0 ? low : high;
    const double cap = pi * radius * radius;
    spread(points, cap, share(cap, total, count), [&](double s, double t) {
      const double rho = radius * std::sqrt(s);
      const double angle = 2.0 * pi * t;
      return Vector3(rho * std::cos(angle), rho * std::sin(angle), end * cone.height);
    });
  }
}

// Around a curve, as wide as it is.
void spread_around(const std::vector<Vector3>& line, bool closed, double width, int count,
                   std::vector<PatchPoint>& points) {
  const double length = curve_length(line, closed);
  const std::size_t steps = closed ? line.size() : line.size() - 1;
  for (std::size_t i = 0; i < steps; ++i) {
    const Vector3& from = line[i];
    const Vector3 along = line[(i + 1) % line.size()] - from;
    const Vector3 x = any_orthogonal(along.normalized());
    const Vector3 y = along.normalized().cross(x);
    spread(points, pi * width * along.norm(), share(along.norm(), length, count),
           [&](double s, double t) {
             const double angle = 2.0 * pi * t;
             return Vector3(from + s * along +
                            0.5 * width * (std::cos(angle) * x + std::sin(angle) * y));
           });
  }
}

void spread_over(const Rim& rim, int count, std::vector<PatchPoint>& points) {
  spread_around(points_of(rim), rim.closed, rim.width, count, points);
}

void spread_over(const Bar& bar, int count, std::vector<PatchPoint>& points) {
  spread_around(bar.points, bar.closed, bar.width, count, points);
}

}  // namespace

std::vector<PatchPoint> spread_points(const Primitive& primitive, int count) {
  std::vector<PatchPoint> points;
  points.reserve(static_cast<std::size_t>(count) + 6);
  std::visit([&](const auto& s) { spread_over(s, count, points); }, primitive.shape);
  for (PatchPoint& point : points) point.p_O = primitive.X_OP * point.p_O;
  return points;
}

}  // namespace prehend
