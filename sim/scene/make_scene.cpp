#include "sim/scene/make_scene.h"

#include <filesystem>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/robot/platform_file.h"
#include "sim/robot/robot_file.h"

namespace prehend {
namespace {

// As scenes keep it (Scene::hand_source): a path is made absolute; a name stays.
std::string source_of(const std::string& name_or_file) {
  if (!std::filesystem::is_regular_file(name_or_file)) return name_or_file;
  return std::filesystem::absolute(name_or_file).lexically_normal().string();
}

}  // namespace

Scene make_scene(GraspableBody object, const std::string& hand) {
  Scene scene;
  scene.name = object.name;
  scene.object = std::move(object);
  scene.hand = find_robot(hand);
  scene.hand_source = source_of(hand);
  return scene;
}

void add_obstacle(Scene& scene, std::string name, TriangleMesh mesh, const Pose& X_WB,
                  Material material) {
  if (mesh.empty()) throw InputError(scene.name + ": obstacles: no triangles (" + name + ")");
  for (const StaticBody& other : scene.obstacles) {
    if (other.name == name) {
      throw InputError(scene.name + ": obstacles: name used twice (" + name + ")");
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
  Carrier carrier;
  carrier.source = source_of(platform);
  carrier.platform = find_platform(platform);
  carrier.hand = hand_of(carrier.platform);
  carrier.X_WB = X_WB;
  MountedRobot& mounted = carrier.platform.robots[index(carrier.hand)];
  if (mounted.parent < 0) {
    throw InputError(scene.name + ": robot: nothing carries the hand (" + platform + ")");
  }
  if (!hand.empty()) mounted.robot = find_robot(hand);
  for (const MountedRobot& robot : carrier.platform.robots) {
    for (const DegreeOfFreedom& dof : robot.robot.dofs) carrier.start.push_back(dof.initial);
  }
  scene.hand = mounted.robot;
  scene.hand_source = source_of(hand);
  scene.carrier = std::move(carrier);
}

}  // namespace prehend
