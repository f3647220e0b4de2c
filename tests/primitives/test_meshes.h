// Meshes of known shape, moved and disturbed in a repeatable way.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "sim/base/random.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend::test {

// Every vertex moved by `distance` in a direction of its own.
inline TriangleMesh disturbed(TriangleMesh mesh, double distance, Random& random) {
  for (Vector3& p : mesh.vertices) p += distance * random.direction();
  return mesh;
}

inline TriangleMesh scaled(TriangleMesh mesh, double factor) {
  for (Vector3& p : mesh.vertices) p *= factor;
  return mesh;
}

inline TriangleMesh without_triangles_above(const TriangleMesh& mesh, double z) {
  TriangleMesh open{mesh.vertices, {}};
  for (const Triangle& t : mesh.triangles) {
    double lowest = mesh.vertices[static_cast<std::size_t>(t[0])].z();
    for (const int v : t) lowest = std::min(lowest, mesh.vertices[static_cast<std::size_t>(v)].z());
    if (lowest < z) open.triangles.push_back(t);
  }
  return open;
}

// Each triangle divided into four: the same surface.
inline TriangleMesh subdivided(const TriangleMesh& mesh) {
  TriangleMesh finer = mesh;
  finer.triangles.clear();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners corner = corners_of(mesh, static_cast<int>(t));
    const int first = static_cast<int>(finer.vertices.size());
    for (std::size_t k = 0; k < 3; ++k) {
      finer.vertices.push_back(0.5 * (corner[k] + corner[(k + 1) % 3]));
    }
    const Triangle& old = mesh.triangles[t];
    finer.triangles.push_back({old[0], first, first + 2});
    finer.triangles.push_back({old[1], first + 1, first});
    finer.triangles.push_back({old[2], first + 2, first + 1});
    finer.triangles.push_back({first, first + 1, first + 2});
  }
  return finer;
}

// `rings` x `sectors` around the z axis; triangles shrink towards the poles.
inline TriangleMesh uv_sphere(double radius, int rings, int sectors) {
  TriangleMesh mesh;
  for (int i = 0; i <= rings; ++i) {
    const double polar = std::numbers::pi * i / rings;
    for (int j = 0; j < sectors; ++j) {
      const double angle = 2.0 * std::numbers::pi * j / sectors;
      mesh.vertices.emplace_back(radius * std::sin(polar) * std::cos(angle),
                                 radius * std::sin(polar) * std::sin(angle),
                                 radius * std::cos(polar));
    }
  }
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sectors; ++j) {
      const int next = (j + 1) % sectors;
      const int a = i * sectors + j;
      const int b = i * sectors + next;
      mesh.triangles.push_back({a, a + sectors, b + sectors});
      mesh.triangles.push_back({a, b + sectors, b});
    }
  }
  return mesh;
}

inline TriangleMesh triangle_soup(int count, Random& random) {
  TriangleMesh soup;
  for (int i = 0; i < count; ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      soup.vertices.emplace_back(random.vector(0.0, 1.0));
    }
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return soup;
}

}  // namespace prehend::test
