// A mesh as another engine sees it: FCL (Pan, Chitta and Manocha 2012, "FCL: A general purpose
// library for collision and proximity queries"). The only files that include it are these two.
// Nothing of our own trees and distances is used, so that an error in them shows.
#pragma once

#include <memory>

#include "sim/base/pose.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// A tree of boxes about the triangles, with spheres about segments in it (OBBRSS).
class FclMesh {
 public:
  explicit FclMesh(const TriangleMesh& mesh);
  ~FclMesh();
  FclMesh(FclMesh&&) noexcept;
  FclMesh& operator=(FclMesh&&) = delete;

  // A ball that contains the mesh: its centre in the frame of the mesh, and its radius [m].
  Vector3 centre() const;
  double radius() const;

  // Whether the surfaces of two meshes cross, whose poses are given in one frame. A mesh wholly
  // inside another crosses it nowhere.
  bool crosses(const Pose& X_WA, const FclMesh& other, const Pose& X_WB) const;

 private:
  struct Model;
  std::unique_ptr<const Model> model_;
};

}  // namespace prehend
