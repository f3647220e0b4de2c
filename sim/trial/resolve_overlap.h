// An overlap that is small enough to be an error of the scan, the pose or the hand's model: the
// hand, or the object before it, gives way by that much, as they do in reality.
#pragma once

#include <optional>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/hand_collision.h"
#include "sim/trial/trial_options.h"

namespace prehend {

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
