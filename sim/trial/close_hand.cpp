#include "sim/trial/close_hand.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "sim/base/index.h"
#include "sim/trial/gap_tracker.h"

namespace prehend {
namespace {

// Closing is event-driven conservative advancement over the closing time t [s], in which every
// degree of freedom moves at its constant closing velocity. For each pair of a moving link and
// anything it may touch, the speed at which the pair's gap can shrink is bounded by the joint
// velocities times the link's reach from each joint axis. So a gap g proves the pair free of
// contact for g / speed more seconds. The pair whose proof ends first is queried there, until all
// proofs outlast the motion. A contact stops joints, which only lowers speeds and keeps all proofs
// valid.

constexpr double kNever = std::numeric_limits<double>::infinity();

// Joint motion over the closing time t [s]: joint j is at start + velocity * min(t, until), where
// `until` is the time at which it reaches its limit or was stopped by contact.
class ClosingMotion {
 public:
  ClosingMotion(const Robot& hand, const ClosingStart& start)
      : hand_(hand),
        start_(start.joints.empty() ? joint_values(hand, start.dofs) : start.joints),
        velocity_(hand.joints.size(), 0.0),
        until_(hand.joints.size(), 0.0),
        by_contact_(hand.joints.size(), false) {
    for (std::size_t j = 0; j < hand.joints.size(); ++j) {
      const DegreeOfFreedom& dof = hand.dofs[index(hand.joints[j].dof)];
      const double from = start.dofs[index(hand.joints[j].dof)];
      const double v = dof.closing_velocity;
      if (v == 0.0) continue;
      velocity_[j] = hand.joints[j].ratio * v;
      until_[j] = std::max(0.0, ((v > 0.0 ? dof.upper : dof.lower) - from) / v);
    }
  }

  bool moves(int joint, double t) const {
    return velocity_[index(joint)] != 0.0 && t < until_[index(joint)];
  }

  // Bound on the speed of any point of the link relative to the palm from time t on [m/s]: the sum
  // over the moving joints before it of |velocity| * (farthest point from the joint's axis).
  double speed(const CompiledLink& link, double t) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < link.joints.size(); ++k) {
      if (moves(link.joints[k], t))
        sum += std::abs(velocity_[index(link.joints[k])]) * link.reach[k];
    }
    return sum;
  }

  // Bound on how far any point of the link can move at all [m]. A self-centering finger may pass
  // its limit by as much as the other one was stopped short of it, which is at most its whole way.
  double farthest(const CompiledLink& link) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < link.joints.size(); ++k) {
      const std::size_t j = index(link.joints[k]);
      const int dof = hand_.joints[j].dof;
      double way = 0.0;
      for (std::size_t other = 0; other < hand_.joints.size(); ++other) {
        if (other == j || (hand_.joints[other].dof == dof &&
                           hand_.dofs[index(dof)].coupling == Coupling::self_centering)) {
          way += until_[other];
        }
      }
      sum += std::abs(velocity_[j]) * way * link.reach[k];
    }
    return sum;
  }

  // Stops all joints between the palm and the link, since each of them would press the link into
  // what it touches. A rigid degree of freedom then cannot move at all: its other joints, which may
  // belong to other fingers, stop too.
  void stop_before(const CompiledLink& link, double t) {
    for (int joint : link.joints) {
      if (!moves(joint, t)) continue;
      stop(joint, t);
      const int dof = hand_.joints[index(joint)].dof;
      if (hand_.dofs[index(dof)].coupling != Coupling::rigid) continue;
      for (std::size_t other = 0; other < hand_.joints.size(); ++other) {
        if (hand_.joints[other].dof == dof) stop(static_cast<int>(other), t);
      }
    }
  }

  // When the last joint comes to rest.
  double end() const {
    return until_.empty() ? 0.0 : *std::max_element(until_.begin(), until_.end());
  }

  // Joint values at time t; after end() those at rest, for any t up to infinity.
  void joints_at(double t, std::vector<double>& joints) const {
    joints.resize(start_.size());
    for (std::size_t j = 0; j < start_.size(); ++j) {
      joints[j] = start_[j] + velocity_[j] * std::min(t, until_[j]);
    }
  }

  // The value of each degree of freedom at the end: that of its joint that moved longest, because
  // the drive moves on as long as any of its joints does (breakaway).
  std::vector<double> dofs_at_end(std::vector<double> dofs) const {
    for (std::size_t d = 0; d < dofs.size(); ++d) {
      double longest = 0.0;
      for (std::size_t j = 0; j < hand_.joints.size(); ++j) {
        if (index(hand_.joints[j].dof) == d && velocity_[j] != 0.0)
          longest = std::max(longest, until_[j]);
      }
      dofs[d] += hand_.dofs[d].closing_velocity * longest;
    }
    return dofs;
  }

  const std::vector<bool>& stopped_by_contact() const { return by_contact_; }

 private:
  void stop(int joint, double t) {
    if (!moves(joint, t)) return;
    const double unused = until_[index(joint)] - t;
    until_[index(joint)] = t;
    by_contact_[index(joint)] = true;
    const int dof = hand_.joints[index(joint)].dof;
    if (hand_.dofs[index(dof)].coupling != Coupling::self_centering) return;
    // Centring (center_hand) sets both joints to their mean. So the other finger may pass its limit
    // by what this one leaves unused, and the mean is still inside the limits.
    for (std::size_t other = 0; other < hand_.joints.size(); ++other) {
      if (hand_.joints[other].dof == dof && !by_contact_[other]) until_[other] += unused;
    }
  }

  const Robot& hand_;
  std::vector<double> start_;
  std::vector<double> velocity_;
  std::vector<double> until_;
  std::vector<bool> by_contact_;
};

