// Scenes and requests of MoveIt, as YAML of their messages.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/scene/scene.h"

namespace prehend {

class JsonFile;  // sim/base/json/json_field.h
struct SceneSource;

// Values of joints by the names that the robot's driver has for them [rad or m].
using NamedJoints = std::map<std::string, double>;

// A moveit_msgs/PlanningScene: its collision objects (boxes, spheres, cylinders, cones and meshes),
// its robot (SceneSource::robot, else the platform of the library that robot_model_name names), the
// robot's base and its joints. The object is the one that is chosen, else the first, where the
// source needs one; the others are obstacles. What of the message is not read is noted. Throws
// InputError.
Scene read_moveit_scene(const JsonFile& file, const SceneSource& source);

// The names of the collision objects of such a scene, in its order. Throws InputError.
std::vector<std::string> moveit_objects(const JsonFile& file);

// A moveit_msgs/MotionPlanRequest: where the arm starts and, of the first of its goals, where it is
// to go. Either may be empty.
struct MotionRequest {
  NamedJoints start;
  NamedJoints goal;
};

// Throws InputError, also for goals that are not values of joints.
MotionRequest read_motion_request(const std::filesystem::path& file);

// Sets the degrees of freedom of the platform whose joints are named, where a scene starts. Joints
// of the hand are brought inside their limits, with a note; names that no joint has are noted.
// Throws InputError where no joint of the arm is named.
void set_start(const NamedJoints& joints, Scene& scene);

}  // namespace prehend
