// Whether the poses of executed grasps are in the frames that their file says, without a look at
// what became of them.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "planner/show/validation/executed_grasps_file.h"
#include "planner/show/validation/open_hand.h"

namespace prehend {

// A change of all poses after which many more of them make sense.
struct FrameSuspicion {
  std::string words;     // as in FrameGuess
  std::string question;  // as in FrameGuess
  int between = 0;       // grasps with the object between the fingers then
};

struct FrameCheck {
  int grasps = 0;
  std::array<int, kAll<ObjectPlace>.size()> places{};  // of so many of them the object is there
  int in_obstacles = 0;                                // hands that cross an obstacle
  std::optional<FrameSuspicion> suspicion;

  int between() const { return places[static_cast<std::size_t>(ObjectPlace::between)]; }
};

// Looks at all grasps with the hand open, as they are given and after each of frame_guesses. What
// is suspected has the object between the fingers of at least a fifth of the grasps more than as
// given (and of four at least), and leaves half as many without it or has twice as many with it. Of
// guesses that are as good up to a fortieth of the grasps the likeliest is named; a mere step of
// the hand only where it is better than all others by a tenth of the grasps. The same on any number
// of threads. Throws Cancelled.
FrameCheck check_frames(const ExecutedGrasps& truth, const RunContext& context = {});

// The check as a sentence.
std::string frame_text(const FrameCheck& check);

}  // namespace prehend
