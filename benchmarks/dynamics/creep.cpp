// How fast what is held slips through a grip that friction holds for good: a capsule of 45 g
// between two pads with a friction of 0.7, pressed with 12 to 60 N, here and in MuJoCo, whose
// friction is regularised. It holds up to 17 to 84 N of weight, and has 0.44 N.
//
//   creep
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mujoco/mujoco.h>
#include <stdexcept>
#include <string>
#include <unistd.h>

#include "sim/motion/rigid_motion.h"
#include "sim/motion/step_world.h"
#include "sim/motion/world.h"
#include "sim/robot/files/robot_file.h"
#include "sim/shape/loft.h"

namespace prehend::bench {
namespace {

constexpr double kMass = 0.045;  // kg
constexpr double kFriction = 0.7;
constexpr double kRadius = 0.0125;  // m
constexpr double kHalf = 0.02;      // of the line between the caps [m]
constexpr double kStart = 1.0;      // when it is looked at first [s]
constexpr double kSeconds = 5.0;    // for how long

// The jaw points down, its plates hold the capsule, which lies across, in their middle.
World capsule_in_jaw(double force) {
  World world;
  for (const Material a : kAll<Material>) {
    for (const Material b : kAll<Material>) world.laws.friction.set(a, b, kFriction);
  }
  const TriangleMesh mesh = make_capsule({0.0, -kHalf, 0.0}, {0.0, kHalf, 0.0}, kRadius, 48);
  WorldBody capsule{"capsule", make_collision_body("capsule", mesh, true)};
  capsule.inertial = inertial_of_mass(mesh, kMass);
  world.bodies.push_back(std::move(capsule));
  const auto model =
      std::make_shared<const RobotModel>(make_robot_model(find_robot("parallel_jaw")));
  Matrix3 down;
  down << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  const double open = kRadius + 1e-4;
  WorldRobot jaw = make_world_robot("jaw", model, pose_from(down, {0.0, 0.0, 0.04}), {open, open});
  for (int d = 0; d < 2; ++d) {
    jaw.drives.push_back({.dof = d, .target_rate = -0.05, .holds_rate = true, .max_effort = force});
  }
  world.robots.push_back(std::move(jaw));
  return world;
}

// m/s downwards.
double own_creep(double force, double step) {
  World world = capsule_in_jaw(force);
  const auto run = [&](double seconds) {
    for (double time = 0.0; time < seconds - 1e-9;) {
      const StepResult result = step_world(world, {.step = step});
      if (!(result.time > 0.0)) throw std::runtime_error("a step failed");
      time += result.time;
    }
    return world.bodies[0].motion.X_WB.translation().z();
  };
  const double before = run(kStart);
  return (before - run(kSeconds)) / kSeconds;
}

std::string mjcf(const char* cone) {
  const auto number = [](double value) { return std::to_string(value); };
  const auto pad = [&](const char* name, double x, double way) {
    return std::string("<body name='") + name + "' pos='" + number(x) + " 0 0'><joint name='" +
           name + "' type='slide' axis='" + number(way) +
           " 0 0' damping='5'/><geom type='box' size='.005 .02 .04' mass='.09' friction='" +
           number(kFriction) + "'/></body>";
  };
  const double at = kRadius + 1e-4 + 0.005;
  return std::string("<mujoco><option timestep='0.002' cone='") + cone + "'/><worldbody>" +
         pad("left", -at, 1.0) + pad("right", at, -1.0) +
         "<body name='capsule'><freejoint/><geom type='capsule' euler='90 0 0' size='" +
         number(kRadius) + " " + number(kHalf) + "' mass='" + number(kMass) + "' friction='" +
         number(kFriction) +
         "'/></body></worldbody><actuator><motor joint='left'/>"
         "<motor joint='right'/></actuator></mujoco>";
}

struct FreeModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};

double mujoco_creep(double force, const char* cone) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("creep_" + std::to_string(getpid()) + ".xml");
  std::ofstream(file) << mjcf(cone);
  std::array<char, 1000> error{};
  const std::unique_ptr<mjModel, FreeModel> model(
      mj_loadXML(file.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
  std::filesystem::remove(file);
  if (!model) throw std::runtime_error(error.data());
  const std::unique_ptr<mjData, FreeModel> data(mj_makeData(model.get()));
  const int capsule = mj_name2id(model.get(), mjOBJ_BODY, "capsule");
  const auto run = [&](double until) {
    while (data->time < until) {
      data->ctrl[0] = force;
      data->ctrl[1] = force;
      mj_step(model.get(), data.get());
    }
    return data->xpos[3 * capsule + 2];
  };
  const double before = run(kStart);
  return (before - run(kStart + kSeconds)) / kSeconds;
}

std::string text_of(double creep) {
  if (creep * kSeconds > 2.0 * kRadius) return "fell";
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.3g um/s", 1e6 * creep);
  return text.data();
}

void print_table() {
  std::printf("MuJoCo %s, steps of 2 ms\n", mj_versionString());
  std::printf("%10s %18s %18s %18s %18s\n", "force [N]", "here, 2 ms", "here, 0.5 ms",
              "MuJoCo, pyramidal", "MuJoCo, elliptic");
  for (const double force : {12.0, 24.0, 36.0, 48.0, 60.0}) {
    std::printf("%10.0f %18s %18s %18s %18s\n", force, text_of(own_creep(force, 2e-3)).c_str(),
                text_of(own_creep(force, 5e-4)).c_str(),
                text_of(mujoco_creep(force, "pyramidal")).c_str(),
                text_of(mujoco_creep(force, "elliptic")).c_str());
  }
}

}  // namespace
}  // namespace prehend::bench

int main() {
  try {
    prehend::bench::print_table();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "creep: %s\n", error.what());
    return 2;
  }
  return 0;
}
