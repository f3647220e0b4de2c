#include "sim/robot/hand/hand_axes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

#include "sim/base/index.h"
#include "sim/robot/hand/fingertip_gap.h"

namespace prehend {
namespace {

constexpr double kParallel = 0.9;      // cosine between bending axes
constexpr double kSideways = 0.5;      // most that the closing axis may be along them
constexpr double kSame = 0.985;        // cosine of 10 degrees: of directions that count as one
constexpr double kNoDirection = 1e-9;  // [m]
constexpr double kMet = 1e-6;          // distance of the only finger from the palm [m]

Vector3 without(const Vector3& v, const Vector3& unit) { return v - unit.dot(v) * unit; }

// The common axis about which the fingers bend, if there is one: of the last joints of all fingers
// but the thumb.
std::optional<Vector3> bending_axis(const Robot& robot, const HandParts& parts,
                                    const Opposition& best) {
  std::vector<Pose> X_BJ;
  joint_poses(robot, joint_values(robot, best.dofs), X_BJ);
  std::vector<Vector3> axes;
  for (std::size_t f = 0; f < parts.fingers.size(); ++f) {
    const Joint& joint = robot.joints[index(parts.fingers[f].joints.back())];
    if (f == best.thumb && parts.fingers.size() > 1) continue;
    if (joint.type != JointType::revolute) return std::nullopt;
    const Vector3 axis = axis_in_base(robot, parts.fingers[f].joints.back(), X_BJ);
    axes.push_back(!axes.empty() && axis.dot(axes.front()) < 0.0 ? Vector3(-axis) : axis);
  }
  Vector3 sum = Vector3::Zero();
  for (const Vector3& axis : axes) sum += axis;
  const Vector3 mean = sum.normalized();
  for (const Vector3& axis : axes) {
    if (axis.dot(mean) < kParallel) return std::nullopt;
  }
  return mean;
}

// Where the line from p against the unit direction u meets the triangle, as a distance [m].
std::optional<double> distance_back(const Vector3& p, const Vector3& u, const Vector3& a,
                                    const Vector3& b, const Vector3& c) {
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const Vector3 h = u.cross(ac);
  const double det = -ab.dot(h);
  if (std::abs(det) < 1e-18) return std::nullopt;
  const Vector3 s = p - a;
  const double v = -s.dot(h) / det;
  const Vector3 q = s.cross(ab);
  const double w = -u.dot(q) / det;
  constexpr double kEdge = 1e-9;
  if (v < -kEdge || w < -kEdge || v + w > 1.0 + kEdge) return std::nullopt;
  return ac.dot(q) / det;
}

// Where the line through g along the approach meets the front of the palm; g may lie inside it.
Vector3 palm_behind(const Robot& robot, const HandParts& parts, const Opposition& best,
                    const Vector3& g, const Vector3& approach) {
  std::vector<Pose> X_BL;
  link_poses(robot, joint_values(robot, best.dofs), X_BL);
  double back = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
  for (const int link : parts.palm_links) {
    const TriangleMesh mesh = transformed(robot.links[index(link)].mesh, X_BL[index(link)]);
    for (const Vector3& p : mesh.vertices) highest = std::max(highest, approach.dot(p - g));
    for (const Triangle& t : mesh.triangles) {
      const auto hit = distance_back(g, approach, mesh.vertices[index(t[0])],
                                     mesh.vertices[index(t[1])], mesh.vertices[index(t[2])]);
      if (hit) back = std::min(back, *hit);
    }
  }
  if (!std::isfinite(back)) back = std::isfinite(highest) ? std::max(0.0, -highest) : 0.0;
  return g - back * approach;
}

// Tip of the thumb, and of what it closes on, at a time of the closing motion.
struct Pinch {
  Vector3 thumb;
  Vector3 others;
};

class Pinching {
 public:
  Pinching(const Robot& robot, const HandParts& parts, const ClosingDofs& closing,
           const Opposition& best)
      : robot_(robot), parts_(parts), closing_(closing), best_(best) {}

  Pinch at(double time) const {
    const auto tips = tips_at(robot_, parts_, closed_for(robot_, closing_, time, best_.dofs));
    const bool alone = tips.size() < 2;
    return {tips[best_.thumb], alone ? tips[best_.thumb] : mean_of_others(tips, best_.thumb)};
  }

