#include <cmath>

#include "planner/show/validation/executed_grasps_file.h"
#include "planner/show/validation/ranking.h"
#include "sim/base/json/json_field.h"
#include "sim/scene/scene_file.h"
#include "tests/fuzz/mesh_promises.h"
#include "tests/fuzz/untrusted_files.h"

namespace prehend::fuzz {

// The objects are always the same one, under the name "ball": others would have to be compiled
// first, which takes longer than all the rest.
void read_executed_grasps_file(std::string_view name, const std::string& bytes) {
  static const CompiledScene ball = compile(load_scene(PREHEND_CORPUS_DIR "/scene/good_ball.json"));
  const JsonFile file(pretended_path(name, "json"), bytes);
  const ExecutedGrasps truth = read_executions(file, {{"ball", ball}});
  const std::vector<Label> labels = truth.labels();
  promised(weights_of(labels).size() == truth.executions.size(), "each execution has a weight");
  for (const Execution& execution : truth.executions) {
    const Candidate& grasp = execution.grasp;
    promised(finite(grasp.X_OH), "the pose of a hand is finite");
    promised(std::abs(grasp.approach_O.norm() - 1.0) < 1e-6, "an approach is unit");
    promised(grasp.preshape.has_value() || grasp.dofs.size() == ball.scene.hand.dofs.size(),
             "a hand has a preshape or a value for each degree of freedom");
    promised(execution.label.object == 0, "objects are those that are given");
    promised(execution.label.session < static_cast<int>(truth.sessions.size()),
             "sessions have names");
  }
}

}  // namespace prehend::fuzz
