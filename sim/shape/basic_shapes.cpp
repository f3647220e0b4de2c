#include "sim/shape/basic_shapes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <string>

#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/range.h"
#include "sim/shape/polygon.h"
#include "sim/shape/weld.h"

namespace prehend {
namespace {

void need_positive(const char* name, double value) {
  // Twice what a vertex may be away from the middle.
  require(value > 0.0 && value <= 2.0 * kFarthest, {.field = name,
                                                    .problem = "must be above 0 and at most 2e6 m",
                                                    .value = formatted("%g", value)});
}

void need_range(const char* name, int value, int lowest, int highest) {
  require(value >= lowest && value <= highest,
          {.field = name,
           .problem = "must be " + std::to_string(lowest) + " to " + std::to_string(highest),
           .value = std::to_string(value)});
}

// Two triangles for the quadrilateral a b c d, counter-clockwise seen from outside.
void add_quad(TriangleMesh& mesh, int a, int b, int c, int d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

// Vertices of a box by their integer lattice coordinates. Each is made once, so that the six faces
// share the vertices of their common edges.
class LatticePoints {
 public:
  LatticePoints(TriangleMesh& mesh, const Vector3& size, const std::array<int, 3>& cells)
      : mesh_(mesh), size_(size), cells_(cells) {}

  int operator()(const std::array<int, 3>& at) {
    const auto [place, fresh] = index_.try_emplace(at, static_cast<int>(mesh_.vertices.size()));
    if (fresh) {
      Vector3 p;
      for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Index axis = static_cast<Eigen::Index>(k);
        p[axis] = size_[axis] * (static_cast<double>(at[k]) / cells_[k] - 0.5);
      }
      mesh_.vertices.push_back(p);
    }
    return place->second;
  }

 private:
  TriangleMesh& mesh_;
  Vector3 size_;
  std::array<int, 3> cells_;
  std::map<std::array<int, 3>, int> index_;
};

// Twelve vertices: the corners of three perpendicular golden rectangles.
TriangleMesh icosahedron() {
  const double g = std::numbers::phi;
  TriangleMesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  return mesh;
}

}  // namespace

TriangleMesh make_box_grid(const Vector3& size, const std::array<int, 3>& cells) {
  for (Eigen::Index k = 0; k < 3; ++k) need_positive("box size", size[k]);
  for (int n : cells) need_range("box cells", n, 1, 10000);
  TriangleMesh mesh;
  LatticePoints point(mesh, size, cells);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    for (const bool top : {false, true}) {
      const auto corner = [&](int i, int j) {
        std::array<int, 3> at{};
        at[axis] = top ? cells[axis] : 0;
        at[u] = i;
        at[v] = j;
        return point(at);
      };
      for (int i = 0; i < cells[u]; ++i) {
        for (int j = 0; j < cells[v]; ++j) {
          // (axis, u, v) is right-handed, so that u before v is counter-clockwise seen from +axis;
          // the face on the other side is wound the other way.
          const int a = corner(i, j);
          const int b = top ? corner(i + 1, j) : corner(i, j + 1);
          const int c = corner(i + 1, j + 1);
          const int d = top ? corner(i, j + 1) : corner(i + 1, j);
          add_quad(mesh, a, b, c, d);
        }
      }
    }
  }
  return mesh;
}

TriangleMesh make_box(const Vector3& size, int cells_per_edge) {
  return make_box_grid(size, {cells_per_edge, cells_per_edge, cells_per_edge});
}

// Vertices: rings + 1 rings of `sides` vertices each, from the bottom up, then the centres of the
// two ends. Every side of a ring carries a column of quadrilaterals and a triangle of each end's
// fan.
TriangleMesh make_cylinder(double radius, double height, int sides, int rings) {
  need_positive("cylinder radius", radius);
  need_positive("cylinder height", height);
  need_range("cylinder sides", sides, 3, 100000);
  need_range("cylinder rings", rings, 1, 100000);
  TriangleMesh mesh;
  for (int i = 0; i <= rings; ++i) {
    const double z = height * (static_cast<double>(i) / rings - 0.5);
    for (int j = 0; j < sides; ++j) {
      const double angle = 2.0 * std::numbers::pi * j / sides;
      mesh.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    }
  }
  const int bottom = static_cast<int>(mesh.vertices.size());
  mesh.vertices.push_back({0.0, 0.0, -0.5 * height});
  mesh.vertices.push_back({0.0, 0.0, 0.5 * height});
  for (int j = 0; j < sides; ++j) {
    const int k = (j + 1) % sides;
    for (int i = 0; i < rings; ++i) {
      const int low = i * sides;
      add_quad(mesh, low + j, low + k, low + sides + k, low + sides + j);
    }
    mesh.triangles.push_back({bottom, k, j});
    mesh.triangles.push_back({bottom + 1, rings * sides + j, rings * sides + k});
  }
  return mesh;
}

