// Scenes made by a program, without a scene file: an object and a hand, then what is around them.
#pragma once

#include <string>

#include "sim/robot/files/package_folders.h"
#include "sim/scene/scene.h"

namespace prehend {

// How a scene names a robot or a platform (Scene::hand_source, Carrier::source): a name of the
// library as it is, a file by its absolute path.
std::string robot_source(const std::string& name_or_file);

// A platform as the carrier of its hand, with its base at the world's origin, where its file says
// that it starts. `platform` as in mount. Throws InputError for an unknown platform, one without
// exactly one hand, and one whose hand stands on no other robot.
Carrier find_carrier(const std::string& platform, const ForeignRobotOptions& foreign = {});

// A scene in which `object` (make_graspable in scene.h) is grasped by a hand that no arm carries.
// `hand` is a name of the library ("franka_hand") or a robot file. Throws InputError that lists the
// names when it is neither.
Scene make_scene(GraspableBody object, const std::string& hand,
                 const ForeignRobotOptions& foreign = {});

// Stands for the object of a scene in which an arm only moves: a cube of 10 mm, 100 m above
// everything.
GraspableBody nothing_to_grasp();

// Puts a body into the scene that does not move: it stands in the way, and can be touched. `mesh`
// in the body's frame B [m]. Throws InputError for a mesh without triangles and for a name that
// another obstacle has: outcomes name what was in the way.
void add_obstacle(Scene& scene, std::string name, TriangleMesh mesh,
                  const Pose& X_WB = Pose::Identity(), Material material = Material::wood);

// Puts the hand on an arm: `platform` is a name of the library ("puma560_barrett") or a file with
// robots, of which exactly one is a hand. X_WB: its base in the world. `hand`: as in make_scene, in
// the place of the platform's own; empty: its own. The scene's hand becomes the one that was
// mounted; the arm starts where its file says, which `scene.carrier->start` may change. Throws
// InputError for an unknown platform or hand, and for one that nothing carries.
void mount(Scene& scene, const std::string& platform, const Pose& X_WB = Pose::Identity(),
           const std::string& hand = "");

}  // namespace prehend
