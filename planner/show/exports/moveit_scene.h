// The surroundings of a plan as a message of MoveIt (docs/reference/exports.md).
#pragma once

#include <string>

namespace prehend {

struct CompiledScene;

// A moveit_msgs/PlanningScene to be added to another one (is_diff): the object and the obstacles as
// collision objects, each a mesh at its pose in the frame "world", and which links of the hand may
// touch the object. Links of an imported robot have the names of its file.
std::string moveit_scene_yaml(const CompiledScene& scene);

}  // namespace prehend
