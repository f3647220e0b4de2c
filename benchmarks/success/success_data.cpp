// Grasps of random objects with what is known of them and what became of them when they were
// carried out in simulation: the data from which SuccessModel (sim/trial/success.h) is made.
//
//   success_data [--objects N] [--seed S] [--meshes FOLDER] [--hand NAME] > success.csv
//
// For each of N objects (40) and each hand of the library, or one of them: two of the best grasps
// of a plan, each also moved by up to 2 cm and turned by up to 30 degrees, evaluated with errors of
// half, one and two times the default, and carried out four times with other errors of that size.
// The object stands on a table for half of them, and floats for the others. The second moved grasp
// states no approach. With --meshes, the objects are the OBJ files of a folder.
#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "benchmarks/shake/on_table.h"
#include "benchmarks/soak/random_object.h"
#include "benchmarks/success/executions.h"
#include "planner/plan/plan.h"
#include "planner/plan/plan_options.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/make_scene.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/object_generator.h"
#include "sim/trial/success.h"

namespace prehend::bench {
namespace {

constexpr std::array kHands = {"franka_hand", "barrett", "robotiq_2f85", "robotiq_3f",
                               "allegro",     "dlr",     "parallel_jaw", "parallel_jaw_wide",
                               "robonaut",    "rutgers", "shadow_like"};
constexpr int kExecutions = 4;

struct NamedMesh {
  std::string name;
  TriangleMesh mesh;
};

// Neither too small nor too large for these hands: half of all dimensions are.
bool is_graspable(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3& vertex : mesh.vertices) box.extend(vertex);
  const Vector3 size = box.sizes();
  return size.minCoeff() > 0.01 && size.minCoeff() < 0.08 && size.maxCoeff() < 0.3;
}

std::vector<NamedMesh> random_meshes(int count, Random& random) {
  std::vector<NamedMesh> meshes;
  const std::vector<std::string> generated = generated_object_names();
  while (static_cast<int>(meshes.size()) < count) {
    // Every fourth is one of the generator's household objects, as long as there are any left.
    const std::size_t next = meshes.size() / 4;
    if (meshes.size() % 4 == 3 && next < generated.size()) {
      meshes.push_back({generated[next], generate_object(generated[next], 2000)});
      continue;
    }
    soak::RandomObject object = soak::random_object(random);
    if (!object.solid || !is_graspable(object.mesh)) continue;
    meshes.push_back({"random " + std::to_string(meshes.size()), std::move(object.mesh)});
  }
  return meshes;
}

std::vector<NamedMesh> meshes_in(const std::filesystem::path& folder) {
  std::vector<NamedMesh> meshes;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".obj") continue;
    meshes.push_back({entry.path().stem().string(), load_mesh(entry.path()).mesh});
  }
  std::sort(meshes.begin(), meshes.end(),
            [](const NamedMesh& a, const NamedMesh& b) { return a.name < b.name; });
  return meshes;
}

// Two of the best: the first, and any other, which may have become something quite different.
std::vector<Candidate> two_of(const std::vector<ScoredGrasp>& grasps, Random& random) {
  std::vector<Candidate> two;
  if (!grasps.empty()) two.push_back(grasps.front().candidate);
  if (grasps.size() > 1) {
    const int last = static_cast<int>(grasps.size()) - 1;
    two.push_back(grasps[index(random.integer(1, last))].candidate);
  }
  return two;
}

// The grasp with its hand moved and turned at random about the point between its fingers.
Candidate moved(Candidate grasp, const Hand& hand, Random& random) {
  const Vector3 grip_H = hand.origin;
  const Vector3 grip_O = grasp.X_OH * grip_H;
  const double angle = random.uniform(0.0, 0.52);
  const Matrix3 turn = Eigen::AngleAxisd(angle, random.direction()).toRotationMatrix();
  grasp.X_OH.linear() = turn * grasp.X_OH.linear();
  grasp.X_OH.translation() = grip_O - grasp.X_OH.linear() * grip_H + random.vector(0.0, 0.02);
  grasp.approach_O = turn * grasp.approach_O;
  return grasp;
}

std::vector<Candidate> grasps_to_judge(const CompiledScene& scene, Random& random) {
  PlanOptions options;
  options.search.trials = 200;
  options.rank.top = 8;
  options.free_closing = 0;
  options.volumes = false;
  std::vector<Candidate> grasps;
  for (const Candidate& grasp : two_of(plan(scene, options).grasps, random)) {
    grasps.push_back(grasp);
    for (int i = 0; i < 2; ++i) grasps.push_back(moved(grasp, *scene.scene.hand.hand, random));
    grasps.back().approach_distance = 0.0;
  }
  return grasps;
}

