// A scene that is being edited, together with what is made of it for trials.
#pragma once

#include <memory>
#include <string>

#include "planner/live/surface_ids.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {

// Immutable and shared: states of a session that differ in other things refer to the same one.
class EditedScene {
 public:
  // Never throws InputError for a scene that cannot be compiled, since editing passes through such
  // scenes (no object yet, an obstacle inside it): problem() says what is wrong. A scene without
  // an object has an empty mesh there. Throws Cancelled.
  explicit EditedScene(Scene scene, const RunContext& context = {});
  // The scene of `base`, which is none of these itself, with its bodies at other places. A function
  // of the two alone: base and places are all that has to be kept of such a scene.
  EditedScene(std::shared_ptr<const EditedScene> base, const BodyPlaces& places);

  const Scene& scene() const { return compiled_ ? compiled_->scene : draft_; }
  bool has_object() const { return !scene().object.mesh.empty(); }
  bool is_ready() const { return compiled_ != nullptr; }
  // Why the scene cannot be used for grasps; empty where it can.
  const std::string& problem() const { return problem_; }
  // Throws InputError of the field "scene" with the problem where the world is not ready.
  const CompiledScene& compiled() const;
  // The same to share; null where the world is not ready.
  const std::shared_ptr<const CompiledScene>& shared() const { return compiled_; }
  const SurfaceIds& surfaces() const { return surfaces_; }
  // A compiled scene of the same bodies and robots, which may stand elsewhere than here; null where
  // there is none. There is one where bodies were only moved into what makes a scene unusable.
  const CompiledScene* parts() const;
  // The scene that this one has the bodies of at other places; null where it was made otherwise.
  const std::shared_ptr<const EditedScene>& base() const { return base_; }
  // X_WO, the identity without an object.
  const Pose& X_WO() const { return scene().object.X_WO; }

 private:
  void compile_draft(Scene scene, const RunContext& context);

  std::shared_ptr<const EditedScene> base_;
  std::shared_ptr<const CompiledScene> compiled_;
  SurfaceIds surfaces_;
  Scene draft_;  // where there is no compiled scene, which has the scene in it
  std::string problem_;
};

using EditedScenePtr = std::shared_ptr<const EditedScene>;

// The scene with its bodies at other places, made from its base where it has one.
EditedScenePtr with_bodies_at(const EditedScenePtr& world, const BodyPlaces& places);

}  // namespace prehend
