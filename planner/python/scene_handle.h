// Scenes as Python holds them: with what a grasp file says of where they came from.
#pragma once

#include <memory>
#include <string>

#include "sim/scene/compiled_scene.h"

namespace prehend::python {

// As in a grasp file (RunRecord). A scene that was made in code is no file that could be named.
struct SceneOrigin {
  std::string file;  // name of a library scene or absolute path; empty: made in code
  std::string unit = "m";
  std::string hand;  // as asked; empty: the scene's own
  bool repair = true;
  ObjectChoice choice = {};
};

struct SceneHandle {
  Scene scene;
  SceneOrigin origin;
};

// Immutable, so that results can share it.
struct CompiledHandle {
  std::shared_ptr<const CompiledScene> scene;
  SceneOrigin origin;
};

}  // namespace prehend::python
