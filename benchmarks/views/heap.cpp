#include "benchmarks/views/heap.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <stdexcept>

#include "benchmarks/views/render_depth.h"
#include "sim/base/random.h"
#include "sim/motion/step_world.h"
#include "sim/motion/world.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_file.h"
#include "sim/shape/basic_shapes.h"
#include "tests/support/depth_camera.h"

namespace prehend::bench {
namespace {

constexpr int kFixed = 5;         // bodies of the world that do not move, the first
constexpr double kTable = 0.6;    // to each side [m]
constexpr double kSpread = 0.08;  // of the places from which things fall [m]
constexpr double kFrame = 0.18;   // that keeps them together while they fall, to each side [m]

void add_fixed(World& world, const std::string& name, const Vector3& size, const Vector3& place) {
  WorldBody body{name, make_collision_body(name, make_box(size), true)};
  body.is_fixed = true;
  body.motion.X_WB = translation(place);
  world.bodies.push_back(std::move(body));
}

// The table, with a frame around the heap.
World empty_table() {
  constexpr double kHigh = 0.25;
  World world;
  add_fixed(world, "table", {2.0, 2.0, 0.1}, {0.0, 0.0, -0.05});
  const double out = kFrame + 0.05;
  for (const double side : {-out, out}) {
    add_fixed(world, "frame", {0.1, 2.0 * out + 0.1, kHigh}, {side, 0.0, 0.5 * kHigh + 1e-3});
    add_fixed(world, "frame", {2.0 * kFrame, 0.1, kHigh}, {0.0, side, 0.5 * kHigh + 1e-3});
  }
  return world;
}

double top_of(const World& world, const std::vector<HeapThing>& things) {
  double top = 0.0;
  for (std::size_t k = 0; k < things.size(); ++k) {
    top = std::max(
        top, bounds(transformed(things[k].mesh_W, world.bodies[k + kFixed].motion.X_WB)).upper.z());
  }
  return top;
}

void let_fall(World& world) {
  constexpr double kLongest = 2.5;  // s
  constexpr double kSlow = 2e-3;    // m/s and rad/s
  double still = 0.0;
  for (double time = 0.0; time < kLongest && still < 0.2;) {
    const StepResult step = step_world(world);
    time += step.time;
    double fastest = 0.0;
    for (const WorldBody& body : world.bodies) {
      fastest = std::max({fastest, body.motion.linear.norm(), 0.05 * body.motion.angular.norm()});
    }
    still = fastest < kSlow ? still + step.time : 0.0;
    if (step.outcome == StepOutcome::blocked) throw std::runtime_error("a heap stands still");
  }
}

bool stays(const World& world) {
  return std::all_of(world.bodies.begin() + kFixed, world.bodies.end(), [](const WorldBody& body) {
    const Vector3 p = body.motion.X_WB * body.inertial.center_of_mass;
    return p.head<2>().cwiseAbs().maxCoeff() < kFrame && p.z() > 0.0;
  });
}

}  // namespace

std::vector<HeapThing> fallen_heap(const std::vector<std::string>& files, std::uint64_t seed) {
  constexpr int kAttempts = 10;
  Random random(seed);
  World world = empty_table();
  std::vector<HeapThing> things;
  for (const std::string& file : files) {
    const GraspableBody object = load_scene(file).object;
    things.push_back({object.name, object.mesh});
    WorldBody body{object.name, make_collision_body(object.name, object.mesh, true)};
    body.inertial = {object.mass, object.center_of_mass, object.inertia};
    const double radius = bounds(object.mesh).diagonal();
    const World before = world;
    for (int attempt = 0;; ++attempt) {
      if (attempt == kAttempts) throw std::runtime_error(file + " does not stay on the heap");
      const double top = top_of(before, {things.begin(), things.end() - 1});
      Pose X_WB = random.pose(0.0);
      const Vector3 place = random.in_box({-kSpread, -kSpread, 0.0}, {kSpread, kSpread, 0.0});
      X_WB.translation() = place + Vector3(0.0, 0.0, top + 0.6 * radius) -
                           X_WB.linear() * bounds(object.mesh).center();
      body.motion.X_WB = X_WB;
      world = before;
      world.bodies.push_back(body);
      let_fall(world);
      if (stays(world)) break;
    }
  }
  for (std::size_t k = 0; k < things.size(); ++k) {
    things[k].mesh_W = transformed(things[k].mesh_W, world.bodies[k + kFixed].motion.X_WB);
  }
  return things;
}

std::vector<DepthView> views_of_heap(const std::vector<HeapThing>& heap, int count,
                                     std::uint64_t seed) {
  constexpr double kDistance = 0.7;
  constexpr double kDown = 0.25 * std::numbers::pi;
  std::deque<ProximityMesh> trees;
  std::vector<ShownThing> shown;
  for (const HeapThing& thing : heap) {
    trees.emplace_back(thing.mesh_W);
    shown.push_back({&trees.back()});
  }
  Random random(seed);
  const double first = random.uniform(0.0, 2.0 * std::numbers::pi);
  std::vector<DepthView> views;
  for (int k = 0; k < count; ++k) {
    const double turn = first + 2.0 * std::numbers::pi * k / count;
    const Vector3 way(std::cos(turn) * std::cos(kDown), std::sin(turn) * std::cos(kDown),
                      std::sin(kDown));
    const Vector3 middle(0.0, 0.0, 0.03);
    views.push_back(
        render_depth(test::camera_at(middle + kDistance * way, middle), shown, kTable, {}, random));
  }
  return views;
}

}  // namespace prehend::bench
