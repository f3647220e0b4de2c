#include "planner/results/datasets/acronym_file.h"
#include "planner/results/datasets/grasp_set_checks.h"
#include "planner/results/datasets/graspgen_file.h"
#include "sim/base/json/json_field.h"
#include "tests/fuzz/untrusted_files.h"

namespace prehend::fuzz {

// What is read can be written: HDF5's own library takes too long to try that here.
void read_acronym_file(std::string_view name, const std::string& bytes) {
  require_sound(read_acronym(pretended_path(name, "h5"), bytes));
}

void read_graspgen_file(std::string_view name, const std::string& bytes) {
  const JsonFile file(pretended_path(name, "json"), bytes);
  const bool told = is_graspgen(file);
  const GraspSet set = read_graspgen(file);
  promised(told, "what is read is known before");
  require_sound(set);
  const GraspSet back = read_graspgen(JsonFile("written.json", graspgen_text(set)));
  promised(back.grasps.size() == set.grasps.size(), "a set reads back as it was");
  for (std::size_t i = 0; i < set.grasps.size(); ++i) {
    promised(back.grasps[i].X_OH.matrix() == set.grasps[i].X_OH.matrix(),
             "a pose reads back as it was");
    promised(back.grasps[i].outcome == set.grasps[i].outcome, "a label reads back as it was");
  }
}

}  // namespace prehend::fuzz
