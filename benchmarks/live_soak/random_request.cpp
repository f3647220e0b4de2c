#include "benchmarks/live_soak/random_request.h"

#include <algorithm>
#include <array>

namespace prehend::live_soak {
namespace {

// Of numbers that nobody should send.
constexpr std::array kOddNumbers = {0.0, -1.0, 1e-12, 1e6, 1e30, -1e30, 1e300};

template <typename Values>
const auto& one_of(Random& random, const Values& values) {
  return values[random.index(values.size())];
}

bool rarely(Random& random, std::size_t one_in) { return random.index(one_in) == 0; }

Json vector_json(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

Json pose_json(Random& random, double reach) {
  const Eigen::Quaterniond q(random.rotation());
  Json pose;
  pose["position"] = vector_json(random.in_box(reach));
  pose["quaternion_wxyz"] = {q.w(), q.x(), q.y(), q.z()};
  return pose;
}

double number(Random& random) {
  if (rarely(random, 15)) return one_of(random, kOddNumbers);
  // Over the scales of masses, lengths, forces and stiffnesses.
  const double size = std::pow(10.0, random.uniform(-3.0, 1.5));
  return rarely(random, 4) ? -size : size;
}

// The names of a list of objects in the state.
std::vector<std::string> names_in(const Json& list) {
  std::vector<std::string> names;
  for (const Json& item : list) {
    names.push_back(item.is_string() ? item.get<std::string>() : item.value("name", ""));
  }
  std::erase(names, "");
  return names;
}

std::vector<std::string> texts_for(std::string_view command, std::string_view field,
                                   const KnownNames& names) {
  const Json& state = names.state;
  if (field == "hand") return names.hands;
  if (field == "platform") return names.platforms;
  if (field == "scene") return names.scenes;
  if (field == "generate") return names.generators;
  if (field == "material") return {"glass", "metal", "plastic", "wood", "rubber"};
  if (field == "accuracy") return {"draft"};
  if (field == "format") return {"json", "csv", "obj", "moveit"};
  if (field == "unit") return {"m", "mm", "cm", "in"};
  if (field == "norm") return {"l1", "linf"};
  if (field == "fixed") return {"fx,fy,fz", "tx,ty,tz", "fx,fy,tz", "fx,fx,fy", "fx"};
  if (field == "file") return {"a.json", "b.json"};
  if (field == "mesh") return {"a.json", "none.obj"};
  if (field == "mesh_text")
    return {"v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"};
  if (field == "line") {
    return {
        "getContacts 3 ALL",        "getAverageContacts 1 0", "getBodyName ALL", "getRobotName ALL",
        "getDOFVals ALL",           "moveDynamicBodies",      "render",          "moveToContacts",
        "computeNewVelocities 0.01"};
  }
  if (state.is_object()) {
    if (field == "dof") return names_in(state["hand"]["dofs"]);
    if (field == "preshape") return names_in(state["hand"]["preshapes"]);
    if (field == "joint" && state["arm"].is_object()) return names_in(state["arm"]["joints"]);
    if (field == "surface") {
      std::vector<std::string> surfaces;
      if (state["object"].is_object()) surfaces.push_back(state["object"].value("surface", ""));
      for (const Json& obstacle : state["obstacles"]) {
        surfaces.push_back(obstacle.value("surface", ""));
      }
      std::erase(surfaces, "");
      return surfaces;
    }
    if (field == "name" && command.starts_with("obstacle.") && command != "obstacle.add") {
      return names_in(state["obstacles"]);
    }
  }
  return {"a", "b", "c", "d"};
}

std::string text(Random& random, std::string_view command, std::string_view field,
                 const KnownNames& names) {
  if (rarely(random, 25)) {
    return one_of(random,
                  std::array<std::string, 5>{std::string("a\0b", 3), "/etc/passwd", "../x.json",
                                             "\xE2\x88\x9B", std::string(3000, 'n')});
  }
  const std::vector<std::string> known = texts_for(command, field, names);
  return known.empty() ? "a" : one_of(random, known);
}

// As little work as an integer of this name can mean, most of the time.
int integer(Random& random, std::string_view field) {
  if (rarely(random, 30)) {
    return one_of(random, std::array{-1, 0, 2147483647, -2147483647});
  }
  if (field == "triangles") return random.integer(4, 600);
  if (field == "trials") return random.integer(1, 25);
  if (field == "edges") return random.integer(2, 16);
  return random.integer(0, 4);
}

std::size_t dof_count(const KnownNames& names, std::string_view field) {
  if (!names.state.is_object()) return 4;
  const Json& arm = names.state["arm"];
  if (field == "joints" && arm.is_object()) return arm["joints"].size();
  return names.state["hand"]["dofs"].size();
}

Json numbers(Random& random, std::size_t count) {
  Json list = Json::array();
  for (std::size_t i = 0; i < count; ++i) list.push_back(random.uniform(-0.5, 2.5));
  return list;
}

Json value(Random& random, std::string_view command, const CommandField& field,
           const KnownNames& names) {
  switch (field.type) {
    case FieldType::number:
      // A step of the world's time is work.
      return field.name == "seconds" ? random.uniform(-0.01, 0.1) : number(random);
    case FieldType::integer:
      return integer(random, field.name);
    case FieldType::boolean:
      return random.index(2) == 0;
    case FieldType::text:
      return text(random, command, field.name, names);
    case FieldType::vector3:
      return vector_json(random.in_box(rarely(random, 5) ? 100.0 : 1.0));
    case FieldType::numbers: {
      const std::size_t count = dof_count(names, field.name);
      return numbers(random, rarely(random, 20) ? count + 1 : count);
    }
    case FieldType::pose:
      return pose_json(random, rarely(random, 20) ? 1e5 : 0.25);
  }
  return nullptr;
}

Json wrong_value(Random& random) {
  return one_of(random, std::array<Json, 7>{Json(nullptr), Json(true), Json(-1.5), Json("x"),
                                            Json::array(), Json::object(), Json(1e300)});
}

// Fields that make a request much work where they are left out or set.
bool is_kept_small(std::string_view field) {
  return field == "trials" || field == "triangles" || field == "accuracy";
}

// Of fields of which a command takes one, one is kept; `value` belongs to a `dof` or `joint`.
void keep_one(Random& random, Json& request) {
  const std::vector<std::vector<std::string>> kinds = {
      {"X_world_hand", "X_object_hand"},
      {"dofs", "dof"},
      {"joints", "joint"},
      {"target", "effort"},
      {"scene", "generate", "mesh", "mesh_text", "mesh_base64", "text"}};
  for (const std::vector<std::string>& kind : kinds) {
    std::vector<std::string> given;
    for (const std::string& field : kind) {
      if (request.contains(field)) given.push_back(field);
    }
    if (given.size() < 2) continue;
    const std::string kept = one_of(random, given);
    for (const std::string& field : given) {
      if (field != kept) request.erase(field);
    }
  }
  const bool has_name = request.contains("dof") || request.contains("joint");
  const bool has_list = request.contains("dofs") || request.contains("joints");
  if (has_list) request.erase("value");
  if (has_name && request["command"] != "time.drive") request["value"] = random.uniform(-0.5, 2.5);
}

// Whether the state says that the command would be refused: it is then asked for more rarely.
bool is_vain(const Command& command, const Json& state) {
  if (!state.is_object()) return false;
  const std::string_view name = command.name;
  const bool moves = !state["time"].is_null();
  if (name.starts_with("time.")) return moves == (name == "time.start");
  if (name.starts_with("arm.") && state["arm"].is_null()) return true;
  if (name.starts_with("plan.") && name != "plan.start" && name != "plan.cancel") {
    return state["results"] == 0;
  }
  if (state["object"].is_null()) return name != "object.set" && name != "scene.load";
  return command.kind == CommandKind::world && (moves || state["planning"] == true);
}

// More than some milliseconds.
bool takes_long(const Command& command) {
  constexpr std::array<std::string_view, 8> kLong{"hello",        "quality",    "primitives",
                                                  "scene.text",   "plan.start", "path.plan",
                                                  "grasp.refine", "plan.export"};
  return command.kind == CommandKind::world ||
         std::find(kLong.begin(), kLong.end(), command.name) != kLong.end();
}

Json request_of(Random& random, const Command& command, const KnownNames& names) {
  Json request{{"command", command.name}};
  for (const CommandField& field : command.fields) {
    // Paths of an arm take seconds each.
    if (field.name == "paths" && !rarely(random, 20)) continue;
    if (!field.required && !is_kept_small(field.name) && random.index(3) == 0) continue;
    if (!field.required && command.fields.size() > 6 && random.index(3) != 0 &&
        !is_kept_small(field.name)) {
      continue;
    }
    request[std::string(field.name)] = value(random, command.name, field, names);
  }
  return request;
}

}  // namespace

KnownNames names_of(const Json& hello) {
  KnownNames names;
  names.hands = hello["hands"].get<std::vector<std::string>>();
  names.generators = hello["generators"].get<std::vector<std::string>>();
  names.scenes = {"mug", "hammer", "mug_on_table"};
  names.platforms = hello["platforms"].get<std::vector<std::string>>();
  return names;
}

Json random_request(Random& random, const KnownNames& names) {
  const Command* command = &one_of(random, commands());
  if (is_vain(*command, names.state) && random.index(4) != 0) {
    command = &one_of(random, commands());
  }
  // Motions are most of what happens, and what takes long most of the work.
  if (takes_long(*command) && random.index(12) != 0) {
    command = find_command(
        one_of(random, std::array<std::string_view, 6>{"hand.move", "hand.dofs", "hand.approach",
                                                       "hand.back_off", "undo", "redo"}));
  }
  Json request = request_of(random, *command, names);
  if (!rarely(random, 10)) keep_one(random, request);
  if (!rarely(random, 12)) return request;
  switch (random.index(4)) {
    case 0:
      request["more"] = 1;
      break;
    case 1:
      request["command"] = std::string(command->name) + "x";
      break;
    default:
      if (command->fields.empty()) break;
      const std::string field(one_of(random, command->fields).name);
      if (random.index(2) == 0) {
        request.erase(field);
      } else {
        request[field] = wrong_value(random);
      }
  }
  return request;
}

Json random_change(Random& random, const KnownNames& names) {
  switch (random.index(9)) {
    case 0:
      return {{"command", "object.change"}, {"mass", random.uniform(0.1, 1.0)}};
    case 1:
      return {{"command", "object.move"}, {"X_world_object", pose_json(random, 0.2)}};
    case 2:
      return {{"command", "obstacle.add"},
              {"generate", "box"},
              {"triangles", 12},
              {"name", "of a change"},
              {"X_world_body", pose_json(random, 0.4)}};
    case 3:
      return {{"command", "hand.auto_grasp"}};
    case 4:
      return {{"command", "hand.approach"}};
    case 5:
      return {{"command", "hand.choose"}, {"hand", one_of(random, names.hands)}};
    case 6:
      return {{"command", "switches.set"}, {"soft_fingers", random.index(2) == 0}};
    case 7:
      return {{"command", "pin.add"}, {"name", "of a change"}};
    default:
      return {{"command", "hand.move"}, {"X_object_hand", pose_json(random, 0.2)}};
  }
}

std::string random_nonsense(Random& random, const KnownNames& names) {
  const std::string sound =
      random_request(random, names).dump(-1, ' ', true, Json::error_handler_t::replace);
  switch (random.index(5)) {
    case 0:
      return sound.substr(0, 1 + random.index(sound.size() - 1));
    case 1:
      return std::string(1 + random.index(3000), '[');
    case 2:
      return R"({"id": {}, "command": "state"})";
    case 3:
      return R"({"command": "hand.dofs", "dofs": [1e999, "x", null]})";
    default:
      return R"({"command": "state", "command": "undo"})";
  }
}

}  // namespace prehend::live_soak