// A link against another link, or against the object or an obstacle.
struct ClosingPair {
  LinkId link;
  std::variant<LinkId, BodyId> other;
  GapTracker tracker;
  double asked_at = 0.0;          // time of the last gap query [s]
  double speed_when_asked = 0.0;  // bound on how fast the gap can shrink from then on [m/s]
  double safe_until = 0.0;        // proven free of contact up to this time [s]
};

class Closing {
 public:
  Closing(const CompiledScene& scene, const ClosingStart& start, const TrialOptions& options,
          const RunContext& context)
      : scene_(scene),
        start_(start),
        options_(options),
        context_(context),
        motion_(scene.scene.hand, start) {
    add_pairings();
  }

  ClosedHand run() {
    const auto earlier = [](const ClosingPair& a, const ClosingPair& b) {
      return a.safe_until < b.safe_until;
    };
    // Contacts change when the motion ends, so that its end is asked for anew in each round.
    while (!pairings_.empty()) {
      context_.cancellation.check();
      // The first of several earliest pairs, in the order of the list: the same in every run.
      ClosingPair& next = *std::min_element(pairings_.begin(), pairings_.end(), earlier);
      if (next.safe_until >= motion_.end()) break;
      advance(next);
    }
    ClosedHand closed;
    motion_.joints_at(kNever, closed.joints);
    closed.dofs = motion_.dofs_at_end(start_.dofs);
    closed.stopped_by_contact = motion_.stopped_by_contact();
    for (const ClosingPair& pairing : pairings_) closed.gap_queries += pairing.tracker.queries();
    return closed;
  }

 private:
  // Every pair that the closing motion can bring together. Links that do not move are left out:
  // they touch nothing that they did not touch before.
  void add_pairings() {
    motion_.joints_at(0.0, joints_);
    for (std::size_t l = 0; l < scene_.links.size(); ++l) {
      const CompiledLink& link = scene_.links[l];
      if (motion_.speed(link, 0.0) == 0.0) continue;
      add_pairing(l, BodyId::object(),
                  start_.object_clearance.empty() ? 0.0 : start_.object_clearance[l]);
      // Obstacles beyond what any point of the link can reach are left out.
      const Vector3 center_O = start_.X_OH * link_pose(scene_.scene.hand, link.joints, joints_) *
                               link.mesh.ball_center();
      const double reach =
          link.mesh.ball_radius() + motion_.farthest(link) + options_.contact.threshold;
      scene_.near_obstacles.find({center_O, center_O, reach}, near_);
      for (const BodyId body : near_) add_pairing(l, body, 0.0);
    }
    for (std::size_t p = 0; p < scene_.self_pairs.size(); ++p) {
      const LinkPair& pair = scene_.self_pairs[p];
      const CompiledLink& a = scene_.links[index(pair.a)];
      const CompiledLink& b = scene_.links[index(pair.b)];
      if (motion_.speed(a, 0.0) + motion_.speed(b, 0.0) == 0.0) continue;
      ClosingPair pairing{pair.b, pair.a, GapTracker(a.mesh, b.mesh, options_.gaps)};
      start_pairing(pairing, start_.self_clearance.empty() ? 0.0 : start_.self_clearance[p]);
    }
  }

