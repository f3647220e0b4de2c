// Independent check of a finished, timed path: collisions along it, and joint limits.
#pragma once

#include <cstddef>
#include <string>

#include "sim/base/run_context.h"
#include "sim/base/settings.h"

namespace prehend {

class SecondCheck;  // second_check.h
struct CompiledScene;
struct Trajectory;

// What check_path measured along a path.
struct PathCheck {
  int postures = 0;             // number of postures that were tested for collision
  int collisions = 0;           // how many of these postures are in collision
  std::string first_collision;  // "LINK meets BODY at TIME s"; empty without a collision
  // Largest ratio of value to limit over all joints, on the cubics between samples; within the
  // limits when <= 1.
  double velocity = 0.0;
  double acceleration = 0.0;
  double beyond_limits = 0.0;  // largest distance of a joint outside its position limits [rad or m]

  // Whether the path may be executed: no collision, and position, velocity and acceleration within
  // their limits up to rounding (1e-6, relative for velocity and acceleration, else rad or m).
  bool ok() const;
};

struct PathCheckOptions {
  static constexpr AboutSettings kAbout{"PathCheckOptions",
                                        "The independent check of a finished path."};
  bool collisions = true;
  double step = 2e-3;
};

template <SettingsOf<PathCheckOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [collisions, step] = options;
  visit("collisions", collisions,
        "Whether another engine (FCL) looks for collisions; else only limits are checked.");
  visit("step", step, kLengthAbove0, "m",
        "Longest motion of any point of a link between two postures that are checked.");
}

// Tests postures along the cubics between the samples of `path` (joints of scene.arm), so densely
// that no corner of a link's bounding box moves more than `step` from one posture to the next. The
// triangles of every link are tested for intersection with those of every link that it is not
// joined to, of the object and of the obstacles, before they have moved by `step` against each
// other since the last time (path_collisions.h).
//
// From the start of a segment "lift" on, the object moves with the hand as it is held there. It is
// then tested against the obstacles and the links that are not the hand's; where surfaces cross at
// that moment, they may do so until they have been apart once.
//
// Planning relies on a proof instead (motion_check.h: distances and bounds of motion). This check
// deliberately uses neither, but another engine (second_check.h), and leaves out no pair that the
// proof found to stay apart, so that an error in the proof shows here. It is no proof: a collision
// between two tests can be missed. The scene must have an arm. Throws Cancelled.
PathCheck check_path(const CompiledScene& scene, const Trajectory& path,
                     const PathCheckOptions& options = {}, const RunContext& context = {});

// The same from sample `first` on, with the bodies of scene.arm prepared already, for several
// paths.
PathCheck check_path(const CompiledScene& scene, const SecondCheck& bodies, const Trajectory& path,
                     std::size_t first, const PathCheckOptions& options, const RunContext& context);

}  // namespace prehend
