// Whether a closed hand carries the object's weight with the efforts of its drives, and how hard it
// has to squeeze for that.
#pragma once

#include <span>

#include "sim/base/pose.h"
#include "sim/base/run_context.h"
#include "sim/trial/uncertainty.h"

namespace prehend {

struct CompiledScene;
struct HandTorques;
struct Trial;

// What it takes to hold the weight in one attitude. Of all forces within the friction cones that
// balance it, `sum_of_normals` and `largest_normal` are the smallest there are, each by itself.
struct LoadCase {
  Vector3 down_O = -Vector3::UnitZ();  // where gravity pulls, unit, object's frame
  double sum_of_normals = 0.0;  // of all contacts; infinite: no forces balance the weight [N]
  double largest_normal = 0.0;  // of a contact; infinite as above [N]
  // How many times the weight the drives can hold (times_borne). 0: no forces balance the weight;
  // infinite: it loads no drive whose effort is known.
  // With suction cups the normal forces are those of the vacuum that the cups need, and strength
  // is what their vacuum holds (cup_balance.h).
  double strength = 0.0;
};

struct PayloadMargin {
  LoadCase given;  // the object as it lies in the scene, gravity along -z of the world
  // Of 42 attitudes, evenly spread, the one with the largest sum of normals. The true worst one has
  // at most 9 % more, as that sum is a convex function of the direction (a norm, but for its sign).
  LoadCase worst;

  // Whether the drives hold the weight as the object lies.
  bool holds() const { return given.strength >= 1.0; }
};

// What contact forces do to the drives of the hand, and what these bear: sums of joint torques, one
// for each degree of freedom and each way in which its clutches pass torques on (clutches.h), with
// the velocity of each contact point and the turning about its normal. Degrees of freedom that
// state no effort have no limit. X_OH, joints and contacts are those of the trial.
HandTorques hand_torques(const CompiledScene& scene, const Trial& trial);

// The burden of the object's weight on the grasp of `trial`. Without contacts nothing is balanced.
// Source of the forces: balancing_forces. Throws Cancelled.
PayloadMargin payload_margin(const CompiledScene& scene, const Trial& trial,
                             const RunContext& context = {});

// How many times the weight the drives hold as the object lies (LoadCase::strength).
double weight_strength(const CompiledScene& scene, const Trial& trial);

// One of several hands that hold the object, each in a scene of its own of it.
struct HoldingHand {
  const CompiledScene& scene;
  const Trial& trial;
};

// How many times the weight the drives of all hands together hold, the object as it lies in the
// first scene (LoadCase::strength). At least one hand; none with suction cups.
double weight_strength(std::span<const HoldingHand> hands);

// Whether the drives hold the weight as the object lies, with friction and the centre of mass
// disturbed.
bool can_lift(const CompiledScene& scene, const Trial& trial,
              const Perturbation& perturbation = {});

}  // namespace prehend
