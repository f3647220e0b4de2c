// Notes of the readers of robots and objects, for people.
#pragma once

#include "sim/scene/scene.h"

namespace prehend {

// Prints what the reader of the robot's file assumed, left out or repaired to stderr, one line
// "note: ..." each.
void print_notes(const Robot& robot);
// The same of the scene's hand and of what carries it; what was assumed about the scene and its
// object, left out or repaired is a line "warning: ..." each.
void print_notes(const Scene& scene);

}  // namespace prehend
