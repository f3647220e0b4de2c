#include "planner/session/edited_scene.h"

#include <utility>

#include "sim/base/input_error.h"

namespace prehend {

EditedScene::EditedScene(Scene scene, const RunContext& context) : surfaces_(surface_ids(scene)) {
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

}  // namespace prehend
