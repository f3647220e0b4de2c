#include "primitives/surface_sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "sim/base/random.h"

namespace prehend {
namespace {

// Where a line along an axis meets the surface.
struct Hit {
  int row = 0;  // of the line in the grid across the axis
  int column = 0;
  double along = 0.0;  // coordinate along the axis
  int triangle = 0;
};

// The parallel lines along one axis: through (column + offset, row + offset) * spacing across it.
struct Lines {
  int axis = 0;
  double spacing = 0.0;
  std::array<double, 2> offset = {};

  int first_at_or_above(double x, std::size_t way) const {
    return static_cast<int>(std::ceil(x / spacing - offset[way]));
  }
  double place(int number, std::size_t way) const { return spacing * (number + offset[way]); }
};

// A corner as the lines see it.
struct Seen {
  double across = 0.0;  // by columns
  double up = 0.0;      // by rows
  double along = 0.0;
};

// Between two corners at a height: the same bits from both triangles that share the edge.
Seen at_height(Seen a, Seen b, double up) {
  if (std::tie(b.up, b.across) < std::tie(a.up, a.across)) std::swap(a, b);
  const double part = (up - a.up) / (b.up - a.up);
  return {a.across + part * (b.across - a.across), up, a.along + part * (b.along - a.along)};
}

// The lines through a triangle, row by row. Of an edge that two triangles share, and of the height
// of a corner, one side belongs to it, so that no line is counted twice.
void add_hits(const Lines& lines, const Corners& corners, int triangle, std::vector<Hit>& hits) {
  std::array<Seen, 3> seen;
  for (std::size_t k = 0; k < 3; ++k) {
    seen[k] = {corners[k][(lines.axis + 1) % 3], corners[k][(lines.axis + 2) % 3],
               corners[k][lines.axis]};
  }
  const auto [low, high] = std::minmax({seen[0].up, seen[1].up, seen[2].up});
  const int end = lines.first_at_or_above(high, 1);
  for (int row = lines.first_at_or_above(low, 1); row < end; ++row) {
    const double up = lines.place(row, 1);
    std::array<Seen, 3> crossed;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Seen& a = seen[k];
      const Seen& b = seen[(k + 1) % 3];
      if ((a.up <= up) != (b.up <= up)) crossed[count++] = at_height(a, b, up);
    }
    if (count != 2) continue;
    if (crossed[1].across < crossed[0].across) std::swap(crossed[0], crossed[1]);
    const auto& [left, right, unused] = crossed;
    const int last = lines.first_at_or_above(right.across, 0);
    for (int column = lines.first_at_or_above(left.across, 0); column < last; ++column) {
      const double part = (lines.place(column, 0) - left.across) / (right.across - left.across);
      hits.push_back({row, column, left.along + part * (right.along - left.along), triangle});
    }
  }
}

// Numbers in [0, 1) for the lines of a grid that are spread evenly over any part of it (Roberts
// 2018, "The unreasonable effectiveness of quasirandom sequences": multiples of the powers of the
// inverse plastic number).
double spread_number(int column, int row, double start) {
  constexpr double kColumn = 0.7548776662466927;
  constexpr double kRow = 0.5698402909980532;
  const double number = start + kColumn * column + kRow * row;
  return number - std::floor(number);
}

// Where the points of a line stand among all: any part of them is spread over the whole surface,
// and a line more or less moves none of the others. By the finalizer of SplitMix64 (Steele, Lea and
// Flood 2014, "Fast splittable pseudorandom number generators").
std::uint64_t place_of_line(int axis, int row, int column) {
  std::uint64_t z = (static_cast<std::uint64_t>(axis) << 62U) ^
                    (static_cast<std::uint64_t>(static_cast<std::uint32_t>(row)) << 31U) ^
                    static_cast<std::uint64_t>(static_cast<std::uint32_t>(column));
  z += 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

struct Placed {
  std::uint64_t place = 0;
  SurfacePoint point;
};

// -1 when the mesh as a whole is inside out. The flux of p - center through a closed surface is
// three times the volume inside (divergence theorem); its sign survives holes that are not too
// large.
double outward_sign(const std::vector<SurfacePoint>& points, const Vector3& center) {
  double flux = 0.0;
  for (const SurfacePoint& s : points) flux += s.n_O.dot(s.p_O - center);
  return flux < 0.0 ? -1.0 : 1.0;
}

// The mesh along the axes of the lines, about its middle.
struct SeenMesh {
  std::vector<Corners> triangles;
  Vector3 middle = Vector3::Zero();  // along the axes
  double diagonal = 0.0;
  double area = 0.0;
  int largest = 0;  // of the triangles
};

SeenMesh seen_along(const Matrix3& axes, const TriangleMesh& mesh) {
  SeenMesh seen;
  seen.triangles.reserve(mesh.triangles.size());
  Bounds around;
  double most = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Corners corners = corners_of(mesh, static_cast<int>(t));
    for (Vector3& p : corners) {
      p = axes.transpose() * p;
      around.lower = around.lower.cwiseMin(p);
      around.upper = around.upper.cwiseMax(p);
    }
    seen.triangles.push_back(corners);
    const double own = 0.5 * doubled_area_vector(mesh, t).norm();
    seen.area += own;
    if (own <= most) continue;
    most = own;
    seen.largest = static_cast<int>(t);
  }
  seen.middle = around.center();
  seen.diagonal = around.diagonal();
  for (Corners& corners : seen.triangles) {
    for (Vector3& p : corners) p -= seen.middle;
  }
  return seen;
}

// All hits of the lines, line by line.
std::vector<Hit> hits_of(const Lines& lines, const SeenMesh& seen) {
  std::vector<Hit> hits;
  for (std::size_t t = 0; t < seen.triangles.size(); ++t) {
    add_hits(lines, seen.triangles[t], static_cast<int>(t), hits);
  }
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
    return std::tie(a.row, a.column, a.along, a.triangle) <
           std::tie(b.row, b.column, b.along, b.triangle);
  });
  return hits;
}

}  // namespace

