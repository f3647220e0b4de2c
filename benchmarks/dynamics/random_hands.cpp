// Hands of the library that close on random bodies, each step judged by means that share no code
// with what made it:
//
//   random_hands [--scenes N] [--first SEED]
//
// N scenes (2000) over all hands: bodies of ordinary density and friction that float before the
// hand or fly at it. After half a second the drives let go, and no energy may come from anywhere. A
// line for each fault, a table of the hands, and a checksum of all ends: it is the same on any
// number of threads (each fourth scene is run again on one thread and compared).
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/parallel/parallel.h"
#include "sim/motion/energy.h"
#include "sim/robot/files/robot_file.h"
#include "tests/support/examine_world.h"
#include "tests/support/random_world.h"

namespace prehend::bench {
namespace {

using test::Examined;

struct Scene {
  int hand = 0;
  std::uint64_t seed = 0;
  bool made = false;
  Examined examined;
  std::uint64_t end = 0;  // checksum of where everything is
};

struct NamedHand {
  std::string name;
  std::shared_ptr<const RobotModel> model;
};

std::vector<NamedHand> library_hands() {
  std::vector<NamedHand> hands;
  for (const std::string& name : library_robot_names()) {
    const Robot robot = find_robot(name);
    if (!robot.hand || robot.hand->preshapes.empty()) continue;
    hands.push_back({name, std::make_shared<const RobotModel>(make_robot_model(robot))});
  }
  return hands;
}

std::uint64_t checksum(const World& world) {
  std::uint64_t sum = 1469598103934665603U;  // FNV-1a
  for (const Pose& X : test::WorldJudge::placement(world)) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(X.data());
    for (std::size_t i = 0; i < sizeof(double) * 16; ++i) sum = (sum ^ bytes[i]) * 1099511628211U;
  }
  return sum;
}

// Drives off, nothing gives energy: it must not grow.
std::string coast(World& world, double seconds) {
  world.robots.front().drives.clear();
  const double start = energy_of(world);
  double energy = start;
  for (double time = 0.0; time < seconds;) {
    const StepResult result = step_world(world);
    if (!(result.time > 0.0)) return std::string(name_of(result.outcome)) + " while coasting";
    time += result.time;
    const double now = energy_of(world);
    if (!(now - energy <= test::kGrowth * std::abs(start) + 1e-9)) {
      return "energy grows while coasting, from " + std::to_string(energy) + " to " +
             std::to_string(now) + " J";
    }
    energy = now;
  }
  return {};
}

void run(const std::vector<NamedHand>& hands, Scene& scene) {
  test::RandomWorld random(test::WorldKind::hand, scene.seed);
  scene.made = random.put_in_hand(hands[index(scene.hand)].model);
  if (!scene.made) return;
  World& world = random.world();
  scene.examined = test::examine(world, 0.5);
  if (scene.examined.fault.empty()) scene.examined.fault = coast(world, 0.1);
  scene.end = checksum(world);
}

void print_table(const std::vector<NamedHand>& hands, const std::vector<Scene>& scenes) {
  std::printf("%-20s %8s %8s %14s\n", "hand", "scenes", "faults", "deepest [um]");
  for (std::size_t h = 0; h < hands.size(); ++h) {
    int count = 0;
    int faults = 0;
    double deepest = 0.0;
    for (const Scene& scene : scenes) {
      if (index(scene.hand) != h || !scene.made) continue;
      ++count;
      faults += scene.examined.fault.empty() ? 0 : 1;
      deepest = std::max(deepest, scene.examined.deepest);
    }
    std::printf("%-20s %8d %8d %14.3g\n", hands[h].name.c_str(), count, faults, 1e6 * deepest);
  }
}

int examine_all(int count, std::uint64_t first) {
  const std::vector<NamedHand> hands = library_hands();
  std::vector<Scene> scenes(index(count));
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    scenes[i].hand = static_cast<int>(i % hands.size());
    scenes[i].seed = first + i;
  }
  for_each_in_parallel(scenes.size(), 0, [&](std::size_t i) { run(hands, scenes[i]); });
  std::uint64_t all = 0;
  int faults = 0;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const Scene& scene = scenes[i];
    all = all * 31 + scene.end;
    std::string fault = scene.examined.fault;
    if (fault.empty() && i % 4 == 0) {
      Scene again{.hand = scene.hand, .seed = scene.seed, .examined = {}};
      run(hands, again);
      if (again.end != scene.end) fault = "ends elsewhere on one thread";
    }
    if (fault.empty()) continue;
    ++faults;
    std::printf("%s, seed %llu: %s\n", hands[index(scene.hand)].name.c_str(),
                static_cast<unsigned long long>(scene.seed), fault.c_str());
  }
  print_table(hands, scenes);
  std::printf("checksum %016llx\n", static_cast<unsigned long long>(all));
  return faults > 0 ? 1 : 0;
}

}  // namespace
}  // namespace prehend::bench

int main(int argc, char** argv) {
  int scenes = 2000;
  std::uint64_t first = 1;
  try {
    for (int i = 1; i < argc; i += 2) {
      const std::string name = argv[i];
      if (i + 1 == argc) throw prehend::InputError({.field = name, .problem = "needs a value"});
      if (name == "--scenes") {
        scenes = std::stoi(argv[i + 1]);
      } else if (name == "--first") {
        first = std::stoull(argv[i + 1]);
      } else {
        throw prehend::InputError({.field = name, .problem = "is not known: --scenes, --first"});
      }
    }
    return prehend::bench::examine_all(scenes, first);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "random_hands: %s\n", error.what());
    return 2;
  }
}
