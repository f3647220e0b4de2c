#include <optional>
#include <string>
#include <utility>

#include "planner/live/protocol/command.h"
#include "planner/live/protocol/session_json.h"
#include "sim/base/json/json_pose.h"
#include "sim/base/output_file.h"
#include "sim/base/range.h"
#include "sim/robot/files/platform_file.h"
#include "sim/robot/files/robot_file.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"
#include "sim/scene/scene_text.h"
#include "sim/shape/files/gltf_buffers.h"
#include "sim/shape/object_generator.h"

// The commands that make, change and keep the scene.
namespace prehend {
namespace {

// Changed when an earlier client could no longer understand what is said.
constexpr int kProtocolVersion = 1;

std::string text_field(const JsonField& request, std::string_view name) {
  return request.has(name) ? request[name].text() : std::string();
}

SurfaceOrder surface_order(const JsonField& request) {
  SurfaceOrder order{
      text_field(request, "scene"), text_field(request, "generate"),  5000,
      text_field(request, "mesh"),  text_field(request, "mesh_text"), text_field(request, "format"),
      text_field(request, "unit")};
  if (request.has("mesh_base64")) {
    const JsonField field = request["mesh_base64"];
    if (!order.mesh_text.empty()) field.fail("cannot be given beside mesh_text");
    order.mesh_text = with_field_errors(field, [&] { return from_base64(field.text()); });
  }
  if (request.has("triangles")) order.triangles = request["triangles"].integer();
  return order;
}

BodyOrder body_order(const JsonField& request, std::string_view pose, std::string_view name) {
  BodyOrder order;
  order.name = text_field(request, name);
  if (request.has("material")) {
    const JsonField field = request["material"];
    order.material = with_field_errors(field, [&] { return material_named(field.text()); });
  }
  if (request.has("mass")) order.mass = request["mass"].number();
  if (request.has(pose)) order.X_WB = read_pose(request[pose]);
  return order;
}

// The robots of the library that are hands.
std::vector<std::string> hand_names() {
  std::vector<std::string> names = library_robot_names();
  std::erase_if(names, [](const std::string& name) { return !find_robot(name).hand; });
  return names;
}

ProtocolJson hello(const CommandScope& /*scope*/, const JsonField& /*request*/) {
  ProtocolJson names = ProtocolJson::array();
  for (const Command& command : commands()) names.push_back(command.name);
  return {{"program", "prehend"},
          {"version", kProtocolVersion},
          {"commands", names},
          {"scenes", library_scene_names()},
          {"hands", hand_names()},
          {"platforms", library_platform_names()},
          {"generators", generated_object_names()}};
}

ProtocolJson scene_new(const CommandScope& scope, const JsonField& request) {
  const std::string hand = text_field(request, "hand");
  scope.session.set_scene(
      scene_of_hand(hand.empty() ? kDefaultHand : scope.session.folders().robot_of(hand, "hand")));
  return state_json(scope.session);
}

ProtocolJson scene_load(const CommandScope& scope, const JsonField& request) {
  if (request.has("scene") == request.has("text")) request.fail("needs one of scene and text");
  const OpenFolders& folders = scope.session.folders();
  scope.session.set_scene(request.has("scene") ? open_scene(request["scene"].text(), folders)
                                               : scene_of_text(request["text"].text(), folders));
  if (request.has("fresh") && request["fresh"].boolean()) scope.session.forget_history();
  return state_json(scope.session);
}

std::string text_of_scene(const CommandScope& scope) {
  const EditedScene& world = *scope.session.state().world;
  require(world.has_object(),
          {.field = "scene", .problem = "has no object, without which there is no scene file"});
  return scene_text(world.scene());
}

ProtocolJson scene_save(const CommandScope& scope, const JsonField& request) {
  const std::string name = request["file"].text();
  const std::filesystem::path file = scope.session.folders().path_of(name, "file");
  if (file.extension() != ".json") request["file"].fail("must end in .json");
  write_file(file, text_of_scene(scope));
  return {{"file", file.string()}};
}

ProtocolJson scene_text_of(const CommandScope& scope, const JsonField& /*request*/) {
  return {{"text", text_of_scene(scope)}};
}

ProtocolJson object_set(const CommandScope& scope, const JsonField& request) {
  const BodyOrder order = body_order(request, "X_world_object", "name");
  BodySurface surface = surface_of(surface_order(request), scope.session.folders());
  scope.session.edit([&](Scene& scene) { set_object(scene, std::move(surface), order); });
  return state_json(scope.session);
}

ProtocolJson friction_set(const CommandScope& scope, const JsonField& request) {
  std::optional<Material> material;
  if (request.has("material")) {
    const JsonField field = request["material"];
    material = with_field_errors(field, [&] { return material_named(field.text()); });
  }
  const double friction = request["static"].number();
  scope.session.edit([&](Scene& scene) { change_friction(scene, material, friction); });
  return state_json(scope.session);
}

ProtocolJson object_change(const CommandScope& scope, const JsonField& request) {
  const BodyOrder order = body_order(request, "X_world_object", "name");
  scope.session.edit([&](Scene& scene) { change_object(scene, order); });
  return state_json(scope.session);
}

ProtocolJson obstacle_add(const CommandScope& scope, const JsonField& request) {
  const BodyOrder order = body_order(request, "X_world_body", "name");
  BodySurface surface = surface_of(surface_order(request), scope.session.folders());
  scope.session.edit([&](Scene& scene) { add_obstacle(scene, std::move(surface), order); });
  return state_json(scope.session);
}

ProtocolJson obstacle_change(const CommandScope& scope, const JsonField& request) {
  const BodyOrder order = body_order(request, "X_world_body", "to");
  const std::string name = request["name"].text();
  scope.session.edit([&](Scene& scene) { change_obstacle(scene, name, order); });
  return state_json(scope.session);
}

ProtocolJson obstacle_remove(const CommandScope& scope, const JsonField& request) {
  const std::string name = request["name"].text();
  scope.session.edit([&](Scene& scene) { remove_obstacle(scene, name); });
  return state_json(scope.session);
}

ProtocolJson hand_choose(const CommandScope& scope, const JsonField& request) {
  const std::string hand = scope.session.folders().robot_of(request["hand"].text(), "hand");
  scope.session.edit([&](Scene& scene) { choose_hand(scene, hand); });
  return state_json(scope.session);
}

ProtocolJson platform_mount(const CommandScope& scope, const JsonField& request) {
  const OpenFolders& folders = scope.session.folders();
  const std::string platform = folders.robot_of(request["platform"].text(), "platform");
  const std::string given = text_field(request, "hand");
  const std::string hand = given.empty() ? given : folders.robot_of(given, "hand");
  const Pose X_WB =
      request.has("X_world_base") ? read_pose(request["X_world_base"]) : Pose::Identity();
  scope.session.edit([&](Scene& scene) {
    with_field_errors(request["platform"], [&] { mount(scene, platform, X_WB, hand); });
  });
  return state_json(scope.session);
}

// The fields of a new body, for the object and for obstacles.
std::vector<CommandField> new_body(const std::vector<CommandField>& more) {
  std::vector<CommandField> fields = {
      {"scene", FieldType::text, false, "a scene of the library, whose object's surface it gets"},
      {"generate", FieldType::text, false, "a generated surface (`hello` lists them)"},
      {"triangles", FieldType::integer, false, "of `generate`: roughly how many; 5000", kIndex},
      {"mesh", FieldType::text, false, "a mesh file in an open folder"},
      {"mesh_text", FieldType::text, false, "the content of a mesh file that is text"},
      {"mesh_base64", FieldType::text, false, "the content of a mesh file in base64"},
      {"format", FieldType::text, false,
       "of `mesh_text` and `mesh_base64`: obj, stl, ply, off, dae, iv or wrl"},
      {"unit", FieldType::text, false,
       "of `mesh`, `mesh_text` and `mesh_base64`: m, cm, mm or in; else the likely one"},
      {"material", FieldType::text, false, "glass, metal, plastic, wood or rubber"}};
  fields.insert(fields.end(), more.begin(), more.end());
  return fields;
}

constexpr std::string_view kReplyState = "the state, as of `state`";

std::vector<Command> file_commands() {
  return {
      {"hello",
       CommandKind::query,
       "Who is there.",
       {},
       "`version` of the protocol (1), `commands`, and the names of `scenes`, `hands`, "
       "`platforms` and "
       "`generators` that come with prehend",
       hello},
      {"scene.new",
       CommandKind::world,
       "Begins with a hand and nothing else.",
       {{"hand", FieldType::text, false,
         "robot of the library, or file in an open folder; barrett"}},
       kReplyState,
       scene_new},
      {"scene.load",
       CommandKind::world,
       "Begins with a scene. The hand stands off the object, above it where that place is free. "
       "One of `scene` and `text` is needed.",
       {{"scene", FieldType::text, false,
         "scene of the library, or scene or mesh file in an open folder"},
        {"text", FieldType::text, false, "the content of a scene file"},
        {"fresh", FieldType::boolean, false,
         "whether to begin anew: nothing from before can be undone to; false"}},
       kReplyState,
       scene_load},
      {"scene.save",
       CommandKind::query,
       "Writes the scene file. What was not changed is written as it was read.",
       {{"file", FieldType::text, true, "a name that ends in .json, in an open folder"}},
       "`file`, its absolute path",
       scene_save},
      {"scene.text",
       CommandKind::query,
       "The scene file, without writing it.",
       {},
       "`text`, the bytes that `scene.save` writes",
       scene_text_of}};
}

std::vector<Command> body_commands() {
  return {
      {"object.set", CommandKind::world,
       "Gives the scene another object. One of `scene`, `generate`, `mesh`, `mesh_text`, "
       "`mesh_base64` is needed.",
       new_body({{"name", FieldType::text, false, "how it is called"},
                 {"mass", FieldType::number, false, "kg, above 0, of uniform density; 0.3", kMass},
                 {"X_world_object", FieldType::pose, false, "where it is; at the origin"}}),
       kReplyState, object_set},
      {"object.change",
       CommandKind::world,
       "Changes what is given of the object. The hand stays where it is in the world.",
       {{"name", FieldType::text, false, "how it is called"},
        {"material", FieldType::text, false, "glass, metal, plastic, wood or rubber"},
        {"mass", FieldType::number, false, "kg, above 0, of uniform density", kMass},
        {"X_world_object", FieldType::pose, false, "where it is"}},
       kReplyState,
       object_change},
      {"friction.set",
       CommandKind::world,
       "Sets the static friction of the object's material with another one, or with all.",
       {{"static",
         FieldType::number,
         true,
         "the coefficient",
         {.lower = 0.0, .upper = kLargestFriction}},
        {"material", FieldType::text, false, "of what touches the object"}},
       kReplyState,
       friction_set},
      {"obstacle.add", CommandKind::world,
       "Puts a body into the scene that does not move. One of `scene`, `generate`, `mesh`, "
       "`mesh_text` is needed.",
       new_body({{"name", FieldType::text, true, "a name that no other obstacle has"},
                 {"X_world_body", FieldType::pose, false, "where it is; at the origin"}}),
       kReplyState, obstacle_add},
      {"obstacle.change",
       CommandKind::world,
       "Changes what is given of an obstacle.",
       {{"name", FieldType::text, true, "which"},
        {"to", FieldType::text, false, "its new name"},
        {"material", FieldType::text, false, "glass, metal, plastic, wood or rubber"},
        {"X_world_body", FieldType::pose, false, "where it is"}},
       kReplyState,
       obstacle_change},
      {"obstacle.remove",
       CommandKind::world,
       "Takes an obstacle away.",
       {{"name", FieldType::text, true, "which"}},
       kReplyState,
       obstacle_remove}};
}

std::vector<Command> robot_commands() {
  return {
      {"hand.choose",
       CommandKind::world,
       "Takes another hand, which flies free, at the same place with its first preshape.",
       {{"hand", FieldType::text, true, "robot of the library, or file in an open folder"}},
       kReplyState,
       hand_choose},
      {"platform.mount",
       CommandKind::world,
       "Puts a hand on an arm, which plans then use.",
       {{"platform", FieldType::text, true, "platform of the library, or file in an open folder"},
        {"hand", FieldType::text, false, "in place of the platform's own"},
        {"X_world_base", FieldType::pose, false, "where the base is; at the origin"}},
       kReplyState,
       platform_mount}};
}

}  // namespace

std::vector<Command> scene_commands() {
  std::vector<Command> all = file_commands();
  for (Command& command : body_commands()) all.push_back(std::move(command));
  for (Command& command : robot_commands()) all.push_back(std::move(command));
  return all;
}

}  // namespace prehend
