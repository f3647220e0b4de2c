// Postures of robots seen with nothing that made them: own kinematics from the robots' numbers,
// triangles against triangles.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/motion/control/trajectory.h"
#include "sim/scene/scene.h"
#include "tests/support/brute_force.h"

namespace prehend::test {

using Matrix4 = Eigen::Matrix4d;

inline Matrix4 turn(double angle, const Vector3& axis) {
  Matrix4 m = Matrix4::Identity();
  m.topLeftCorner<3, 3>() = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  return m;
}

inline Matrix4 shift(const Vector3& way) {
  Matrix4 m = Matrix4::Identity();
  m.topRightCorner<3, 1>() = way;
  return m;
}

// A rigid body in the tree of frames: frames are joints "ROBOT/JOINT", or "" for the base.
struct Body {
  std::string name;
  std::string frame;               // it is fixed to
  std::vector<Corners> triangles;  // in that frame
  Bounds box;
};

inline Bounds box_of(const std::vector<Corners>& triangles) {
  Bounds box = bounds_of(triangles.front());
  for (const Corners& t : triangles) {
    const Bounds one = bounds_of(t);
    box.lower = box.lower.cwiseMin(one.lower);
    box.upper = box.upper.cwiseMax(one.upper);
  }
  return box;
}

inline Vector3 moved(const Matrix4& X, const Vector3& p) {
  return X.topLeftCorner<3, 3>() * p + X.topRightCorner<3, 1>();
}

// A box around the box, moved.
inline Bounds moved(const Matrix4& X, const Bounds& box) {
  const Vector3 middle = moved(X, box.center());
  const Vector3 half = 0.5 * (box.upper - box.lower);
  const Vector3 reach = X.topLeftCorner<3, 3>().cwiseAbs() * half;
  return {middle - reach, middle + reach};
}

// Joint values by name, "ROBOT/JOINT".
using Posture = std::map<std::string, double>;
using Frames = std::map<std::string, Matrix4>;

// All robots of a carrier as bodies and frames, in the world.
class Machine {
 public:
  explicit Machine(const Scene& scene) : Machine(*scene.carrier) {}

  explicit Machine(Carrier carrier) : carrier_(std::move(carrier)) {
    for (const MountedRobot& mounted : carrier_.platform.robots) add_links(mounted);
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) {
        if (!joined(bodies_[a].frame, bodies_[b].frame)) pairs_.emplace_back(a, b);
      }
    }
  }

  const std::vector<Body>& bodies() const { return bodies_; }
  const std::vector<std::pair<std::size_t, std::size_t>>& pairs() const { return pairs_; }

  // The frame after every joint, and "", in the world.
  Frames frames(const Posture& posture) const {
    Frames frames;
    frames[""] = carrier_.X_WB.matrix();
    for (const MountedRobot& mounted : carrier_.platform.robots) {
      const Matrix4 base = frames.at(carried_by(mounted)) * mounted.X_MR.matrix();
      for (const Joint& joint : mounted.robot.joints) {
        const std::string name = mounted.name + "/" + joint.name;
        const Matrix4& from =
            joint.parent < 0 ? base : frames.at(joint_name(mounted, joint.parent));
        frames[name] = from * across(joint, posture.at(name));
      }
    }
    return frames;
  }

  Matrix4 hand_base(const Frames& frames) const {
    const MountedRobot& hand = carrier_.platform.robots[at(carrier_.hand)];
    return frames.at(carried_by(hand)) * hand.X_MR.matrix();
  }

  std::string carried_by(const MountedRobot& mounted) const {
    if (mounted.parent < 0) return "";
    const MountedRobot& parent = carrier_.platform.robots[at(mounted.parent)];
    const Chain& chain = parent.robot.chains[at(mounted.chain)];
    return joint_name(parent, chain.first_joint + chain.joint_count - 1);
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  static Matrix4 across(const Joint& joint, double value) {
    const double moved = value + joint.zero;
    const Matrix4 motion = joint.type == JointType::revolute ? turn(moved, joint.axis)
                                                             : shift(Vector3(moved * joint.axis));
    return joint.X_PJ.matrix() * motion * joint.X_JA.matrix();
  }

  static std::string joint_name(const MountedRobot& mounted, int joint) {
    return mounted.name + "/" + mounted.robot.joints[at(joint)].name;
  }

  void add_links(const MountedRobot& mounted) {
    const std::string base = carried_by(mounted);
    for (const Joint& joint : mounted.robot.joints) {
      // `parent` of a chain's first joint is what the chain stands on.
      before_[mounted.name + "/" + joint.name] =
          joint.parent < 0 ? base : joint_name(mounted, joint.parent);
    }
    if (mounted.mount)
      add(mounted.name + "/" + mounted.mount->name, base, soup(mounted.mount->mesh));
    for (const Link& link : mounted.robot.links) {
      const bool fixed = link.joint < 0;
      add(mounted.name + "/" + link.name, fixed ? base : joint_name(mounted, link.joint),
          soup(link.mesh, fixed ? mounted.X_MR : Pose::Identity()));
    }
  }

  void add(const std::string& name, const std::string& frame, std::vector<Corners> triangles) {
    const Bounds box = box_of(triangles);
    bodies_.push_back({name, frame, std::move(triangles), box});
  }

  // The nearest frame before `frame` that has a body.
  std::string body_before(const std::string& frame) const {
    std::string f = frame;
    while (!f.empty()) {
      f = before_.at(f);
      if (std::any_of(bodies_.begin(), bodies_.end(),
                      [&](const Body& b) { return b.frame == f; })) {
        break;
      }
    }
    return f;
  }

  // Bodies on one frame, and those on frames that follow each other, are made to overlap.
  bool joined(const std::string& a, const std::string& b) const {
    return a == b || (!a.empty() && body_before(a) == b) || (!b.empty() && body_before(b) == a);
  }

  Carrier carrier_;
  std::vector<Body> bodies_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
  std::map<std::string, std::string> before_;  // the frame before each
};

