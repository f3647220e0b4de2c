#include "sim/scene/graspit_world.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "sim/base/index.h"
#include "sim/robot/files/graspit_body.h"
#include "sim/robot/files/graspit_notes.h"
#include "sim/robot/files/graspit_transform.h"
#include "sim/robot/files/graspit_world_robots.h"
#include "sim/robot/files/robot_file.h"
#include "sim/robot/hand/derive_hand.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/object_mass.h"

namespace prehend {
namespace {

// A body of the world, and where it is.
struct WorldBody {
  GraspitBody body;
  Pose X_WB = Pose::Identity();
};

WorldBody read_placed_body(const XmlElement& element, std::vector<std::string>& notes) {
  constexpr std::array<std::string_view, 2> kKnown{"filename", "transform"};
  note_unknown(element, kKnown, notes);
  const XmlElement filename = element["filename"];
  const std::filesystem::path file = graspit_world_file(filename);
  WorldBody placed{.body = with_field_errors(filename, [&] { return load_graspit_body(file); })};
  const std::vector<std::string>& own = placed.body.notes;
  for (const std::string& note : own) {
    // A body that a world has several times has one note of each kind.
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
  }
  if (const auto transform = element.child("transform")) {
    placed.X_WB = read_graspit_transform(*transform);
  }
  return placed;
}

ShapeSource source_of(const GraspitBody& body) {
  if (body.mesh_file.empty()) return std::monostate{};
  return MeshFileSource{body.mesh_file.string(), body.unit};
}

GraspableBody graspable(const WorldBody& placed) {
  const GraspitBody& body = placed.body;
  const double mass = body.mass > 0.0 ? body.mass : kDefaultObjectMass;
  GraspableBody object = make_graspable(body.name, body.mesh, body.material, mass);
  object.X_WO = placed.X_WB;
  if (body.center_of_mass) state_center_of_mass(object, *body.center_of_mass);
  if (body.unit_inertia) object.inertia = mass * *body.unit_inertia;
  object.source = source_of(body);
  return object;
}

// The name, with a number behind it where an obstacle has it already.
std::string new_name(const Scene& scene, const std::string& name) {
  const auto taken = [&](const std::string& candidate) {
    return std::any_of(scene.obstacles.begin(), scene.obstacles.end(),
                       [&](const StaticBody& other) { return other.name == candidate; });
  };
  std::string candidate = name;
  for (int number = 2; taken(candidate); ++number) candidate = name + "_" + std::to_string(number);
  return candidate;
}

void add_static(Scene& scene, const WorldBody& placed) {
  const GraspitBody& body = placed.body;
  add_obstacle(scene, new_name(scene, body.name), body.mesh, placed.X_WB, body.material);
  scene.obstacles.back().source = source_of(body);
}

void read_bodies(const XmlElement& world, Scene& scene) {
  const std::vector<XmlElement> graspable_bodies = world.children("graspableBody");
  if (graspable_bodies.empty()) world.fail("there is no <graspableBody>, so nothing to grasp");
  scene.object = graspable(read_placed_body(graspable_bodies.front(), scene.notes));
  for (const XmlElement& element : world.children()) {
    const bool other =
        element.name() == "graspableBody" && element.line() != graspable_bodies.front().line();
    if (element.name() != "obstacle" && !other) continue;
    add_static(scene, read_placed_body(element, scene.notes));
    if (other) {
      scene.notes.push_back(
          note_of(element, scene.obstacles.back().name + " is an obstacle: one body is grasped"));
    }
  }
}

// The links of a robot that is not connected to the hand, where the world has them.
void add_bystander(Scene& scene, const std::vector<GraspitWorldRobot>& robots, int bystander) {
  const GraspitPlatform whole = graspit_platform_with(robots, bystander);
  const auto member = std::find(whole.members.begin(), whole.members.end(), bystander);
  const AssembledPlatform joined = assemble(whole.platform);
  std::vector<Pose> X_BL;
  link_poses(joined.robot, joint_values(joined.robot, whole.start), X_BL);
  const std::size_t part = static_cast<std::size_t>(member - whole.members.begin());
  const std::size_t first = index(joined.parts[part].first_link);
  const Robot& robot = robots[index(bystander)].robot;
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    const Link& link = robot.links[l];
    add_obstacle(scene, new_name(scene, robots[index(bystander)].name + "/" + link.name), link.mesh,
                 whole.X_WB * X_BL[first + l], material_named(link.material));
  }
}

void read_robots(const XmlFile& file, Scene& scene, const SceneSource& source) {
  const std::string& other_hand = source.hand;
  const XmlElement world = file.root();
  const std::vector<GraspitWorldRobot> robots = read_graspit_world_robots(world, scene.notes);
  const int hand = graspit_hand_of(robots);
  if (hand < 0) world.fail("no robot here is a hand, which has an <approachDirection>");
  const GraspitPlatform carrier = graspit_platform_with(robots, hand);
  const auto position = std::find(carrier.members.begin(), carrier.members.end(), hand);
  const bool carried = robots[index(hand)].parent >= 0;
  for (std::size_t r = 0; r < robots.size(); ++r) {
    const int robot = static_cast<int>(r);
    const bool member =
        std::find(carrier.members.begin(), carrier.members.end(), robot) != carrier.members.end();
    if (robot == hand || (carried && member)) continue;
    add_bystander(scene, robots, robot);
    scene.notes.push_back(robots[r].name + " does not carry the hand: its links are obstacles");
  }
  scene.hand = other_hand.empty() ? robots[index(hand)].robot : find_robot(other_hand);
  if (source.derive_hand) scene.hand = with_hand(scene.hand);
  if (!other_hand.empty()) scene.hand_source = robot_source(other_hand);
  if (!carried) {
    if (other_hand.empty()) scene.hand_source = robot_source(robots[index(hand)].file.string());
    scene.notes.push_back("nothing carries " + robots[index(hand)].name +
                          ": it flies free, and where the world has it does not matter");
    return;
  }
  scene.carrier = Carrier{.platform = carrier.platform,
                          .source = robot_source(file.path().string()),
                          .hand = static_cast<int>(position - carrier.members.begin()),
                          .X_WB = carrier.X_WB,
                          .start = carrier.start};
  scene.carrier->platform.robots[index(scene.carrier->hand)].robot = scene.hand;
  if (!other_hand.empty()) scene.carrier->start = initial_dofs(scene.carrier->platform);
}

}  // namespace

