#include "sim/robot/hand/fingertip_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/base/index.h"
#include "sim/robot/hand/closing_dofs.h"

namespace prehend {
namespace {

constexpr double kOuter = 0.5;    // of the reach from the joint
constexpr double kNoWay = 1e-9;   // [m]
constexpr int kMostSlides = 100;  // steps of one

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
  const int last = parts.fingers.front().joints.back();
  if (robot.joints[index(last)].type == JointType::prismatic) slide_ = last;
}

double FingertipGap::distance(const Pose& X_BT, const std::vector<Pose>& X_BL) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < palm_.size(); ++k) {
    const Pose X_PT = X_BL[index(palm_links_[k])].inverse() * X_BT;
    least = std::min(least, find_gap(palm_[k], tip_, X_PT).upper);
  }
  return least;
}

// How far the tip moves along a unit vector until it touches the palm; infinite where it passes.
double FingertipGap::way(const Vector3& along, const Pose& X_BT,
                         const std::vector<Pose>& X_BL) const {
  const Joint& joint = robot_.joints[index(slide_)];
  const double most = 2.0 * (joint.upper - joint.lower);
  double way = 0.0;
  for (int step = 0; step < kMostSlides && way < most; ++step) {
    const double next = distance(translation(way * along) * X_BT, X_BL);
    if (next <= kNoWay) return way;
    way += next;
  }
  return std::numeric_limits<double>::infinity();
}

double FingertipGap::at(const std::vector<double>& dofs) const {
  RobotPoses poses;
  robot_poses(robot_, joint_values(robot_, dofs), poses);
  const Pose& X_BT = poses.X_BL[index(tip_link_)];
  const double nearest = distance(X_BT, poses.X_BL);
  if (slide_ < 0 || nearest <= kNoWay) return nearest;
  const Vector3 along = axis_in_base(robot_, slide_, poses.X_BJ);
  const double way_there = std::min(way(along, X_BT, poses.X_BL), way(-along, X_BT, poses.X_BL));
  return std::isfinite(way_there) ? way_there : nearest;
}

}  // namespace prehend