  void add_pairing(std::size_t l, BodyId body, double clearance) {
    const CompiledLink& link = scene_.links[l];
    ClosingPair pairing{link_id(l), body,
                        GapTracker(scene_.body(body).mesh, link.mesh, options_.gaps)};
    start_pairing(pairing, clearance);
  }

  // Only pairs that can move come here, so that the speed is above 0. A clearance of 0 is no proof:
  // the pair is queried at the start.
  void start_pairing(ClosingPair& pairing, double clearance) {
    pairing.speed_when_asked = speed(pairing, 0.0);
    pairing.safe_until = std::max(0.0, clearance - options_.contact_gap) / pairing.speed_when_asked;
    pairings_.push_back(std::move(pairing));
  }

  double speed(const ClosingPair& pairing, double t) const {
    const LinkId* other = std::get_if<LinkId>(&pairing.other);
    return motion_.speed(scene_.links[index(pairing.link)], t) +
           (other != nullptr ? motion_.speed(scene_.links[index(*other)], t) : 0.0);
  }

  // The link's pose in the frame of what it is paired with, at time t.
  Pose relative_pose(const ClosingPair& pairing, double t) {
    motion_.joints_at(t, joints_);
    const auto pose_of = [&](LinkId link) {
      return link_pose(scene_.scene.hand, scene_.links[index(link)].joints, joints_);
    };
    const Pose X_HL = pose_of(pairing.link);
    if (const LinkId* other = std::get_if<LinkId>(&pairing.other)) {
      return pose_of(*other).inverse() * X_HL;
    }
    return scene_.pose_in(std::get<BodyId>(pairing.other), start_.X_OH * X_HL);
  }

  // Queries the gap where the last proof ends. A contact stops the joints of both links; otherwise
  // the proof is extended by the time in which the gap could close at the present bound on the
  // speed. Joints stop and never start, so that the bound stays valid.
  void advance(ClosingPair& pairing) {
    const double t = pairing.safe_until;
    const double speed_now = speed(pairing, t);
    // All joints of the pair have stopped since the last query: nothing can close the gap.
    if (speed_now == 0.0) {
      pairing.safe_until = kNever;
      return;
    }
    const double moved = (t - pairing.asked_at) * pairing.speed_when_asked;
    // As in approach(): a gap beyond the motion that is left need not be known exactly, and the
    // threshold keeps a gap at the end of the motion distinguishable from a contact.
    const double left = speed_now * (motion_.end() - t) + options_.contact.threshold;
    const Gap gap = pairing.tracker.query(relative_pose(pairing, t), moved, left);
    pairing.asked_at = t;
    pairing.speed_when_asked = speed_now;
    if (gap.upper <= options_.closed_gap() ||
        pairing.tracker.queries() > options_.max_gap_queries) {
      motion_.stop_before(scene_.links[index(pairing.link)], t);
      if (const LinkId* other = std::get_if<LinkId>(&pairing.other)) {
        motion_.stop_before(scene_.links[index(*other)], t);
      }
      pairing.safe_until = kNever;
      return;
    }
    pairing.safe_until = t + safe_step(gap, options_) / speed_now;
  }

  const CompiledScene& scene_;
  const ClosingStart& start_;
  const TrialOptions& options_;
  const RunContext& context_;
  ClosingMotion motion_;
  std::vector<ClosingPair> pairings_;
  std::vector<double> joints_;
  std::vector<BodyId> near_;
};

}  // namespace

ClosedHand close_hand(const CompiledScene& scene, const ClosingStart& start,
                      const TrialOptions& options, const RunContext& context) {
  return Closing(scene, start, options, context).run();
}

}  // namespace prehend