Scene read_graspit_world(const XmlFile& file, const SceneSource& source) {
  const XmlElement world = file.root();
  if (world.name() != "world") {
    world.fail("not a GraspIt! world, whose outermost element is <world>");
  }
  Scene scene;
  scene.name = file.path().stem().string();
  constexpr std::array<std::string_view, 6> kKnown{"obstacle",   "graspableBody", "robot",
                                                   "connection", "camera",        "timeStep"};
  note_unknown(world, kKnown, scene.notes);
  read_bodies(world, scene);
  read_robots(file, scene, source);
  return scene;
}

Scene read_graspit_scene(const XmlFile& file, const SceneSource& source) {
  const XmlElement root = file.root();
  if (root.name() == "world") return read_graspit_world(file, source);
  if (root.name() == "root") {
    const GraspitBody body = read_graspit_body(file);
    Scene scene =
        make_scene(graspable({.body = body}), source.hand.empty() ? kDefaultHand : source.hand);
    scene.notes = body.notes;
    return scene;
  }
  root.fail("neither a GraspIt! world (<world>) nor a body (<root>)");
}

bool is_graspit_scene(const std::filesystem::path& file) {
  if (file.extension() != ".xml") return false;
  const XmlFile xml(file);
  const std::string name = xml.root().name();
  return name == "world" || name == "root";
}

}  // namespace prehend
