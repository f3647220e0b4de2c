#include <algorithm>

#include "planner/live/protocol/command.h"
#include "planner/show/report/packed_mesh.h"
#include "planner/show/report/robot_json.h"

// The commands of clients that draw.
namespace prehend {
namespace {

ProtocolJson view_surface(const CommandScope& scope, const JsonField& request) {
  const EditedScene& world = *scope.session.state().world;
  const std::string id = request["surface"].text();
  const Scene& scene = world.scene();
  const SurfaceIds& ids = world.surfaces();
  const TriangleMesh* mesh = id == ids.object ? &scene.object.mesh : nullptr;
  const auto obstacle = std::find(ids.obstacles.begin(), ids.obstacles.end(), id);
  if (mesh == nullptr && obstacle != ids.obstacles.end()) {
    mesh = &scene.obstacles[static_cast<std::size_t>(obstacle - ids.obstacles.begin())].mesh;
  }
  if (mesh == nullptr) request["surface"].fail("no body of the scene has this surface");
  return {{"surface", id}, {"mesh", drawn_mesh(*mesh, kMostDrawnTriangles)}};
}

// Which degree of freedom moves each joint, and how.
ProtocolJson drives_json(const Robot& robot) {
  ProtocolJson drives = ProtocolJson::array();
  for (const Joint& joint : robot.joints) {
    drives.push_back({{"dof", joint.dof}, {"ratio", joint.ratio}, {"offset", joint.offset}});
  }
  return drives;
}

ProtocolJson dof_names(const Robot& robot) {
  ProtocolJson names = ProtocolJson::array();
  for (const DegreeOfFreedom& dof : robot.dofs) names.push_back(dof.name);
  return names;
}

ProtocolJson view_robots(const CommandScope& scope, const JsonField& /*request*/) {
  const EditedScene& world = *scope.session.state().world;
  const Robot& robot = world.scene().hand;
  ProtocolJson hand = robot_json(robot);
  hand["dofs"] = dof_names(robot);
  hand["drives"] = drives_json(robot);
  hand["approach"] = rounded(robot.hand->approach);
  hand["closing"] = rounded(robot.hand->closing);
  ProtocolJson json{{"robots", world.surfaces().robots}, {"hand", hand}, {"arm", nullptr}};
  if (world.is_ready() && world.compiled().arm) {
    json["arm"] = arm_json(*world.compiled().arm);
    json["arm"]["dofs"] = dof_names(world.compiled().arm->robot());
    json["arm"]["drives"] = drives_json(world.compiled().arm->robot());
  }
  return json;
}

}  // namespace

std::vector<Command> view_commands() {
  return {
      {"view.surface",
       CommandKind::query,
       "The surface of the object or an obstacle, to be drawn. States name them; equal ones have "
       "one name.",
       {{"surface", FieldType::text, true, "its name in the state"}},
       "`surface`, and `mesh`: `positions`, base64 of little-endian float32, three a vertex [m, "
       "frame of the body], and `indices`, base64 of uint32, three a triangle; `simplified_from`: "
       "how many triangles there were, if not all are there",
       view_surface},
      {"view.robots",
       CommandKind::query,
       "The hand and its platform, to be drawn and moved.",
       {},
       "`robots`, their name in the state, `hand` and `arm` (null without a platform): `joints`, "
       "each "
       "with its `parent` (-1: the base), `type` (`r` turns, `p` slides), `axis` (null: z), and "
       "the "
       "poses `before` and `after` the motion (x, y, z, then a quaternion x, y, z, w; null: none), "
       "`links`, each with `name`, `joint`, `material` and a `mesh` as of `view.surface`, the "
       "names of "
       "`dofs`, and `drives` (a joint's value is `ratio` times that of number `dof` plus "
       "`offset`); of "
       "a hand also the unit vectors `approach` and `closing`, of an arm its base `X` in the "
       "world, "
       "the joint `hand_joint` and the pose `X_hand` behind it that carry the hand, and "
       "`first_hand_joint`",
       view_robots}};
}

}  // namespace prehend
