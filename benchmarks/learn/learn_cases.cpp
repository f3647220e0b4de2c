#include "benchmarks/learn/learn_cases.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planner/plan/learn/grasp_features.h"
#include "primitives/decompose.h"
#include "primitives/thin_parts.h"
#include "sim/base/random.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/shape/object_generator.h"
#include "sim/trial/trial_options.h"

namespace prehend::bench {
namespace {

bool is_object_file(const std::filesystem::path& file) {
  return file.extension() == ".obj" || file.extension() == ".stl";
}

Scene scene_as_it_is(const LearnObject& object, const std::string& hand) {
  if (!object.file.empty()) return load_scene(object.file, {.hand = hand});
  return make_scene(
      make_graspable(object.name, generate_object(object.name, 3000), Material::plastic), hand);
}

TriangleMesh stretched(TriangleMesh mesh, const std::string& name, int variant) {
  std::uint64_t seed = static_cast<std::uint64_t>(variant);
  for (const char c : name) seed = seed * 31U + static_cast<unsigned char>(c);
  Random random(seed);
  constexpr double kSize = 1.6;
  constexpr double kStretch = 1.35;
  const double size = std::pow(kSize, random.uniform(-1.0, 1.0));
  Vector3 scale;
  for (double& along : scale) along = size * std::pow(kStretch, random.uniform(-1.0, 1.0));
  for (Vector3& vertex : mesh.vertices) vertex = vertex.cwiseProduct(scale);
  return mesh;
}

CompiledScene scene_of(const LearnObject& object, const std::string& hand, int variant) {
  Scene scene = scene_as_it_is(object, hand);
  if (variant == 0) return compile(std::move(scene));
  return compile(
      make_scene(make_graspable(object.name, stretched(scene.object.mesh, object.name, variant),
                                Material::plastic),
                 hand));
}

// As plan() finds them.
std::vector<Primitive> primitives_of(const CompiledScene& scene, std::uint64_t seed) {
  DecomposeOptions solids;
  solids.seed = seed;
  ThinPartOptions thin;
  thin.seed = seed;
  const TriangleMesh& mesh = scene.scene.object.mesh;
  std::vector<Primitive> primitives = decompose(mesh, solids).primitives;
  for (Primitive& part : find_thin_parts(scene.object().mesh, primitives, thin)) {
    primitives.push_back(std::move(part));
  }
  return primitives;
}

GraspSet set_of(const CompiledScene& scene, const SearchResult& found) {
  GraspSet set;
  set.hand = scene.scene.hand.name;
  set.feature_names = grasp_feature_names();
  for (const Trial& trial : found.trials) {
    GraspSetEntry& grasp = set.grasps.emplace_back();
    grasp.outcome = trial.outcome;
    grasp.epsilon = {trial.epsilon.lower, trial.epsilon.upper};
  }
  return set;
}

void add_features(const CompiledScene& scene, const std::vector<Primitive>& primitives,
                  const SearchResult& found, GraspSet& set) {
  const FeatureMaker maker(scene, primitives);
  for (std::size_t i = 0; i < set.grasps.size(); ++i) {
    const GraspFeatures features = maker.features(found.proposed[found.candidates[i]]);
    set.grasps[i].features.assign(features.begin(), features.end());
  }
}

}  // namespace

std::vector<LearnObject> learn_objects(const std::vector<std::filesystem::path>& folders) {
  std::vector<LearnObject> objects;
  for (const std::filesystem::path& folder : folders) {
    std::vector<LearnObject> inside;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (!is_object_file(entry.path())) continue;
      inside.push_back({entry.path().stem().string(), entry.path()});
    }
    std::sort(inside.begin(), inside.end(),
              [](const LearnObject& a, const LearnObject& b) { return a.name < b.name; });
    objects.insert(objects.end(), inside.begin(), inside.end());
  }
  for (const std::string& name : generated_object_names()) objects.push_back({name, {}});
  return objects;
}

std::optional<LearnRun> run_learn_case(const LearnObject& object, const std::string& hand,
                                       const LearnSearch& search) {
  const CompiledScene scene = scene_of(object, hand, search.variant);
  const std::vector<Primitive> primitives = primitives_of(scene, search.seed);
  SearchOptions options;
  options.trials = search.trials;
  options.learned = search.learned;
  if (!search.follow) options.local_fraction = 0.0;
  const SearchResult found =
      search_grasps(scene, primitives, {}, options, {}, {.threads = search.threads});
  if (found.trials.empty()) return std::nullopt;
  LearnRun run{object.name, hand, search.seed, set_of(scene, found), {}};
  run.set.object.file = object.file.empty() ? object.name : object.file.string();
  if (search.features) add_features(scene, primitives, found, run.set);
  run.best = best_so_far(run.set);
  return run;
}

std::vector<double> best_so_far(const GraspSet& set) {
  std::vector<double> best;
  double most = 0.0;
  for (const GraspSetEntry& grasp : set.grasps) {
    if (grasp.outcome == Outcome::stable) most = std::max(most, grasp.epsilon.lower);
    if (!is_blocked(grasp.outcome)) best.push_back(most);
  }
  return best;
}

}  // namespace prehend::bench
