#include "planner/live/body_motion.h"

#include <cmath>
#include <utility>

#include "sim/base/index.h"

namespace prehend {
namespace {

// What stands in the way of a body, and where.
struct Standing {
  const CollisionBody* body = nullptr;
  Pose X_WS = Pose::Identity();
};

std::vector<Standing> standing_bodies(const CompiledScene& scene, const BodyPlaces& places,
                                      BodyId moved, const StandingRobot& robot) {
  std::vector<Standing> all;
  std::vector<Pose> poses;
  link_poses(scene.scene.hand, robot.hand_joints, poses);
  for (std::size_t l = 0; l < scene.links.size(); ++l) {
    all.push_back({&scene.links[l], robot.X_WH * poses[l]});
  }
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const BodyId body = BodyId::at(b);
    if (body != moved) all.push_back({&scene.bodies[b], place_of(places, body)});
  }
  if (!scene.arm || robot.platform_joints.empty()) return all;
  arm_link_poses(*scene.arm, robot.platform_joints, poses);
  for (std::size_t l = 0; l < scene.arm->links.size(); ++l) {
    if (scene.arm->is_hand_link(link_id(l))) continue;
    all.push_back({&scene.arm->links[l], scene.arm->X_WB * poses[l]});
  }
  return all;
}

}  // namespace

BodyMotion move_body_to_contact(const CompiledScene& scene, const BodyPlaces& places, BodyId body,
                                const Pose& X_WB_to, const StandingRobot& robot,
                                const TrialOptions& options, const RunContext& context) {
  const StraightMotion motion(place_of(places, body), X_WB_to);
  const std::vector<Standing> standing = standing_bodies(scene, places, body, robot);
  const CollisionBody& moving = scene.body(body);
  const double farthest = moving.mesh.ball_center().norm() + moving.mesh.ball_radius();
  const Vector3 turn_W =
      farthest * motion.turn.angle() * (motion.from.linear() * motion.turn.axis());
  std::vector<SweptPair> pairs;
  for (const Standing& other : standing) {
    const Matrix3 R_SW = other.X_WS.linear().transpose();
    pairs.push_back({other.body, &moving, R_SW * motion.slide, R_SW * turn_W, 0.0});
  }
  const SweepEnd end = sweep(
      pairs,
      [&](std::size_t pair, double share) {
        return Pose(standing[pair].X_WS.inverse() * motion.at(share));
      },
      options, context);
  if (end.end == MotionEnd::arrived) return {end.end, 1.0, X_WB_to, ""};
  return {end.end, end.share, motion.at(end.share), standing[end.pair].body->name};
}

const Pose& place_of(const BodyPlaces& places, BodyId body) {
  return body.is_object() ? places.X_WO : places.X_WB[index(body) - 1];
}

Pose& place_of(BodyPlaces& places, BodyId body) {
  return body.is_object() ? places.X_WO : places.X_WB[index(body) - 1];
}

}  // namespace prehend
