// The mug is a cup (surface of revolution) with two rectangular patches of cells cut out of its
// wall, one above the other, and a tube (the handle) whose ends are joined to the borders of the
// patches vertex by vertex. So handle and body are one closed manifold surface instead of two that
// intersect.
#include "sim/shape/generate_mug.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <vector>

#include "sim/shape/revolve.h"
#include "sim/shape/weld.h"

namespace prehend {
namespace {

// All dimensions in metres.
constexpr double kRadius = 0.052;
constexpr double kHeight = 0.105;
constexpr double kWall = 0.0045;
constexpr double kFootFillet = 0.005;
constexpr double kInnerFillet = 0.008;
// The handle's centre line is about half an ellipse whose centre is at this height.
constexpr double kHandleMiddle = 0.054;
constexpr double kHandleHalfHeight = 0.028;
constexpr double kHandleReach = 0.0285;
constexpr double kHandleWidth = 0.014;
constexpr double kHandleThickness = 0.009;
// Relative increase of the cross section at the wall; it decays exponentially with the distance
// from the wall over kFlareLength.
constexpr double kFlare = 0.35;
constexpr double kFlareLength = 0.006;

std::vector<ProfileCorner> body_profile() {
  std::vector<ProfileCorner> outer{
      {{0.0, 0.0}}, {{kRadius, 0.0}, kFootFillet}, {{kRadius, kHeight}, 0.5 * kWall}};
  std::vector<ProfileCorner> inner = inner_side(outer, kWall);
  inner[1].fillet = kInnerFillet;
  outer.insert(outer.end(), inner.begin(), inner.end());
  return outer;
}

// The cylindrical part of the outer wall as a grid: rings first_ring to last_ring with `columns`
// vertices each.
struct Wall {
  std::size_t first_ring = 0;
  std::size_t last_ring = 0;
  int columns = 0;
  double row_height = 0.0;
};

Wall find_wall(const Revolved& body) {
  const auto on_wall = [&](std::size_t i) {
    const Vector3& p = body.mesh.vertices[static_cast<std::size_t>(body.rings[i].first)];
    return std::abs(std::hypot(p.x(), p.y()) - kRadius) < 1e-9;
  };
  Wall wall;
  while (!on_wall(wall.first_ring)) ++wall.first_ring;
  wall.last_ring = wall.first_ring;
  while (on_wall(wall.last_ring + 1)) ++wall.last_ring;
  wall.columns = body.rings[wall.first_ring].count;
  const auto height = [&](std::size_t i) {
    return body.mesh.vertices[static_cast<std::size_t>(body.rings[i].first)].z();
  };
  wall.row_height = (height(wall.last_ring) - height(wall.first_ring)) /
                    static_cast<double>(wall.last_ring - wall.first_ring);
  return wall;
}

// A rectangle of wall cells, symmetric about the plane y = 0.
struct Patch {
  std::size_t first_ring = 0;
  int rows = 1;
  int columns = 1;
};

// The patch of the given size whose middle is nearest to `height`, moved so that it fits on the
// wall.
Patch patch_at(const Wall& wall, double height, int rows, int columns) {
  const double row = (height - kFootFillet) / wall.row_height - 0.5 * rows;
  const long last = static_cast<long>(wall.last_ring - wall.first_ring) - rows;
  const long first = std::clamp(std::lround(row), 0L, last);
  return {wall.first_ring + static_cast<std::size_t>(first), rows, columns};
}

// Index of a vertex of the patch; row 0 is its lowest ring, column 0 its side of lowest y. Odd
// numbers of columns are symmetric about y = 0 because the body then has its vertices at half
// steps.
int patch_vertex(const Revolved& body, const Patch& patch, int row, int column) {
  const Ring& ring = body.rings[patch.first_ring + static_cast<std::size_t>(row)];
  const int first = -(patch.columns / 2) - (patch.columns % 2);
  return ring.first + (first + column + ring.count) % ring.count;
}

// Vertices of the border, counter-clockwise seen from +x, starting at the lower corner of lowest y.
// `mirrored` exchanges up and down: the tube turns over between its upper and its lower end, so
// that its vertices meet the lower patch in mirrored order.
std::vector<int> border(const Revolved& body, const Patch& patch, bool mirrored) {
  std::vector<int> loop;
  const auto add = [&](int row, int column) {
    loop.push_back(patch_vertex(body, patch, mirrored ? patch.rows - row : row, column));
  };
  for (int c = 0; c < patch.columns; ++c) add(0, c);
  for (int r = 0; r < patch.rows; ++r) add(r, patch.columns);
  for (int c = patch.columns; c > 0; --c) add(patch.rows, c);
  for (int r = patch.rows; r > 0; --r) add(r, 0);
  return loop;
}

// Removes the two triangles of every cell of the patches.
void remove_cells(Revolved& body, const std::vector<Patch>& patches) {
  std::set<int> removed;
  for (const Patch& patch : patches) {
    for (int row = 0; row < patch.rows; ++row) {
      const std::size_t band = patch.first_ring + static_cast<std::size_t>(row);
      for (int column = 0; column < patch.columns; ++column) {
        const int cell = patch_vertex(body, patch, row, column) - body.rings[band].first;
        removed.insert(body.first_triangle[band] + 2 * cell);
        removed.insert(body.first_triangle[band] + 2 * cell + 1);
      }
    }
  }
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < body.mesh.triangles.size(); ++t) {
    if (!removed.contains(static_cast<int>(t))) kept.push_back(body.mesh.triangles[t]);
  }
  body.mesh.triangles = std::move(kept);
}

// Joins two loops of equal length by a band of triangles.
void join(TriangleMesh& mesh, const std::vector<int>& from, const std::vector<int>& to) {
  for (std::size_t k = 0; k < from.size(); ++k) {
    const std::size_t next = (k + 1) % from.size();
    mesh.triangles.push_back({from[k], from[next], to[next]});
    mesh.triangles.push_back({from[k], to[next], to[k]});
  }
}

// The handle's centre line: half an ellipse in the plane y = 0, from the upper patch to the lower.
struct Bow {
  double middle = 0.0;  // height of the ellipse's centre
  double half_height = 0.0;
};

// Height of the middle of a patch [m].
double center_height(const Revolved& body, const Patch& patch) {
  const int low = patch_vertex(body, patch, 0, 0);
  const int high = patch_vertex(body, patch, patch.rows, 0);
  return 0.5 * (body.mesh.vertices[static_cast<std::size_t>(low)].z() +
                body.mesh.vertices[static_cast<std::size_t>(high)].z());
}

// Adds the elliptic cross section at `progress` along the bow (0: upper end, 1: lower end), with
// one vertex at each of `angles`, measured from +y; at the upper end the angle pi / 2 points up.
std::vector<int> add_section(TriangleMesh& mesh, const Bow& bow, double progress,
                             const std::vector<double>& angles) {
  const double t = std::numbers::pi * (0.5 - progress);
  const Vector3 center(kRadius + kHandleReach * std::cos(t), 0.0,
                       bow.middle + bow.half_height * std::sin(t));
  const Vector3 along =
      Vector3(kHandleReach * std::sin(t), 0.0, -bow.half_height * std::cos(t)).normalized();
  const Vector3 across = along.cross(Vector3::UnitY());
  const double flare = 1.0 + kFlare * std::exp(-(center.x() - kRadius) / kFlareLength);
  std::vector<int> ring;
  for (const double angle : angles) {
    ring.push_back(static_cast<int>(mesh.vertices.size()));
    mesh.vertices.push_back(center +
                            0.5 * flare * kHandleWidth * std::cos(angle) * Vector3::UnitY() +
                            0.5 * flare * kHandleThickness * std::sin(angle) * across);
  }
  return ring;
}

// The handle's tube between the borders of the two patches.
void add_handle(Revolved& body, const Patch& upper, const Patch& lower, double edge) {
  const double high = center_height(body, upper);
  const double low = center_height(body, lower);
  const Bow bow{0.5 * (high + low), 0.5 * (high - low)};
  std::vector<int> previous = border(body, upper, false);
  const std::vector<int> end = border(body, lower, true);
  // Equal angles, starting at the direction of the corner where the border of the patch starts
  // (lower corner of lowest y), so that the tube is not twisted against the border.
  const double corner = std::numbers::pi + std::atan2(upper.rows, upper.columns);
  std::vector<double> angles;
  for (std::size_t k = 0; k < previous.size(); ++k) {
    angles.push_back(corner + 2.0 * std::numbers::pi * static_cast<double>(k) /
                                  static_cast<double>(previous.size()));
  }
  const double length = 0.5 * std::numbers::pi * (kHandleReach + bow.half_height);
  const int sections = std::max(6, static_cast<int>(std::lround(length / edge)));
  for (int i = 1; i < sections; ++i) {
    std::vector<int> ring = add_section(body.mesh, bow, static_cast<double>(i) / sections, angles);
    join(body.mesh, previous, ring);
    previous = std::move(ring);
  }
  join(body.mesh, previous, end);
}

}  // namespace

TriangleMesh generate_mug(double edge) {
  // The wall then has at least five rows: room for two patches and a row between them.
  edge = std::min(edge, 0.018);
  // The holes are slightly larger than the cross section of the handle, like the foot of its flare.
  const int columns = std::max(1, static_cast<int>(std::lround(kHandleWidth * 1.1 / edge)));
  Revolved body = revolve(profile_points(body_profile(), edge), edge, columns % 2 == 1);
  const Wall wall = find_wall(body);
  const int rows =
      std::max(1, static_cast<int>(std::lround(kHandleThickness * 1.5 / wall.row_height)));
  const Patch upper = patch_at(wall, kHandleMiddle + kHandleHalfHeight, rows, columns);
  const Patch lower = patch_at(wall, kHandleMiddle - kHandleHalfHeight, rows, columns);
  remove_cells(body, {upper, lower});
  add_handle(body, upper, lower, edge);
  drop_unused_vertices(body.mesh);
  return body.mesh;
}

}  // namespace prehend
