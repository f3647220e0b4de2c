#include "sim/robot/files/sphere_model.h"

#include <algorithm>
#include <set>

#include "sim/base/index.h"
#include "sim/robot/files/urdf_form.h"
#include "sim/robot/link_pairs.h"

namespace prehend {
namespace {

// More of them for a smaller error: about a quarter as many for twice the error.
double error_for(const TriangleMesh& mesh) {
  constexpr double kPart = 0.12;
  return std::clamp(kPart * bounds(mesh).size().norm(), 3e-3, 30e-3);
}

SphereLink sphere_link(const std::string& name, const TriangleMesh& mesh, const Pose& X_AL) {
  SphereLink link{name, {}, 0.0};
  if (mesh.empty()) return link;
  link.error = error_for(mesh);
  link.spheres = sphere_cover(ProximityMesh(mesh), link.error);
  const Pose X_LA = X_AL.inverse();
  for (CoverSphere& sphere : link.spheres) sphere.center_M = X_LA * sphere.center_M;
  return link;
}

std::vector<SphereModel::Pair> unchecked_pairs(const Robot& whole) {
  Robot without = whole;
  without.exempt_pairs.clear();
  const auto set_of = [](const std::vector<std::pair<int, int>>& pairs) {
    return std::set<std::pair<int, int>>(pairs.begin(), pairs.end());
  };
  const std::set<std::pair<int, int>> checked = set_of(checked_pairs(whole));
  const std::set<std::pair<int, int>> apart = set_of(checked_pairs(without));
  std::vector<SphereModel::Pair> pairs;
  const auto count = static_cast<int>(whole.links.size());
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      if (!checked.contains({a, b})) pairs.push_back({a, b, !apart.contains({a, b})});
    }
  }
  return pairs;
}

}  // namespace

SphereModel sphere_model(const Platform& platform) {
  const AssembledPlatform assembled = assemble(platform);
  SphereModel model;
  model.name = platform.name;
  model.links.resize(assembled.robot.links.size());
  for (std::size_t r = 0; r < platform.robots.size(); ++r) {
    const MountedRobot& mounted = platform.robots[r];
    const Robot& robot = model.robots.emplace_back(urdf_form(platform, mounted));
    const std::size_t first = index(assembled.parts[r].first_link);
    for (std::size_t l = 0; l < robot.links.size(); ++l) {
      model.links[first + l] =
          sphere_link(robot.links[l].name, robot.links[l].mesh, own_frame(robot, l));
    }
    if (mounted.mount) {
      model.links[first - 1] = sphere_link(mounted.name + "_" + mounted.mount->name,
                                           mounted.mount->mesh, Pose::Identity());
    }
  }
  model.unchecked = unchecked_pairs(assembled.robot);
  return model;
}

}  // namespace prehend
