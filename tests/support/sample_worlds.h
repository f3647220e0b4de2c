// Worlds of plain bodies for tests of dynamics.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "sim/motion/step_options.h"
#include "sim/motion/step_world.h"
#include "sim/motion/world.h"
#include "sim/shape/basic_shapes.h"

namespace prehend::test {

inline constexpr double kG = 9.81;  // [m/s^2]

inline WorldBody body_of(const std::string& name, const TriangleMesh& mesh, double mass,
                         const Vector3& p) {
  WorldBody body{name, make_collision_body(name, mesh, true)};
  body.inertial = inertial_of_mass(mesh, mass);
  body.motion.X_WB = translation(p);
  return body;
}

inline WorldBody box(const std::string& name, const Vector3& size, double mass, const Vector3& p) {
  return body_of(name, make_box(size), mass, p);
}

// A plate whose upper side is at z = 0.
inline WorldBody ground(double size = 4.0) {
  WorldBody body = box("ground", {size, size, 0.1}, 1.0, {0.0, 0.0, -0.05});
  body.is_fixed = true;
  return body;
}

inline World world_with(std::vector<WorldBody> bodies, double friction) {
  World world;
  world.bodies = std::move(bodies);
  world.laws.friction.set(Material::plastic, Material::plastic, friction);
  return world;
}

// Until `seconds` have passed, or a step does not move.
inline StepOutcome run(World& world, double seconds, const StepOptions& options = {}) {
  double time = 0.0;
  StepOptions last = options;
  while (time < seconds - 1e-12) {
    last.step = std::min(options.step, seconds - time);
    const StepResult result = step_world(world, last);
    if (result.outcome != StepOutcome::moved) return result.outcome;
    time += result.time;
  }
  return StepOutcome::moved;
}

}  // namespace prehend::test
