#include "benchmarks/shake/on_table.h"

#include <algorithm>
#include <limits>

#include "sim/base/input_error.h"
#include "sim/motion/step_world.h"
#include "sim/motion/world.h"
#include "sim/scene/make_scene.h"
#include "sim/shape/basic_shapes.h"

namespace prehend::bench {
namespace {

constexpr double kDrop = 1e-3;       // that the object is let fall [m]
constexpr double kClear = 1e-4;      // between its lowest point and the plate in the end [m]
constexpr double kThickness = 0.05;  // of the plate [m]
constexpr double kMargin = 0.3;      // of the plate around the object [m]
constexpr double kPatience = 10.0;   // s

double lowest_of(const GraspableBody& object) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vector3& p : object.mesh.vertices) lowest = std::min(lowest, (object.X_WO * p).z());
  return lowest;
}

// A plate whose upper face is at z, under the object's origin.
StaticBody plate_at(double z, const GraspableBody& object) {
  const double edge = 2.0 * (bounds(object.mesh).size().norm() + kMargin);
  StaticBody plate;
  plate.name = "table";
  plate.mesh = make_box({edge, edge, kThickness});
  const Vector3 p = object.X_WO.translation();
  plate.X_WB = translation({p.x(), p.y(), z - 0.5 * kThickness});
  return plate;
}

World world_of(const Scene& scene, const StaticBody& plate) {
  const GraspableBody& object = scene.object;
  World world;
  world.laws.friction = scene.friction;
  WorldBody body{object.name, make_collision_body(object.name, object.mesh, true), object.material};
  body.inertial = {object.mass, object.center_of_mass, object.inertia};
  body.motion.X_WB = object.X_WO;
  world.bodies.push_back(std::move(body));
  WorldBody table{plate.name, make_collision_body(plate.name, plate.mesh, true), plate.material};
  table.is_fixed = true;
  table.motion.X_WB = plate.X_WB;
  world.bodies.push_back(std::move(table));
  return world;
}

}  // namespace

void put_on_table(Scene& scene) {
  if (scene.carrier) throw InputError({.field = scene.name, .problem = "has an arm"});
  const double z = lowest_of(scene.object) - kDrop;
  World world = world_of(scene, plate_at(z, scene.object));
  for (double time = 0.0; !world.bodies[0].asleep;) {
    const double step = step_world(world).time;
    time += step;
    if (step > 0.0 && time < kPatience) continue;
    throw InputError({.field = scene.object.name, .problem = "does not come to rest on a table"});
  }
  scene.object.X_WO = world.bodies[0].motion.X_WB;
  // Surfaces at rest may cross by a little, which scenes must not.
  const double up = z + kClear - lowest_of(scene.object);
  scene.object.X_WO = translation({0.0, 0.0, up}) * scene.object.X_WO;
  const StaticBody plate = plate_at(z, scene.object);
  add_obstacle(scene, plate.name, plate.mesh, plate.X_WB, plate.material);
}

}  // namespace prehend::bench
