#include "sim/motion/require_world.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/motion/near_pairs.h"
#include "sim/motion/solids.h"

namespace prehend {
namespace {

void require_body(const WorldBody& body) {
  if (!body.motion.X_WB.matrix().allFinite() || !body.motion.linear.allFinite() ||
      !body.motion.angular.allFinite() || !body.force_W.allFinite() || !body.torque_W.allFinite()) {
    throw InputError({.field = body.name, .problem = "has a motion or force that is not finite"});
  }
  if (!(body.restitution >= 0.0 && body.restitution <= 1.0)) {
    throw InputError({.field = body.name,
                      .problem = "restitution must be from 0 to 1",
                      .value = std::to_string(body.restitution)});
  }
  if (body.is_fixed) return;
  if (!(body.inertial.mass > 0.0) || !std::isfinite(body.inertial.mass)) {
    throw InputError({.field = body.name,
                      .problem = "needs a positive mass to move",
                      .value = std::to_string(body.inertial.mass)});
  }
  const std::string defect = inertia_defect(body.inertial.inertia);
  if (!defect.empty()) throw InputError({.field = body.name, .problem = defect});
  if (!(body.inertial.inertia.determinant() > 0.0)) {
    throw InputError({.field = body.name, .problem = "needs an inertia about every axis to move"});
  }
}

void require_drive(const WorldRobot& robot, const Drive& drive) {
  const auto fail = [&](const char* what, double value) {
    throw InputError({.field = robot.name, .problem = what, .value = std::to_string(value)});
  };
  if (drive.dof < 0 || drive.dof >= robot.model->dofs()) {
    fail("has no degree of freedom for a drive", drive.dof);
  }
  if (!std::isfinite(drive.stiffness) || !std::isfinite(drive.damping)) {
    fail("a drive's gains must be finite", drive.stiffness);
  }
  if (!(drive.stiffness >= 0.0)) fail("a drive's stiffness must not be negative", drive.stiffness);
  if (!(drive.damping >= 0.0)) fail("a drive's damping must not be negative", drive.damping);
  if (!(drive.max_effort >= 0.0)) fail("a drive's effort must not be negative", drive.max_effort);
  if (!std::isfinite(drive.target) || !std::isfinite(drive.target_rate)) {
    fail("a drive's target must be finite", drive.target);
  }
}

void require_robot(const WorldRobot& robot) {
  const bool is_finite = robot.X_WB.matrix().allFinite() && robot.base_angular.allFinite() &&
                         robot.base_linear.allFinite() && robot.x.allFinite() &&
                         robot.rate.allFinite() && robot.effort.allFinite();
  if (!is_finite) {
    throw InputError({.field = robot.name, .problem = "has a motion or effort that is not finite"});
  }
  for (const Drive& drive : robot.drives) require_drive(robot, drive);
}

std::string name_of(const World& world, const SolidId& id) {
  if (id.robot < 0) return world.bodies[index(id.index)].name;
  const WorldRobot& robot = world.robots[index(id.robot)];
  return robot.name + "/" + robot.model->robot.links[index(id.index)].name;
}

}  // namespace

void require_quantities(const World& world, const StepOptions& options) {
  if (!kSteps.contains(options.step)) {
    throw InputError(
        {.field = "step", .problem = kSteps.words(), .value = std::to_string(options.step)});
  }
  if (!world.gravity.allFinite()) {
    throw InputError({.field = "gravity", .problem = "must be finite"});
  }
  for (const WorldBody& body : world.bodies) require_body(body);
  for (const WorldRobot& robot : world.robots) require_robot(robot);
}

std::optional<std::pair<std::string, std::string>> overlap_in(const World& world,
                                                              const StepOptions& options) {
  const Solids solids(world);
  ContactMemory memory;
  find_near(solids, nullptr, world, options.step, options, memory);
  for (const PairMemory& pair : memory.pairs) {
    const Solid& a = solids.at(pair.a);
    const Solid& b = solids.at(pair.b);
    if (bodies_overlap(*a.shape, *b.shape, a.X_WS.inverse() * b.X_WS)) {
      return std::pair(name_of(world, pair.a), name_of(world, pair.b));
    }
  }
  return std::nullopt;
}

void require_world(const World& world, const StepOptions& options) {
  require_quantities(world, options);
  const auto overlap = overlap_in(world, options);
  if (!overlap) return;
  throw InputError(
      {.field = overlap->first, .problem = "overlaps " + overlap->second + " at the start"});
}

}  // namespace prehend
