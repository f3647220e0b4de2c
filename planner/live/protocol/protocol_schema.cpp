#include "planner/live/protocol/protocol_schema.h"

#include <cmath>
#include <sstream>

#include "planner/live/protocol/command.h"
#include "sim/base/json/wrapped_json.h"

namespace prehend {
namespace {

using Json = ProtocolJson;

// A schema says with its keyword whether the lower end belongs to the range.
Json number_schema(const char* type, const Range& range) {
  Json schema{{"type", type}};
  if (std::isfinite(range.lower)) {
    schema[range.without_lower ? "exclusiveMinimum" : "minimum"] = range.lower;
  }
  if (std::isfinite(range.upper)) schema["maximum"] = range.upper;
  return schema;
}

Json numbers_schema(int count, const Range& range) {
  Json schema{{"type", "array"}, {"items", number_schema("number", range)}};
  if (count > 0) schema["minItems"] = schema["maxItems"] = count;
  return schema;
}

Json field_schema(const CommandField& field) {
  switch (field.type) {
    case FieldType::number:
      return number_schema("number", field.range);
    case FieldType::integer:
      return number_schema("integer", field.range);
    case FieldType::boolean:
      return {{"type", "boolean"}};
    case FieldType::text:
      return {{"type", "string"}, {"minLength", 1}};
    case FieldType::vector3:
      return numbers_schema(3, field.range);
    case FieldType::numbers:
      return numbers_schema(0, field.range);
    case FieldType::pose:
      break;
  }
  return {{"$ref", "#/$defs/pose"}};
}

// `properties` and `required` have what comes before the command's own fields.
Json fields_schema(const Command& command, Json properties, Json required) {
  for (const CommandField& field : command.fields) {
    Json schema = field_schema(field);
    schema["description"] = field.meaning;
    properties[std::string(field.name)] = schema;
    if (field.required) required.push_back(field.name);
  }
  return {{"description", command.summary},
          {"type", "object"},
          {"properties", properties},
          {"required", required},
          {"additionalProperties", false}};
}

Json request_schema(const Command& command) {
  return fields_schema(command,
                       {{"id", {{"$ref", "#/$defs/id"}}}, {"command", {{"const", command.name}}}},
                       Json::array({"command"}));
}

Json pose_schema() {
  return {{"type", "object"},
          {"properties",
           {{"position", numbers_schema(3, kCoordinate)},
            {"quaternion_wxyz", numbers_schema(4, kAnyNumber)}}},
          {"additionalProperties", false}};
}

Json reply_schema() {
  const Json error{{"type", "object"},
                   {"properties",
                    {{"field", {{"type", "string"}}},
                     {"problem", {{"type", "string"}}},
                     {"value", {{"type", "string"}}}}},
                   {"required", {"field", "problem", "value"}}};
  const Json id{{"type", {"integer", "string", "null"}}};
  return {
      {"oneOf",
       {{{"type", "object"},
         {"properties", {{"id", id}, {"ok", {{"const", true}}}, {"result", {{"type", "object"}}}}},
         {"required", {"id", "ok", "result"}}},
        {{"type", "object"},
         {"properties", {{"id", id}, {"ok", {{"const", false}}}, {"error", error}}},
         {"required", {"id", "ok", "error"}}}}}};
}

Json event_schema() {
  return {{"type", "object"},
          {"properties",
           {{"event", {{"enum", {"state", "progress", "grasps", "plan", "path", "recording"}}}}}},
          {"required", {"event"}}};
}

// What commands reply that change something; the document says it once.
constexpr std::string_view kState = "the state, as of `state`";

// The command's fields, those that it needs in bold.
std::string field_names(const Command& command) {
  std::string names;
  for (const CommandField& field : command.fields) {
    const std::string_view mark = field.required ? "**" : "";
    if (!names.empty()) names += ", ";
    names.append(mark).append("`").append(field.name).append("`").append(mark);
  }
  return names;
}

// What the command replies; of equal replies only the first is written out.
std::string reply_text(const Command& command) {
  for (const Command& earlier : commands()) {
    if (&earlier == &command) break;
    if (earlier.result == command.result) return "as `" + std::string(earlier.name) + "` does";
  }
  return std::string(command.result);
}

}  // namespace

ProtocolJson command_schema(const Command& command) {
  Json schema = fields_schema(command, Json::object(), Json::array());
  schema.erase("description");
  for (const CommandField& field : command.fields) {
    if (field.type == FieldType::pose) schema["$defs"]["pose"] = pose_schema();
  }
  return schema;
}

std::string protocol_schema() {
  Json requests = Json::array();
  for (const Command& command : commands()) requests.push_back(request_schema(command));
  const Json schema{
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"title", "prehend protocol, version 1"},
      {"description", "A message of a client is a request; those to it are replies and events."},
      {"oneOf",
       {{{"$ref", "#/$defs/request"}}, {{"$ref", "#/$defs/reply"}}, {{"$ref", "#/$defs/event"}}}},
      {"$defs",
       {{"id", {{"type", {"integer", "string"}}}},
        {"pose", pose_schema()},
        {"request", {{"oneOf", requests}}},
        {"reply", reply_schema()},
        {"event", event_schema()}}}};
  return wrapped_json(schema);
}

std::string protocol_reference() {
  std::ostringstream text;
  text << "Fields in bold are needed. Commands with * are refused while a plan runs. Where no "
          "reply is "
          "named, it is "
       << kState << ".\n\n| command | fields | what it does |\n|---|---|---|\n";
  for (const Command& command : commands()) {
    text << "| `" << command.name << "`" << (command.kind == CommandKind::world ? " *" : "")
         << " | " << field_names(command) << " | " << command.summary;
    if (command.result != kState) text << " Replies " << reply_text(command) << ".";
    text << " |\n";
  }
  return text.str();
}

}  // namespace prehend
