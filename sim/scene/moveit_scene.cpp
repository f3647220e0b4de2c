#include "sim/scene/moveit_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "sim/base/index.h"
#include "sim/base/joined.h"
#include "sim/base/json/json_field.h"
#include "sim/base/json/yaml_file.h"
#include "sim/base/number_text.h"
#include "sim/base/range.h"
#include "sim/robot/files/robot_file.h"
#include "sim/robot/files/robot_geometry.h"
#include "sim/robot/hand/derive_hand.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/shape/mesh_checks.h"

namespace prehend {
namespace {

// A vector as {x, y, z} or as a list.
Vector3 read_vector(const JsonField& field) {
  if (field.is_list()) return field.vector3(kCoordinate);
  return {field["x"].number(kCoordinate), field["y"].number(kCoordinate),
          field["z"].number(kCoordinate)};
}

// A quaternion as {x, y, z, w} or as a list in that order.
Matrix3 read_turn(const JsonField& field) {
  std::vector<double> q;
  if (field.is_list()) {
    q = field.numbers(4);
  } else {
    for (const char* key : {"x", "y", "z", "w"}) q.push_back(field[key].number());
  }
  const Eigen::Quaterniond turn(q[3], q[0], q[1], q[2]);
  constexpr double kOff = 1e-3;  // of the length of a quaternion written with few digits
  if (!(std::abs(turn.norm() - 1.0) < kOff)) field.fail("not a quaternion of length 1");
  return turn.normalized().toRotationMatrix();
}

// geometry_msgs/Pose, or Transform.
Pose read_message_pose(const JsonField& field) {
  const bool is_transform = field.has("translation");
  return pose_from(read_turn(field[is_transform ? "rotation" : "orientation"]),
                   read_vector(field[is_transform ? "translation" : "position"]));
}

// The kinds of shape_msgs/SolidPrimitive, from 1 on, and how many dimensions each has.
struct SolidKind {
  const char* name;
  std::size_t dimensions;
};
constexpr SolidKind kSolids[] = {{"box", 3}, {"sphere", 1}, {"cylinder", 2}, {"cone", 2}};

const SolidKind& kind_of(const JsonField& type) {
  const int number = type.is_text() ? 0 : type.integer();
  for (int k = 0; k < 4; ++k) {
    if (number == k + 1 || (type.is_text() && type.text() == kSolids[k].name)) return kSolids[k];
  }
  type.fail("must be box, sphere, cylinder or cone, or 1 to 4 in this order");
}

// The tip up, the middle of its height at the origin, as the message has it.
nlohmann::json cone_points(double height, double radius) {
  constexpr int kSides = 24;
  nlohmann::json points = {{0.0, 0.0, 0.5 * height}};
  for (int k = 0; k < kSides; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kSides;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle), -0.5 * height});
  }
  return points;
}

// The solid as a shape of a scene file.
nlohmann::json solid_shape(const JsonField& solid) {
  const SolidKind& kind = kind_of(solid["type"]);
  const std::vector<double> size = solid["dimensions"].numbers(kind.dimensions, kLengthAbove0);
  const std::string name = kind.name;
  if (name == "box") return {{"shape", "box"}, {"size", size}};
  if (name == "sphere") return {{"shape", "sphere"}, {"radius", size[0]}};
  if (name == "cylinder") {
    return {{"shape", "cylinder"}, {"height", size[0]}, {"radius", size[1]}};
  }
  return {{"shape", "hull"}, {"points", cone_points(size[0], size[1])}};
}

// shape_msgs/Mesh.
TriangleMesh read_message_mesh(const JsonField& field) {
  TriangleMesh mesh;
  for (const JsonField& vertex : field["vertices"].items()) {
    mesh.vertices.push_back(read_vector(vertex));
  }
  const auto count = static_cast<int>(mesh.vertices.size());
  for (const JsonField& triangle : field["triangles"].items()) {
    const JsonField corners = triangle.is_list() ? triangle : triangle["vertex_indices"];
    const std::vector<JsonField> indices = corners.items();
    if (indices.size() != 3) corners.fail("must be three vertices");
    Triangle t{};
    for (std::size_t k = 0; k < 3; ++k) {
      t[k] = indices[k].integer();
      if (t[k] < 0 || t[k] >= count) indices[k].fail("must be the number of a vertex");
    }
    mesh.triangles.push_back(t);
  }
  if (mesh.empty()) field.fail("no triangles");
  return mesh;
}

// The poses of shapes beside their list; those left out are the identity.
Pose pose_beside(const JsonField& body, const char* key, std::size_t i) {
  if (!body.has(key)) return Pose::Identity();
  const std::vector<JsonField> poses = body[key].items();
  return i < poses.size() ? read_message_pose(poses[i]) : Pose::Identity();
}

