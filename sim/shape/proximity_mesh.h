// A triangle mesh made ready for distance queries (proximity.h).
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

class ConvexPoints;     // separation.h
struct PlacedTriangle;  // triangle_distance.h
struct SmoothSurface;   // smooth_surface.h

// A triangle mesh prepared for distance queries: with a bounding-volume hierarchy and other search
// structures. Immutable, so threads may share it; copies share their data and are cheap.
class ProximityMesh {
 public:
  // Builds the search structures. Throws InputError for a mesh without triangles, and Cancelled.
  explicit ProximityMesh(TriangleMesh mesh, const RunContext& context = {});

  // The mesh, unchanged.
  const TriangleMesh& mesh() const;
  // Its triangles with their normals, in its frame.
  const std::vector<PlacedTriangle>& triangles() const;
  // Indices of the triangles that use vertex `v`, ascending.
  std::span<const int> triangles_at(int v) const;
  // Centre (mesh frame) and radius [m] of a sphere that contains all vertices: a bounding sphere,
  // not the smallest one.
  const Vector3& ball_center() const;
  double ball_radius() const;
  // Convex sets whose union contains the surface (convex_parts.h), for quick separation tests.
  const std::vector<ConvexPoints>& parts() const;

  // The smooth surface that the mesh stands for (smooth_surface.h), made when it is first
  // asked for.
  const SmoothSurface& smooth() const;

  // Bytes of the mesh and of all search structures, those that are made later among them. Copies
  // share them.
  std::size_t memory() const;

  // Internal data, for the functions of this folder.
  struct Data;
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

}  // namespace prehend
