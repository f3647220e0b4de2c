// An overlap that is small enough to be an error of the scan, the pose or the hand's model: the
// hand, or the object before it, gives way by that much, as they do in reality.
#pragma once

#include <optional>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/hand_collision.h"

namespace prehend {

struct OverlapOptions {
  static constexpr AboutSettings kAbout{"GiveWayOptions",
                                        "By how much an overlap at the start may be resolved, by "
                                        "moving the hand, instead of ending the trial; 0: none."};
  // Scans and models of hands are wrong by this much, and a light object moves aside.
  double object = 2e-3;
  // How far an arm with a stiffness of 2 N/mm yields to 10 N.
  double obstacle = 5e-3;
  double deepest = 20e-3;
};

template <SettingsOf<OverlapOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [object, obstacle, deepest] = options;
  visit("object", object, kAtLeast0, "m", "Deepest overlap of hand and object.");
  visit("obstacle", obstacle, kAtLeast0, "m", "Deepest overlap of a hand with obstacles only.");
  visit("deepest", deepest, kAtLeast0, "m",
        "How deep an overlap that stays is measured; 0: it is not, as in plans, which leave such "
        "candidates out.");
}

// Buffers of resolve_overlap, to allocate less; one for each thread.
struct GiveWayWorkspace {
  RobotPoses poses;
  NearBodies near;
};

// The shortest translation of the hand, in the object's frame [m], after which no link of it
// overlaps the object or an obstacle, among 26 directions: along the axes of the hand's base, their
// diagonals, and so back along its approach. A direction counts if the hand is free at the end of
// the longest way allowed; the way is then shortened as far as it stays free, to 0.05 mm. Only
// moves of the hand as a whole are looked at, so a hand that is narrower than the object does not
// give way. Nothing where the hand overlaps more than the options allow; zero where nothing
// overlaps. `joints` [rad or m]. Throws Cancelled.
std::optional<Vector3> resolve_overlap(const CompiledScene& scene, const Pose& X_OH,
                                       const std::vector<double>& joints,
                                       const OverlapOptions& options, GiveWayWorkspace& workspace,
                                       const RunContext& context = {});

// The length of the shortest translation of the hand after which it overlaps nothing, among the
// same directions: how deep the overlap is that resolve_overlap leaves [m]. Nothing where it is
// deeper than options.deepest.
std::optional<double> overlap_depth(const CompiledScene& scene, const Pose& X_OH,
                                    const std::vector<double>& joints,
                                    const OverlapOptions& options, GiveWayWorkspace& workspace,
                                    const RunContext& context = {});

}  // namespace prehend
