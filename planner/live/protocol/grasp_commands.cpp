#include "planner/live/protocol/command.h"
#include "planner/live/protocol/session_json.h"
#include "sim/base/index.h"
#include "sim/base/json/json_pose.h"
#include "sim/base/range.h"

// The commands that improve the grasp in hand, and show how the robot comes to it.
namespace prehend {
namespace {

// Trials that take a second or two; those of an arm take longer.
constexpr int kRefineTrials = 200;
constexpr int kRefineTrialsOfArm = 100;

std::uint64_t seed_of(const JsonField& request) {
  return request.has("seed") ? request["seed"].unsigned_integer() : 1;
}

ProtocolJson grasp_refine(const CommandScope& scope, const JsonField& request) {
  const bool has_arm = scope.session.arm() != nullptr;
  const int usual = has_arm ? kRefineTrialsOfArm : kRefineTrials;
  const int trials = request.has("trials") ? request["trials"].integer() : usual;
  const Refined refined = scope.session.refine(trials, seed_of(request));
  const auto& outcome = scope.session.state().outcome;
  return {{"improved", refined.after > refined.before},
          {"epsilon_before", refined.before},
          {"epsilon", refined.after},
          {"trials", refined.trials},
          {"outcome", name_of(outcome.value_or(Outcome::stable))},
          {"hand", hand_json(scope.session)}};
}

}  // namespace

std::vector<Command> grasp_commands() {
  return {
      {"grasp.refine",
       CommandKind::change,
       "Improves the grasp in hand by trials of grasps close to it. It stays where none is better.",
       {{"trials", FieldType::integer, false, "how many at most, 2 to 2000; 200, with an arm 100",
         Session::kRefineTrials},
        {"seed", FieldType::integer, false, "of everything random, at least 0; 1", kIndex}},
       "`improved`, `epsilon_before` and `epsilon` (lower bounds), how many `trials`, `outcome`, "
       "and `hand`",
       grasp_refine}};
}

}  // namespace prehend
