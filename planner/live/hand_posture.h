// Where the hand of a session is, and motions of it that end where it would touch something.
#pragma once

#include <string>
#include <vector>

#include "planner/live/sweep.h"
#include "sim/base/run_context.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/trial_options.h"

namespace prehend {

struct HandPosture {
  Pose X_OH =
      Pose::Identity();      // of the hand's base, frame of the object (the world's without one)
  std::vector<double> dofs;  // per degree of freedom [rad or m]
  // Per joint [rad or m]; they differ from those of `dofs` where contact stopped some (ClosedHand).
  std::vector<double> joints;
};

bool is_same(const HandPosture& a, const HandPosture& b);

// `share` of the way from one posture to the other, in 0 .. 1: the base moves along a straight line
// while it turns evenly about one axis through itself, the joints move evenly. 1 gives `to` itself.
HandPosture between(const HandPosture& from, const HandPosture& to, double share);

// A motion of the hand, and why it ended.
struct HandMotion {
  MotionEnd end = MotionEnd::arrived;
  double share = 1.0;   // of the way that was gone, in 0 .. 1
  HandPosture posture;  // where it ended
  std::string link;     // which touched or overlaps `by`; empty where it arrived
  std::string by;       // the object, an obstacle or another link
};

// Moves the hand from one posture towards another until a link would touch the object, an obstacle
// or another link, as sweep() does. Throws Cancelled.
HandMotion move_to_contact(const CompiledScene& scene, const HandPosture& from,
                           const HandPosture& to, const TrialOptions& options,
                           const RunContext& context = {});

}  // namespace prehend
