#include "planner/files/json_settings.h"

#include <array>
#include <string>
#include <type_traits>
#include <utility>

#include "sim/json/json_fields.h"

namespace prehend {
namespace {

// Every option under its name (sim/base/settings.h).
template <HasSettings Options>
void option_fields(auto& fields, Options& options) {
  visit_settings(options, [&](const std::string& name, auto& value) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, PathPlanner>) {
      fields.named(name, value, value_names(kPathPlanners, path_planner_name));
    } else if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, RefineObjective>) {
      fields.named(name, value, value_names(kRefineObjectives, refine_objective_name));
    } else {
      fields(name, value);
    }
  });
}

// Settings that files of earlier versions have. What they said has no place in today's options.
constexpr std::array kFormerSettings = {"max_candidates", "cylinder_directions", "places",
                                        "sphere_directions", "sphere_turns"};

void settings_fields(auto& fields, auto& record) {
  auto& options = record.options;
  option_fields(fields, options);
  // Says the same as "soft_fingers", in the words of the command line.
  fields.named("contacts", options.trial.soft_fingers,
               ValueNames<bool>{{"soft", true}, {"hard", false}});
  if constexpr (kReads<decltype(fields)>) {
    for (const char* name : kFormerSettings) (void)fields.knows(name);
    // The object "paths" is there where paths were planned, so its presence is a setting as well.
    if (fields.knows("paths")) options.paths.emplace();
  }
  if (options.paths) {
    fields.object("paths", [&](auto& inner) { option_fields(inner, *options.paths); });
  }
}

}  // namespace

nlohmann::ordered_json settings_to_json(const RunRecord& record) {
  FieldWriter fields;
  settings_fields(fields, record);
  return std::move(fields).json();
}

void read_settings(const JsonField& field, RunRecord& record) {
  FieldReader fields(field);
  settings_fields(fields, record);
  fields.finish();
}

}  // namespace prehend