// What does not move, in the world: the object and the obstacles, with a box around each triangle.
struct Surroundings {
  struct Thing {
    std::string name;
    std::vector<Corners> triangles;
    std::vector<Bounds> boxes;
    Bounds box;
  };
  std::vector<Thing> things;

  Surroundings() = default;

  explicit Surroundings(const Scene& scene) {
    add(scene.object.name, soup(scene.object.mesh, scene.object.X_WO));
    for (const StaticBody& body : scene.obstacles) add(body.name, soup(body.mesh, body.X_WB));
  }

  void add(const std::string& name, std::vector<Corners> triangles) {
    Thing thing{name, std::move(triangles), {}, {}};
    for (const Corners& t : thing.triangles) thing.boxes.push_back(bounds_of(t));
    thing.box = box_of(thing.triangles);
    things.push_back(std::move(thing));
  }
};

inline bool boxes_meet(const Bounds& a, const Bounds& b) {
  return (a.lower.array() <= b.upper.array()).all() && (b.lower.array() <= a.upper.array()).all();
}

// The triangles of a body that come into a box of the world, there.
inline std::vector<Corners> triangles_in(const Body& body, const Matrix4& X, const Bounds& box) {
  std::vector<Corners> inside;
  for (const Corners& t : body.triangles) {
    const Corners here = {moved(X, t[0]), moved(X, t[1]), moved(X, t[2])};
    if (boxes_meet(bounds_of(here), box)) inside.push_back(here);
  }
  return inside;
}

// "A meets B" in a posture, "" for nothing.
inline std::string what_meets(const Machine& machine, const Surroundings& around,
                              const Frames& frames) {
  const std::vector<Body>& bodies = machine.bodies();
  std::vector<const Matrix4*> X;
  std::vector<Bounds> box;
  for (const Body& body : bodies) {
    X.push_back(&frames.at(body.frame));
    box.push_back(moved(*X.back(), body.box));
  }
  for (const auto& [a, b] : machine.pairs()) {
    if (!boxes_meet(box[a], box[b])) continue;
    if (surfaces_meet(triangles_in(bodies[a], *X[a], box[b]),
                      triangles_in(bodies[b], *X[b], box[a]))) {
      return bodies[a].name + " meets " + bodies[b].name;
    }
  }
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    for (const Surroundings::Thing& thing : around.things) {
      if (!boxes_meet(box[a], thing.box)) continue;
      std::vector<Corners> near;
      for (std::size_t t = 0; t < thing.triangles.size(); ++t) {
        if (boxes_meet(thing.boxes[t], box[a])) near.push_back(thing.triangles[t]);
      }
      if (near.empty()) continue;
      if (surfaces_meet(triangles_in(bodies[a], *X[a], box_of(near)), near)) {
        return bodies[a].name + " meets " + thing.name;
      }
    }
  }
  return "";
}

}  // namespace prehend::test