// moveit_msgs/CollisionObject.
struct MoveitBody {
  std::string name;
  TriangleMesh mesh;  // in the frame of the body
  Pose X_WB = Pose::Identity();
};

MoveitBody read_moveit_body(const JsonField& field, ShapeBudget& budget) {
  MoveitBody body;
  body.name = field["id"].text();
  if (field.has("pose")) body.X_WB = read_message_pose(field["pose"]);
  if (field.has("primitives")) {
    const std::vector<JsonField> solids = field["primitives"].items();
    for (std::size_t i = 0; i < solids.size(); ++i) {
      const nlohmann::json shapes = nlohmann::json::array({solid_shape(solids[i])});
      const TriangleMesh mesh = read_geometry(JsonField(shapes, solids[i].file(), solids[i].name()),
                                              FileUnits{}, {}, budget);
      append(body.mesh, transformed(mesh, pose_beside(field, "primitive_poses", i)));
    }
  }
  if (field.has("meshes")) {
    const std::vector<JsonField> meshes = field["meshes"].items();
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      append(body.mesh,
             transformed(read_message_mesh(meshes[i]), pose_beside(field, "mesh_poses", i)));
    }
  }
  if (body.mesh.empty()) {
    field.fail("no primitives and no meshes, other shapes are not read: leave it out");
  }
  orient_outward(body.mesh);
  return body;
}

std::vector<JsonField> collision_objects(const JsonField& root) {
  if (!root.has("world") || !root["world"].is_object()) {
    root.fail("no \"world\": not a scene of MoveIt (moveit_msgs/PlanningScene)");
  }
  const JsonField world = root["world"];
  if (!world.has("collision_objects") || world["collision_objects"].is_null()) return {};
  return world["collision_objects"].items();
}

// All of them must stand in one frame, which is taken as the world's.
void require_one_frame(const std::vector<JsonField>& objects) {
  std::string first;
  for (const JsonField& field : objects) {
    if (!field.has("header")) continue;
    const JsonField header = field["header"];
    const std::string frame = header.has("frame_id") ? header["frame_id"].json() : "";
    if (first.empty()) first = frame;
    if (frame != first) {
      header["frame_id"].fail("other objects are in another frame: all must be in one");
    }
  }
}

// sensor_msgs/JointState.
NamedJoints read_joint_state(const JsonField& field) {
  const std::vector<JsonField> names = field["name"].items();
  const std::vector<double> values = field["position"].numbers(names.size(), kCoordinate);
  NamedJoints joints;
  for (std::size_t i = 0; i < names.size(); ++i) joints[names[i].text()] = values[i];
  return joints;
}

// Of moveit_msgs/RobotState; none where it says nothing.
NamedJoints read_robot_state(const JsonField& field) {
  if (!field.has("joint_state") || !field["joint_state"].has("name")) return {};
  return read_joint_state(field["joint_state"]);
}

// Where the first joint that floats puts the robot.
Pose read_base(const JsonField& state) {
  if (!state.has("multi_dof_joint_state")) return Pose::Identity();
  const JsonField joints = state["multi_dof_joint_state"];
  if (!joints.has("transforms") || joints["transforms"].is_null()) return Pose::Identity();
  const std::vector<JsonField> transforms = joints["transforms"].items();
  return transforms.empty() ? Pose::Identity() : read_message_pose(transforms.front());
}

Carrier read_robot(const JsonField& root, const SceneSource& source) {
  if (!source.robot.empty()) return find_carrier(source.robot, source.foreign);
  if (!root.has("robot_model_name")) {
    root.fail("no robot: robot_model_name must be a platform of the library, or a robot file");
  }
  const JsonField name = root["robot_model_name"];
  try {
    return find_carrier(name.text(), source.foreign);
  } catch (const InputError& error) {
    name.fail(std::string("no arm with a hand: ") + error.what());
  }
}

void note_unread(const JsonField& root, std::vector<std::string>& notes) {
  const JsonField world = root["world"];
  if (world.has("octomap")) notes.emplace_back("the octomap of the scene is not read");
  if (!root.has("robot_state")) return;
  const JsonField state = root["robot_state"];
  const char* attached = "attached_collision_objects";
  if (state.has(attached) && state[attached].is_list() && !state[attached].items().empty()) {
    notes.emplace_back("objects attached to the robot are not read");
  }
}

// The value of the joint, brought inside its limits where the hand has it.
double start_value(const Joint& joint, const DegreeOfFreedom& dof, bool in_hand, double value,
                   std::vector<std::string>& notes) {
  const double asked = (value - joint.offset) / joint.ratio;
  if (!in_hand || within_limits(dof, asked)) return asked;
  const double possible = std::clamp(asked, dof.lower, dof.upper);
  notes.push_back("joint " + driver_name(joint) + " starts at " + shortest_text(value) +
                  ", beyond its limits: taken as " +
                  shortest_text(joint.ratio * possible + joint.offset));
  return possible;
}

}  // namespace

