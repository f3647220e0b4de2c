// What trials of a grasp on disturbed poses showed (perturbed_trials.h).
#pragma once

#include <optional>
#include <vector>

#include "sim/base/named_enum.h"
#include "sim/base/pose.h"
#include "sim/trial/outcome.h"

namespace prehend {

// How a hand that closed on an object that is free to move (closed_freely) ended.
struct FreeEnd {
  bool kept = false;      // the object is in the hand (keeps_object)
  double epsilon = 0.0;   // where the object ended
  double strength = 0.0;  // there: how many times the weight the drives hold (weight_strength)
  double moved = 0.0;     // how far its centre of mass moved [m]
};

// What disturbed trials of one grasp showed.
struct Robustness {
  int samples = 0;
  // In so many of them the hand closed on the object and holds its weight as it lies in the scene
  // (can_lift), with the disturbed friction and centre of mass.
  int held = 0;
  // Of the lower bound of epsilon, 0 where a sample is not in force closure: the mean, and the
  // largest value that at most a tenth of the samples are below.
  double epsilon_mean = 0.0;
  double epsilon_low = 0.0;
  std::vector<double> epsilons;      // of the samples, in their order
  EnumArray<Outcome, int> outcomes;  // of the samples
  // How many times the weight the drives hold (weight_strength), and what becomes of an object that
  // is free to move. Both without errors; where the hand does not close on the object then, of the
  // first sample in which it does.
  double strength = 0.0;
  std::optional<FreeEnd> free;  // empty: not tried
  // How far the object may be off, alone, along each axis of the hand's base, both ways, before the
  // hand no longer holds it: at least this far [m], of the distances kMarginSteps. The direction is
  // that in which the object is off, object's frame.
  double position_margin = 0.0;
  Vector3 weakest_O = Vector3::Zero();
  // How the trial ended with the object farther off that way than `spare`; stable: in force
  // closure, but the drives do not hold the weight. Of no meaning where `spare` is the last of
  // kMarginSteps.
  Outcome weakest_end = Outcome::stable;

  // In so many of the samples the hand closed on the object.
  int closed() const { return outcomes[Outcome::stable] + outcomes[Outcome::not_force_closure]; }
  // Share of the samples that held.
  double probability() const { return samples > 0 ? static_cast<double>(held) / samples : 0.0; }
};

}  // namespace prehend
