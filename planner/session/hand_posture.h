// Where the hand of a session is, and motions of it that end where it would touch something.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

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

// `share` of the way from one posture to the other, in 0 .. 1: the base moves along a straight line
// while it turns evenly about one axis through itself, the joints move evenly. 1 gives `to` itself.
HandPosture between(const HandPosture& from, const HandPosture& to, double share);

// Why a motion of the hand ended.
enum class MotionEnd {
  arrived,              // it touches nothing on the way
  touched,              // two bodies are so near that they count as touching
  starts_in_collision,  // bodies overlap where it starts: it did not move
};

// "arrived", "touched", "starts_in_collision": as in messages.
constexpr std::string_view motion_end_name(MotionEnd end) {
  constexpr std::array<std::string_view, 3> kNames = {"arrived", "touched", "starts_in_collision"};
  return kNames[static_cast<std::size_t>(end)];
}

struct HandMotion {
  MotionEnd end = MotionEnd::arrived;
  double share = 1.0;   // of the way that was gone, in 0 .. 1
  HandPosture posture;  // where it ended
  std::string link;     // which touched or overlaps `by`; empty where it arrived
  std::string by;       // the object, an obstacle or another link
};

// Moves the hand from one posture towards another until a link comes within contact_gap (at most
// 10 % more) of the object, an obstacle or another link; it never penetrates, because no step is
// longer than what proven bounds of the gaps allow (conservative advancement, as approach.h does
// for straight motions). Bodies that are as near at the start may come closer, to half of their
// gap: a hand that touches can move away and along. Throws Cancelled.
HandMotion move_to_contact(const CompiledScene& scene, const HandPosture& from,
                           const HandPosture& to, const TrialOptions& options,
                           const RunContext& context = {});

}  // namespace prehend
