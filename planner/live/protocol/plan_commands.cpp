#include <utility>

#include "planner/live/protocol/command.h"
#include "planner/live/protocol/session_json.h"
#include "planner/plan/accuracy.h"
#include "planner/show/exports/export_files.h"
#include "planner/show/exports/export_formats.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/joined.h"

// The commands of plans, and of what is kept to be compared.
namespace prehend {
namespace {

constexpr Range kTrials{.lower = 1.0, .upper = 1e6};
constexpr Range kTop{.lower = 1.0, .upper = 1e5};

PlanOptions options_of_plan(const JsonField& request) {
  PlanOptions options;
  if (request.has("accuracy")) {
    const JsonField field = request["accuracy"];
    const std::optional<Accuracy> accuracy = value_named<Accuracy>(field.text());
    if (!accuracy) field.fail("must be one of draft, standard, fine");
    options = plan_options(*accuracy);
  }
  if (request.has("trials")) options.search.trials = request["trials"].integer();
  if (request.has("top")) options.rank.top = request["top"].integer();
  if (request.has("paths") && request["paths"].boolean()) options.paths.emplace();
  if (request.has("approach")) {
    const JsonField field = request["approach"];
    options.candidates.approach =
        with_field_errors(field, [&] { return approach_limit(field.text()); });
  }
  if (request.has("seed")) options.seed = request["seed"].unsigned_integer();
  return options;
}

ProtocolJson plan_start(const CommandScope& scope, const JsonField& request) {
  PlanOptions options = options_of_plan(request);
  if (options.paths) (void)scope.session.require_arm();
  options.trial.contacts =
      scope.session.state().switches.soft_fingers ? ContactKind::soft : ContactKind::hard;
  scope.session.start_plan(options, scope.listener ? scope.listener() : PlanListener{});
  return {{"started", true}, {"trials", options.search.trials}};
}

ProtocolJson plan_cancel(const CommandScope& scope, const JsonField& /*request*/) {
  const std::optional<Cancellation> running = scope.session.plan_cancellation();
  if (running && scope.cancels) running->request();
  return {{"cancelled", running.has_value()}};
}

// [s]; null without a path.
ProtocolJson duration_of_path(const ScoredGrasp& grasp) {
  if (!grasp.path || grasp.path->times.empty()) return nullptr;
  return grasp.path->times.back();
}

ProtocolJson plan_results(const CommandScope& scope, const JsonField& request) {
  const int first = request.has("first") ? request["first"].integer() : 0;
  const int count =
      request.has("count") ? request["count"].integer() : std::numeric_limits<int>::max();
  const auto& results = scope.session.state().results;
  ProtocolJson list = ProtocolJson::array();
  const std::size_t size = results ? results->grasps.size() : 0;
  for (std::size_t i = index(first); i < size && list.size() < index(count); ++i) {
    ProtocolJson grasp = found_json(results->grasps[i].trial);
    grasp["volume"] =
        results->grasps[i].volume ? ProtocolJson(*results->grasps[i].volume) : ProtocolJson();
    grasp["path"] = duration_of_path(results->grasps[i]);
    list.push_back(std::move(grasp));
  }
  return {{"status", results ? ProtocolJson(name_of(results->status)) : ProtocolJson()},
          {"size", size},
          {"grasps", list}};
}

ProtocolJson plan_go(const CommandScope& scope, const JsonField& request) {
  const int grasp = request["grasp"].integer();
  scope.session.go_to(index(grasp));
  return {{"hand", hand_json(scope.session)}};
}

// The formats that can be sent: a message is text.
std::vector<std::string_view> text_formats() {
  std::vector<std::string_view> names = {"json"};
  for (const ExportFormat& format : export_formats()) {
    if (format.is_text) names.push_back(format.name);
  }
  return names;
}

// "a, b or c".
std::string one_of(std::vector<std::string_view> names) {
  const std::string last(names.back());
  names.pop_back();
  return joined(names) + " or " + last;
}

ProtocolJson plan_export(const CommandScope& scope, const JsonField& request) {
  const std::string format = request.has("format") ? request["format"].text() : "json";
  ProtocolJson files = ProtocolJson::array();
  const std::string own = scope.session.grasps_text();
  if (format == "json") {
    files.push_back({{"name", "grasps.json"}, {"text", own}});
    return {{"files", files}};
  }
  for (const ExportFormat& known : export_formats()) {
    if (known.name == format && !known.is_text) request["format"].fail("cannot be sent as text");
  }
  const SessionState& state = scope.session.state();
  const std::vector<ExportFile> made = with_field_errors(request["format"], [&] {
    return export_files(state.world->compiled(), *state.results, format);
  });
  for (const ExportFile& file : made) {
    files.push_back({{"name", file.name}, {"text", file.content}});
  }
  return {{"files", files}};
}

ProtocolJson pin_add(const CommandScope& scope, const JsonField& request) {
  scope.session.pin(request["name"].text());
  return state_json(scope.session);
}

ProtocolJson pin_go(const CommandScope& scope, const JsonField& request) {
  scope.session.go_to_pin(request["name"].text());
  return {{"hand", hand_json(scope.session)}};
}

ProtocolJson pin_remove(const CommandScope& scope, const JsonField& request) {
  scope.session.unpin(request["name"].text());
  return state_json(scope.session);
}

std::vector<Command> of_plans() {
  return {
      {"plan.start",
       CommandKind::query,
       "Begins to plan grasps of the scene as it is.",
       {{"trials", FieldType::integer, false, "candidates to try; those of the accuracy", kTrials},
        {"top", FieldType::integer, false, "grasps to keep; 10", kTop},
        {"seed", FieldType::integer, false, "of everything random, at least 0; 1", kIndex},
        {"accuracy", FieldType::text, false, "draft, standard or fine; standard"},
        {"approach", FieldType::text, false,
         "directions in which the hand may move, as of --approach: down/30deg; any"},
        {"paths", FieldType::boolean, false,
         "whether a path of the arm is planned for each, and those without one are left out; "
         "false"}},
       "`started`, and how many `trials`",
       plan_start},
      {"plan.cancel",
       CommandKind::query,
       "Ends the running plan at once. What it has found is kept; the event `plan` tells when "
       "it is "
       "there.",
       {},
       "`cancelled`, false where none runs",
       plan_cancel},
      {"plan.results",
       CommandKind::query,
       "What the last plan in this scene has found, best first.",
       {{"first", FieldType::integer, false, "number of the first, from 0; 0", kIndex},
        {"count", FieldType::integer, false, "how many at most; all", kIndex}},
       "`status`, the `size` of the whole list, and `grasps`, each with `outcome`, `epsilon`, "
       "`volume`, `X_object_hand`, `dofs` and `joints` [rad or m], and how long its `path` "
       "takes [s], "
       "null without one (`path.result` has it)",
       plan_results},
      {"plan.go",
       CommandKind::change,
       "Moves the hand to a result, through whatever is there.",
       {{"grasp", FieldType::integer, true, "its number, from 0", kIndex}},
       "`hand`",
       plan_go},
      {"plan.export",
       CommandKind::query,
       "The results as files.",
       {{"format", FieldType::text, false, one_of(text_formats()) + "; json"}},
       "`files`, each with `name` and `text`",
       plan_export}};
}

std::vector<Command> of_pins() {
  return {{"pin.add",
           CommandKind::change,
           "Keeps the hand as it is, to compare it with others.",
           {{"name", FieldType::text, true, "a name that no other pin has"}},
           "the state, as of `state`",
           pin_add},
          {"pin.go",
           CommandKind::change,
           "Moves the hand to where it was pinned, through whatever is there.",
           {{"name", FieldType::text, true, "which"}},
           "`hand`",
           pin_go},
          {"pin.remove",
           CommandKind::change,
           "Forgets a pin.",
           {{"name", FieldType::text, true, "which"}},
           "the state, as of `state`",
           pin_remove}};
}

}  // namespace

std::vector<Command> plan_commands() {
  std::vector<Command> all = of_plans();
  for (Command& command : of_pins()) all.push_back(std::move(command));
  return all;
}

}  // namespace prehend
