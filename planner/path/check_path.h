// An independent check of a finished path: collisions, and the limits of the joints.
#pragma once

#include <string>

#include "planner/path/trajectory.h"
#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {

struct PathCheck {
  int postures = 0;             // that were looked at
  int collisions = 0;           // of them
  std::string first_collision;  // "LINK meets BODY at TIME s", empty for none
  // Largest over all samples and joints, as parts of the limits: at most 1 is inside.
  double velocity = 0.0;
  double acceleration = 0.0;   // difference of the velocities of two samples over the time between
  double beyond_limits = 0.0;  // farthest that a joint is outside its limits [rad or m]

  bool ok() const;
};

struct PathCheckOptions {
  double step = 2e-3;  // longest motion of any point of a link between two postures [m]
};

template <SettingsOf<PathCheckOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [step] = options;
  visit("step", step);
}

// Checks postures along the cubics between the samples of the path, so densely that no corner of a
// link's bounding box moves more than `step` from one to the next: whether any two triangles meet,
// of every link with every other that it is not joined to, with the object and with the obstacles.
// It shares no code with the proof that planning relies on (motion_check.h): no gaps, no bounds of
// motion, no pairs left out because they were proven to stay apart. So an error there shows here.
// Throws Cancelled.
PathCheck check_path(const CompiledScene& scene, const Trajectory& path,
                     const PathCheckOptions& options = {}, const RunContext& context = {});

}  // namespace prehend
