#include "planner/results/grasps_file.h"

#include <filesystem>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "planner/results/json_grasp.h"
#include "planner/results/json_settings.h"
#include "sim/base/index.h"
#include "sim/base/input_file.h"
#include "sim/base/json/json_field.h"
#include "sim/base/json/json_fields.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/json_primitive.h"
#include "sim/scene/json_region.h"

namespace prehend {
namespace {

using Json = nlohmann::ordered_json;

// Most functions below visit the fields of an object for a FieldWriter or a FieldReader
// (json_fields.h), so that reading and writing cannot differ. `kReads` marks the few places where
// they do. What follows from the scene is written for other readers and not read back (derived).

constexpr int kVersion = 1;

Json names_json(const Robot& robot) {
  Json dofs = Json::array();
  for (const DegreeOfFreedom& dof : robot.dofs) dofs.push_back(dof.name);
  Json joints = Json::array();
  for (const Joint& joint : robot.joints) joints.push_back(joint.name);
  return {{"name", robot.name}, {"dofs", dofs}, {"joints", joints}};
}

Json object_json(const GraspableBody& object) {
  return {{"name", object.name},
          {"material", name_of(object.material)},
          {"mass", object.mass},
          {"center_of_mass", vector_to_json(object.center_of_mass)},
          {"X_world_object", pose_to_json(object.X_WO)}};
}

Json robot_json(const CompiledArm& arm) {
  Json json = names_json(arm.robot());
  json["X_world_robot"] = pose_to_json(arm.X_WB);
  return json;
}

Json obstacles_json(const CompiledScene& scene) {
  Json names = Json::array();
  for (const PlacedBody& obstacle : scene.obstacles()) names.push_back(obstacle.name);
  return names;
}

// Only what is out of the ordinary is written: the plan ended early, or candidates were left out.
void status_fields(auto& fields, auto& result) {
  if (kReads<decltype(fields)> || result.status != PlanStatus::complete) {
    fields("status", result.status);
  }
  if (kReads<decltype(fields)> || result.untested > 0) fields("untested", result.untested);
  if (kReads<decltype(fields)> || result.families_untested > 0) {
    fields("ways", result.families);
    fields("ways_untested", result.families_untested);
  }
}

// Only scenes with regions that hands must keep out of, or with suction cups, have these outcomes.
void outcome_counts(auto& fields, auto& outcomes) {
  for (const Outcome outcome : kAll<Outcome>) {
    const bool rare = outcome == Outcome::keep_out || outcome == Outcome::no_seal;
    if (kReads<decltype(fields)> || !rare || outcomes[outcome] != 0)
      fields(name_of(outcome), outcomes[outcome]);
  }
}

void result_fields(auto& fields, auto& result) {
  status_fields(fields, result);
  fields.objects("stages", result.stages, [](auto& inner, auto& stage) {
    inner.needs("name");
    inner("name", stage.what);
    inner("count", stage.count);
  });
  fields.object("outcomes", [&](auto& inner) { outcome_counts(inner, result.outcomes); });
  fields.objects("blockers", result.blockers, [](auto& inner, auto& blocker) {
    for (const char* name : {"outcome", "link", "by"}) inner.needs(name);
    inner("outcome", blocker.outcome);
    inner("link", blocker.link);
    inner("by", blocker.by);
    inner("count", blocker.count);
  });
}

// Only of plans without a grasp.
void advice_fields(auto& fields, auto& result) {
  if (!kReads<decltype(fields)> && result.rules.empty() && result.advice.empty()) return;
  fields.objects("rules", result.rules, [](auto& inner, auto& rule) {
    inner.needs("rule");
    inner("rule", rule.rule);
    inner.object("outcomes", [&](auto& counts) { outcome_counts(counts, rule.outcomes); });
  });
  fields.objects("advice", result.advice, [](auto& inner, auto& advice) {
    for (const char* name : {"hint", "words"}) inner.needs(name);
    inner("hint", advice.hint);
    inner("words", advice.words);
  });
}

Json primitives_json(const std::vector<Primitive>& primitives) {
  Json list = Json::array();
  for (const Primitive& primitive : primitives) list.push_back(primitive_to_json(primitive));
  return list;
}

// File names may have bytes that are not UTF-8, for which dump() would throw otherwise.
std::string text_of(const Json& json) {
  return json.dump(1, ' ', false, Json::error_handler_t::replace);
}

// The text of all fields but the grasps, which come last, then the grasps one after the other: as
// JSON values, all of them together would take many times the memory of their text.
void write_with_grasps(std::ostream& stream, std::string text, const CompiledScene& scene,
                       const PlanResult& result) {
  constexpr std::string_view kEmptyList = "[]\n}";
  text.resize(text.size() - kEmptyList.size());
  const std::string open = "{\n \"grasps\": [\n";
  const std::string close = "\n ]\n}";
  stream << text << "[";
  for (const ScoredGrasp& grasp : result.grasps) {
    // Written as a list of one, so that it is indented as in the file.
    const Json one{{"grasps", Json::array({grasp_to_json(grasp, scene, result.primitives)})}};
    const std::string alone = text_of(one);
    stream << (&grasp == result.grasps.data() ? "\n" : ",\n")
           << std::string_view(alone).substr(open.size(),
                                             alone.size() - open.size() - close.size());
  }
  stream << (result.grasps.empty() ? "]\n}" : close) << "\n";
}

void read_choice(FieldReader& fields, ObjectChoice& choice) {
  fields("object", choice.object);
  if (fields.allow("keep_out")) choice.keep_out = read_regions(fields.field()["keep_out"]);
  if (fields.allow("preferred")) choice.preferred = read_regions(fields.field()["preferred"]);
  fields("apart", choice.apart);
}

void write_choice(FieldWriter& fields, const ObjectChoice& choice) {
  if (!choice.object.empty()) fields("object", choice.object);
  const auto write = [&](const char* name, const std::vector<SurfaceRegion>& regions) {
    if (!regions.empty()) fields.derived(name, [&] { return regions_to_json(regions); });
  };
  write("keep_out", choice.keep_out);
  write("preferred", choice.preferred);
  if (choice.apart > 0.0) fields("apart", choice.apart);
}

// "scene" is an object in files that prehend writes. In files of other programs it may also be a
// text, a name or a path, and "hand" may stand beside it.
void read_scene(const JsonField& root, SceneReference& reference) {
  if (root.has("scene") && root["scene"].is_text()) {
    reference.scene = root["scene"].text();
  } else if (root.has("scene")) {
    FieldReader fields(root["scene"]);
    fields("file", reference.scene);
    fields("unit", reference.unit);
    fields("hand", reference.hand);
    fields("repair", reference.repair);
    read_choice(fields, reference.choice);
    if (fields.allow("friction")) {
      reference.friction = fields.field()["friction"].number({.upper = kLargestFriction});
    }
    fields.finish();
  }
  const bool beside = reference.hand.empty() && root.has("hand") && root["hand"].is_text();
  if (beside) reference.hand = root["hand"].text();
}

void scene_field(auto& fields, auto& record) {
  if constexpr (kReads<decltype(fields)>) {
    SceneReference reference;
    // "scene" may be a text or an object and "hand" may stand beside it, which the visitor has no
    // function for. knows() makes the field a permitted one.
    (void)fields.allow("scene");
    read_scene(fields.field(), reference);
    record.scene = reference.scene;
    record.hand = reference.hand;
    if (!reference.unit.empty()) record.unit = reference.unit;
    record.repair = reference.repair;
    record.choice = std::move(reference.choice);
    record.friction = reference.friction;
  } else {
    fields.object("scene", [&](auto& inner) {
      // A scene that was made in code has no file.
      if (!record.scene.empty()) inner("file", record.scene);
      inner("unit", record.unit);
      if (!record.hand.empty()) inner("hand", record.hand);
      if (!record.repair) inner("repair", record.repair);
      write_choice(inner, record.choice);
      if (record.friction) inner("friction", *record.friction);
    });
  }
}

void settings_field(auto& fields, auto& record) {
  if constexpr (kReads<decltype(fields)>) {
    if (fields.allow("settings")) read_settings(fields.field()["settings"], record);
  } else {
    fields.derived("settings", [&] { return settings_to_json(record); });
  }
}

void file_fields(auto& fields, auto& record, auto& result, const CompiledScene& scene) {
  int version = kVersion;
  fields.named("format", version, ValueNames<int>{{"prehend grasps 1", kVersion}});
  scene_field(fields, record);
  fields.derived("object", [&] { return object_json(scene.scene.object); });
  fields.derived("hand", [&] { return names_json(scene.scene.hand); });
  // When read, the field is permitted in every scene; when written, it is there only where it means
  // something.
  if (kReads<decltype(fields)> || scene.arm) {
    fields.derived("robot", [&] { return robot_json(*scene.arm); });
  }
  if (kReads<decltype(fields)> || scene.has_obstacles()) {
    fields.derived("obstacles", [&] { return obstacles_json(scene); });
  }
  settings_field(fields, record);
  result_fields(fields, result);
  advice_fields(fields, result);
}

void read_lists(FieldReader& fields, GraspFile& file, const CompiledScene& scene) {
  const JsonField root = fields.field();
  if (fields.allow("primitives")) {
    for (const JsonField& field : root["primitives"].items()) {
      file.result.primitives.push_back(read_primitive(field));
    }
  }
  fields.needs("grasps");
  (void)fields.allow("grasps");
  // Primitives come first: grasps refer to them by index.
  for (const JsonField& field : root["grasps"].items()) {
    ReadGrasp read = read_grasp(field, scene, file.result.primitives);
    file.result.grasps.push_back(std::move(read.grasp));
    file.judged.push_back(read.judged);
  }
}

}  // namespace

void write_grasps(std::ostream& stream, const CompiledScene& scene, const PlanResult& result,
                  const RunRecord& record) {
  FieldWriter fields;
  file_fields(fields, record, result, scene);
  fields.derived("primitives", [&] { return primitives_json(result.primitives); });
  fields.derived("grasps", [] { return Json::array(); });
  write_with_grasps(stream, text_of(std::move(fields).json()), scene, result);
}

std::string grasps_json(const CompiledScene& scene, const PlanResult& result,
                        const RunRecord& record) {
  std::ostringstream stream;
  write_grasps(stream, scene, result, record);
  return std::move(stream).str();
}

SceneReference read_scene_reference(const JsonFile& file) {
  SceneReference reference;
  read_scene(file.root(), reference);
  // A path that is relative to the grasp file is preferred to one that is relative to the working
  // directory, and to a library scene of that name.
  const std::filesystem::path beside = file.path().parent_path() / reference.scene;
  if (!reference.scene.empty() && is_there(beside)) {
    reference.scene = beside.string();
  }
  return reference;
}

GraspFile read_grasps(const JsonFile& file, const CompiledScene& scene) {
  GraspFile read;
  FieldReader fields(file.root());
  file_fields(fields, read.record, read.result, scene);
  read_lists(fields, read, scene);
  fields.finish();
  return read;
}

std::vector<Candidate> given_candidates(const GraspFile& file, const CompiledScene& scene) {
  std::vector<Candidate> candidates;
  for (const ScoredGrasp& grasp : file.result.grasps) {
    Candidate candidate = grasp.candidate;
    candidate.approach_O = candidate.X_OH.linear() * scene.scene.hand.hand->approach;
    // The hand is placed at the pose and closes there. Without an approach it does not back off
    // either.
    candidate.approach_distance = 0.0;
    candidates.push_back(std::move(candidate));
  }
  return candidates;
}

}  // namespace prehend
