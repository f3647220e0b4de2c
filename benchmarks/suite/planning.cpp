#include "benchmarks/suite/planning.h"

#include "sim/scene/make_scene.h"
#include "sim/shape/object_generator.h"

namespace prehend::bench {
std::vector<AccuracySetting> accuracy_settings() {
  std::vector<AccuracySetting> settings;
  for (const Accuracy accuracy : kAll<Accuracy>) {
    settings.push_back({std::string(name_of(accuracy)), plan_options(accuracy)});
  }
  return settings;
}

AccuracySetting standard_setting() { return {kDefaultSetting, {}}; }

int default_trials() { return SearchOptions{}.trials; }

PlanOptions options_of(const AccuracySetting& setting, int trials, std::uint64_t seed) {
  PlanOptions options = setting.options;
  options.seed = seed;
  options.search.trials = trials;
  return options;
}

std::vector<ScoredGrasp> best_grasps(const CompiledScene& scene, int trials, int most) {
  PlanOptions options = options_of(standard_setting(), trials, 1);
  options.rank.top = most;
  return plan(scene, options).grasps;
}

CompiledScene object_scene(const std::string& object, int triangles, const std::string& hand) {
  return compile(make_scene(
      make_graspable(object, generate_object(object, triangles), Material::plastic), hand));
}

std::vector<Primitive> primitives_of(const CompiledScene& scene) {
  if (!scene.scene.primitives.empty()) return scene.scene.primitives;
  return decompose(scene.scene.object.mesh).primitives;
}

std::vector<Candidate> propose(const CompiledScene& scene, const std::vector<Primitive>& primitives,
                               int count) {
  const Proposals proposals = propose_grasps(scene, primitives, static_cast<std::size_t>(count));
  std::vector<Candidate> candidates;
  for (const ProposedGrasp& grasp : proposals.grasps) candidates.push_back(grasp.candidate);
  return candidates;
}

std::vector<Candidate> propose(const CompiledScene& scene, int count) {
  return propose(scene, primitives_of(scene), count);
}

}  // namespace prehend::bench
