// Each attempt (as it is, holes closed, convex hull, surface) is used if its result is plausible.
#include "sim/shape/mass_solid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>

#include "sim/base/disjoint_sets.h"
#include "sim/base/input_error.h"
#include "sim/shape/convex_hull.h"
#include "sim/shape/edge_table.h"
#include "sim/shape/mesh_checks.h"
#include "sim/shape/weld.h"

namespace prehend {
namespace {

// The triangles that close the holes. Edges that are not traversed equally often in both directions
// form the rims; rim edges connected by vertices are one hole. Each rim edge is joined to the mean
// of the vertices of its hole, as often as one direction is missing. The result bounds a solid in
// the sense of signed volume for any mesh.
TriangleMesh caps(const TriangleMesh& mesh) {
  struct Rim {
    int from;
    int to;
    int times;
  };
  std::vector<Rim> rims;
  DisjointSets holes(mesh.vertices.size());
  for_each_edge(edge_uses(mesh), [&](std::span<const EdgeUse> edge) {
    const int net = net_direction(edge);
    if (net == 0) return;
    // The cap traverses the edge in the direction that is missing.
    rims.push_back(net > 0 ? Rim{edge[0].high, edge[0].low, net}
                           : Rim{edge[0].low, edge[0].high, -net});
    holes.merge(static_cast<std::size_t>(edge[0].low), static_cast<std::size_t>(edge[0].high));
  });
  struct Mean {
    Vector3 sum = Vector3::Zero();
    int count = 0;
    int vertex = -1;
  };
  std::map<std::size_t, Mean> mean_of;
  for (const Rim& rim : rims) {
    Mean& mean = mean_of[holes.find(static_cast<std::size_t>(rim.from))];
    mean.sum += mesh.vertices[static_cast<std::size_t>(rim.from)] +
                mesh.vertices[static_cast<std::size_t>(rim.to)];
    mean.count += 2;
  }
  TriangleMesh closing{mesh.vertices, {}};
  for (auto& [root, mean] : mean_of) {
    mean.vertex = static_cast<int>(closing.vertices.size());
    closing.vertices.push_back(mean.sum / mean.count);
  }
  for (const Rim& rim : rims) {
    const int apex = mean_of.at(holes.find(static_cast<std::size_t>(rim.from))).vertex;
    for (int i = 0; i < rim.times; ++i) closing.triangles.push_back({rim.from, rim.to, apex});
  }
  return closing;
}

// Whether the moments can be those of a solid within the bounds of the mesh. Wrongly wound or
// overlapping parts make volume, centre or inertia impossible.
bool plausible(const Moments& solid, const TriangleMesh& mesh) {
  const Bounds box = bounds(mesh);
  const double box_volume = box.size().prod();
  // A box fills its bounds exactly, up to rounding.
  constexpr double kRounding = 1e-9;
  if (!(solid.zeroth > 1e-6 * box_volume)) return false;
  if (!(solid.zeroth <= (1.0 + kRounding) * box_volume)) return false;
  const Vector3 center = solid.center();
  if (((center - box.lower).array() < 0.0).any() || ((box.upper - center).array() < 0.0).any()) {
    return false;
  }
  // The second central moment of a solid is positive definite, and at most the squared diagonal of
  // its bounds.
  const Matrix3 spread = solid.spread();
  const Vector3 eigenvalues = Eigen::SelfAdjointEigenSolver<Matrix3>(spread).eigenvalues();
  return eigenvalues.minCoeff() > 0.0 && spread.trace() <= box.size().squaredNorm();
}

// The solid that the mesh bounds with its present winding, after closing holes. nullopt when its
// mass properties are implausible.
std::optional<MassSolid> enclosed(const TriangleMesh& mesh) {
  // Largest share of cap area. Beyond it the volume depends mostly on the guessed caps; the convex
  // hull is the better guess.
  constexpr double kMostCapped = 0.25;
  const TriangleMesh closing = caps(mesh);
  if (surface_area(closing) > kMostCapped * surface_area(mesh)) return std::nullopt;
  TriangleMesh whole{closing.vertices, mesh.triangles};
  whole.triangles.insert(whole.triangles.end(), closing.triangles.begin(), closing.triangles.end());
  const Moments solid = solid_moments(whole);
  if (!plausible(solid, mesh)) return std::nullopt;
  const MassSource source = closing.empty() ? MassSource::signed_volume : MassSource::closed_holes;
  return MassSolid{source, std::move(whole), solid};
}

bool has_area(const TriangleMesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!is_degenerate(mesh, t)) return true;
  }
  return false;
}

// For a mesh with a bounding-box diagonal of 1 about the origin: the attempts in the order of
// MassSource.
MassSolid of_unit_size(TriangleMesh mesh) {
  orient_outward(mesh);
  if (std::optional<MassSolid> found = enclosed(mesh)) return std::move(*found);
  TriangleMesh hull = convex_hull(mesh.vertices);
  if (!hull.empty()) {
    const Moments solid = solid_moments(hull);
    if (plausible(solid, mesh)) return {MassSource::convex_hull, std::move(hull), solid};
  }
  const Moments sheet = sheet_moments(mesh);
  return {MassSource::surface, std::move(mesh), sheet};
}

}  // namespace

MassSolid mass_solid(const TriangleMesh& mesh) {
  const bool finite = std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                                  [](const Vector3& p) { return p.allFinite(); });
  require(finite, {.field = "mesh", .problem = "has vertices that are not finite"});
  // Computed about the centre of the bounds and at unit size: the volumes of tetrahedra from a
  // distant origin would cancel most digits, and those of tiny meshes would fall below absolute
  // thresholds.
  TriangleMesh unit = mesh;
  drop_unused_vertices(unit);
  const Bounds box = bounds(unit);
  const double size = box.diagonal();
  for (Vector3& p : unit.vertices) p = (p - box.center()) / size;
  // At that size, tiny triangles that are far from each other may have no area.
  require(has_area(unit), {.field = "mesh",
                           .problem = "has no triangle of positive area",
                           .value = std::to_string(unit.triangles.size()) + " triangles"});
  MassSolid solid = of_unit_size(std::move(unit));
  solid.center = box.center();
  solid.size = size;
  return solid;
}

}  // namespace prehend
