#include "planner/live/edited_scene.h"

#include <utility>

#include "sim/base/input_error.h"

namespace prehend {

EditedScene::EditedScene(Scene scene, const RunContext& context) : surfaces_(surface_ids(scene)) {
  compile_draft(std::move(scene), context);
}

EditedScene::EditedScene(std::shared_ptr<const EditedScene> base, const BodyPlaces& places)
    : base_(std::move(base)), surfaces_(base_->surfaces()) {
  if (base_->is_ready()) {
    try {
      compiled_ =
          std::make_shared<const CompiledScene>(prehend::with_bodies_at(base_->compiled(), places));
      return;
    } catch (const InputError& error) {
      problem_ = error.what();
    }
  }
  Scene scene = base_->scene();
  set_places(scene, places);
  if (base_->is_ready()) {
    draft_ = std::move(scene);
  } else {
    compile_draft(std::move(scene), {});
  }
}

void EditedScene::compile_draft(Scene scene, const RunContext& context) {
  if (scene.object.mesh.empty()) {
    problem_ = "there is no object";
    draft_ = std::move(scene);
    return;
  }
  // compile() takes the scene; a draft is needed only where it throws.
  try {
    compiled_ = std::make_shared<const CompiledScene>(compile(scene, context));
  } catch (const InputError& error) {
    problem_ = error.what();
    draft_ = std::move(scene);
  }
}

const CompiledScene& EditedScene::compiled() const {
  require(is_ready(), {.field = "scene", .problem = problem_});
  return *compiled_;
}

const CompiledScene* EditedScene::parts() const {
  if (compiled_) return compiled_.get();
  return base_ ? base_->compiled_.get() : nullptr;
}

EditedScenePtr with_bodies_at(const EditedScenePtr& world, const BodyPlaces& places) {
  return std::make_shared<const EditedScene>(world->base() ? world->base() : world, places);
}

}  // namespace prehend
