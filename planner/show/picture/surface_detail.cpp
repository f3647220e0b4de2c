#include "planner/show/picture/surface_detail.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "sim/base/index.h"

namespace prehend {
namespace {

// For each vertex, the lowest index among the vertices with exactly the same coordinates. Files of
// loose triangles (STL) repeat each vertex for every triangle; without welding, each triangle would
// be shaded flat and all of its edges drawn as borders.
std::vector<int> welded_vertices(const std::vector<Vector3>& vertices) {
  std::vector<int> order(vertices.size());
  std::iota(order.begin(), order.end(), 0);
  const auto place = [&](int i) {
    const Vector3& p = vertices[index(i)];
    return std::make_tuple(p.x(), p.y(), p.z());
  };
  std::sort(order.begin(), order.end(), [&](int i, int j) {
    return std::tuple_cat(place(i), std::make_tuple(i)) <
           std::tuple_cat(place(j), std::make_tuple(j));
  });
  std::vector<int> first(vertices.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    // Sorted by place and then by index, so the first of equal places has the lowest index.
    const bool repeated = k > 0 && place(order[k]) == place(order[k - 1]);
    first[index(order[k])] = repeated ? first[index(order[k - 1])] : order[k];
  }
  return first;
}

// Unit normal; zero when the triangle is so thin that its normal is only rounding: its doubled area
// is compared with the square of its longest side, so that the test does not depend on its size.
Vector3 face_normal(const TriangleMesh& mesh, std::size_t t) {
  constexpr double kThin = 1e-12;
  const Triangle& v = mesh.triangles[t];
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 side = mesh.vertices[index(v[(k + 1) % 3])] - mesh.vertices[index(v[k])];
    longest = std::max(longest, side.squaredNorm());
  }
  const Vector3 doubled_area = doubled_area_vector(mesh, t);
  const double norm = doubled_area.norm();
  if (!(norm > kThin * longest) || !std::isfinite(norm)) return Vector3::Zero();
  return doubled_area / norm;
}

// Angle at corner k. atan2 is accurate for angles of all sizes, unlike the arc cosine near 0 and
// pi.
double corner_angle(const TriangleMesh& mesh, const Triangle& v, std::size_t k) {
  const Vector3& p = mesh.vertices[index(v[k])];
  const Vector3 a = mesh.vertices[index(v[(k + 1) % 3])] - p;
  const Vector3 b = mesh.vertices[index(v[(k + 2) % 3])] - p;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// One corner of one face, listed under its vertex.
struct Corner {
  int vertex = 0;  // welded
  int triangle = 0;
  double angle = 0.0;
};

// Normals to shade with (SurfaceDetail::corner_normals). Faces around a vertex are weighted by
// their angle there (Thuermer and Wuethrich 1998), so that the result does not depend on how a flat
// region is divided into triangles. Corners are sorted by vertex first; `start` then gives the
// range of corners of each vertex.
std::vector<std::array<Vector3, 3>> corner_normals(const TriangleMesh& mesh,
                                                   const std::vector<int>& weld,
                                                   const std::vector<Vector3>& face_normals,
                                                   double crease_angle) {
  std::vector<Corner> corners;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (face_normals[t].isZero(0.0)) continue;
    const Triangle& v = mesh.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      corners.push_back({weld[index(v[k])], static_cast<int>(t), corner_angle(mesh, v, k)});
    }
  }
  std::stable_sort(corners.begin(), corners.end(),
                   [](const Corner& a, const Corner& b) { return a.vertex < b.vertex; });
  std::vector<std::size_t> start(mesh.vertices.size() + 1, 0);
  for (const Corner& corner : corners) ++start[index(corner.vertex) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());

  // Only faces that meet this one at less than the crease angle are averaged. A corner of a box
  // thus keeps three normals, one for each face.
  const double least_cosine = std::cos(crease_angle);
  std::vector<std::array<Vector3, 3>> normals(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t vertex = index(weld[index(mesh.triangles[t][k])]);
      Vector3 sum = Vector3::Zero();
      for (std::size_t c = start[vertex]; c < start[vertex + 1]; ++c) {
        const Vector3& other = face_normals[index(corners[c].triangle)];
        if (other.dot(face_normals[t]) > least_cosine) sum += corners[c].angle * other;
      }
      normals[t][k] = sum.norm() > 0.0 ? Vector3(sum.normalized()) : face_normals[t];
    }
  }
  return normals;
}

// Edges with the triangles at them. Each side of a triangle is a half edge; after sorting, the half
// edges between the same two vertices are neighbours. Exactly two that run in opposite directions
// are a regular edge between two faces of the same orientation; everything else is treated as a
// border.
std::vector<SurfaceEdge> surface_edges(const TriangleMesh& mesh, const std::vector<int>& weld,
                                       const std::vector<Vector3>& face_normals) {
  struct HalfEdge {
    int low, high, triangle;
    bool rising;  // runs from `low` to `high`
  };
  std::vector<HalfEdge> half_edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (face_normals[t].isZero(0.0)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = weld[index(mesh.triangles[t][k])];
      const int b = weld[index(mesh.triangles[t][(k + 1) % 3])];
      half_edges.push_back({std::min(a, b), std::max(a, b), static_cast<int>(t), a < b});
    }
  }
  std::sort(half_edges.begin(), half_edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  std::vector<SurfaceEdge> edges;
  for (std::size_t i = 0; i < half_edges.size();) {
    std::size_t end = i + 1;
    const HalfEdge& first = half_edges[i];
    while (end < half_edges.size() && half_edges[end].low == first.low &&
           half_edges[end].high == first.high) {
      ++end;
    }
    const bool pair = end == i + 2 && half_edges[i + 1].rising != first.rising;
    edges.push_back(
        {first.low, first.high, first.triangle, pair ? half_edges[i + 1].triangle : -1});
    i = end;
  }
  return edges;
}

}  // namespace

SurfaceDetail surface_detail(const TriangleMesh& mesh, double crease_angle) {
  const std::vector<int> weld = welded_vertices(mesh.vertices);
  SurfaceDetail detail;
  detail.face_normals.resize(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    detail.face_normals[t] = face_normal(mesh, t);
  }
  detail.corner_normals = corner_normals(mesh, weld, detail.face_normals, crease_angle);
  detail.edges = surface_edges(mesh, weld, detail.face_normals);
  return detail;
}

}  // namespace prehend
