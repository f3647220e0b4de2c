// Whether and how a hand closes in time.
#pragma once

#include "sim/base/settings.h"
#include "sim/motion/step_options.h"

namespace prehend {

struct DynamicGraspOptions {
  static constexpr AboutSettings kAbout{"FormationOptions",
                                        "A hand that closes in time, on an object that gives way."};
  bool dynamic = false;
  double gravity = 9.81;
  double settle = 0.5;
  double close = 2.0;
  double lift = 0.05;
  double lift_time = 0.5;
  double hold = 2.0;
  // Steps of 2.5 ms lead the object to the same places within a millimetre or two, and take five
  // times as long (docs/reference/dynamics.md).
  double step = 0.1;
  double travel = 4e-3;
};

template <SettingsOf<DynamicGraspOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [dynamic, gravity, settle, close, lift, lift_time, hold, step, travel] = options;
  visit("dynamic", dynamic,
        "Whether a trial's hand closes in time, which takes a hundred times longer; else the "
        "object stands still, as in the closing of a hand in GraspIt!.");
  visit("gravity", gravity, kRate, "m/s^2",
        "Where the scene has obstacles to stand on; else there is none.");
  visit("settle", settle, kTime, "s", "Longest time in which the object comes to rest at first.");
  visit("close", close, kTimeAbove0, "s",
        "Longest time in which the hand closes, or ends a stage of its strategy.");
  visit("lift", lift, kDistance, "m",
        "How far the closed hand rises, if the object stands on something; 0: not.");
  visit("lift_time", lift_time, kTimeAbove0, "s", "Time in which it rises.");
  visit("hold", hold, kTime, "s",
        "Longest time in which it is watched after that, until everything rests.");
  visit("step", step, kSteps, "s", "The longest of the simulation.");
  visit("travel", travel, kLengthAbove0, "m",
        "Steps are shorter where points of the hand or the object would move farther than this in "
        "one, down to those of other simulations.");
}

}  // namespace prehend
