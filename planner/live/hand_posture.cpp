#include "planner/live/hand_posture.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "sim/base/index.h"

namespace prehend {
namespace {

// Two bodies that may meet on the way: a link with a body of the scene or with another link.
struct HandPair {
  LinkId link = {};
  std::variant<BodyId, LinkId> other = BodyId::object();
};

double joint_speed(const CompiledLink& link, const std::vector<double>& moved) {
  double speed = 0.0;
  for (std::size_t i = 0; i < link.joints.size(); ++i) {
    speed += link.reach[i] * std::abs(moved[index(link.joints[i])]);
  }
  return speed;
}

// One motion, with the way counted in shares of it.
class HandSweep {
 public:
  HandSweep(const CompiledScene& scene, const HandPosture& from, const HandPosture& to)
      : scene_(scene), from_(from), to_(to) {
    list_pairs();
  }

  HandMotion run(const TrialOptions& options, const RunContext& context) {
    const SweepEnd end = sweep(
        swept_, [this](std::size_t pair, double share) { return relative_pose(pair, share); },
        options, context);
    if (end.end == MotionEnd::arrived) return {end.end, 1.0, to_, "", ""};
    const HandPair& pair = pairs_[end.pair];
    return {end.end, end.share, between(from_, to_, end.share), scene_.links[index(pair.link)].name,
            body(pair.other).name};
  }

 private:
  void list_pairs() {
    std::vector<double> moved(from_.joints.size());
    for (std::size_t j = 0; j < moved.size(); ++j) moved[j] = to_.joints[j] - from_.joints[j];
    const StraightMotion base(from_.X_OH, to_.X_OH);
    place(0.0);
    for (std::size_t l = 0; l < scene_.links.size(); ++l) {
      const CompiledLink& link = scene_.links[l];
      const double own = joint_speed(link, moved);
      // The farthest that a point of the link can be from the base's origin, about which the hand
      // turns: where it is now, and as far as its joints carry it.
      const double arm =
          (poses_.X_BL[l] * link.mesh.ball_center()).norm() + link.mesh.ball_radius() + own;
      for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
        const Matrix3 R_BO = scene_.bodies[b].X_RB.linear().transpose();
        const Vector3 axis_B = R_BO * (from_.X_OH.linear() * base.turn.axis());
        add(link_id(l), BodyId::at(b),
            {nullptr, nullptr, R_BO * base.slide, base.turn.angle() * arm * axis_B, own});
      }
    }
    for (const LinkPair& pair : scene_.self_pairs) {
      SweptPair swept;
      swept.rest = joint_speed(scene_.links[index(pair.a)], moved) +
                   joint_speed(scene_.links[index(pair.b)], moved);
      add(pair.a, pair.b, swept);
    }
  }

  // `motion` is that of the pair, whose bodies are not known yet.
  void add(LinkId link, std::variant<BodyId, LinkId> other, SweptPair motion) {
    motion.a = &body(other);
    motion.b = &scene_.links[index(link)];
    pairs_.push_back({link, other});
    swept_.push_back(motion);
  }

  const CollisionBody& body(const std::variant<BodyId, LinkId>& other) const {
    if (const auto* id = std::get_if<BodyId>(&other)) return scene_.body(*id);
    return scene_.links[index(std::get<LinkId>(other))];
  }

  // Poses of the links at this share of the way.
  void place(double share) {
    if (share == placed_at_) return;
    placed_at_ = share;
    const HandPosture now = between(from_, to_, share);
    robot_poses(scene_.scene.hand, now.joints, poses_);
    X_OH_ = now.X_OH;
  }

  // The pose of the pair's link in the frame of the other body.
  Pose relative_pose(std::size_t place_of_pair, double share) {
    place(share);
    const HandPair& pair = pairs_[place_of_pair];
    const Pose& X_HL = poses_.X_BL[index(pair.link)];
    if (const auto* id = std::get_if<BodyId>(&pair.other)) {
      return scene_.pose_in(*id, X_OH_ * X_HL);
    }
    return poses_.X_BL[index(std::get<LinkId>(pair.other))].inverse() * X_HL;
  }

  const CompiledScene& scene_;
  const HandPosture& from_;
  const HandPosture& to_;
  std::vector<HandPair> pairs_;
  std::vector<SweptPair> swept_;
  double placed_at_ = -1.0;  // a share that no way has
  RobotPoses poses_;
  Pose X_OH_ = Pose::Identity();
};

}  // namespace

bool is_same(const HandPosture& a, const HandPosture& b) {
  return a.X_OH.matrix() == b.X_OH.matrix() && a.dofs == b.dofs && a.joints == b.joints;
}

HandPosture between(const HandPosture& from, const HandPosture& to, double share) {
  if (share >= 1.0) return to;
  if (share <= 0.0) return from;
  HandPosture posture = from;
  posture.X_OH = StraightMotion(from.X_OH, to.X_OH).at(share);
  for (std::size_t i = 0; i < posture.dofs.size(); ++i) {
    posture.dofs[i] += share * (to.dofs[i] - from.dofs[i]);
  }
  for (std::size_t i = 0; i < posture.joints.size(); ++i) {
    posture.joints[i] += share * (to.joints[i] - from.joints[i]);
  }
  return posture;
}

HandMotion move_to_contact(const CompiledScene& scene, const HandPosture& from,
                           const HandPosture& to, const TrialOptions& options,
                           const RunContext& context) {
  return HandSweep(scene, from, to).run(options, context);
}

}  // namespace prehend