// Each triangle of an icosahedron is divided into frequency^2 triangles by lines parallel to its
// sides, and all vertices are projected onto the sphere.
TriangleMesh make_geodesic_sphere(double radius, int frequency) {
  need_positive("sphere radius", radius);
  need_range("sphere frequency", frequency, 1, 2000);
  const TriangleMesh base = icosahedron();
  TriangleMesh mesh;
  // A point on a triangle of the icosahedron is identified by its integer barycentric coordinates,
  // as pairs of vertex and weight without zero weights. A point on an edge then has the same key in
  // both triangles, and the mesh is closed without welding.
  std::map<std::array<int, 6>, int> index;
  const auto point = [&](const Triangle& t, std::array<int, 3> weight) {
    std::map<int, int> weight_at;
    for (std::size_t k = 0; k < 3; ++k) {
      if (weight[k] > 0) weight_at[t[k]] = weight[k];
    }
    std::array<int, 6> key{-1, 0, -1, 0, -1, 0};
    std::size_t slot = 0;
    Vector3 p = Vector3::Zero();
    for (const auto& [vertex, w] : weight_at) {
      key[slot++] = vertex;
      key[slot++] = w;
      p += w * base.vertices[static_cast<std::size_t>(vertex)];
    }
    const auto [place, fresh] = index.try_emplace(key, static_cast<int>(mesh.vertices.size()));
    if (fresh) mesh.vertices.push_back(radius * p.normalized());
    return place->second;
  };
  // Six small triangles share a point: it is looked up once.
  const int row = frequency + 1;
  std::vector<int> known(static_cast<std::size_t>(row) * static_cast<std::size_t>(row));
  for (const Triangle& t : base.triangles) {
    std::fill(known.begin(), known.end(), -1);
    const auto at = [&](int i, int j) {
      int& vertex = known[static_cast<std::size_t>(i * row + j)];
      if (vertex < 0) vertex = point(t, {frequency - i - j, i, j});
      return vertex;
    };
    for (int i = 0; i < frequency; ++i) {
      for (int j = 0; i + j < frequency; ++j) {
        const int a = at(i, j);
        const int b = at(i + 1, j);
        const int c = at(i, j + 1);
        mesh.triangles.push_back({a, b, c});
        // The triangle that points the other way, where there is room for one.
        if (i + j + 2 <= frequency) mesh.triangles.push_back({b, at(i + 1, j + 1), c});
      }
    }
  }
  return mesh;
}

// To divide each triangle in four, s times, is to divide each edge in 2^s.
TriangleMesh make_sphere(double radius, int subdivisions) {
  need_range("sphere subdivisions", subdivisions, 0, 8);
  return make_geodesic_sphere(radius, 1 << subdivisions);
}

// Vertices: the polygon at the lower end, then, shifted by n, at the upper end. The triangles of
// the lower end are turned over to face down.
TriangleMesh make_prism(const std::vector<Eigen::Vector2d>& polygon, double lower, double upper) {
  need_positive("prism height", upper - lower);
  const std::vector<Triangle> caps = triangulate_polygon(polygon);
  if (caps.empty()) {
    throw InputError({.field = "prism polygon",
                      .problem = "must be simple, counter-clockwise and of positive area",
                      .value = std::to_string(polygon.size()) + " corners"});
  }
  TriangleMesh mesh;
  const int n = static_cast<int>(polygon.size());
  for (const double z : {lower, upper}) {
    for (const Eigen::Vector2d& p : polygon) mesh.vertices.push_back({p.x(), p.y(), z});
  }
  for (const Triangle& t : caps) {
    mesh.triangles.push_back({t[2], t[1], t[0]});
    mesh.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  }
  for (int j = 0; j < n; ++j) {
    const int k = (j + 1) % n;
    add_quad(mesh, j, k, k + n, j + n);
  }
  return mesh;
}

}  // namespace prehend
