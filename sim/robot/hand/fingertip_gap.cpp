#include "sim/robot/hand/fingertip_gap.h"

#include <algorithm>
#include <limits>

#include "sim/base/index.h"

namespace prehend {
namespace {

constexpr double kOuter = 0.5;  // of the reach from the joint

// The triangles of the outer half; where no triangle lies in it as a whole, a fan over its corners.
TriangleMesh outer_half(const TriangleMesh& mesh) {
  double reach = 0.0;
  for (const Vector3& p : mesh.vertices) reach = std::max(reach, p.norm());
  const auto outer = [&](int v) { return mesh.vertices[index(v)].norm() >= kOuter * reach; };
  TriangleMesh part{.vertices = mesh.vertices, .triangles = {}};
  for (const Triangle& t : mesh.triangles) {
    if (std::all_of(t.begin(), t.end(), outer)) part.triangles.push_back(t);
  }
  if (!part.triangles.empty()) return part;
  std::vector<int> corners;
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) {
    if (outer(v)) corners.push_back(v);
  }
  for (std::size_t k = 0; k + 2 < corners.size(); ++k) {
    part.triangles.push_back({corners[0], corners[k + 1], corners[k + 2]});
  }
  return part.triangles.empty() ? mesh : part;
}

}  // namespace

FingertipGap::FingertipGap(const Robot& robot, const HandParts& parts)
    : robot_(robot),
      tip_link_(parts.fingers.front().tip_link),
      palm_links_(parts.palm_links),
      tip_(outer_half(robot.links[index(tip_link_)].mesh)) {
  for (const int link : palm_links_) palm_.emplace_back(robot.links[index(link)].mesh);
}

double FingertipGap::at(const std::vector<double>& dofs) const {
  std::vector<Pose> X_BL;
  link_poses(robot_, joint_values(robot_, dofs), X_BL);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < palm_.size(); ++k) {
    const Pose X_PT = X_BL[index(palm_links_[k])].inverse() * X_BL[index(tip_link_)];
    least = std::min(least, find_gap(palm_[k], tip_, X_PT).upper);
  }
  return least;
}

}  // namespace prehend
