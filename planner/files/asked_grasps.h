// A grasp file as it comes in: grasps that somebody proposed, or that an earlier run found.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/json/json_field.h"
#include "sim/trial/trial.h"

namespace prehend {

// What the file says of the scene; what it leaves open is for the caller to say.
struct AskedScene {
  std::optional<std::string> file;  // a scene's name, or a path (relative ones are beside the file)
  std::optional<std::string> unit;
  std::optional<std::string> hand;
};

// "scene": a name or path, or {"file", "unit", "hand"}; "hand" may also stand beside it.
// Throws InputError that names the file and the field.
AskedScene asked_scene(const JsonFile& file);

struct AskedGrasp {
  Candidate candidate;
  std::vector<GraspContact> contacts;  // as the file has them, for drawing
};

// Every entry of "grasps": X_object_hand (or X_world_hand), and a preshape by name, or joints, or
// dofs (numbers in the hand's order). Other fields are left alone. A grasp has approach_distance 0:
// it is tried where it is. Throws InputError that names the file, the grasp and the field.
std::vector<AskedGrasp> asked_grasps(const JsonFile& file, const CompiledScene& scene);

// Values outside the limits by more than this are refused; by less, they are rounding [rad or m].
inline constexpr double kLimitTolerance = 1e-6;

// Numbers in the robot's order, brought inside its limits where rounding left them. Throws
// InputError for one that is farther outside.
std::vector<double> asked_dofs(const JsonField& field, const Robot& robot);

}  // namespace prehend
