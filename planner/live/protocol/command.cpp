#include "planner/live/protocol/command.h"

#include <algorithm>
#include <iterator>

#include "sim/base/json/json_pose.h"

namespace prehend {
namespace {

void check_field(const JsonField& field, const CommandField& declared) {
  switch (declared.type) {
    case FieldType::number:
      (void)field.number(declared.range);
      return;
    case FieldType::integer:
      (void)field.integer();
      (void)field.number(declared.range);
      return;
    case FieldType::boolean:
      (void)field.boolean();
      return;
    case FieldType::text:
      (void)field.text();
      return;
    case FieldType::vector3:
      (void)field.vector3(declared.range);
      return;
    case FieldType::numbers:
      (void)field.numbers(field.items().size(), declared.range);
      return;
    case FieldType::pose:
      (void)read_pose(field);
      return;
  }
}

}  // namespace

const std::vector<Command>& commands() {
  static const std::vector<Command> known = [] {
    std::vector<Command> all;
    for (auto part : {scene_commands(), move_commands(), hand_commands(), judging_commands(),
                      grasp_commands(), path_commands(), plan_commands(), primitive_commands(),
                      view_commands(), time_commands()}) {
      std::move(part.begin(), part.end(), std::back_inserter(all));
    }
    return all;
  }();
  return known;
}

const Command* find_command(std::string_view name) {
  const auto found = std::find_if(commands().begin(), commands().end(),
                                  [&](const Command& command) { return command.name == name; });
  return found == commands().end() ? nullptr : &*found;
}

void check_fields(const Command& command, const JsonField& request) {
  std::vector<std::string_view> names = {"id", "command"};
  for (const CommandField& field : command.fields) names.push_back(field.name);
  request.allow_only(names);
  for (const CommandField& field : command.fields) {
    if (field.required || request.has(field.name)) check_field(request[field.name], field);
  }
}

}  // namespace prehend
