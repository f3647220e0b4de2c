#include "planner/show/scene_film.h"

#include <cstddef>
#include <utility>

#include <nlohmann/json.hpp>

#include "planner/show/palette.h"
#include "sim/robot/platform.h"

namespace prehend {
namespace {

// The frame before a joint's fixed pose behind it, in that of its parent: a turning joint does
// nothing but turn it about its own origin, so that half way between two moments it is half turned.
Pose moved_frame(const Robot& robot, std::size_t j, double value) {
  const Joint& joint = robot.joints[j];
  const Pose X_PN = joint.X_PJ * across(joint, value) * joint.X_JA.inverse();
  if (joint.parent < 0) return X_PN;
  return robot.joints[static_cast<std::size_t>(joint.parent)].X_JA * X_PN;
}

// Of a part of a robot, from `first` on.
bool is_in(std::size_t number, int first, std::size_t count) {
  const auto begin = static_cast<std::size_t>(first);
  return number >= begin && number < begin + count;
}

}  // namespace

// A robot whose base is at X_WB, but for the joints and links of a part of it.
struct SceneFilm::ShownRobot {
  std::string id;
  const Robot& robot;
  Pose X_WB;
  const std::vector<double>& joints;
  bool is_arm = false;
  PlatformPart left_out = {};
  std::size_t joints_left_out = 0;
  std::size_t links_left_out = 0;

  Color color_of(const Link& link) const {
    if (is_arm) return palette::kArm;
    return link.material == "rubber" ? palette::kRubber : palette::kHard;
  }
};

int SceneFilm::place(const std::string& id, const AnimatedNode& node, const Pose& X_PN) {
  const auto [known, is_new] = numbers_.try_emplace(id, static_cast<int>(nodes_.size()));
  if (is_new) {
    nodes_.push_back(node);
    is_fixed_.push_back(false);
  }
  AnimatedNode& placed = nodes_[static_cast<std::size_t>(known->second)];
  // It waited where it appears.
  placed.X_PN.resize(moment_count_, X_PN);
  placed.X_PN.push_back(X_PN);
  if (placed.parent < 0) {
    placed.shown.resize(moment_count_, false);
    placed.shown.push_back(true);
  }
  return known->second;
}

void SceneFilm::place_body(const std::string& kind, const std::string& name,
                           const std::string& surface, const TriangleMesh& mesh, const Color& color,
                           const Pose& X_WB) {
  const std::string id = kind + " " + surface + " " + name;
  AnimatedNode node;
  if (!numbers_.contains(id)) node = {.name = name, .mesh = mesh, .color = color};
  place(id, node, X_WB);
}

void SceneFilm::place_robot(const ShownRobot& shown) {
  const Robot& robot = shown.robot;
  const bool is_new = !numbers_.contains(shown.id);
  const int base = place(shown.id, {.name = robot.name}, shown.X_WB);
  std::vector<int> frames(robot.joints.size(), base);
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    if (is_in(j, shown.left_out.first_joint, shown.joints_left_out)) continue;
    const Joint& joint = robot.joints[j];
    const int parent = joint.parent < 0 ? base : frames[static_cast<std::size_t>(joint.parent)];
    frames[j] = place(shown.id + " " + std::to_string(j), {.name = joint.name, .parent = parent},
                      moved_frame(robot, j, shown.joints[j]));
  }
  if (!is_new) return;
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    if (is_in(l, shown.left_out.first_link, shown.links_left_out)) continue;
    const Link& link = robot.links[l];
    const auto joint = static_cast<std::size_t>(link.joint);
    const bool moves = link.joint >= 0;
    nodes_.push_back({.name = link.name,
                      .parent = moves ? frames[joint] : base,
                      .mesh = link.mesh,
                      .color = shown.color_of(link),
                      .X_PN = {moves ? robot.joints[joint].X_JA : Pose::Identity()}});
    is_fixed_.push_back(true);
  }
}

void SceneFilm::place_arm(const SceneMoment& moment) {
  const Carrier& carrier = *moment.scene.carrier;
  const AssembledPlatform assembled = assemble(carrier.platform);
  const auto hand = static_cast<std::size_t>(carrier.hand);
  const std::vector<double> joints =
      moment.arm_joints.empty() ? joint_values(assembled.robot, carrier.start) : moment.arm_joints;
  place_robot({.id = "arm " + moment.robots,
               .robot = assembled.robot,
               .X_WB = carrier.X_WB,
               .joints = joints,
               .is_arm = true,
               .left_out = assembled.parts[hand],
               .joints_left_out = carrier.platform.robots[hand].robot.joints.size(),
               .links_left_out = carrier.platform.robots[hand].robot.links.size()});
}

void SceneFilm::add(const SceneMoment& moment) {
  const Scene& scene = moment.scene;
  if (!scene.object.mesh.empty()) {
    place_body("object", scene.object.name, moment.object, scene.object.mesh, palette::kObject,
               scene.object.X_WO);
  }
  for (std::size_t b = 0; b < scene.obstacles.size(); ++b) {
    const StaticBody& body = scene.obstacles[b];
    place_body("obstacle", body.name, moment.obstacles[b], body.mesh, palette::kObstacle,
               body.X_WB);
  }
  place_robot({.id = "hand " + moment.robots,
               .robot = scene.hand,
               .X_WB = moment.X_WH,
               .joints = moment.joints});
  if (scene.carrier) place_arm(moment);
  ++moment_count_;
  // What was not placed stays where it is, hidden.
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    AnimatedNode& node = nodes_[n];
    if (!is_fixed_[n]) node.X_PN.resize(moment_count_, node.X_PN.back());
    if (node.parent < 0) node.shown.resize(moment_count_, false);
  }
}

std::string SceneFilm::glb(const std::string& name, double seconds) const {
  std::vector<double> times(moment_count_);
  for (std::size_t m = 0; m < times.size(); ++m) times[m] = static_cast<double>(m) * seconds;
  return animated_glb(nodes_, times, name, {});
}

}  // namespace prehend
