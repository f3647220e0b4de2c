// How much the quality of a grasp depends on what is below the accuracy of any robot and any file.
#pragma once

#include "sim/quality/interval.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/trial.h"
#include "sim/trial/trial_options.h"

namespace prehend {

struct NearbyOptions {
  double shift = 1e-6;     // of the hand, along each axis [m]
  double turn = 1e-5;      // of the hand, about each axis through its base [rad]
  double threshold = 0.1;  // part of the contact threshold by which it is larger or smaller
};

// The least and the largest epsilon among the grasp and its neighbours: the hand, with the joints
// as they are, shifted along and turned about each of its axes, both ways, and the contacts found
// with a larger or a smaller threshold. Where the interval is wide, epsilon rests on a contact
// whose gap is close to the threshold, or on which corners of a flat contact count as equally near:
// the grasp is on the border between two sets of contacts. `trial` must be stable and of `scene`;
// its epsilon is in the interval. Throws Cancelled.
Interval epsilon_nearby(const CompiledScene& scene, const Trial& trial, const TrialOptions& options,
                        const NearbyOptions& nearby = {}, const RunContext& context = {});

}  // namespace prehend
