// How deep the solids of a world penetrate each other, seen with nothing that moved them: own
// kinematics, and triangles against triangles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "sim/motion/world.h"
#include "tests/support/brute_force.h"

namespace prehend::test {

// How a world's solids stand: bodies, then robots with their links.
using Placement = std::vector<Pose>;

// The deepest penetration of two solids.
struct Penetration {
  double depth = 0.0;  // [m]
  std::string a;
  std::string b;
};

// The part of `triangles`, moved, that comes into a box.
inline std::vector<Corners> triangles_within(const std::vector<Corners>& triangles, const Pose& X,
                                             const Bounds& box) {
  std::vector<Corners> inside;
  for (const Corners& t : triangles) {
    const Corners here = {X * t[0], X * t[1], X * t[2]};
    if (bounds_apart(bounds_of(here), box) == 0.0) inside.push_back(here);
  }
  return inside;
}

// Where the edges of `a` run through `b`, the depth of their points below b's surface, at most.
// `near` are the triangles of b that they can cross, `all` is b.
inline double depth_of_edges(const std::vector<Corners>& a, const std::vector<Corners>& near,
                             const std::vector<Corners>& all) {
  constexpr int kSamples = 8;  // of each part that is inside, besides its ends
  double deepest = 0.0;
  for (const Corners& t : a) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3& from = t[k];
      const Vector3 way = t[(k + 1) % 3] - from;
      const Bounds box = bounds_of({from, from + way, from});
      std::vector<double> cuts = {0.0, 1.0};
      for (const Corners& other : near) {
        if (bounds_apart(box, bounds_of(other)) > 0.0) continue;
        if (!segment_meets_triangle(from, from + way, other)) continue;
        const Vector3 n = (other[1] - other[0]).cross(other[2] - other[0]);
        cuts.push_back((other[0] - from).dot(n) / way.dot(n));
      }
      if (cuts.size() == 2) continue;
      std::sort(cuts.begin(), cuts.end());
      for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
        const double length = cuts[c + 1] - cuts[c];
        if (length * way.norm() < 1e-7) continue;
        if (winding(from + (cuts[c] + 0.5 * length) * way, all) <= 0) continue;
        for (int s = 0; s <= kSamples + 1; ++s) {
          const Vector3 p = from + (cuts[c] + length * s / (kSamples + 1)) * way;
          deepest = std::max(deepest, point_to_surface(p, all));
        }
      }
    }
  }
  return deepest;
}

// The solids of a world, which keep their shapes while it moves.
class WorldJudge {
 public:
  explicit WorldJudge(const World& world) {
    for (const WorldBody& body : world.bodies) add(body.name, body.shape, -1, body.is_fixed);
    for (std::size_t r = 0; r < world.robots.size(); ++r) {
      const RobotModel& model = *world.robots[r].model;
      const int first = static_cast<int>(solids_.size());
      for (const CollisionBody& shape : model.shapes) {
        add(world.robots[r].name + "/" + shape.name, shape, static_cast<int>(r), false);
      }
      for (const auto& [a, b] : model.self_pairs) self_pairs_.emplace_back(first + a, first + b);
    }
    for (int b = 0; b < static_cast<int>(solids_.size()); ++b) {
      for (int a = 0; a < b; ++a) {
        const Solid& of_a = at(a);
        const Solid& of_b = at(b);
        const bool same = of_a.robot >= 0 && of_a.robot == of_b.robot;
        if (!same && !(of_a.is_fixed && of_b.is_fixed)) pairs_.emplace_back(a, b);
      }
    }
    pairs_.insert(pairs_.end(), self_pairs_.begin(), self_pairs_.end());
  }

  static Placement placement(const World& world) {
    Placement poses;
    for (const WorldBody& body : world.bodies) poses.push_back(body.motion.X_WB);
    for (const WorldRobot& robot : world.robots) {
      const Robot& model = robot.model->robot;
      const Eigen::VectorXd q = joints_of(robot);
      std::vector<Pose> after;
      for (std::size_t j = 0; j < model.joints.size(); ++j) {
        const Joint& joint = model.joints[j];
        const double value = q[static_cast<Eigen::Index>(j)] + joint.zero;
        Pose motion = Pose::Identity();
        if (joint.type == JointType::revolute) {
          motion.linear() = Eigen::AngleAxisd(value, joint.axis).toRotationMatrix();
        } else {
          motion.translation() = value * joint.axis;
        }
        const Pose& before =
            joint.parent < 0 ? robot.X_WB : after[static_cast<std::size_t>(joint.parent)];
        after.push_back(before * joint.X_PJ * motion * joint.X_JA);
      }
      for (const Link& link : model.links) {
        poses.push_back(link.joint < 0 ? robot.X_WB : after[static_cast<std::size_t>(link.joint)]);
      }
    }
    return poses;
  }

