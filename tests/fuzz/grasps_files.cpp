#include <cmath>

#include "planner/results/grasps_file.h"
#include "sim/base/json/json_field.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/scene_file.h"
#include "tests/fuzz/mesh_promises.h"
#include "tests/fuzz/same_json.h"
#include "tests/fuzz/untrusted_files.h"

namespace prehend::fuzz {
namespace {

CompiledScene compiled(const char* scene) {
  return compile(load_scene(PREHEND_CORPUS_DIR "/scene/" + std::string(scene)));
}

// The scene that a file asks for: one with an arm or one without. Other scenes would have to be
// compiled first, which takes longer than all the rest.
const CompiledScene& scene_of(const JsonFile& file) {
  static const CompiledScene alone = compiled("good_ball.json");
  static const CompiledScene carried = compiled("good_arm.json");
  return read_scene_reference(file).scene.find("arm") == std::string::npos ? alone : carried;
}

void check_grasp(const ScoredGrasp& grasp, const CompiledScene& scene) {
  const Trial& trial = grasp.trial;
  const Robot& hand = scene.scene.hand;
  promised(finite(trial.X_OH) && finite(grasp.candidate.X_OH), "the pose of a hand is finite");
  promised(std::abs(grasp.candidate.approach_O.norm() - 1.0) < 1e-6, "an approach is unit");
  promised(trial.dofs.size() == hand.dofs.size() && trial.joints.size() == hand.joints.size(),
           "a hand has a value for each joint");
  promised(std::isfinite(trial.epsilon.lower), "epsilon is finite");
  for (const GraspContact& contact : trial.contacts) {
    promised(std::abs(contact.point.normal.norm() - 1.0) < 1e-3, "the normal of a contact is unit");
  }
}

std::string written(const CompiledScene& scene, const GraspFile& file) {
  return grasps_json(scene, file.result, file.record);
}

}  // namespace

// What is written of the grasps reads back as the same grasps, to rounding.
void read_grasps_file(std::string_view name, const std::string& bytes) {
  const std::string path = pretended_path(name, "json");
  const JsonFile file(path, bytes);
  const CompiledScene& scene = scene_of(file);
  const GraspFile read = read_grasps(file, scene);
  promised(read.judged.size() == read.result.grasps.size(), "every grasp is judged or not");
  for (const ScoredGrasp& grasp : read.result.grasps) check_grasp(grasp, scene);
  promised(given_candidates(read, scene).size() == read.result.grasps.size(),
           "every grasp becomes a candidate");
  const std::string text = written(scene, read);
  promised(same_but_rounded(written(scene, read_grasps(JsonFile(path, text), scene)), text),
           "grasps read back as written");
}

}  // namespace prehend::fuzz
