// What comes after a grasp: the arm lifts the object and takes it along.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "sim/base/named_enum.h"
#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/motion/control/time_path.h"
#include "sim/robot/dof_values.h"

namespace prehend {

struct CompiledArm;
struct CompiledScene;
struct MotionCheckOptions;
struct ReachOptions;
struct TransferOptions;
struct Trial;

// Names of the segments.
inline constexpr const char* kLift = "lift";
inline constexpr const char* kRetreat = "retreat";

struct LiftOptions {
  static constexpr AboutSettings kAbout{"LiftOptions", "What comes after the grasp."};
  double height = 0.1;
  bool retreat = true;
};

template <SettingsOf<LiftOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [height, retreat] = options;
  visit("height", height, kDistance, "m",
        "How far the hand moves straight up, away from gravity; 0: the path ends in the grasp.");
  visit("retreat", retreat, "Whether the arm then takes the object back to its start posture.");
}

// How far it came.
enum class LiftEnd {
  not_asked,         // the path ends in the grasp, as it was to
  complete,          // all that was asked for is there
  lift_unreachable,  // no posture of the arm, or none without a jump, along the line upwards
  lift_blocked,      // something collides on the way up
  retreat_blocked,   // the object is lifted, but no way back to the start was found
};

// The name in files: the same word as the enumerator.
constexpr auto enum_names(LiftEnd /*of*/) {
  return std::to_array<std::string_view>(
      {"not_asked", "complete", "lift_unreachable", "lift_blocked", "retreat_blocked"});
}

// The closed hand, and the posture of the arm that holds it at the grasp.
struct HeldObject {
  const CompiledScene& scene;
  const Trial& trial;
  const DofValues& arm_dofs;
};

// The postures in which `arm` (arm_with_object) moves the object straight up, the first being that
// of the grasp; empty where it cannot. Throws Cancelled.
std::vector<DofValues> lift_postures(const HeldObject& held, CompiledArm& arm, double height,
                                     const ReachOptions& reach, const RunContext& context = {});

// Whether something collides while `arm` (arm_with_object) lifts, or that could not be ruled out.
// At the beginning the object and the hand may touch what they stand on or beside. Throws
// Cancelled.
bool lift_blocked(const CompiledArm& arm, const TimedPath& lift, const MotionCheckOptions& motion,
                  const RunContext& context = {});

// The motions after the grasp, as far as they were found, each from rest to rest.
struct LiftedPath {
  LiftEnd end = LiftEnd::not_asked;
  std::optional<TimedPath> lift;
  std::optional<TimedPath> retreat;
};

// Plans them for the arm with the object in its hand (carried_object.h): both are proven free of
// collision as they are timed. The object and the hand do not collide with each other. At the
// beginning both may touch what they stand on or beside (leave_contact.h). Throws InputError like
// time_path, and Cancelled.
LiftedPath lift_object(const HeldObject& held, const LiftOptions& options,
                       const ReachOptions& reach, const TransferOptions& transfer,
                       const JointLimits& limits, const TimePathOptions& timing,
                       const RunContext& context = {});

}  // namespace prehend