void set_start(const NamedJoints& joints, Scene& scene) {
  Carrier& carrier = scene.carrier.value();
  NamedJoints left = joints;
  bool moves_arm = false;
  std::size_t first_dof = 0;
  for (std::size_t r = 0; r < carrier.platform.robots.size(); ++r) {
    const Robot& robot = carrier.platform.robots[r].robot;
    const bool in_hand = static_cast<int>(r) == carrier.hand;
    for (const Joint& joint : robot.joints) {
      const auto found = joints.find(driver_name(joint));
      if (found == joints.end()) continue;
      const std::size_t dof = index(joint.dof);
      left.erase(found->first);
      carrier.start[first_dof + dof] =
          start_value(joint, robot.dofs[dof], in_hand, found->second, scene.notes);
      moves_arm = moves_arm || !in_hand;
    }
    first_dof += robot.dofs.size();
  }
  std::string unknown;
  for (const auto& [name, value] : left) add_part(unknown, name);
  if (!unknown.empty()) scene.notes.push_back("joints that the robot does not have: " + unknown);
  if (moves_arm || joints.empty()) return;
  std::string known;
  for (const MountedRobot& mounted : carrier.platform.robots) {
    for (const Joint& joint : mounted.robot.joints) add_part(known, driver_name(joint));
  }
  throw InputError({.field = "joints",
                    .problem = "none is of the arm, whose joints are " + known,
                    .value = unknown});
}

Scene read_moveit_scene(const JsonFile& file, const SceneSource& source) {
  const JsonField root = file.root();
  const std::vector<JsonField> objects = collision_objects(root);
  if (objects.empty() && source.needs_object) {
    root["world"].fail("no collision object to grasp");
  }
  require_one_frame(objects);
  require(source.choice.apart == 0.0,
          {.file = file.path().string(),
           .field = "apart",
           .problem = "a MoveIt scene does not tell objects from what they stand on; name the "
                      "distance in a scene file",
           .value = std::to_string(source.choice.apart)});
  Scene scene;
  scene.name = file.path().stem().string();
  ShapeBudget budget;
  bool is_chosen = false;
  for (const JsonField& field : objects) {
    MoveitBody body = read_moveit_body(field, budget);
    const std::string& asked = source.choice.object;
    if (!is_chosen && (asked.empty() ? source.needs_object : asked == body.name)) {
      is_chosen = true;
      scene.object = make_graspable(body.name, std::move(body.mesh), Material::plastic);
      scene.object.X_WO = body.X_WB;
    } else {
      add_obstacle(scene, body.name, std::move(body.mesh), body.X_WB);
    }
  }
  if (!is_chosen && !source.choice.object.empty()) {
    throw InputError({file.path().string(), "object",
                      "the scene has no such object; it has " + joined(moveit_objects(file)),
                      source.choice.object});
  }
  if (!is_chosen) scene.object = nothing_to_grasp();
  scene.carrier = read_robot(root, source);
  MountedRobot& mounted = scene.carrier->platform.robots[index(scene.carrier->hand)];
  if (!source.hand.empty()) {
    mounted.robot = with_hand(find_robot(source.hand, source.foreign));
    scene.hand_source = robot_source(source.hand);
    scene.carrier->start = initial_dofs(scene.carrier->platform);
  }
  scene.hand = mounted.robot;
  if (root.has("robot_state")) {
    const JsonField state = root["robot_state"];
    scene.carrier->X_WB = read_base(state);
    with_field_errors(state, [&] { set_start(read_robot_state(state), scene); });
  }
  note_unread(root, scene.notes);
  return scene;
}

std::vector<std::string> moveit_objects(const JsonFile& file) {
  std::vector<std::string> names;
  for (const JsonField& field : collision_objects(file.root())) names.push_back(field["id"].text());
  return names;
}

MotionRequest read_motion_request(const std::filesystem::path& file) {
  const JsonFile yaml = read_yaml(file);
  const JsonField root = yaml.root();
  MotionRequest request;
  if (root.has("start_state")) request.start = read_robot_state(root["start_state"]);
  const std::vector<JsonField> goals = root["goal_constraints"].items();
  if (goals.empty()) root["goal_constraints"].fail("no goal");
  const char* joints = "joint_constraints";
  if (!goals.front().has(joints) || goals.front()[joints].is_null()) {
    goals.front().fail("only goals of joints (joint_constraints) are read");
  }
  for (const JsonField& joint : goals.front()[joints].items()) {
    request.goal[joint["joint_name"].text()] = joint["position"].number(kCoordinate);
  }
  return request;
}

}  // namespace prehend
