// A command of the protocol: its name, its fields and what it does. All that is known of a command
// stands in one place; dispatch, schema and documentation are made from it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "planner/live/session.h"
#include "sim/base/json/json_field.h"
#include "sim/base/range.h"

namespace prehend {

using ProtocolJson = nlohmann::ordered_json;

enum class FieldType {
  number,
  integer,
  boolean,
  text,     // not empty
  vector3,  // three numbers
  numbers,  // a list of numbers
  pose,     // {"position", "quaternion_wxyz"} (json_pose.h)
};

struct CommandField {
  std::string_view name;
  FieldType type = FieldType::number;
  bool required = false;
  std::string meaning = {};  // with unit and frame
  Range range = kAnyNumber;  // of a number, and of each in a list or a vector
};

// What a command may do.
enum class CommandKind {
  query,   // changes nothing
  change,  // changes the session; allowed while a plan runs
  world,   // changes the scene, or may: refused while a plan runs
};

// What commands are carried out on.
struct CommandScope {
  Session& session;
  // Makes the listener of a plan or a path that starts.
  std::function<PlanListener()> listener = {};
  // Whether plan.cancel and path.cancel end what runs; a recorded session says itself how that
  // ended.
  bool cancels = true;
};

struct Command {
  std::string_view name;
  CommandKind kind = CommandKind::query;
  std::string_view summary;
  std::vector<CommandField> fields;
  std::string_view result;  // what it replies, for people
  // Makes the result. Throws InputError of a field of `request`, whose fields were checked.
  ProtocolJson (*run)(const CommandScope& scope, const JsonField& request);
};

// All commands, in the order of the documentation.
const std::vector<Command>& commands();
// null where there is none of this name.
const Command* find_command(std::string_view name);

// Throws InputError unless the request has the command's required fields, no others but "id" and
// "command", and each of the right type, numbers within their ranges.
void check_fields(const Command& command, const JsonField& request);

// Parts of the table.
std::vector<Command> scene_commands();
std::vector<Command> hand_commands();
std::vector<Command> judging_commands();
std::vector<Command> plan_commands();
std::vector<Command> primitive_commands();
std::vector<Command> view_commands();
std::vector<Command> time_commands();
std::vector<Command> move_commands();
std::vector<Command> grasp_commands();
std::vector<Command> path_commands();

// The field of a request that names a gesture (Gesture), and what it says.
CommandField gesture_field();
std::optional<int> gesture_of(const JsonField& request);

}  // namespace prehend
