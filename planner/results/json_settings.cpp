#include "planner/results/json_settings.h"

#include <array>
#include <string>
#include <type_traits>
#include <utility>

#include "sim/base/formatted.h"
#include "sim/base/json/json_fields.h"

namespace prehend {
namespace {

// Every option under its name (sim/base/settings.h).
template <HasSettings Options>
void option_fields(auto& fields, Options& options) {
  visit_settings(options, [&](const std::string& name, auto& value, const Range& range) {
    using Value = std::remove_cvref_t<decltype(value)>;
    fields(name, value);
    if constexpr (!std::is_enum_v<Value>) {
      fields.require(name, range.contains(static_cast<double>(value)), range.words().c_str());
    }
  });
}

// Settings that files of earlier versions have. What they said has no place in today's options.
constexpr std::array kFormerSettings = {"max_candidates", "cylinder_directions", "places",
                                        "sphere_directions", "sphere_turns"};

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
  // Says the same as "soft_fingers", in the words of the command line.
  fields.named("contacts", options.trial.soft_fingers,
               ValueNames<bool>{{"soft", true}, {"hard", false}});
  if constexpr (kReads<decltype(fields)>) {
    for (const char* name : kFormerSettings) (void)fields.allow(name);
    // The object "paths" is there where paths were planned, so its presence is a setting as well.
    if (fields.allow("paths")) options.paths.emplace();
  }
  if (options.paths) {
    fields.object("paths", [&](auto& inner) { option_fields(inner, *options.paths); });
  }
  // Not read: it is said for people, and a model cannot be found by its name.
  if constexpr (kReads<decltype(fields)>) {
    (void)fields.allow("learned");
  } else if (options.search.learned) {
    fields.derived("learned", [&] { return learned_to_json(*options.search.learned); });
  }
}

}  // namespace

nlohmann::ordered_json settings_to_json(const RunRecord& record) {
  FieldWriter fields;
  settings_fields(fields, record);
  return std::move(fields).json();
}

PlanOptions read_accuracy(const std::string& name_or_file) {
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
  // Motions end up to 10 % above the gap, and must end within the threshold.
  constexpr double kLargestGap = 0.9;
  const TrialOptions& trial = record.options.trial;
  if (!(trial.contact_gap > 0.0 && trial.contact_gap <= kLargestGap * trial.contact.threshold)) {
    root[root.has("contact_gap") ? "contact_gap" : "contact_threshold"].fail(
        "must be at most 0.9 of the contact_threshold");
  }
  return record.options;
}

void read_settings(const JsonField& field, RunRecord& record) {
  FieldReader fields(field);
  settings_fields(fields, record);
  fields.finish();
}

}  // namespace prehend
