#include "planner/results/json_settings.h"

#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "planner/plan/learn/tree_model.h"
#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/json/json_fields.h"
#include "sim/base/require_settings.h"

namespace prehend {
namespace {

// Every option under its name (sim/base/settings.h).
template <HasSettings Options>
void option_fields(auto& fields, Options& options) {
  visit_settings(options, [&](const std::string& name, auto& value, const Setting& setting) {
    using Value = std::remove_cvref_t<decltype(value)>;
    fields(name, value);
    if constexpr (std::is_arithmetic_v<Value>) {
      fields.require(name, setting.range.contains(static_cast<double>(value)),
                     setting.range.words().c_str());
    }
  });
}

// Settings that files of earlier versions have, and that have no effect any more: what most of them
// said is a constant beside its use.
constexpr std::array kFormerSettings = {
    "max_candidates",         "cylinder_directions", "places",
    "sphere_directions",      "sphere_turns",        "duplicate_distance",
    "duplicate_angle",        "solids_first",        "curves_least",
    "patient_back_offs",      "contact_same_place",  "contact_flat_corner",
    "contact_weakest_patch",  "settle_least_part",   "settle_loosen",
    "settle_least_gain",      "settle_least_force",  "settle_least_arm",
    "max_gap_queries",        "gaps_near",           "gaps_reach",
    "gaps_least_reach",       "gaps_most_pairs",     "gaps_looseness",
    "reach_motion_gap_error", "refine_spread",       "refine_reach"};
// The same of "paths".
constexpr std::array kFormerPathSettings = {"gap_error", "motion_gap_error", "longest_edge",
                                            "lift_leave_within"};

// The order that a model gave to the candidates: by name and checksum, the model itself is a file
// of its own.
nlohmann::ordered_json learned_to_json(const LearnedOrder& order) {
  FieldWriter fields;
  fields("model", order.model->name);
  fields("checksum", formatted("%016llx", static_cast<unsigned long long>(checksum(*order.model))));
  option_fields(fields, order);
  return std::move(fields).json();
}

void settings_fields(auto& fields, auto& record) {
  auto& options = record.options;
  option_fields(fields, options);
  if constexpr (kReads<decltype(fields)>) {
    for (const char* name : kFormerSettings) (void)fields.allow(name);
    // These objects are there where paths were planned, and where the approach was limited, so
    // their presence is a setting as well.
    if (fields.allow("paths")) options.paths.emplace();
    if (fields.allow("approach")) options.candidates.approach.emplace();
  }
  if (options.candidates.approach) {
    fields.object("approach", [&](auto& inner) {
      auto& limit = *options.candidates.approach;
      option_fields(inner, limit);
      inner.require("direction", limit.direction.norm() > kShortestApproach, "must not be zero");
    });
  }
  if (options.paths) {
    fields.object("paths", [&](auto& inner) {
      option_fields(inner, *options.paths);
      if constexpr (kReads<decltype(inner)>) {
        for (const char* name : kFormerPathSettings) (void)inner.allow(name);
      }
    });
  }
  // Not read: it is said for people, and a model cannot be found by its name.
  if constexpr (kReads<decltype(fields)>) {
    (void)fields.allow("learned");
  } else if (options.search.learned) {
    fields.derived("learned", [&] { return learned_to_json(*options.search.learned); });
  }
}

// What the range of one setting does not say: whether it fits to the others.
void require_relations(const JsonField& root, const PlanOptions& options) {
  const std::optional<SettingFault> fault = setting_fault(options);
  if (!fault) return;
  if (root.has(fault->in_files)) root[fault->in_files].fail(fault->problem);
  throw InputError(
      {.file = root.file().string(), .field = fault->in_files, .problem = fault->problem});
}

std::vector<std::string> notes_on_former(const JsonField& root) {
  std::vector<std::string> notes;
  const auto note = [&](const JsonField& object, const std::string& outer, const char* name) {
    if (!object.has(name)) return;
    notes.push_back(root.file().string() + ": " + outer + name + " has no effect any more");
  };
  for (const char* name : kFormerSettings) note(root, "", name);
  if (!root.has("paths")) return notes;
  for (const char* name : kFormerPathSettings) note(root["paths"], "paths.", name);
  return notes;
}

}  // namespace

nlohmann::ordered_json settings_to_json(const RunRecord& record) {
  FieldWriter fields;
  settings_fields(fields, record);
  return std::move(fields).json();
}

PlanOptions read_accuracy(const std::string& name_or_file, std::vector<std::string>* notes) {
  if (const auto known = value_named<Accuracy>(name_or_file)) return plan_options(*known);
  const JsonFile file(name_or_file);
  const JsonField root = file.root();
  for (const char* name : {"seed", "top", "learned"}) {
    if (root.has(name)) root[name].fail("is no matter of accuracy");
  }
  FieldReader fields(root);
  Accuracy base = Accuracy::standard;
  fields("accuracy", base);
  RunRecord record;
  record.options = plan_options(base);
  settings_fields(fields, record);
  fields.finish();
  require_relations(root, record.options);
  if (notes != nullptr) *notes = notes_on_former(root);
  return record.options;
}

void read_settings(const JsonField& field, RunRecord& record) {
  FieldReader fields(field);
  settings_fields(fields, record);
  fields.finish();
}

}  // namespace prehend
