#include "sim/scene/make_scene.h"

#include <filesystem>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/robot/files/foreign_robot.h"
#include "sim/robot/files/platform_file.h"
#include "sim/robot/files/robot_file.h"
#include "sim/robot/hand/derive_hand.h"
#include "sim/scene/free_start.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

// Where none of its robots is said to be a hand, the last one is taken as it, if another carries
// it.
void derive_hands(Platform& platform) {
  bool has_hand = false;
  for (MountedRobot& mounted : platform.robots) {
    if (!mounted.robot.hand) continue;
    mounted.robot = with_hand(std::move(mounted.robot));
    has_hand = true;
  }
  if (has_hand) return;
  MountedRobot& last = platform.robots.back();
  if (last.parent >= 0) last.robot = with_hand(std::move(last.robot));
}

}  // namespace

std::string robot_source(const std::string& name_or_file) {
  if (!is_file(name_or_file)) return name_or_file;
  return std::filesystem::absolute(name_or_file).lexically_normal().string();
}

Carrier find_carrier(const std::string& platform, const ForeignRobotOptions& foreign) {
  Carrier carrier;
  carrier.source = robot_source(platform);
  carrier.platform = find_platform(platform, foreign);
  // Files of other programs do not say where a robot starts.
  if (is_file(platform) && has_foreign_robot_name(platform)) find_free_start(carrier.platform);
  derive_hands(carrier.platform);
  carrier.hand = hand_of(carrier.platform);
  if (carrier.platform.robots[index(carrier.hand)].parent < 0) {
    throw InputError("nothing carries the hand");
  }
  carrier.start = initial_dofs(carrier.platform);
  return carrier;
}

Scene make_scene(GraspableBody object, const std::string& hand,
                 const ForeignRobotOptions& foreign) {
  Scene scene;
  scene.name = object.name;
  scene.object = std::move(object);
  scene.hand = with_hand(find_robot(hand, foreign));
  scene.hand_source = robot_source(hand);
  return scene;
}

GraspableBody nothing_to_grasp() {
  GraspableBody body =
      make_graspable("nothing", make_box(Vector3::Constant(0.01)), Material::plastic);
  body.X_WO = translation(Vector3(0.0, 0.0, 100.0));
  return body;
}

void add_obstacle(Scene& scene, std::string name, TriangleMesh mesh, const Pose& X_WB,
                  Material material) {
  if (mesh.empty()) throw InputError({scene.name, "obstacles", "no triangles", name});
  for (const StaticBody& other : scene.obstacles) {
    if (other.name == name) {
      throw InputError({scene.name, "obstacles", "name used twice", name});
    }
  }
  StaticBody body;
  body.name = std::move(name);
  body.mesh = std::move(mesh);
  body.X_WB = X_WB;
  body.material = material;
  scene.obstacles.push_back(std::move(body));
}

void mount(Scene& scene, const std::string& platform, const Pose& X_WB, const std::string& hand) {
  Carrier carrier = [&] {
    try {
      return find_carrier(platform);
    } catch (const InputError& error) {
      throw error.about("robot", platform).in_file(scene.name);
    }
  }();
  carrier.X_WB = X_WB;
  Robot& mounted = carrier.platform.robots[index(carrier.hand)].robot;
  if (!hand.empty()) mounted = with_hand(find_robot(hand));
  carrier.start = initial_dofs(carrier.platform);
  scene.hand = mounted;
  scene.hand_source = robot_source(hand);
  scene.carrier = std::move(carrier);
}

}  // namespace prehend
