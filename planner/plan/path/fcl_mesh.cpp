#include "planner/plan/path/fcl_mesh.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>

#include "sim/base/index.h"

namespace prehend {
namespace {

// Thresholds of FCL are absolute; in metres they would be large against small triangles.
constexpr double kMillimetres = 1000.0;

// By how much more than FCL says a ball contains its mesh, against rounding [m].
constexpr double kBallSlack = 1e-9;

fcl::Transform3d in_millimetres(Pose X) {
  X.translation() *= kMillimetres;
  return X;
}

}  // namespace

struct FclMesh::Model {
  fcl::BVHModel<fcl::OBBRSSd> tree;
};

FclMesh::FclMesh(const TriangleMesh& mesh) {
  auto model = std::make_unique<Model>();
  std::vector<fcl::Vector3d> vertices;
  for (const Vector3& v : mesh.vertices) vertices.emplace_back(kMillimetres * v);
  std::vector<fcl::Triangle> triangles;
  for (const Triangle& t : mesh.triangles) {
    triangles.emplace_back(index(t[0]), index(t[1]), index(t[2]));
  }
  model->tree.beginModel();
  model->tree.addSubModel(vertices, triangles);
  model->tree.endModel();
  model->tree.computeLocalAABB();
  model_ = std::move(model);
}

FclMesh::~FclMesh() = default;
FclMesh::FclMesh(FclMesh&&) noexcept = default;

Vector3 FclMesh::centre() const { return model_->tree.aabb_center / kMillimetres; }

double FclMesh::radius() const { return model_->tree.aabb_radius / kMillimetres + kBallSlack; }

bool FclMesh::crosses(const Pose& X_WA, const FclMesh& other, const Pose& X_WB) const {
  const fcl::CollisionRequestd request(1);
  fcl::CollisionResultd result;
  return fcl::collide(&model_->tree, in_millimetres(X_WA), &other.model_->tree,
                      in_millimetres(X_WB), request, result) > 0;
}

}  // namespace prehend
