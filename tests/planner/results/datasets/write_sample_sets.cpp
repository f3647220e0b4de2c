// Writes one set of grasps in all formats of data sets, for tests in other languages:
// write_sample_sets FOLDER
#include <filesystem>
#include <ostream>

#include "planner/results/datasets/acronym_file.h"
#include "planner/results/datasets/grasp_table.h"
#include "planner/results/datasets/graspgen_file.h"
#include "sim/base/output_file.h"

namespace prehend {
namespace {

// Three grasps: one that holds, of which all is known, and two that do not.
GraspSet sample_set() {
  GraspSet set;
  set.object = {.file = "meshes/Cube/cube.obj", .scale = 0.02, .density = 150.0, .friction = 1.0};
  set.object.mass = 0.25;
  set.object.volume = 0.001;
  set.object.com_O = {0.01, 0.02, 0.03};
  set.object.inertia << 1.0, 0.1, 0.2, 0.1, 2.0, 0.3, 0.2, 0.3, 3.0;
  set.hand = "panda";
  set.configuration = 0.08;
  set.dofs = {"opening"};
  set.joints = {"left", "right"};
  set.links = {"left_pad", "right_pad"};
  set.feature_names = {"distance", "width"};
  set.version = "prehend test";
  set.settings = R"({"seed": 7})";
  set.grasps.resize(3);
  GraspSetEntry& held = set.grasps.front();
  held.X_OH = translation({0.0, 0.0, -0.1});
  held.X_OH_aim = translation({0.0, 0.0, -0.09});
  held.approach_O = Vector3::UnitZ();
  held.outcome = Outcome::stable;
  held.epsilon = {0.125, 0.25};
  held.dofs = {0.02};
  held.joints = {0.02, -0.02};
  held.contacts = {{{0.02, 0.0, 0.0}, -Vector3::UnitX(), 0}, {{-0.02, 0.0, 0.0}, {1, 0, 0}, 1}};
  held.closing = ObjectShift{0.001, 0.01};
  held.features = {0.5F, 0.75F};
  set.grasps.back().outcome = Outcome::hand_blocked;
  return set;
}

void write_sample_sets(const std::filesystem::path& folder) {
  const GraspSet set = sample_set();
  write_file(folder / "sample.h5", acronym_bytes(set));
  write_file(folder / "sample.json", graspgen_text(set));
  write_file(folder / "sample.csv", [&](std::ostream& stream) {
    write_grasp_table_header(stream);
    write_grasp_table_rows(stream, "sample", set);
  });
}

}  // namespace
}  // namespace prehend

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  prehend::write_sample_sets(argv[1]);
  return 0;
}