 private:
  const Robot& robot_;
  const HandParts& parts_;
  const ClosingDofs& closing_;
  const Opposition& best_;
};

// The links that move with the palm's joint: those before a wrist say nothing of the palm.
std::vector<int> palm_body(const Robot& robot, const HandParts& parts) {
  std::vector<int> links;
  for (const int link : parts.palm_links) {
    if (robot.links[index(link)].joint == parts.palm_joint) links.push_back(link);
  }
  return links.empty() ? parts.palm_links : links;
}

// The axis of the palm's surface along which it extends least.
Vector3 thinnest_axis(const Robot& robot, const HandParts& parts) {
  const std::vector<int> links = palm_body(robot, parts);
  const Vector3 middle = middle_of(robot, links);
  std::vector<Pose> X_BL;
  link_poses(robot, joint_values(robot, initial_dofs(robot)), X_BL);
  Matrix3 spread = Matrix3::Zero();
  for (const int link : links) {
    const TriangleMesh mesh = transformed(robot.links[index(link)].mesh, X_BL[index(link)]);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const double area = doubled_area_vector(mesh, t).norm();
      Vector3 sum = Vector3::Zero();
      for (const int v : mesh.triangles[t]) {
        const Vector3 p = mesh.vertices[index(v)] - middle;
        spread += area * p * p.transpose();
        sum += p;
      }
      spread += area * sum * sum.transpose();
    }
  }
  return Eigen::SelfAdjointEigenSolver<Matrix3>(spread).eigenvectors().col(0);
}

// How the tips of the others move where each finger turns about its first joint that closes it.
Vector3 curl_of(const Robot& robot, const HandParts& parts, const ClosingDofs& closing,
                const Opposition& best) {
  RobotPoses poses;
  robot_poses(robot, joint_values(robot, best.dofs), poses);
  Vector3 sum = Vector3::Zero();
  for (std::size_t f = 0; f < parts.fingers.size(); ++f) {
    if (f == best.thumb && parts.fingers.size() > 1) continue;
    const Finger& finger = parts.fingers[f];
    const std::vector<int> joints = closing_joints(robot, finger, poses.X_BJ);
    const auto first = std::find_if(joints.begin(), joints.end(), [&](int joint) {
      return closing.closes(index(robot.joints[index(joint)].dof));
    });
    if (first == joints.end()) continue;
    const Joint& joint = robot.joints[index(*first)];
    const double rate = joint.ratio * closing.velocity[index(joint.dof)];
    const Vector3 axis = axis_in_base(robot, *first, poses.X_BJ);
    const Vector3 tip = poses.X_BL[index(finger.tip_link)] * finger.tip;
    if (joint.type == JointType::prismatic) {
      sum += rate * axis;
      continue;
    }
    const Pose X_BP = joint.parent < 0 ? Pose::Identity() : poses.X_BJ[index(joint.parent)];
    const Vector3 motion = rate * axis.cross(tip - X_BP * joint.X_PJ.translation());
    if (motion.norm() > kNoDirection) sum += motion.normalized();
  }
  return sum;
}

}  // namespace

std::vector<Vector3> other_approaches(const Robot& robot, const HandParts& parts,
                                      const ClosingDofs& closing, const Opposition& best,
                                      const Vector3& approach) {
  std::vector<Vector3> others;
  const auto add = [&](const Vector3& direction) {
    if (direction.norm() < kNoDirection) return;
    const Vector3 unit = direction.normalized();
    const auto same = [&](const Vector3& known) { return unit.dot(known) > kSame; };
    if (!same(approach) && std::none_of(others.begin(), others.end(), same)) others.push_back(unit);
  };
  const Vector3 curl = curl_of(robot, parts, closing, best);
  const Vector3 thin = thinnest_axis(robot, parts);
  add(thin.dot(approach + curl) < 0.0 ? Vector3(-thin) : thin);
  add(curl);
  const std::vector<Vector3> whole = others;
  for (const Vector3& direction : whole) add(approach + direction);
  return others;
}

std::optional<HandAxes> across_bending(const Robot& robot, const HandParts& parts,
                                       const Opposition& best, const HandAxes& axes) {
  const std::optional<Vector3> bending = bending_axis(robot, parts, best);
  if (!bending) return std::nullopt;
  const Vector3 across = bending->cross(axes.approach);
  if (across.norm() < kParallel || std::abs(across.normalized().dot(axes.closing)) > kSame) {
    return std::nullopt;
  }
  HandAxes turned = axes;
  turned.closing = (across.dot(axes.closing) < 0.0 ? -1.0 : 1.0) * across.normalized();
  return turned;
}

HandAxes find_hand_axes(const Robot& robot, const HandParts& parts, const ClosingDofs& closing,
                        const Opposition& best, const StatedHand& stated) {
  const Pinching pinching(robot, parts, closing, best);
  const bool alone = parts.fingers.size() < 2;
  double meeting = best.meeting;
  if (alone) {
    // The finger goes as far as the palm lets it.
    const double end = closing_time(robot, closing);
    const FingertipGap gap(robot, parts);
    for (int k = 1; k <= 64; ++k) {
      const auto dofs = closed_for(robot, closing, end * k / 64, best.dofs);
      if (gap.at(dofs) <= kMet) break;
      meeting = end * k / 64;
    }
  }
  const Pinch met = pinching.at(meeting);
  const Pinch half = pinching.at(0.5 * meeting);
  const Joint& last = robot.joints[index(parts.fingers[best.thumb].joints.back())];
  const std::optional<Vector3> bending = bending_axis(robot, parts, best);
  HandAxes axes;
  Vector3 c = half.others - half.thumb;
  if (alone) c = met.thumb - pinching.at(0.9 * meeting).thumb;
  if (!alone && last.type == JointType::prismatic) c = met.thumb - pinching.at(0.0).thumb;
  if (bending && std::abs(bending->dot(c.normalized())) < kSideways) c = without(c, *bending);
  if (stated.closing) c = *stated.closing;
  if (stated.approach && !stated.closing) c = without(c, *stated.approach);
  if (c.norm() < kNoDirection) c = any_orthogonal(stated.approach.value_or(Vector3::UnitZ()));
  axes.closing = c.normalized();
  const Vector3 g = 0.5 * (met.thumb + met.others);
  Vector3 a = without(g - middle_of(robot, palm_body(robot, parts)), axes.closing);
  if (bending && std::abs(bending->dot(axes.closing)) < kSideways) {
    const Vector3 w = without(*bending, axes.closing).normalized();
    const Vector3 in_plane = without(a, w);
    if (in_plane.norm() > kSideways * a.norm()) a = in_plane;
  }
  if (stated.approach) a = *stated.approach;
  if (a.norm() < kNoDirection) a = any_orthogonal(axes.closing);
  axes.approach = a.normalized();
  axes.closing = without(axes.closing, axes.approach).normalized();
  axes.origin = stated.origin.value_or(palm_behind(robot, parts, best, g, axes.approach));
  return axes;
}

}  // namespace prehend
