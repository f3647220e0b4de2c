// Notes of the readers of robots, for people.
#pragma once

#include "sim/scene/scene.h"

namespace prehend {

// Prints what the reader of the robot's file assumed, left out or repaired to stderr, one line
// "note: ..." each.
void print_notes(const Robot& robot);
// The same of the scene's own file, of its hand and of what carries it.
void print_notes(const Scene& scene);

}  // namespace prehend
