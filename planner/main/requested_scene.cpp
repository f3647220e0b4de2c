#include "planner/main/requested_scene.h"

#include <iostream>
#include <utility>

#include "planner/main/print_notes.h"
#include "planner/results/datasets/set_scene.h"
#include "planner/results/json_settings.h"
#include "primitives/decompose.h"
#include "sim/base/input_error.h"
#include "sim/base/json/json_field.h"
#include "sim/manipulation/test_procedure_file.h"
#include "sim/scene/object_friction.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"

namespace prehend {

LoadedScene load_asked_scene(const JsonFile& grasps, const SceneReference& command_line) {
  SceneReference asked = read_scene_reference(grasps);
  if (!command_line.scene.empty()) asked.scene = command_line.scene;
  if (!command_line.hand.empty()) asked.hand = command_line.hand;
  if (!command_line.unit.empty()) asked.unit = command_line.unit;
  if (asked.scene.empty()) {
    throw InputError({grasps.path().string(), "scene", "missing; name it there or with --scene"});
  }
  RunRecord record;
  record.repair = asked.repair && command_line.repair;
  record.hand = asked.hand;
  record.scene = scene_reference(asked.scene);
  record.choice = asked.choice;
  record.friction = command_line.friction ? command_line.friction : asked.friction;
  Scene loaded = load_scene(asked.scene, {.hand = record.hand,
                                          .unit = asked.unit,
                                          .repair = record.repair,
                                          .choice = record.choice,
                                          .friction = record.friction});
  record.unit = unit_of_source(asked.scene, loaded);
  print_notes(loaded);
  return {compile(std::move(loaded)), record};
}

LoadedScene load_asked_scene(const GraspSet& set, const std::filesystem::path& file,
                             const SceneReference& command_line,
                             const std::filesystem::path& scaled) {
  SetScene loaded = load_set_scene(
      set, file, {command_line.scene, command_line.hand, command_line.unit, command_line.repair});
  RunRecord record;
  record.repair = command_line.repair;
  record.hand = loaded.hand;
  record.unit = loaded.scaled ? "m" : loaded.unit;
  record.scene = loaded.scaled ? std::filesystem::absolute(scaled).lexically_normal().string()
                               : scene_reference(loaded.source);
  record.friction = command_line.friction;
  if (record.friction) set_object_friction(loaded.scene, *record.friction);
  print_notes(loaded.scene);
  return {compile(std::move(loaded.scene)), record};
}

std::optional<TestProcedure> requested_test_procedure(const std::string& name_or_file) {
  if (name_or_file.empty()) return {};
  return read_test_procedure(find_test_procedure(name_or_file));
}

PlanOptions requested_accuracy(const std::string& name_or_file) {
  std::vector<std::string> notes;
  PlanOptions options = read_accuracy(name_or_file, &notes);
  for (const std::string& note : notes) std::cerr << "note: " << on_one_line(note) << "\n";
  return options;
}

ApproachLimit requested_approach(const std::string& words) {
  try {
    return approach_limit(words);
  } catch (const InputError& error) {
    throw error.about("--approach");
  }
}

double requested_tolerance(const TriangleMesh& object, double millimetres) {
  try {
    return relative_tolerance(object, 1e-3 * millimetres);
  } catch (const InputError& error) {
    throw error.about("--primitive-tolerance");
  }
}

}  // namespace prehend
