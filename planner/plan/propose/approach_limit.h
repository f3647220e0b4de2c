// From which directions hands may come.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "sim/base/named_enum.h"
#include "sim/base/pose.h"
#include "sim/base/settings.h"

namespace prehend {

struct Candidate;
struct CompiledScene;
struct Trial;

// The frame in which a direction of approach is stated.
enum class ApproachFrame { world, object };

constexpr auto enum_names(ApproachFrame /*of*/) {
  return std::to_array<std::string_view>({"world", "object"});
}

struct ApproachLimit {
  static constexpr AboutSettings kAbout{"ApproachLimit",
                                        "The directions in which a hand may move to the object: "
                                        "those within an angle of one."};
  Vector3 direction = Vector3(0.0, 0.0, -1.0);
  double angle = 0.5235987755982988;  // 30 degrees
  ApproachFrame frame = ApproachFrame::world;
};

inline constexpr double kShortestApproach = 1e-12;
inline constexpr Range kApproachAngle{.upper = 3.141592653589793};

template <SettingsOf<ApproachLimit> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [direction, angle, frame] = options;
  visit("direction", direction,
        "In which the hand moves, as its `approach` points in its file; of any length.");
  visit.relation("direction", direction.allFinite() && direction.norm() > kShortestApproach,
                 "must not be zero");
  visit("angle", angle, kApproachAngle, "rad",
        "How far the hand's own direction may be from it; the largest allows all.");
  visit("frame", frame, "In which `direction` is given.");
}

// The limit that words state: [FRAME:]DIRECTION[/ANGLE]. FRAME is world (or left out) or object;
// DIRECTION is down (-z), up (+z), +x, -x, +y, -y, +z, -z, or three numbers with commas; ANGLE is a
// number with deg or rad, 30deg where it is left out. Throws InputError for anything else.
ApproachLimit approach_limit(const std::string& words);

// The limit in such words: "down/30deg", "object:1,0,1/15deg".
std::string approach_text(const ApproachLimit& limit);

// Whether hands in this scene may move along the unit direction `approach_O` (object frame).
bool allows(const ApproachLimit& limit, const CompiledScene& scene, const Vector3& approach_O);

// Whether the limit allows a grasp: the direction in which its hand moves, and the one in which the
// hand's approach points in the end, which are the same unless the object settled between the
// fingers.
bool allows(const ApproachLimit& limit, const CompiledScene& scene, const Candidate& candidate,
            const Trial& trial);

}  // namespace prehend
