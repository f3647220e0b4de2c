#include "sim/soft/pad.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "sim/base/input_error.h"
#include "sim/base/number_text.h"
#include "sim/shape/proximity.h"
#include "sim/soft/elastic_solid.h"

namespace prehend {
namespace {

// Rays through the rim of the surface would miss it by rounding: the grid ends this part of its
// spacing inside.
constexpr double kInside = 1e-3;
// The link may be thinner than the pad by rounding.
constexpr double kThinner = 1e-6;

// Extent of a region along an axis [m].
struct Extent {
  double lower = 0.0;
  double upper = 0.0;
  double size() const { return upper - lower; }
};

// The grid of rays that look for the surface, in a frame with z outward.
class Grid {
 public:
  Grid(const ProximityMesh& link, const PadShape& shape, const PadOptions& options)
      : link_(link), shape_(shape), least_(std::cos(options.steepest)) {
    find_axes();
    find_extents();
    choose_spacing(options);
  }

  int columns() const { return cells_[0] + 1; }
  int rows() const { return cells_[1] + 1; }
  double spacing() const { return spacing_; }

  // The surface of the link under node (i, j) of the grid, with its normal; false: not of the pad.
  bool find_surface(int i, int j, Vector3& p_L, Vector3& normal_L) const {
    const double inside = kInside * spacing_;
    Vector3 at = Vector3::Zero();
    for (Eigen::Index k = 0; k < 2; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      const Extent& extent = extents_[axis];
      const double part = static_cast<double>(k == 0 ? i : j) / cells_[axis];
      at[k] = extent.lower + inside + part * (extent.size() - 2.0 * inside);
    }
    at[2] = extents_[2].upper + shape_.thickness;
    const RayHit hit = first_hit(link_, axes_ * at, -shape_.outward_L);
    if (hit.triangle < 0) return false;
    normal_L =
        doubled_area_vector(link_.mesh(), static_cast<std::size_t>(hit.triangle)).normalized();
    if (normal_L.dot(shape_.outward_L) < least_) return false;
    p_L = axes_ * at - hit.distance * shape_.outward_L;
    return true;
  }

 private:
  // x along the longer side of the smallest rectangle around the surface's outline, among
  // directions of its edges: grids then follow the sides of rectangular pads.
  void find_axes() {
    axes_.col(2) = shape_.outward_L;
    axes_.col(0) = any_orthogonal(shape_.outward_L);
    axes_.col(1) = axes_.col(2).cross(axes_.col(0));
    find_extents();
    double smallest = extents_[0].size() * extents_[1].size();
    const Matrix3 start = axes_;
    Matrix3 best = axes_;
    constexpr int kTurns = 90;  // a degree each
    for (int turn = 1; turn < kTurns; ++turn) {
      const double angle = 0.5 * std::numbers::pi * turn / kTurns;
      axes_.col(0) = std::cos(angle) * start.col(0) + std::sin(angle) * start.col(1);
      axes_.col(1) = axes_.col(2).cross(axes_.col(0));
      find_extents();
      const double area = extents_[0].size() * extents_[1].size();
      if (area < smallest * (1.0 - kThinner)) {
        smallest = area;
        best = axes_;
      }
    }
    axes_ = best;
  }

  void find_extents() {
    bool found = false;
    const TriangleMesh& mesh = link_.mesh();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Vector3 area = doubled_area_vector(mesh, t);
      if (area.dot(shape_.outward_L) < least_ * area.norm() || area.isZero(0.0)) continue;
      for (const Vector3& corner : corners_of(mesh, static_cast<int>(t))) {
        for (Eigen::Index k = 0; k < 3; ++k) {
          const double value = axes_.col(k).dot(corner);
          Extent& extent = extents_[static_cast<std::size_t>(k)];
          if (!found) extent = {value, value};
          extent.lower = std::min(extent.lower, value);
          extent.upper = std::max(extent.upper, value);
        }
        found = true;
      }
    }
    require(found, {.field = "outward", .problem = "no part of the link's surface faces this way"});
  }

  void choose_spacing(const PadOptions& options) {
    spacing_ = options.spacing;
    while (true) {
      for (std::size_t k = 0; k < 2; ++k) {
        cells_[k] = std::max(1, static_cast<int>(std::lround(extents_[k].size() / spacing_)));
      }
      if ((cells_[0] + 1) * (cells_[1] + 1) <= options.most_nodes) return;
      spacing_ *= 1.05;
    }
  }

  const ProximityMesh& link_;
  const PadShape& shape_;
  double least_;  // cosine of the steepest slope
  Matrix3 axes_;  // columns: x, y of the grid and outward, in L
  std::array<Extent, 3> extents_ = {};
  std::array<int, 2> cells_ = {1, 1};
  double spacing_ = 0.0;
};

// A node of the grid that lies on the pad; `place` counts those that belong to a cell.
struct GridNode {
  bool found = false;
  int place = -1;
  Vector3 p_L = Vector3::Zero();
  Vector3 normal_L = Vector3::Zero();
};

using Cell = std::array<std::size_t, 4>;  // nodes, counter-clockwise seen from outside

// Cells whose four nodes are on the surface and lie in one piece of it.
std::vector<Cell> find_cells(const Grid& grid, const std::vector<GridNode>& nodes,
                             double steepest) {
  const double longest = 1.5 * grid.spacing() / std::cos(steepest);
  std::vector<Cell> cells;
  const auto columns = static_cast<std::size_t>(grid.columns());
  for (std::size_t j = 0; j + 1 < static_cast<std::size_t>(grid.rows()); ++j) {
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      const std::size_t first = j * columns + i;
      const Cell cell{first, first + 1, first + columns + 1, first + columns};
      bool whole = true;
      for (std::size_t k = 0; k < 4; ++k) {
        const GridNode& a = nodes[cell[k]];
        const GridNode& b = nodes[cell[(k + 1) % 4]];
        whole &= a.found && b.found && (a.p_L - b.p_L).norm() <= longest;
      }
      if (whole) cells.push_back(cell);
    }
  }
  return cells;
}