std::vector<SurfacePoint> sample_surface(const TriangleMesh& mesh, int count, std::uint64_t seed,
                                         const Matrix3& axes) {
  // No finer than this part of the mesh's size: of a needle without area, rows without end would
  // miss it.
  constexpr double kFinest = 1.0 / 300.0;
  const SeenMesh seen = seen_along(axes, mesh);
  if (!(seen.area > 0.0)) return {};
  const double spacing = std::max(std::sqrt(seen.area / count), kFinest * seen.diagonal);

  Random random(seed);
  std::vector<Placed> placed;
  const auto normal_of = [&](int triangle) -> Vector3 {
    return doubled_area_vector(mesh, static_cast<std::size_t>(triangle)).normalized();
  };
  const auto add = [&](std::uint64_t place, const Vector3& p, int triangle) {
    placed.push_back({place, {axes * (seen.middle + p), normal_of(triangle), triangle}});
  };
  for (int axis = 0; axis < 3; ++axis) {
    const Lines lines{axis, spacing, {random.uniform(), random.uniform()}};
    const double start = random.uniform();
    for (const Hit& hit : hits_of(lines, seen)) {
      const double lines_here = (axes.transpose() * normal_of(hit.triangle)).lpNorm<1>();
      if (spread_number(hit.column, hit.row, start) * lines_here >= 1.0) continue;
      Vector3 p;
      p[axis] = hit.along;
      p[(axis + 1) % 3] = lines.place(hit.column, 0);
      p[(axis + 2) % 3] = lines.place(hit.row, 1);
      add(place_of_line(axis, hit.row, hit.column), p, hit.triangle);
    }
  }
  // Of a few needles, chance may leave nothing.
  if (placed.empty()) {
    const Corners& corners = seen.triangles[static_cast<std::size_t>(seen.largest)];
    add(0, (corners[0] + corners[1] + corners[2]) / 3.0, seen.largest);
  }
  std::stable_sort(placed.begin(), placed.end(),
                   [](const Placed& a, const Placed& b) { return a.place < b.place; });
  std::vector<SurfacePoint> points;
  points.reserve(placed.size());
  for (const Placed& one : placed) points.push_back(one.point);
  const double sign = outward_sign(points, axes * seen.middle);
  for (SurfacePoint& s : points) s.n_O *= sign;
  return points;
}

}  // namespace prehend
