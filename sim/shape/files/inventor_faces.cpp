#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "sim/base/index.h"
#include "sim/shape/files/inventor_shapes.h"
#include "sim/shape/files/inventor_tokens.h"
#include "sim/shape/polygon.h"

// Shapes of faces: each lists runs of vertices, as indices or as numbers of consecutive vertices,
// and a run is a polygon or a strip of triangles.
namespace prehend {
namespace {

constexpr int kMostInventorCorners = 10'000;

using Runs = std::vector<std::vector<int>>;

// The points that the shape refers to: its own, or those of the nodes before it.
const InventorField* points_of(const InventorTree& tree, const InventorNode& node,
                               const InventorCoordinates& before) {
  for (const auto& [owner, list] : {std::pair("vertexProperty", "vertex"), {"coord", "point"}}) {
    const InventorField* own = node.field(owner);
    if (!own || own->nodes.empty()) continue;
    return tree.nodes[static_cast<std::size_t>(own->nodes.front())].field(list);
  }
  return before.points;
}

int whole_number(int line, std::string_view name, double value) {
  // Also false for what is no number.
  const bool whole =
      std::abs(value) <= std::numeric_limits<int>::max() && value == std::floor(value);
  if (!whole) fail_in_line(line, "not a whole number", name);
  return static_cast<int>(value);
}

// Runs of indices, which end at -1.
Runs indexed_runs(const InventorNode& node, int points) {
  Runs runs;
  const InventorField* field = node.field("coordIndex");
  if (!field) return runs;
  bool open = false;
  for (const double value : numbers_of(*field)) {
    const int vertex = whole_number(field->line, field->name, value);
    if (vertex < -1 || vertex >= points) {
      fail_in_line(field->line, "a face refers to vertex " + std::to_string(vertex) + " of " +
                                    std::to_string(points));
    }
    if (vertex >= 0 && !open) runs.emplace_back();
    open = vertex >= 0;
    if (open) runs.back().push_back(vertex);
  }
  return runs;
}

// Runs of consecutive vertices; -1 stands for all that are left.
Runs counted_runs(const InventorNode& node, int points) {
  Runs runs;
  int next = whole_number(node.line, "startIndex", node.number("startIndex", 0.0));
  const InventorField* field = node.field("numVertices");
  const std::vector<double> all = {-1.0};
  for (const double value : field ? numbers_of(*field) : all) {
    int count = field ? whole_number(field->line, field->name, value) : -1;
    if (count == -1) count = points - next;
    if (next < 0 || count < 0 || count > points - next) {
      fail_in_line(field ? field->line : node.line,
                   "faces need more vertices than the " + std::to_string(points) + " there are");
    }
    std::vector<int>& run = runs.emplace_back();
    for (int k = 0; k < count; ++k) run.push_back(next++);
  }
  return runs;
}

// Whether the triangles between the first corner and the others all face the same way, as those of
// a convex polygon do.
bool is_fan(const TriangleMesh& mesh, std::span<const int> run) {
  const auto corner = [&](std::size_t k) { return mesh.vertices[index(run[k])]; };
  Vector3 sum = Vector3::Zero();
  const auto doubled = [&](std::size_t k) {
    return (corner(k) - corner(0)).cross(corner(k + 1) - corner(0));
  };
  for (std::size_t k = 1; k + 1 < run.size(); ++k) sum += doubled(k);
  for (std::size_t k = 1; k + 1 < run.size(); ++k) {
    if (doubled(k).dot(sum) < 0.0) return false;
  }
  return true;
}

// Corners that are not in one plane make another surface of each way to divide a face. Coin, which
// GraspIt! reads files with, divides convex faces into a fan.
void add_polygon(TriangleMesh& mesh, std::span<const int> run) {
  return is_fan(mesh, run) ? add_fan(mesh, run) : add_triangles(mesh, run);
}

void spend(const InventorNode& node, const Runs& runs, bool strips, InventorBudget& budget) {
  for (const std::vector<int>& run : runs) {
    const auto corners = static_cast<double>(run.size());
    if (!strips && corners > kMostInventorCorners) {
      fail_in_line(node.line, "a face of more than 10,000 corners");
    }
    budget.triangles -= std::max(0.0, corners - 2.0);
    if (!strips && corners > 4.0) budget.polygon_work -= corners * corners;
  }
  if (budget.triangles < 0.0 || budget.polygon_work < 0.0) {
    fail_in_line(node.line, "too many faces: nodes that are used again make millions of them");
  }
}

// Only the points that are used, so that many small shapes can share one large list.
TriangleMesh used_points(const InventorField& points, Runs& runs) {
  std::vector<int> used;
  for (const std::vector<int>& run : runs) used.insert(used.end(), run.begin(), run.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  TriangleMesh mesh;
  for (const int vertex : used) {
    const double* p = &points.numbers[3 * static_cast<std::size_t>(vertex)];
    const Vector3 point(p[0], p[1], p[2]);
    if (!(point.cwiseAbs().maxCoeff() <= std::numeric_limits<float>::max())) {
      fail_in_line(points.line, "vertex " + std::to_string(vertex) + " is not finite or too large");
    }
    mesh.vertices.push_back(point);
  }
  for (std::vector<int>& run : runs) {
    for (int& vertex : run) {
      vertex = static_cast<int>(std::lower_bound(used.begin(), used.end(), vertex) - used.begin());
    }
  }
  return mesh;
}

}  // namespace

std::optional<TriangleMesh> inventor_faces(const InventorTree& tree, const InventorNode& node,
                                           const InventorCoordinates& before,
                                           InventorBudget& budget) {
  const bool polygons = node.type == "FaceSet" || node.type == "IndexedFaceSet";
  const bool strips = node.type == "TriangleStripSet" || node.type == "IndexedTriangleStripSet";
  if (!polygons && !strips) return std::nullopt;
  const InventorField* points = points_of(tree, node, before);
  if (!points) return TriangleMesh{};
  if (numbers_of(*points).size() % 3 != 0) {
    fail_in_line(points->line, "points must have three numbers each", points->name);
  }
  const auto count = static_cast<int>(
      std::min<std::size_t>(points->numbers.size() / 3, std::numeric_limits<int>::max()));
  const bool indexed = node.type.starts_with("Indexed");
  Runs runs = indexed ? indexed_runs(node, count) : counted_runs(node, count);
  std::erase_if(runs, [](const std::vector<int>& run) { return run.size() < 3; });
  spend(node, runs, strips, budget);
  TriangleMesh mesh = used_points(*points, runs);
  for (const std::vector<int>& run : runs) {
    if (strips) {
      add_strip(mesh, run);
    } else {
      add_polygon(mesh, run);
    }
  }
  if (before.clockwise != !node.flag("ccw", true)) {
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

}  // namespace prehend
