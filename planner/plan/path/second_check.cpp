#include "planner/plan/path/second_check.h"

#include "planner/plan/path/fcl_mesh.h"
#include "sim/base/index.h"
#include "sim/scene/compiled_arm.h"

namespace prehend {

struct SecondCheck::Models {
  std::vector<FclMesh> links;
  std::vector<FclMesh> bodies;  // the object is the first
};

SecondCheck::SecondCheck(const CompiledArm& arm) : arm_(arm) {}

const SecondCheck::Models& SecondCheck::models() const {
  std::call_once(is_built_, [this] {
    auto models = std::make_unique<Models>();
    for (const CompiledLink& link : arm_.links) models->links.emplace_back(link.mesh.mesh());
    for (const PlacedBody& body : arm_.bodies) models->bodies.emplace_back(body.mesh.mesh());
    models_ = std::move(models);
  });
  return *models_;
}

SecondCheck::~SecondCheck() = default;

const FclMesh& SecondCheck::link(LinkId link) const { return models().links[index(link)]; }

const FclMesh& SecondCheck::body(BodyId body) const { return models().bodies[index(body)]; }

}  // namespace prehend