  // The deepest of all pairs that may touch.
  Penetration deepest(const Placement& poses) const {
    std::vector<Bounds> boxes;
    for (std::size_t i = 0; i < solids_.size(); ++i) {
      boxes.push_back(moved_box(solids_[i].box, poses[i]));
    }
    Penetration worst;
    for (const auto& [a, b] : pairs_) {
      const auto i = static_cast<std::size_t>(a);
      const auto k = static_cast<std::size_t>(b);
      if (bounds_apart(boxes[i], boxes[k]) > 0.0) continue;
      const double depth = depth_of(solids_[i], poses[i], boxes[i], solids_[k], poses[k], boxes[k]);
      if (depth > worst.depth) worst = {depth, solids_[i].name, solids_[k].name};
    }
    return worst;
  }

 private:
  struct Solid {
    std::string name;
    std::vector<Corners> triangles;  // in its frame
    Bounds box;
    int robot = -1;
    bool is_fixed = false;
  };

  const Solid& at(int i) const { return solids_[static_cast<std::size_t>(i)]; }

  void add(const std::string& name, const CollisionBody& shape, int robot, bool is_fixed) {
    std::vector<Corners> triangles = soup(shape.mesh.mesh());
    Bounds box = bounds_of(triangles.front());
    for (const Corners& t : triangles) {
      box.lower = box.lower.cwiseMin(bounds_of(t).lower);
      box.upper = box.upper.cwiseMax(bounds_of(t).upper);
    }
    solids_.push_back({name, std::move(triangles), box, robot, is_fixed});
  }

  static Bounds moved_box(const Bounds& box, const Pose& X) {
    const Vector3 middle = X * box.center();
    const Vector3 reach = X.linear().cwiseAbs() * (0.5 * (box.upper - box.lower));
    return {middle - reach, middle + reach};
  }

  static double depth_of(const Solid& a, const Pose& X_WA, const Bounds& box_a, const Solid& b,
                         const Pose& X_WB, const Bounds& box_b) {
    const Bounds shared{box_a.lower.cwiseMax(box_b.lower), box_a.upper.cwiseMin(box_b.upper)};
    const std::vector<Corners> near_a = triangles_within(a.triangles, X_WA, shared);
    const std::vector<Corners> near_b = triangles_within(b.triangles, X_WB, shared);
    if (near_a.empty() && near_b.empty()) return 0.0;
    if (surfaces_meet(near_a, near_b)) {
      const std::vector<Corners> all_a = triangles_within(a.triangles, X_WA, box_a);
      const std::vector<Corners> all_b = triangles_within(b.triangles, X_WB, box_b);
      return std::max(depth_of_edges(near_a, near_b, all_b), depth_of_edges(near_b, near_a, all_a));
    }
    return std::max(depth_inside(a, X_WA, b, X_WB), depth_inside(b, X_WB, a, X_WA));
  }

  // Of a solid in one piece whose surface does not meet the other's: inside or outside.
  static double depth_inside(const Solid& inner, const Pose& X_WI, const Solid& outer,
                             const Pose& X_WO) {
    const Vector3 p_O = X_WO.inverse() * (X_WI * inner.triangles.front()[0]);
    if (bounds_apart({p_O, p_O}, outer.box) > 0.0) return 0.0;
    return winding(p_O, outer.triangles) > 0 ? point_to_surface(p_O, outer.triangles) : 0.0;
  }

  std::vector<Solid> solids_;
  std::vector<std::pair<int, int>> pairs_;
  std::vector<std::pair<int, int>> self_pairs_;
};

// Poses between two placements: each solid turns and shifts evenly.
inline Placement between(const Placement& from, const Placement& to, double part) {
  Placement poses;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Eigen::Quaterniond a(from[i].linear());
    const Eigen::Quaterniond b(to[i].linear());
    const Vector3 p = (1.0 - part) * from[i].translation() + part * to[i].translation();
    poses.push_back(pose_from(a.slerp(part, b).toRotationMatrix(), p));
  }
  return poses;
}

// Kinetic energy of the bodies and theirs in gravity, by the textbook.
inline double energy_of_bodies(const World& world) {
  double sum = 0.0;
  for (const WorldBody& body : world.bodies) {
    if (body.is_fixed) continue;
    const Vector3 w_B = body.motion.X_WB.linear().transpose() * body.motion.angular;
    const Vector3 center = body.motion.X_WB * body.inertial.center_of_mass;
    sum += 0.5 * body.inertial.mass * body.motion.linear.squaredNorm() +
           0.5 * w_B.dot(body.inertial.inertia * w_B) -
           body.inertial.mass * world.gravity.dot(center);
  }
  return sum;
}

}  // namespace prehend::test
