// Worlds that move, each step of which is judged by code that shares nothing with what made it.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/base/index.h"
#include "sim/motion/require_world.h"
#include "sim/motion/step_world.h"
#include "tests/support/judge_world.h"

namespace prehend::test {

struct Examined {
  std::string fault;     // the first that was found; empty: none
  double deepest = 0.0;  // of all penetrations [m]
};

// Deepest penetration at the end of a step and on the way between two, at evenly spaced moments of
// bodies that turn evenly [m].
inline constexpr double kDeepest = 1e-4;
// Growth of the energy in a step, of what there was: turns of free bodies swing by a little.
inline constexpr double kGrowth = 1e-3;
// How far forces may be outside of their cones: what is acceptable where the solver cannot do
// better (ContactSolverOptions::acceptable), of all forces of the step.
inline constexpr double kOutsideCones = 1e-3;

inline Material material_of(const World& world, const SolidId& id) {
  if (id.robot < 0) return world.bodies[index(id.index)].material;
  return world.robots[index(id.robot)].model->materials[index(id.index)];
}

// The first contact whose force pulls, or is outside of its friction cone.
inline std::string outside_cone(const World& world) {
  double most = 0.0;
  for (const WorldContact& contact : world.contacts) {
    most = std::max(most, contact.impulse_W.norm());
  }
  for (const WorldContact& contact : world.contacts) {
    const double normal = contact.impulse_W.dot(contact.normal_W);
    const double along = (contact.impulse_W - normal * contact.normal_W).norm();
    const double friction =
        world.laws.friction.between(material_of(world, contact.a), material_of(world, contact.b));
    if (normal < -kOutsideCones * most) return "a contact pulls";
    if (along > friction * normal + kOutsideCones * most) return "a force outside of its cone";
  }
  return {};
}

// Moves the world, and judges every step and moments between that are 2 mm apart on fast ways.
inline Examined examine(World& world, double seconds) {
  Examined examined;
  const auto at = [](double time) { return " at " + std::to_string(time); };
  const WorldJudge judge(world);
  Placement before = WorldJudge::placement(world);
  const double start = energy_of_bodies(world);
  double energy = start;
  for (double time = 0.0; time < seconds;) {
    const StepResult result = step_world(world);
    if (!(result.time > 0.0)) return {std::string(name_of(result.outcome)) + at(time)};
    time += result.time;
    const Placement after = WorldJudge::placement(world);
    double farthest = 0.0;
    for (std::size_t i = 0; i < after.size(); ++i) {
      farthest = std::max(farthest, (after[i].translation() - before[i].translation()).norm());
    }
    const int looks = std::clamp(static_cast<int>(farthest / 2e-3), 1, 50);
    for (int look = 1; look <= looks; ++look) {
      const Penetration found =
          judge.deepest(look == looks ? after : between(before, after, double(look) / looks));
      examined.deepest = std::max(examined.deepest, found.depth);
      if (found.depth > kDeepest) {
        examined.fault =
            found.a + " is " + std::to_string(1e3 * found.depth) + " mm in " + found.b + at(time);
        return examined;
      }
    }
    const double now = energy_of_bodies(world);
    if (!std::isfinite(now)) examined.fault = "not finite" + at(time);
    if (world.robots.empty() && now - energy > kGrowth * std::abs(start)) {
      examined.fault = "energy grows" + at(time);
    }
    if (const std::string outside = outside_cone(world); !outside.empty()) {
      examined.fault = outside + at(time);
    }
    if (!examined.fault.empty()) return examined;
    energy = now;
    before = after;
  }
  return examined;
}

}  // namespace prehend::test
