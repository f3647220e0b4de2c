// Mistakes that poses of hands are often written with: another frame, another unit.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/scene/compiled_scene.h"

namespace prehend {

// A constant change of all poses, which puts one such mistake right.
struct FrameGuess {
  std::string words;     // "with the hand 103 mm farther back along its approach axis"
  std::string question;  // "are the poses those of the point between the fingertips?"
  // The pose as it would have to be, from the pose as it is given.
  std::function<Pose(const Pose& X_OH, const CompiledScene& scene)> corrected;
  bool is_step = false;  // one of a row of moves, none of which means anything by itself
};

// The likeliest first: the hand moved along its approach by lengths of its own, turned about it,
// units of positions, origins of the object, poses that are inverse, then moves of the hand by
// multiples of 10 mm up to 250 mm, and frames of hand or object with other axes.
std::vector<FrameGuess> frame_guesses(const Hand& hand);

}  // namespace prehend
