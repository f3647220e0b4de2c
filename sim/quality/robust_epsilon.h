// Epsilon under random errors of pose, contacts and friction.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/quality/contact.h"
#include "sim/quality/contact_map.h"

namespace prehend {

struct WrenchSpaceOptions;

struct NoiseOptions {
  static constexpr AboutSettings kAbout{
      "NoiseOptions",
      "Standard deviations of random errors of pose, contacts and "
      "friction; lengths are parts of r = 1 / torque_scale."};
  double pose_position = 0.02;
  double pose_angle = 0.05;
  double contact_position = 0.01;
  double normal_angle = 0.05;
  double friction = 0.1;
  int samples = 200;
  std::uint64_t seed = 1;
};

template <SettingsOf<NoiseOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [pose_position, pose_angle, contact_position, normal_angle, friction, samples, seed] =
      options;
  visit("pose_position", pose_position, kRatio, "r",
        "Of the object as a whole against the hand, along each axis.");
  visit("pose_angle", pose_angle, kAngle, "rad",
        "Of the object as a whole, about each axis through the torque origin.");
  visit("contact_position", contact_position, kRatio, "r", "Of each contact by itself.");
  visit("normal_angle", normal_angle, kAngle, "rad", "Of the normal of each contact.");
  visit("friction", friction, kRatio, "",
        "Of the logarithm of each friction coefficient that has none of its own.");
  visit("samples", samples, kSampleCount, "", "Samples of these errors.");
  visit.unlisted("seed", seed, kAtLeast0, "", "Of the samples.");
}

// Statistics of epsilon over the samples; its lower bound is taken, which is 0 for a sample without
// force closure.
struct RobustEpsilon {
  double mean = 0.0;
  double percentile_5 = 0.0;   // of the samples, the smallest that at least 5 % do not exceed
  double force_closure = 0.0;  // part of the samples that have it
};

// The same on every platform and for every number of threads. Source: Weisz and Allen, ICRA 2012
// (probability of force closure under pose error). Throws InputError for a deviation that is
// negative or not finite or for no samples, as wrench_space, and Cancelled.
RobustEpsilon robust_epsilon(std::span<const Contact> contacts, const WrenchFrame& frame,
                             const WrenchSpaceOptions& space, const NoiseOptions& noise = {},
                             const RunContext& context = {});

}  // namespace prehend
