#include "planner/plan/path/second_check.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>

#include "sim/base/index.h"
#include "sim/scene/compiled_arm.h"

namespace prehend {
namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

// Thresholds of FCL are absolute; in metres they would be large against small triangles.
constexpr double kMillimetres = 1000.0;

std::unique_ptr<const Model> model_of(const TriangleMesh& mesh) {
  auto model = std::make_unique<Model>();
  std::vector<fcl::Vector3d> vertices;
  for (const Vector3& v : mesh.vertices) vertices.emplace_back(kMillimetres * v);
  std::vector<fcl::Triangle> triangles;
  for (const Triangle& t : mesh.triangles) {
    triangles.emplace_back(index(t[0]), index(t[1]), index(t[2]));
  }
  model->beginModel();
  model->addSubModel(vertices, triangles);
  model->endModel();
  model->computeLocalAABB();
  return model;
}

fcl::Transform3d in_millimetres(Pose X) {
  X.translation() *= kMillimetres;
  return X;
}

bool cross(const Model& a, const Pose& X_BA, const Model& c, const Pose& X_BC) {
  const fcl::CollisionRequestd request(1);
  fcl::CollisionResultd result;
  return fcl::collide(&a, in_millimetres(X_BA), &c, in_millimetres(X_BC), request, result) > 0;
}

}  // namespace

struct SecondCheck::Models {
  std::vector<std::unique_ptr<const Model>> links;
  std::vector<std::unique_ptr<const Model>> bodies;  // the object is the first
};

SecondCheck::SecondCheck(const CompiledArm& arm) : arm_(arm) {}

const SecondCheck::Models& SecondCheck::models() const {
  std::call_once(is_built_, [this] {
    auto models = std::make_unique<Models>();
    for (const CompiledLink& link : arm_.links) models->links.push_back(model_of(link.mesh.mesh()));
    for (const PlacedBody& body : arm_.bodies) models->bodies.push_back(model_of(body.mesh.mesh()));
    models_ = std::move(models);
  });
  return *models_;
}

SecondCheck::~SecondCheck() = default;

bool SecondCheck::links_cross(LinkId a, const Pose& X_BA, LinkId c, const Pose& X_BC) const {
  return cross(*models().links[index(a)], X_BA, *models().links[index(c)], X_BC);
}

bool SecondCheck::body_crosses(BodyId a, const Pose& X_BA, LinkId c, const Pose& X_BC) const {
  return cross(*models().bodies[index(a)], X_BA, *models().links[index(c)], X_BC);
}

bool SecondCheck::object_crosses(const Pose& X_BO, LinkId c, const Pose& X_BC) const {
  return cross(*models().bodies.front(), X_BO, *models().links[index(c)], X_BC);
}

bool SecondCheck::object_crosses(const Pose& X_BO, BodyId c, const Pose& X_BC) const {
  return cross(*models().bodies.front(), X_BO, *models().bodies[index(c)], X_BC);
}

}  // namespace prehend
