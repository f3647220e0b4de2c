#include "benchmarks/motion/moveit_problem.h"

#include <cstddef>
#include <utility>
#include <yaml-cpp/yaml.h>

#include "sim/base/input_error.h"
#include "sim/base/pose.h"
#include "sim/shape/basic_shapes.h"

namespace prehend::benchmark {
namespace {

std::vector<double> numbers(const YAML::Node& list, std::size_t count,
                            const std::filesystem::path& file) {
  if (!list.IsSequence() || list.size() != count) {
    throw InputError(file.string() + ": a list of " + std::to_string(count) + " numbers is needed");
  }
  return list.as<std::vector<double>>();
}

Pose read_pose(const YAML::Node& node, const std::filesystem::path& file) {
  const std::vector<double> p = numbers(node["position"], 3, file);
  const std::vector<double> q = numbers(node["orientation"], 4, file);
  Pose X = Pose::Identity();
  X.linear() = Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized().toRotationMatrix();
  X.translation() = Vector3(p[0], p[1], p[2]);
  return X;
}

// Dimensions are in the order of shape_msgs/SolidPrimitive: those of a cylinder are its height and
// its radius.
TriangleMesh read_shape(const YAML::Node& node, const std::filesystem::path& file) {
  const auto type = node["type"].as<std::string>();
  const YAML::Node sizes = node["dimensions"];
  if (type == "box") {
    const std::vector<double> size = numbers(sizes, 3, file);
    return make_box({size[0], size[1], size[2]});
  }
  if (type == "cylinder") {
    const std::vector<double> size = numbers(sizes, 2, file);
    return make_cylinder(size[1], size[0]);
  }
  throw InputError(file.string() + ": a shape \"" + type +
                   "\", where boxes and cylinders are read");
}

std::map<std::string, double> read_start(const YAML::Node& state,
                                         const std::filesystem::path& file) {
  const auto names = state["name"].as<std::vector<std::string>>();
  const std::vector<double> values = numbers(state["position"], names.size(), file);
  std::map<std::string, double> result;
  for (std::size_t i = 0; i < names.size(); ++i) result[names[i]] = values[i];
  return result;
}

}  // namespace

MoveitProblem read_moveit_problem(const std::filesystem::path& scene_file,
                                  const std::filesystem::path& request_file) {
  MoveitProblem result;
  const YAML::Node scene = YAML::LoadFile(scene_file.string());
  for (const YAML::Node& body : scene["world"]["collision_objects"]) {
    const auto name = body["id"].as<std::string>();
    const YAML::Node shapes = body["primitives"];
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      StaticBody part{.name = name + "/" + std::to_string(i),
                      .mesh = read_shape(shapes[i], scene_file),
                      .X_WB = read_pose(body["primitive_poses"][i], scene_file)};
      result.obstacles.push_back(std::move(part));
    }
  }
  const YAML::Node request = YAML::LoadFile(request_file.string());
  result.start = read_start(request["start_state"]["joint_state"], request_file);
  for (const YAML::Node& joint : request["goal_constraints"][0]["joint_constraints"]) {
    result.goal[joint["joint_name"].as<std::string>()] = joint["position"].as<double>();
  }
  return result;
}

}  // namespace prehend::benchmark
