#include "planner/bulk/part_worker.h"

#include <algorithm>
#include <utility>

#include "planner/bulk/content_key.h"
#include "planner/bulk/object_in_scene.h"
#include "planner/plan/learn/grasp_features.h"
#include "planner/plan/object_primitives.h"
#include "planner/plan/search_grasps.h"
#include "sim/scene/named_mass.h"
#include "sim/scene/object_friction.h"
#include "sim/scene/object_mass.h"
#include "sim/scene/object_mesh.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/object_generator.h"

namespace prehend {
namespace {

GraspableBody grasped_object(const Batch& batch, const BatchPart& part, TriangleMesh mesh,
                             const std::vector<MeshPart>& named) {
  const BatchObject& source = batch.objects[part.object];
  const double scale = batch.scales[part.scale];
  for (Vector3& vertex : mesh.vertices) vertex *= scale;
  GraspableBody object = make_graspable(source.name, std::move(mesh), batch.material);
  std::vector<std::string> notes;
  if (batch.density) {
    state_mass(object, {.density = batch.density});
  } else {
    spread_named_mass(object, scaled(named, scale), {}, notes);
  }
  return object;
}

// The coefficient of the object with every material, whether it sticks or slides.
void set_friction(Scene& scene, double friction) {
  set_object_friction(scene, friction);
  for (const Material other : kAll<Material>) {
    scene.kinetic_friction.set(scene.object.material, other, std::nullopt);
  }
}

// Of the materials of the hand's links, the one that holds best.
double largest_friction(const CompiledScene& scene) {
  double largest = 0.0;
  for (const CompiledLink& link : scene.links) largest = std::max(largest, link.friction);
  return largest;
}

GraspSetObject object_of(const CompiledScene& scene, const Batch& batch, const BatchPart& part,
                         const std::string& unit) {
  const GraspableBody& body = scene.scene.object;
  GraspSetObject object;
  object.file = batch.objects[part.object].file;
  object.scale = metres_per_unit(unit) * batch.scales[part.scale];
  object.friction = batch.frictions[part.friction].value_or(largest_friction(scene));
  object.mass = body.mass;
  object.volume = mass_properties(body.mesh).volume;
  object.density = object.volume > 0.0 ? body.mass / object.volume : 0.0;
  object.com_O = body.center_of_mass;
  object.inertia = body.inertia;
  return object;
}

ObjectShift closing_motion(const Trial& trial) {
  if (!trial.X_OC) return {trial.pushed.norm() + trial.slid, trial.turned};
  return {trial.X_OC->translation().norm(), Eigen::AngleAxisd(trial.X_OC->linear()).angle()};
}

GraspSetEntry entry_of(const Candidate& candidate, const Trial& trial) {
  GraspSetEntry entry;
  entry.X_OH = trial.X_OH;
  entry.X_OH_aim = candidate.X_OH;
  entry.approach_O = candidate.approach_O;
  entry.outcome = trial.outcome;
  if (trial.outcome == Outcome::stable) {
    entry.epsilon = {trial.epsilon.lower, trial.epsilon.upper};
  }
  entry.dofs = trial.dofs;
  entry.joints = trial.joints;
  for (const GraspContact& contact : trial.contacts) {
    entry.contacts.push_back(
        {contact.point.position, contact.point.normal, static_cast<int>(index(contact.link))});
  }
  if (!trial.contacts.empty()) entry.closing = closing_motion(trial);
  return entry;
}

// Of a hand with one degree of freedom, its value in the widest preshape.
std::optional<double> opening_of(const Robot& hand) {
  if (hand.dofs.size() != 1 || !hand.hand || hand.hand->preshapes.empty()) return std::nullopt;
  const auto widest = std::max_element(
      hand.hand->preshapes.begin(), hand.hand->preshapes.end(),
      [](const Preshape& a, const Preshape& b) { return a.max_width < b.max_width; });
  return widest->dofs.front();
}

void describe_hand(const Robot& hand, GraspSet& set) {
  set.hand = hand.name;
  set.configuration = opening_of(hand);
  for (const DegreeOfFreedom& dof : hand.dofs) set.dofs.push_back(dof.name);
  for (const Joint& joint : hand.joints) set.joints.push_back(joint.name);
  for (const Link& link : hand.links) set.links.push_back(link.name);
}

}  // namespace

std::string PartWorker::key(const Batch& batch, const BatchInputs& inputs, const BatchPart& part) {
  if (!key_ || key_->object != part.object) {
    const BatchObject& object = batch.objects[part.object];
    const auto* file = std::get_if<MeshFileSource>(&object.source);
    const auto* generated = std::get_if<GeneratedSource>(&object.source);
    key_ = Key{part.object, file != nullptr
                                ? mesh_file_key(file->path)
                                : generated->name + " " + std::to_string(generated->triangles)};
  }
  return part_key(batch, inputs, part, key_->key);
}

const PartWorker::Mesh& PartWorker::mesh(const BatchObject& object, std::size_t number) {
  if (mesh_ && mesh_->object == number) return *mesh_;
  mesh_.reset();
  primitives_.reset();
  if (const auto* file = std::get_if<MeshFileSource>(&object.source)) {
    ObjectMesh read = load_object_mesh(file->path, {file->unit, file->repair});
    mesh_ = Mesh{number, std::move(read.mesh), read.unit, std::move(read.parts)};
  } else {
    const auto& generated = std::get<GeneratedSource>(object.source);
    mesh_ = Mesh{number, generate_object(generated.name, generated.triangles), "m"};
  }
  return *mesh_;
}

const std::vector<Primitive>& PartWorker::primitives(const CompiledScene& scene,
                                                     const PlanOptions& options,
                                                     const BatchPart& part,
                                                     const RunContext& context) {
  if (!primitives_ || primitives_->object != part.object || primitives_->scale != part.scale) {
    primitives_ = Primitives{part.object, part.scale, {}};
  }
  const std::pair which{part.setting, part.seed};
  const auto known = primitives_->of.find(which);
  if (known != primitives_->of.end()) return known->second;
  return primitives_->of
      .emplace(which, object_primitives(scene, options.primitives, options.thin_parts, context).all)
      .first->second;
}

Scene PartWorker::scene(const Batch& batch, const BatchInputs& inputs, const BatchPart& part) {
  const Mesh& surface = mesh(batch.objects[part.object], part.object);
  GraspableBody object = grasped_object(batch, part, surface.mesh, surface.parts);
  Scene scene = inputs.scene_of(part).scene;
  if (batch.scenes[part.scene].scene.empty()) {
    scene.object = std::move(object);
  } else {
    replace_object(scene, std::move(object));
  }
  if (batch.frictions[part.friction]) set_friction(scene, *batch.frictions[part.friction]);
  return scene;
}

GraspSet PartWorker::run(const Batch& batch, const BatchInputs& inputs, const BatchPart& part,
                         const RunContext& context) {
  const PlanOptions& options = inputs.options_of(part);
  const CompiledScene compiled = compile(scene(batch, inputs, part), context);
  const std::vector<Primitive>& made_from = primitives(compiled, options, part, context);
  const SearchResult found = search_grasps(compiled, made_from, options.candidates, options.search,
                                           options.trial, context);
  context.cancellation.check();
  GraspSet set;
  set.object = object_of(compiled, batch, part, mesh_->unit);
  describe_hand(compiled.scene.hand, set);
  set.version = "prehend " PREHEND_VERSION;
  set.settings = inputs.settings_of(part);
  set.feature_names = grasp_feature_names();
  const FeatureMaker features(compiled, made_from);
  for (std::size_t i = 0; i < found.trials.size(); ++i) {
    const ProposedGrasp& proposed = found.proposed[found.candidates[i]];
    set.grasps.push_back(entry_of(proposed.candidate, found.trials[i]));
    const GraspFeatures values = features.features(proposed);
    set.grasps.back().features.assign(values.begin(), values.end());
  }
  return set;
}

}  // namespace prehend