UncertaintyOptions scaled(double by) {
  UncertaintyOptions options;
  for (double* value : {&options.across, &options.along, &options.angle, &options.hand,
                        &options.hand_angle, &options.friction, &options.center_of_mass}) {
    *value *= by;
  }
  return options;
}

// What of the grasps of an object is varied.
struct Setting {
  std::string hand;
  double errors = 1.0;  // times the default
  double mass = 0.3;    // kg
  bool on_table = false;
};

void write_rows(const NamedMesh& object, const Setting& setting, Random& random) {
  Scene made = make_scene(make_graspable(object.name, object.mesh, Material::plastic, setting.mass),
                          setting.hand);
  if (setting.on_table) put_on_table(made);
  const CompiledScene scene = compile(std::move(made));
  EvaluateOptions options;
  options.robustness = true;
  options.uncertainty = scaled(setting.errors);
  options.volumes = 0;
  const PlanResult result = evaluate(scene, grasps_to_judge(scene, random), options);
  UncertaintyOptions errors = options.uncertainty;
  errors.samples = kExecutions;
  const std::vector<Executions> executions =
      execute_grasps(scene, options.trial, perturbations(scene, errors, 77), result);
  for (std::size_t i = 0; i < executions.size(); ++i) {
    const ScoredGrasp& grasp = result.grasps[i];
    if (!grasp.robustness) continue;
    const SuccessFacts facts = success_facts(*grasp.robustness);
    std::printf("%s,%s,%s,%s,%g,%g,%d,%d,%.6g,%.6g,%.6g,%.6g,", object.name.c_str(),
                setting.hand.c_str(), setting.on_table ? "table" : "none",
                std::string(name_of(grasp.trial.outcome)).c_str(), setting.errors, setting.mass,
                executions[i].tried, executions[i].lifted, facts.closed, facts.held, facts.epsilon,
                facts.strength);
    if (facts.free) {
      std::printf("%d,%.6g,%.6g,%.6g\n", facts.free->kept ? 1 : 0, facts.free->epsilon,
                  facts.free->strength, facts.free->moved);
    } else {
      std::printf(",,,\n");
    }
  }
  std::fflush(stdout);
}

struct Arguments {
  int objects = 40;
  std::uint64_t seed = 1;
  std::filesystem::path meshes;
  std::string hand;  // empty: all
};

Arguments arguments_of(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    if (i + 1 == argc) throw InputError({.field = name, .problem = "needs a value"});
    if (name == "--objects") {
      arguments.objects = std::stoi(argv[i + 1]);
    } else if (name == "--seed") {
      arguments.seed = std::stoull(argv[i + 1]);
    } else if (name == "--meshes") {
      arguments.meshes = argv[i + 1];
    } else if (name == "--hand") {
      arguments.hand = argv[i + 1];
    } else {
      throw InputError(
          {.field = name, .problem = "is not known: --objects, --seed, --meshes, --hand"});
    }
  }
  return arguments;
}

void run(const Arguments& arguments) {
  Random random(arguments.seed);
  const std::vector<NamedMesh> meshes = arguments.meshes.empty()
                                            ? random_meshes(arguments.objects, random)
                                            : meshes_in(arguments.meshes);
  constexpr std::array kSizes = {0.5, 1.0, 2.0};
  constexpr std::array kMasses = {0.1, 0.3, 1.0};
  std::printf(
      "object,hand,support,outcome,errors,mass,executions,lifted,closed,held,epsilon,strength,"
      "kept,free_epsilon,free_strength,moved\n");
  for (std::size_t o = 0; o < meshes.size(); ++o) {
    for (std::size_t h = 0; h < kHands.size(); ++h) {
      if (!arguments.hand.empty() && arguments.hand != kHands[h]) continue;
      const Setting setting{.hand = kHands[h],
                            .errors = kSizes[(o + h) % kSizes.size()],
                            .mass = kMasses[(o / kSizes.size() + h) % kMasses.size()],
                            .on_table = (o + h) % 2 == 1};
      // The same for one hand as among all.
      Random dice(derived_seed(arguments.seed + kHands.size() * o + h));
      try {
        write_rows(meshes[o], setting, dice);
      } catch (const InputError& error) {
        std::fprintf(stderr, "%s, %s: %s\n", meshes[o].name.c_str(), kHands[h], error.what());
      }
    }
  }
}

}  // namespace
}  // namespace prehend::bench

int main(int argc, char** argv) {
  try {
    prehend::bench::run(prehend::bench::arguments_of(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "success_data: %s\n", error.what());
    return 2;
  }
  return 0;
}
