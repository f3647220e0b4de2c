// A motion problem as MoveIt writes it: a planning scene and a request, each a YAML file, as the
// data set MotionBenchMaker has them (Chamzas et al. 2022).
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/scene/scene.h"

namespace prehend::benchmark {

struct MoveitProblem {
  std::vector<StaticBody> obstacles;    // boxes and cylinders
  std::map<std::string, double> start;  // of each joint [rad or m]
  std::map<std::string, double> goal;   // of the joints that the goal states [rad or m]
};

// Throws InputError that names the file where a body has another shape, or a pose or position is
// missing; and YAML::Exception.
MoveitProblem read_moveit_problem(const std::filesystem::path& scene_file,
                                  const std::filesystem::path& request_file);

}  // namespace prehend::benchmark
