// The calls of the planner that the suite makes: the only place to change when they do.
#pragma once

#include <string>
#include <vector>

#include "planner/plan/accuracy.h"
#include "planner/plan/plan.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/scene_file.h"

namespace prehend::bench {

// An accuracy, by name.
struct AccuracySetting {
  std::string name;
  PlanOptions options;
};

// From the coarsest to the finest, which the others are compared with.
std::vector<AccuracySetting> accuracy_settings();

// What plan() does unless told otherwise: the name of its setting, and how many trials it makes.
inline constexpr const char* kDefaultSetting = "standard";
AccuracySetting standard_setting();
int default_trials();

// Options of a plan that makes so many trials.
PlanOptions options_of(const AccuracySetting& setting, int trials, std::uint64_t seed);

// The best grasps of a plan with so many trials, at most `most`.
std::vector<ScoredGrasp> best_grasps(const CompiledScene& scene, int trials, int most);

// A generated object of about so many triangles and a hand, ready for trials.
CompiledScene object_scene(const std::string& object, int triangles, const std::string& hand);

// The primitives of the scene's object.
std::vector<Primitive> primitives_of(const CompiledScene& scene);

// At most `count` candidates: as many as the rules give when they sample densely enough.
std::vector<Candidate> propose(const CompiledScene& scene, const std::vector<Primitive>& primitives,
                               int count);

// Both: candidates of the scene's object.
std::vector<Candidate> propose(const CompiledScene& scene, int count);

}  // namespace prehend::bench
