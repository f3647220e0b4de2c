#include "benchmarks/suite/hands.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <limits>

#include <Eigen/Eigenvalues>

#include "benchmarks/suite/planning.h"
#include "benchmarks/support/percentile.h"
#include "sim/base/input_error.h"
#include "sim/robot/files/robot_file.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/shape/mass_properties.h"

namespace prehend::bench {
namespace {

bool is_mesh_file(const std::filesystem::path& file) {
  constexpr std::array<const char*, 7> kMeshes = {".obj",  ".stl", ".ply", ".off",
                                                  ".gltf", ".glb", ".dae"};
  return std::find(kMeshes.begin(), kMeshes.end(), file.extension()) != kMeshes.end();
}

std::vector<std::filesystem::path> files_of(const std::vector<std::string>& paths) {
  std::vector<std::filesystem::path> files;
  for (const std::string& path : paths) {
    if (!std::filesystem::is_directory(path)) {
      files.emplace_back(path);
      continue;
    }
    std::vector<std::filesystem::path> inside;
    for (const auto& entry : std::filesystem::directory_iterator(path)) {
      if (is_mesh_file(entry.path())) inside.push_back(entry.path());
    }
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

// The object's extents along the principal axes of its inertia [m].
Vector3 principal_extents(const TriangleMesh& mesh) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> axes(mass_properties(mesh).unit_inertia);
  Vector3 least = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 most = -least;
  for (const Vector3& p_O : mesh.vertices) {
    const Vector3 p = axes.eigenvectors().transpose() * p_O;
    least = least.cwiseMin(p);
    most = most.cwiseMax(p);
  }
  return most - least;
}

bool takes(const Hand& hand, double width) {
  return std::any_of(hand.preshapes.begin(), hand.preshapes.end(), [&](const Preshape& preshape) {
    return preshape.min_width <= width && width <= preshape.max_width;
  });
}

std::vector<std::string> library_hands() {
  std::vector<std::string> names = library_robot_names();
  std::erase_if(names, [](const std::string& name) { return !find_robot(name).hand; });
  return names;
}

HandOnObject plan_one(const CompiledScene& scene) {
  HandOnObject found;
  found.object = scene.scene.object.name;
  found.of_its_size =
      takes(*scene.scene.hand.hand, principal_extents(scene.scene.object.mesh).minCoeff());
  PlanOptions options = standard_setting().options;
  options.volumes = false;
  const auto start = benchmark::Clock::now();
  const PlanResult result = plan(scene, options);
  found.seconds = 1e-3 * benchmark::milliseconds_since(start);
  found.stable = result.outcomes[Outcome::stable];
  if (result.grasps.empty()) return found;
  found.epsilon = result.grasps.front().trial.epsilon.lower;
  found.rule = result.grasps.front().rule;
  return found;
}

}  // namespace

std::vector<HandOnObject> plan_hands(const std::vector<std::string>& paths) {
  const std::vector<std::filesystem::path> files = files_of(paths);
  require(!files.empty(), {.field = "hands", .problem = "there is no mesh in these folders"});
  std::vector<HandOnObject> plans;
  for (const std::string& hand : library_hands()) {
    for (const std::filesystem::path& file : files) {
      const std::string object = file.stem().string();
      std::fprintf(stderr, "bench: hands: %s, %s\n", hand.c_str(), object.c_str());
      plans.push_back(plan_one(compile(load_scene(file, {.hand = hand}))));
      plans.back().hand = hand;
      plans.back().object = object;
    }
  }
  return plans;
}

}  // namespace prehend::bench
