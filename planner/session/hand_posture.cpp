#include "planner/session/hand_posture.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "sim/base/index.h"
#include "sim/trial/gap_tracker.h"

namespace prehend {
namespace {

// Two bodies that may meet on the way: a link with a body of the scene or with another link.
struct SweptPair {
  LinkId link = {};
  std::variant<BodyId, LinkId> other = BodyId::object();
  double speed = 0.0;  // bound of how far a point of one moves relative to the other on all the way
  GapTracker tracker;
  double stop_gap = 0.0;  // at which the motion ends [m]
  double asked_at = 0.0;  // share of the way at the last query
  double safe_until = 0.0;
};

double joint_speed(const CompiledLink& link, const std::vector<double>& moved) {
  double speed = 0.0;
  for (std::size_t i = 0; i < link.joints.size(); ++i) {
    speed += link.reach[i] * std::abs(moved[index(link.joints[i])]);
  }
  return speed;
}

// One motion, with the way counted in shares of it.
class Sweep {
 public:
  Sweep(const CompiledScene& scene, const HandPosture& from, const HandPosture& to,
        const TrialOptions& options, const RunContext& context)
      : scene_(scene), from_(from), to_(to), options_(options), context_(context) {
    list_pairs();
  }

  HandMotion run() {
    if (const SweptPair* pair = overlap_at_start())
      return ended(MotionEnd::starts_in_collision, *pair, 0.0);
    while (true) {
      context_.cancellation.check();
      if (pairs_.empty()) break;
      SweptPair& next = *std::min_element(
          pairs_.begin(), pairs_.end(),
          [](const SweptPair& a, const SweptPair& b) { return a.safe_until < b.safe_until; });
      if (next.safe_until >= 1.0 && next.tracker.queries() > 0) break;
      if (!advance(next)) {
        const bool at_start = next.tracker.queries() == 1;
        return ended(at_start ? MotionEnd::starts_in_collision : MotionEnd::touched, next,
                     next.safe_until);
      }
    }
    HandMotion motion;
    motion.posture = to_;
    return motion;
  }

 private:
  void list_pairs() {
    std::vector<double> moved(from_.joints.size());
    for (std::size_t j = 0; j < moved.size(); ++j) moved[j] = to_.joints[j] - from_.joints[j];
    const double slide = (to_.X_OH.translation() - from_.X_OH.translation()).norm();
    const Eigen::AngleAxisd turn(Matrix3(from_.X_OH.linear().transpose() * to_.X_OH.linear()));
    const double angle = std::abs(turn.angle());
    place(0.0);
    for (std::size_t l = 0; l < scene_.links.size(); ++l) {
      const CompiledLink& link = scene_.links[l];
      const double own = joint_speed(link, moved);
      // The farthest that a point of the link can be from the base's origin, about which the hand
      // turns: where it is now, and as far as its joints carry it.
      const double arm =
          (poses_.X_BL[l] * link.mesh.ball_center()).norm() + link.mesh.ball_radius() + own;
      for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
        add(link_id(l), BodyId::at(b), slide + angle * arm + own);
      }
    }
    for (const LinkPair& pair : scene_.self_pairs) {
      add(pair.a, pair.b,
          joint_speed(scene_.links[index(pair.a)], moved) +
              joint_speed(scene_.links[index(pair.b)], moved));
    }
  }

  // Pairs that do not move against each other are left out: nothing becomes of them.
  void add(LinkId link, std::variant<BodyId, LinkId> other, double speed) {
    if (speed <= 0.0) return;
    SweptPair& pair = pairs_.emplace_back();
    pair.link = link;
    pair.other = other;
    pair.speed = speed;
    pair.stop_gap = options_.contact_gap;
    pair.tracker.start(body(other).mesh, scene_.links[index(link)].mesh, options_.gaps);
  }

  const CollisionBody& body(const std::variant<BodyId, LinkId>& other) const {
    if (const auto* id = std::get_if<BodyId>(&other)) return scene_.body(*id);
    return scene_.links[index(std::get<LinkId>(other))];
  }

  // Poses of the links at this share of the way.
  void place(double share) {
    const HandPosture now = between(from_, to_, share);
    robot_poses(scene_.scene.hand, now.joints, poses_);
    X_OH_ = now.X_OH;
  }

  // The pose of the pair's link in the frame of the other body, at the last place().
  Pose relative_pose(const SweptPair& pair) const {
    const Pose& X_HL = poses_.X_BL[index(pair.link)];
    if (const auto* id = std::get_if<BodyId>(&pair.other)) {
      return scene_.pose_in(*id, X_OH_ * X_HL);
    }
    return poses_.X_BL[index(std::get<LinkId>(pair.other))].inverse() * X_HL;
  }

  // Surfaces that cross are found by their gap; a body inside another has one.
  const SweptPair* overlap_at_start() const {
    for (const SweptPair& pair : pairs_) {
      if (bodies_overlap(body(pair.other), scene_.links[index(pair.link)], relative_pose(pair))) {
        return &pair;
      }
    }
    return nullptr;
  }

  // Extends the proof for the pair that it is free of contact; false where it touches.
  bool advance(SweptPair& pair) {
    const double share = std::min(pair.safe_until, 1.0);
    place(share);
    const double left = (1.0 - share) * pair.speed + options_.contact.threshold;
    const Gap gap =
        pair.tracker.query(relative_pose(pair), (share - pair.asked_at) * pair.speed, left);
    pair.asked_at = share;
    if (pair.tracker.queries() == 1) {
      if (!(gap.lower > 0.0)) return false;
      // What touches already.
      if (gap.lower <= options_.closed_gap()) pair.stop_gap = 0.5 * gap.lower;
    }
    if (gap.upper <= 1.1 * pair.stop_gap || pair.tracker.queries() > options_.max_gap_queries) {
      return false;
    }
    const double step =
        gap.lower > 1.1 * pair.stop_gap ? gap.lower - pair.stop_gap : 0.25 * gap.lower;
    pair.safe_until = share + step / pair.speed;
    return true;
  }

  HandMotion ended(MotionEnd end, const SweptPair& pair, double share) const {
    return {end, share, between(from_, to_, share), scene_.links[index(pair.link)].name,
            body(pair.other).name};
  }

  const CompiledScene& scene_;
  const HandPosture& from_;
  const HandPosture& to_;
  const TrialOptions& options_;
  const RunContext& context_;
  std::vector<SweptPair> pairs_;
  RobotPoses poses_;
  Pose X_OH_ = Pose::Identity();
};

}  // namespace

HandPosture between(const HandPosture& from, const HandPosture& to, double share) {
  if (share >= 1.0) return to;
  if (share <= 0.0) return from;
  HandPosture posture = from;
  const Eigen::AngleAxisd turn(Matrix3(from.X_OH.linear().transpose() * to.X_OH.linear()));
  posture.X_OH.linear() =
      from.X_OH.linear() * Eigen::AngleAxisd(share * turn.angle(), turn.axis()).matrix();
  posture.X_OH.translation() += share * (to.X_OH.translation() - from.X_OH.translation()).eval();
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
  return Sweep(scene, from, to, options, context).run();
}

}  // namespace prehend
