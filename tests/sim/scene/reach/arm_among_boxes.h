// An arm with a hand among boxes, and motions of it looked at step by step.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/robot/files/platform_file.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/reach/motion_check.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/proximity.h"

namespace prehend::test {

// Nothing but the arm, a ball of 20 mm far away, and the boxes.
inline Scene arm_scene(std::vector<StaticBody> boxes) {
  Scene scene;
  scene.name = "boxes";
  scene.object = make_graspable("ball", make_sphere(0.01, 1), Material::plastic);
  scene.object.X_WO = translation(Vector3(5.0, 0.0, 0.0));
  scene.obstacles = std::move(boxes);
  Carrier carrier;
  carrier.platform = find_platform("puma560_barrett");
  carrier.hand = hand_of(carrier.platform);
  scene.hand = carrier.platform.robots[static_cast<std::size_t>(carrier.hand)].robot;
  for (const MountedRobot& mounted : carrier.platform.robots) {
    for (const DegreeOfFreedom& dof : mounted.robot.dofs) carrier.start.push_back(dof.initial);
  }
  scene.carrier = std::move(carrier);
  return scene;
}

inline StaticBody box(const std::string& name, const Vector3& size, const Pose& X_WB) {
  StaticBody body;
  body.name = name;
  body.mesh = make_box(size);
  body.X_WB = X_WB;
  return body;
}

// Boxes of 4 to 40 cm around the arm, turned any way, none in the way of its start.
inline CompiledScene among_random_boxes(Random& random, int count) {
  std::vector<StaticBody> boxes;
  while (true) {
    boxes.clear();
    for (int i = 0; i < count; ++i) {
      const Vector3 size = Vector3::Constant(0.22) + random.in_box(0.18);
      // One draw a statement: compilers evaluate operands in different orders.
      const Vector3 direction = random.direction();
      const Vector3 at = random.uniform(0.35, 1.0) * direction;
      boxes.push_back(box("box_" + std::to_string(i), size, pose_from(random.rotation(), at)));
    }
    try {
      return compile(arm_scene(boxes));
    } catch (const InputError&) {
      continue;  // the start posture collides
    }
  }
}

inline std::vector<ArmPair> pairs_of(const CompiledArm& arm) {
  std::vector<ArmPair> pairs = arm.arm_pairs;
  pairs.insert(pairs.end(), arm.hand_pairs.begin(), arm.hand_pairs.end());
  return pairs;
}

inline std::vector<double> random_dofs(const Robot& robot, Random& random) {
  std::vector<double> dofs;
  for (const DegreeOfFreedom& dof : robot.dofs)
    dofs.push_back(random.uniform(dof.lower, dof.upper));
  return dofs;
}

// The straight motion of the joints from one posture to another.
class Motion {
 public:
  Motion(const CompiledArm& arm, std::vector<double> from, std::vector<double> to)
      : arm_(arm), from_(std::move(from)), to_(std::move(to)) {
    for (const CompiledLink& link : arm.links) {
      const Bounds box = bounds(link.mesh.mesh());
      corners_.emplace_back();
      for (const double x : {box.lower.x(), box.upper.x()}) {
        for (const double y : {box.lower.y(), box.upper.y()}) {
          for (const double z : {box.lower.z(), box.upper.z()})
            corners_.back().emplace_back(x, y, z);
        }
      }
    }
  }

  std::vector<Pose> at(double part) const {
    std::vector<double> joints(from_.size());
    for (std::size_t j = 0; j < joints.size(); ++j) {
      joints[j] = from_[j] + part * (to_[j] - from_[j]);
    }
    std::vector<Pose> X_BL;
    arm_link_poses(arm_, joints, X_BL);
    return X_BL;
  }

  // Farthest that a corner of a link's box, and with it any point of the link, is in one from where
  // it is in the other.
  double apart(const std::vector<Pose>& a, const std::vector<Pose>& b) const {
    double most = 0.0;
    for (std::size_t l = 0; l < a.size(); ++l) {
      for (const Vector3& p : corners_[l]) most = std::max(most, (a[l] * p - b[l] * p).norm());
    }
    return most;
  }

  // So many equal parts that no point moves more than `step` in one.
  int parts(double step) const {
    constexpr int kCoarse = 32;
    double longest = 0.0;
    std::vector<Pose> before = at(0.0);
    for (int i = 1; i <= kCoarse; ++i) {
      std::vector<Pose> after = at(static_cast<double>(i) / kCoarse);
      longest = std::max(longest, apart(before, after));
      before.swap(after);
    }
    // A tenth more for the way that speed changes inside a coarse part.
    return std::max(1, static_cast<int>(std::ceil(1.1 * kCoarse * longest / step)));
  }

  JointPath path() const { return {from_, to_}; }

 private:
  const CompiledArm& arm_;
  std::vector<double> from_;
  std::vector<double> to_;
  std::vector<std::vector<Vector3>> corners_;
};

struct PairBodies {
  const ProximityMesh& a;
  Pose X_A;
  const ProximityMesh& b;
  Pose X_B;
};

inline PairBodies bodies_of(const CompiledArm& arm, const ArmPair& pair,
                            const std::vector<Pose>& X_BL) {
  const auto link = static_cast<std::size_t>(pair.link);
  if (const LinkId* other_link = std::get_if<LinkId>(&pair.other)) {
    const std::size_t other = index(*other_link);
    return {arm.links[link].mesh, X_BL[link], arm.links[other].mesh, X_BL[other]};
  }
  const PlacedBody& body = arm.body(std::get<BodyId>(pair.other));
  return {arm.links[link].mesh, X_BL[link], body.mesh, body.X_RB};
}

inline bool crosses(const CompiledArm& arm, const ArmPair& pair, const std::vector<Pose>& X_BL) {
  const PairBodies two = bodies_of(arm, pair, X_BL);
  const double centres = (two.X_A * two.a.ball_center() - two.X_B * two.b.ball_center()).norm();
  return centres <= two.a.ball_radius() + two.b.ball_radius() &&
         surfaces_cross(two.a, two.b, two.X_A.inverse() * two.X_B);
}

inline double gap_of(const CompiledArm& arm, const ArmPair& pair, const std::vector<Pose>& X_BL) {
  const PairBodies two = bodies_of(arm, pair, X_BL);
  return find_gap(two.a, two.b, two.X_A.inverse() * two.X_B).upper;
}

}  // namespace prehend::test
