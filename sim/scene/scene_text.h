// A scene as the text of a scene file (docs/reference/scene-file.md).
#pragma once

#include <string>

#include "sim/scene/scene.h"

namespace prehend {

// Reads back as the same scene: bodies as their file said them, those without a source triangle by
// triangle; names that are not UTF-8 as U+FFFD. Throws InputError for a hand or platform without a
// source, which no file could name.
std::string scene_text(const Scene& scene);

}  // namespace prehend
