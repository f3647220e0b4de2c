#include "sim/quality/wrench_slice.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "sim/base/input_error.h"
#include "sim/quality/conic/conic_program.h"
#include "sim/quality/point_hull.h"
#include "sim/quality/quickhull.h"

namespace prehend {
namespace {

// The section of a hull given by half-spaces is the intersection of the half-spaces cut by the
// fixed coordinates. Its corners are found by duality: about a point strictly inside, each
// half-space becomes a point (its pole), and the facets of the hull of the poles are the corners of
// the intersection. The point inside is the section's origin where that is well inside, and the
// centre of the largest inscribed ball otherwise, which keeps all poles as short as possible.

// Sections thinner than this part of the hull's size are flat.
constexpr double kFlat = 1e-9;

// A point so far inside, as a part of the hull's size, leaves poles short enough.
constexpr double kWellInside = 1e-3;

// normals.col(i) . x <= offsets[i]; normals are unit.
struct HalfSpaces {
  Eigen::Matrix3Xd normals;
  Eigen::VectorXd offsets;
};

std::array<int, 3> others(const std::array<int, 3>& fixed) {
  std::array<int, 3> free = {};
  std::size_t count = 0;
  for (int i = 0; i < 6; ++i) {
    if (std::find(fixed.begin(), fixed.end(), i) == fixed.end()) free[count++] = i;
  }
  return free;
}

void check(const PointHull& hull, const FixedCoordinates& fixed) {
  if (hull.status != PointHullStatus::solid || hull.normals.rows() != 6) {
    throw InputError({.field = "hull", .problem = "a section needs a solid one in six dimensions"});
  }
  const std::array<int, 3>& c = fixed.coordinates;
  const bool known = std::all_of(c.begin(), c.end(), [](int i) { return 0 <= i && i < 6; });
  if (!known || c[0] == c[1] || c[0] == c[2] || c[1] == c[2]) {
    throw InputError(
        {.field = "coordinates", .problem = "three different ones of 0 to 5 are needed"});
  }
  if (!fixed.values.allFinite()) throw InputError({.field = "values", .problem = "not finite"});
}

// The half-spaces of the hull's facets in the three free coordinates. A facet parallel to the
// section does not bound it; it only tells whether the section is on its inner side. None: empty.
std::optional<HalfSpaces> cut_facets(const PointHull& hull, const FixedCoordinates& fixed,
                                     const std::array<int, 3>& free) {
  const Eigen::Index count = hull.offsets.size();
  HalfSpaces cut{Eigen::Matrix3Xd(3, count), Eigen::VectorXd(count)};
  Eigen::Index kept = 0;
  for (Eigen::Index f = 0; f < count; ++f) {
    Eigen::Vector3d normal;
    double offset = hull.offsets[f];
    for (std::size_t i = 0; i < 3; ++i) {
      normal[static_cast<Eigen::Index>(i)] = hull.normals(free[i], f);
      offset -= hull.normals(fixed.coordinates[i], f) * fixed.values[static_cast<Eigen::Index>(i)];
    }
    const double length = normal.norm();
    if (length < kFlat) {
      if (offset < 0.0) return std::nullopt;
      continue;
    }
    cut.normals.col(kept) = normal / length;
    cut.offsets[kept++] = offset / length;
  }
  cut.normals.conservativeResize(Eigen::NoChange, kept);
  cut.offsets.conservativeResize(kept);
  return cut;
}

struct Ball {
  Eigen::Vector3d center;
  double radius = 0.0;
};

// The largest ball inside those half-spaces that are listed and a cube of the given half size, as a
// linear program (the Chebyshev centre): maximise the radius r over the centre c and r, subject to
// normal . c + r <= offset for each half-space. The cube keeps the program bounded while few
// half-spaces are listed. A negative radius shows that the intersection is empty.
Ball largest_ball(const HalfSpaces& all, const std::vector<Eigen::Index>& listed, double half) {
  ConicProgram program;
  program.c = -Eigen::Vector4d::Unit(3);
  program.A.resize(0, 4);
  program.b.resize(0);
  const auto rows = static_cast<Eigen::Index>(listed.size()) + 6;
  program.G.resize(rows, 4);
  program.h.resize(rows);
  program.cone.orthant = static_cast<int>(rows);
  for (int i = 0; i < 6; ++i) {
    program.G.row(i) << (i < 3 ? 1.0 : -1.0) * Eigen::RowVector3d::Unit(i % 3), 1.0;
    program.h[i] = half;
  }
  for (Eigen::Index i = 6; i < rows; ++i) {
    const Eigen::Index f = listed[static_cast<std::size_t>(i) - 6];
    program.G.row(i) << all.normals.col(f).transpose(), 1.0;
    program.h[i] = all.offsets[f];
  }
  const ConicSolution solution = solve(program);
  return {solution.x.head<3>(), solution.x[3]};
}

// The largest ball inside all half-spaces. Only few of them touch it, so that a small linear
// program is solved again and again (cutting planes): the half-space that the last ball violates
// most is added, until the ball violates none. If the worst half-space is already listed, the
// violation is a rounding error of the solver. The radius returned is at most the distance of the
// centre from the nearest half-space, so that the ball is inside all of them even then.
Ball inscribed_ball(const HalfSpaces& all, double half) {
  std::vector<Eigen::Index> listed;
  while (true) {
    const Ball ball = largest_ball(all, listed, half);
    Eigen::Index worst = 0;
    const double slack = (all.offsets - all.normals.transpose() * ball.center).minCoeff(&worst);
    const bool known = std::find(listed.begin(), listed.end(), worst) != listed.end();
    if (known || slack >= ball.radius || ball.radius <= 0.0) {
      return {ball.center, std::min(ball.radius, slack)};
    }
    listed.push_back(worst);
  }
}

PointHull hull_of(const Eigen::Matrix3Xd& points) {
  PointHull hull = quickhull(points);
  if (hull.status == PointHullStatus::failed) hull = point_hull(points);
  if (hull.status == PointHullStatus::failed) hull = point_hull(points, HullInput::joggled);
  return hull;
}

// Many facets of the hull are in one plane, and give the same half-space.
void drop_copies(Eigen::Matrix3Xd& points) {
  std::vector<Eigen::Vector3d> all(points.colwise().begin(), points.colwise().end());
  const auto before = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  std::sort(all.begin(), all.end(), before);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  points.resize(Eigen::NoChange, std::ssize(all));
  std::copy(all.begin(), all.end(), points.colwise().begin());
}

// The corners of the intersection. A half-space normal . (x - centre) <= d, with d > 0 since the
// centre is inside, has the pole normal / d. A facet normal . y <= offset of the hull of the poles
// is dual to the corner normal / offset, relative to the centre.
Eigen::Matrix3Xd corners(const HalfSpaces& all, const Eigen::Vector3d& center) {
  Eigen::Matrix3Xd poles = all.normals;
  for (Eigen::Index f = 0; f < poles.cols(); ++f) {
    poles.col(f) /= all.offsets[f] - all.normals.col(f).dot(center);
  }
  drop_copies(poles);
  PointHull hull = hull_of(poles);
  if (hull.status != PointHullStatus::solid) hull = point_hull(poles, HullInput::joggled);
  Eigen::Matrix3Xd found(3, hull.offsets.size());
  for (Eigen::Index f = 0; f < found.cols(); ++f) {
    found.col(f) = center + hull.normals.col(f) / hull.offsets[f];
  }
  return found;
}

// Times 2^exponent.
template <typename Numbers>
void scale(Numbers& numbers, int exponent) {
  for (double& number : numbers.reshaped()) number = std::ldexp(number, exponent);
}

// The triangles of the convex hull of the corners. Where more than three half-spaces meet in one
// corner, the list of corners has copies of it up to rounding: taking their hull again removes the
// copies inside it. Vertices are numbered in the order in which the triangles first use them.
void add_surface(const Eigen::Matrix3Xd& points, WrenchSlice& slice) {
  const PointHull hull = hull_of(points);
  if (hull.status != PointHullStatus::solid) return;
  std::vector<int> number(static_cast<std::size_t>(points.cols()), -1);
  slice.vertices.resize(3, points.cols());
  slice.triangles.resize(3, hull.offsets.size());
  Eigen::Index used = 0;
  for (Eigen::Index f = 0; f < hull.offsets.size(); ++f) {
    Eigen::Vector3i triangle = hull.corners.col(f);
    const Eigen::Vector3d a = points.col(triangle[0]);
    const Eigen::Vector3d b = points.col(triangle[1]);
    const Eigen::Vector3d c = points.col(triangle[2]);
    // The corners of a facet are listed in no particular orientation.
    if ((b - a).cross(c - a).dot(Eigen::Vector3d(hull.normals.col(f))) < 0.0) {
      std::swap(triangle[1], triangle[2]);
    }
    for (int& corner : triangle) {
      int& at = number[static_cast<std::size_t>(corner)];
      if (at < 0) {
        at = static_cast<int>(used);
        slice.vertices.col(used++) = points.col(corner);
      }
      corner = at;
    }
    slice.triangles.col(f) = triangle;
  }
  slice.vertices.conservativeResize(Eigen::NoChange, used);
  slice.volume = hull.volume;
}

}  // namespace

WrenchSlice wrench_slice(const PointHull& hull, const FixedCoordinates& fixed) {
  check(hull, fixed);
  WrenchSlice slice;
  slice.coordinates = others(fixed.coordinates);
  std::optional<HalfSpaces> cut = cut_facets(hull, fixed, slice.coordinates);
  if (!cut) return slice;
  // Lengths are scaled near one by a power of two, which is exact: products of much larger or
  // smaller ones could leave the range of doubles.
  int exponent = 0;
  // The size is that of the hull, which contains the section. Offsets in the section cannot tell
  // it: those of facets nearly parallel to the section may be far larger than the section itself.
  // The cube of 1.1 times this size contains the hull, so that it does not cut the ball.
  const double size = std::frexp(hull.reach, &exponent);
  scale(cut->offsets, -exponent);
  const double depth = cut->offsets.minCoeff();  // of the origin
  const Ball ball = depth > kWellInside * size ? Ball{Eigen::Vector3d::Zero(), depth}
                                               : inscribed_ball(*cut, 1.1 * size);
  if (!(ball.radius > kFlat * size)) return slice;
  add_surface(corners(*cut, ball.center), slice);
  scale(slice.vertices, exponent);
  slice.volume = std::ldexp(slice.volume, 3 * exponent);
  return slice;
}

WrenchSections wrench_sections(const PointHull& hull) {
  if (hull.status != PointHullStatus::solid) return {};
  return {wrench_slice(hull, {{3, 4, 5}, Eigen::Vector3d::Zero()}),
          wrench_slice(hull, {{0, 1, 2}, Eigen::Vector3d::Zero()})};
}

}  // namespace prehend
