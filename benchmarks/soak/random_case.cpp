#include "benchmarks/soak/random_case.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "benchmarks/soak/random_object.h"
#include "sim/scene/make_scene.h"
#include "sim/shape/basic_shapes.h"

namespace prehend::soak {
namespace {

constexpr std::array<const char*, 4> kHands = {"barrett", "franka_hand", "parallel_jaw",
                                               "parallel_jaw_wide"};
constexpr double kTableHeight = 0.72;  // as in the library's scenes [m]

// Neighbouring numbers give unlike seeds (the finaliser of SplitMix64, Steele et al. 2014).
std::uint64_t mixed(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15U;
  value = (value ^ (value >> 30U)) * 0xbf58476d1ce4e5b9U;
  value = (value ^ (value >> 27U)) * 0x94d049bb133111ebU;
  return value ^ (value >> 31U);
}

// Friction of the object with all materials: that of the table, or any.
void choose_friction(Random& random, test::KnownScene& known) {
  const Material object = known.scene.object.material;
  const bool any = random.index(2) == 0;
  for (const Material material : kAll<Material>) {
    const std::string name(name_of(material));
    if (any) {
      // Some are slippery, or nearly so.
      const double low = random.index(8) == 0 ? 0.0 : 0.1;
      known.friction[name] = random.uniform(low, random.index(8) == 0 ? 0.02 + low : 1.5);
      known.scene.friction.set(object, material, known.friction[name]);
    } else {
      known.friction[name] = known.scene.friction.between(object, material);
    }
  }
}

// A table under the object, which stands or lies on it in any pose, and blocks around it.
void add_table(Random& random, Scene& scene, const Vector3& at) {
  const Matrix3 turn = random.index(2) == 0
                           ? Matrix3(Eigen::AngleAxisd(random.uniform(0.0, 6.28), Vector3::UnitZ()))
                           : random.rotation();
  const Bounds lying = bounds(transformed(scene.object.mesh, pose_from(turn, Vector3::Zero())));
  const Vector3 foot(lying.center().x(), lying.center().y(), lying.lower.z());
  scene.object.X_WO = pose_from(turn, at + Vector3(0.0, 0.0, 1e-4) - foot);
  add_obstacle(scene, "table", make_box({0.7, 1.2, 0.03}),
               translation(at + Vector3(0.09, 0.0, -0.015)));
  const double reach = 0.5 * lying.size().head<2>().norm();
  const int blocks = random.integer(0, 3);
  for (int i = 0; i < blocks; ++i) {
    const double angle = random.uniform(0.0, 6.28);
    const Vector3 size = random.in_box({0.02, 0.02, 0.03}, {0.08, 0.08, 0.25});
    const double away = reach + size.head<2>().norm() / 2.0 + random.uniform(0.005, 0.2);
    const Vector3 place =
        at + Vector3(away * std::cos(angle), away * std::sin(angle), 0.5 * size.z() + 1e-4);
    add_obstacle(scene, "block " + std::to_string(i), make_box(size),
                 pose_from(Matrix3(Eigen::AngleAxisd(angle, Vector3::UnitZ())), place));
  }
}

TrialOptions trial_options(Random& random) {
  TrialOptions options;
  options.contacts = random.index(3) > 0 ? ContactKind::soft : ContactKind::hard;
  if (random.index(3) == 0) options.cone_edges = random.integer(3, 12);
  if (random.index(4) == 0) options.settle.steps = random.integer(0, 30);
  if (random.index(4) == 0) options.back_off_tries = random.integer(0, 5);
  if (random.index(4) == 0) options.back_off_step = random.uniform(1e-3, 2e-2);
  if (random.index(4) == 0) options.contact.threshold = random.uniform(5e-5, 5e-4);
  options.contact_gap = options.contact.threshold * 0.5;
  if (random.index(4) == 0) {
    options.contact_gap = options.contact.threshold * random.uniform(0.05, 0.9);
  }
  if (random.index(4) == 0) options.contact.max_region_corners = random.integer(3, 12);
  return options;
}

PlanOptions plan_options(Random& random, bool has_arm) {
  PlanOptions options;
  options.seed = mixed(random.index(1000000)) >> 1U;
  options.rank.top = random.integer(1, has_arm ? 3 : 6);
  options.search.trials = has_arm ? random.integer(50, 200) : random.integer(20, 200);
  if (random.index(4) == 0) options.primitives.max_primitives = random.integer(1, 20);
  if (random.index(4) == 0) options.primitives.tolerance = random.uniform(0.005, 0.2);
  if (random.index(4) == 0) options.candidates.start_clearance = random.uniform(0.0, 0.05);
  if (random.index(6) == 0) options.sections = 1;
  options.trial = trial_options(random);
  if (has_arm && random.index(3) > 0) {
    options.paths.emplace();
    options.paths->transfer.planner = kAll<PathPlanner>[random.index(random.index(3) + 1)];
    options.paths->transfer.max_iterations = random.integer(100, 600);
  }
  return options;
}

std::string words_of(const RandomCase& made, const std::string& object, const std::string& hand) {
  const Scene& scene = made.known.scene;
  std::string words = object + " of " + std::string(name_of(scene.object.material)) + ", ";
  words += hand + (scene.carrier ? " on an arm" : "");
  if (!scene.obstacles.empty())
    words += ", " + std::to_string(scene.obstacles.size()) + " obstacles";
  words += ", " + std::string(name_of(made.options.trial.contacts));
  words += ", " + std::to_string(made.options.trial.cone_edges) + " edges";
  if (made.options.paths) {
    words += ", " + std::string(name_of(made.options.paths->transfer.planner));
  }
  return words;
}

}  // namespace

RandomCase random_case(std::uint64_t seed, std::uint64_t number) {
  Random random(mixed(mixed(seed) + number));
  RandomCase made;
  made.seed = number;
  const RandomObject object = random_object(random);
  const Material material = kAll<Material>[random.index(kAll<Material>.size())];
  const bool has_arm = random.index(4) == 0;
  // The arm with its own hand reaches most.
  const std::string hand =
      kHands[random.index(has_arm && random.index(2) == 0 ? 1 : kHands.size())];
  Scene& scene = made.known.scene;
  scene = make_scene(make_graspable("object", object.mesh, material), hand);
  made.known.solid = object.solid;
  choose_friction(random, made.known);
  const Vector3 at = random.in_box({0.45, -0.25, kTableHeight}, {0.7, 0.25, kTableHeight});
  if (has_arm) {
    mount(scene, "puma560_barrett", translation({0.0, 0.0, 0.6868}), hand);
    add_table(random, scene, at);
  } else if (random.index(3) == 0) {
    add_table(random, scene, at);
  } else {
    scene.object.X_WO = random.pose(0.5);
  }
  made.options = plan_options(random, has_arm);
  made.known.options = made.options.trial;
  made.twice = random.index(10) == 0;
  made.words = words_of(made, object.words, hand);
  return made;
}

}  // namespace prehend::soak