// A pad is no thicker than what it is made of.
void require_thick(const ProximityMesh& link, const PadShape& shape, const Vector3& p_L,
                   const Vector3& normal_L) {
  const double step = kThinner * shape.thickness;
  const RayHit exit = first_hit(link, p_L - step * normal_L, -normal_L, shape.thickness);
  const double available = exit.triangle < 0 ? shape.thickness : exit.distance + step;
  require(available >= shape.thickness * (1.0 - 1e3 * kThinner),
          {.field = "thickness",
           .problem = "the link is only " + number_text(1e3 * available) + " mm thick there",
           .value = number_text(1e3 * shape.thickness) + " mm"});
}

}  // namespace

PadMesh pad_mesh(const ProximityMesh& link, const PadShape& shape, const PadOptions& options) {
  const Grid grid(link, shape, options);
  std::vector<GridNode> nodes;
  for (int j = 0; j < grid.rows(); ++j) {
    for (int i = 0; i < grid.columns(); ++i) {
      GridNode node;
      node.found = grid.find_surface(i, j, node.p_L, node.normal_L);
      nodes.push_back(node);
    }
  }
  const std::vector<Cell> cells = find_cells(grid, nodes, options.steepest);
  require(!cells.empty(), {.field = "outward",
                           .problem = "the surface that faces this way is too "
                                      "small for a pad"});
  PadMesh pad;
  for (const Cell& cell : cells) {
    for (const std::size_t n : cell) {
      if (nodes[n].place >= 0) continue;
      nodes[n].place = pad.surface_nodes++;
      require_thick(link, shape, nodes[n].p_L, nodes[n].normal_L);
      pad.mesh.nodes.push_back(nodes[n].p_L);
      pad.normals_L.push_back(nodes[n].normal_L);
    }
  }
  pad.areas.assign(static_cast<std::size_t>(pad.surface_nodes), 0.0);
  for (const Cell& cell : cells) {
    const auto at = [&](std::size_t k) { return nodes[cell[k]].p_L; };
    const double area = 0.5 * (at(2) - at(0)).cross(at(3) - at(1)).norm();
    for (const std::size_t n : cell) {
      pad.areas[static_cast<std::size_t>(nodes[n].place)] += 0.25 * area;
    }
  }
  const auto surface = static_cast<std::size_t>(pad.surface_nodes);
  for (int layer = 1; layer <= options.layers; ++layer) {
    const double depth = shape.thickness * layer / options.layers;
    for (std::size_t n = 0; n < surface; ++n) {
      pad.mesh.nodes.push_back(pad.mesh.nodes[n] - depth * pad.normals_L[n]);
    }
  }
  for (int layer = 0; layer < options.layers; ++layer) {
    for (const Cell& cell : cells) {
      Hexahedron element;
      for (std::size_t k = 0; k < 4; ++k) {
        const int top = nodes[cell[k]].place + layer * pad.surface_nodes;
        element[k] = top + pad.surface_nodes;
        element[k + 4] = top;
      }
      pad.mesh.elements.push_back(element);
    }
  }
  return pad;
}

void check_pad(const ProximityMesh& link, const PadShape& shape, const PadOptions& options) {
  require_in(kLengthAbove0, shape.thickness, "thickness");
  (void)stiffness_matrix(pad_mesh(link, shape, options).mesh, shape.material);
}

Pad make_pad(const ProximityMesh& link, const PadShape& shape, const PadOptions& options,
             const RunContext& context) {
  require_in(kLengthAbove0, shape.thickness, "thickness");
  PadMesh mesh = pad_mesh(link, shape, options);
  Pad pad;
  const auto surface = static_cast<std::size_t>(mesh.surface_nodes);
  pad.nodes_L.assign(mesh.mesh.nodes.begin(),
                     mesh.mesh.nodes.begin() + static_cast<std::ptrdiff_t>(surface));
  pad.normals_L = std::move(mesh.normals_L);
  pad.areas = std::move(mesh.areas);
  pad.outward_L = shape.outward_L;
  pad.thickness = shape.thickness;
  std::vector<bool> held(3 * mesh.mesh.nodes.size(), false);
  std::fill(held.end() - static_cast<std::ptrdiff_t>(3 * surface), held.end(), true);
  std::vector<int> loaded;
  for (int i = 0; i < 3 * mesh.surface_nodes; ++i) loaded.push_back(i);
  pad.compliance =
      compliance_matrix(stiffness_matrix(mesh.mesh, shape.material), held, loaded, context);
  return pad;
}

}  // namespace prehend
