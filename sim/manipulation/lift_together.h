// Several hands that close on one object and lift it together, in time.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "sim/base/named_enum.h"
#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/trial/payload_margin.h"

namespace prehend {

struct SharedLiftOptions {
  static constexpr AboutSettings kAbout{"SharedLiftOptions",
                                        "How hands lift an object that they hold together."};
  double gravity = 9.81;
  double close = 1.0;
  double height = 0.1;
  double time = 2.0;
  double hold = 0.5;
};

template <SettingsOf<SharedLiftOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [gravity, close, height, time, hold] = options;
  visit("gravity", gravity, kRate, "m/s^2", "Of the lift.");
  visit("close", close, kTimeAbove0, "s",
        "Longest time in which the hands press before they rise.");
  visit("height", height, kLengthAbove0, "m", "How far all hands rise, without turning.");
  visit("time", time, kTimeAbove0, "s", "Time in which they rise.");
  visit("hold", hold, kTime, "s", "For how long the object is watched after that.");
}

// How it ended for the object.
enum class SharedLiftEnd {
  lifted,         // it rose with the hands, all of which touch it
  lost,           // a hand no longer touches it
  slipped,        // all touch it, but it did not come along, or tilted
  not_simulated,  // solids overlapped at the start, or a step failed
};

constexpr auto enum_names(SharedLiftEnd /*of*/) {
  return std::to_array<std::string_view>({"lifted", "lost", "slipped", "not_simulated"});
}

struct SharedLift {
  SharedLiftEnd end = SharedLiftEnd::not_simulated;
  double risen = 0.0;  // of the object's centre of mass [m]
  double tilt = 0.0;   // of what was its vertical [rad]
};

// The hands begin where their trials closed, press with the largest efforts of their drives, and
// rise, as if arms without any give carried them. Obstacles are those of the first scene. The same
// hands give the same bytes. Throws InputError for an object without a mass, and Cancelled.
SharedLift lift_together(std::span<const HoldingHand> hands, const SharedLiftOptions& options = {},
                         const RunContext& context = {});

}  // namespace prehend
