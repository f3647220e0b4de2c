// Whether and how a hand closes in time.
#pragma once

#include "sim/base/settings.h"

namespace prehend {

struct DynamicGraspOptions {
  // Whether a trial's hand closes in time, on an object that gives way; else the object stands
  // still, as in the closing of a hand in GraspIt!.
  bool dynamic = false;
  double gravity = 9.81;  // where the scene has obstacles to stand on; else there is none [m/s^2]
  double settle = 0.5;    // longest time in which the object comes to rest at first [s]
  double close = 2.0;     // longest time in which the hand closes [s]
  // The closed hand rises by so much in lift_time, if the object stands on something; 0: not [m,
  // s].
  double lift = 0.05;
  double lift_time = 0.5;
  double step = 2.5e-3;  // of the simulation [s]
};

template <SettingsOf<DynamicGraspOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [dynamic, gravity, settle, close, lift, lift_time, step] = options;
  visit("dynamic", dynamic);
  visit("gravity", gravity, kAtLeast0);
  visit("settle", settle, kAtLeast0);
  visit("close", close, kAbove0);
  visit("lift", lift, kAtLeast0);
  visit("lift_time", lift_time, kAbove0);
  visit("step", step, kAbove0);
}

}  // namespace prehend
