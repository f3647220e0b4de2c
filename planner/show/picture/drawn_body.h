// What a picture is made of: meshes with a place and a colour.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "planner/show/picture/color.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// A handle to a mesh that does not change. Copies of it are the same mesh, so that a body can be
// drawn in many places and pictures without its triangles being copied.
class SharedMesh {
 public:
  SharedMesh() : SharedMesh(TriangleMesh{}) {}

  // Keeps the mesh itself. Implicit, so that a mesh can be written where a body wants one.
  SharedMesh(TriangleMesh mesh)  // NOLINT(google-explicit-constructor)
      : mesh_(std::make_shared<const TriangleMesh>(std::move(mesh))) {}

  // Only refers to the mesh, which must outlive the handle and all its copies.
  static SharedMesh borrowed(const TriangleMesh& mesh) {
    return SharedMesh(std::shared_ptr<const TriangleMesh>(std::shared_ptr<void>(), &mesh));
  }

  const TriangleMesh& operator*() const { return *mesh_; }
  const TriangleMesh* operator->() const { return mesh_.get(); }

 private:
  explicit SharedMesh(std::shared_ptr<const TriangleMesh> mesh) : mesh_(std::move(mesh)) {}

  std::shared_ptr<const TriangleMesh> mesh_;
};

// Both sides of a surface are drawn, so that a mesh need not be closed. The back of a translucent
// surface is half as opaque as its front, and a translucent surface is denser where it is seen at
// an angle, as a thin shell is: its opacity is that of its color where it faces the viewer.
struct DrawnBody {
  SharedMesh mesh = {};
  Pose X_WB = Pose::Identity();
  Color color = {};
  std::string name = {};  // for files that name bodies; not drawn
};

}  // namespace prehend
