#include "sim/trial/close_hand.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "sim/base/index.h"

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

class Closing {
 public:
  Closing(const CompiledScene& scene, const ClosingStart& start, const TrialOptions& options,
          const RunContext& context, ClosingWorkspace& workspace)
      : scene_(scene),
        start_(start),
        options_(options),
        context_(context),
        motion_(workspace.motion),
        pairings_(workspace.pairs),
        queue_(workspace.queue),
        joints_(workspace.joints),
        link_(workspace.link),
        other_(workspace.other),
        near_(workspace.near) {
    motion_.start(scene.scene.hand, start.dofs, start.joints);
    add_pairings();
  }

  void run(ClosedHand& closed) {
    // The pair whose proof ends first is on top; of several the first of the list, the same in
    // every run. A pair that can touch no more is not put back.
    queue_.clear();
    for (std::size_t p = 0; p < pairings_.size(); ++p) {
      queue_.emplace_back(pairings_[p].safe_until, p);
    }
    std::make_heap(queue_.begin(), queue_.end(), std::greater<>());
    // Contacts change when the motion ends, so that its end is asked for anew in each round.
    while (!queue_.empty() && queue_.front().first < motion_.end()) {
      context_.cancellation.check();
      std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
      ClosingPair& next = pairings_[queue_.back().second];
      advance(next);
      queue_.back().first = next.safe_until;
      if (next.safe_until == kNever) {
        queue_.pop_back();
      } else {
        std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
      }
    }
    motion_.joints_at(kNever, closed.joints);
    closed.dofs = start_.dofs;
    motion_.move_to_end(closed.dofs);
    closed.stopped_by_contact = motion_.stopped_by_contact();
    closed.gap_queries = 0;
    for (const ClosingPair& pairing : pairings_) closed.gap_queries += pairing.tracker.queries();
  }

 private:
  // Every pair that the closing motion can bring together. Links that do not move are left out:
  // they touch nothing that they did not touch before.
  void add_pairings() {
    pairings_.clear();
    motion_.joints_at(0.0, joints_);
    for (std::size_t l = 0; l < scene_.links.size(); ++l) {
      const CompiledLink& link = scene_.links[l];
      if (motion_.speed(link, 0.0) == 0.0) continue;
      add_pairing(link_id(l), BodyId::object(), scene_.object().mesh,
                  start_.object_clearance.empty() ? 0.0 : start_.object_clearance[l]);
      // Obstacles beyond what any point of the link can reach are left out.
      const Vector3 center_O = start_.X_OH * link_pose(scene_.scene.hand, link.joints, joints_) *
                               link.mesh.ball_center();
      const double reach =
          link.mesh.ball_radius() + motion_.farthest(link) + options_.contact.threshold;
      scene_.near_obstacles.find({center_O, center_O, reach}, near_);
      for (const BodyId body : near_.found) {
        add_pairing(link_id(l), body, scene_.body(body).mesh, 0.0);
      }
    }
    for (std::size_t p = 0; p < scene_.self_pairs.size(); ++p) {
      const LinkPair& pair = scene_.self_pairs[p];
      const CompiledLink& a = scene_.links[index(pair.a)];
      const CompiledLink& b = scene_.links[index(pair.b)];
      if (motion_.speed(a, 0.0) + motion_.speed(b, 0.0) == 0.0) continue;
      add_pairing(pair.b, pair.a, a.mesh,
                  start_.self_clearance.empty() ? 0.0 : start_.self_clearance[p]);
    }
  }

  // Only pairs that can move come here, so that the speed is above 0. A clearance of 0 is no proof:
  // the pair is queried at the start.
  void add_pairing(LinkId link, std::variant<LinkId, BodyId> other, const ProximityMesh& others,
                   double clearance) {
    ClosingPair& pairing = pairings_.add();
    pairing.link = link;
    pairing.other = other;
    pairing.tracker.start(others, scene_.links[index(link)].mesh);
    pairing.asked_at = 0.0;
    pairing.speed_when_asked = speed(pairing, 0.0);
    pairing.safe_until = std::max(0.0, clearance - options_.contact_gap) / pairing.speed_when_asked;
  }

  double speed(const ClosingPair& pairing, double t) const {
    const LinkId* other = std::get_if<LinkId>(&pairing.other);
    return motion_.speed(scene_.links[index(pairing.link)], t) +
           (other != nullptr ? motion_.speed(scene_.links[index(*other)], t) : 0.0);
  }

  // The hand's pose in the frame of what a link is paired with; that of a link is other_.
  Pose hand_in(const std::variant<LinkId, BodyId>& other) const {
    if (std::holds_alternative<LinkId>(other)) return other_.X_HL.inverse();
    return scene_.pose_in(std::get<BodyId>(other), start_.X_OH);
  }

  // Places the links of the pair at time t.
  void place(const ClosingPair& pairing, double t) {
    motion_.place(scene_.links[index(pairing.link)], t, link_);
    if (const LinkId* other = std::get_if<LinkId>(&pairing.other)) {
      motion_.place(scene_.links[index(*other)], t, other_);
    }
  }

  // For how long from time t on, for which the links are placed, the gap that a query found stays
  // above contact_gap. Convex parts that are apart along a direction stay so until motions along
  // it have used their distance up: fingers side by side are asked for once.
  double safe_time(const ClosingPair& pairing, const Gap& gap, const Matrix3& R_PH,
                   double speed_now, double t) const {
    double along = pairing.tracker.parts_apart().empty() ? 0.0 : kNever;
    for (const PartsApart& parts : pairing.tracker.parts_apart()) {
      const Vector3 direction_H = R_PH.transpose() * parts.direction;
      TravelBound bound = motion_.travel_along(scene_.links[index(pairing.link)], *parts.part_of_b,
                                               link_, -direction_H, t);
      if (const LinkId* other = std::get_if<LinkId>(&pairing.other)) {
        bound += motion_.travel_along(scene_.links[index(*other)], *parts.part_of_a, other_,
                                      direction_H, t);
      }
      along = std::min(along, bound.time_for(parts.distance - options_.contact_gap));
    }
    return std::max(safe_step(gap, options_) / speed_now, along);
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
    place(pairing, t);
    const Pose X_PH = hand_in(pairing.other);
    const Gap gap = pairing.tracker.query(X_PH * link_.X_HL, moved, left);
    pairing.asked_at = t;
    pairing.speed_when_asked = speed_now;
    if (gap.upper <= options_.closed_gap() || pairing.tracker.queries() > kMaxGapQueries) {
      motion_.stop_before(scene_.links[index(pairing.link)], t);
      if (const LinkId* other = std::get_if<LinkId>(&pairing.other)) {
        motion_.stop_before(scene_.links[index(*other)], t);
      }
      pairing.safe_until = kNever;
      return;
    }
    pairing.safe_until = t + safe_time(pairing, gap, X_PH.linear(), speed_now, t);
  }

  const CompiledScene& scene_;
  const ClosingStart& start_;
  const TrialOptions& options_;
  const RunContext& context_;
  ClosingMotion& motion_;
  ReusedList<ClosingPair>& pairings_;
  std::vector<std::pair<double, std::size_t>>& queue_;
  std::vector<double>& joints_;
  ClosingLink& link_;
  ClosingLink& other_;
  NearBodies& near_;
};

}  // namespace

void close_hand(const CompiledScene& scene, const ClosingStart& start, const TrialOptions& options,
                ClosingWorkspace& workspace, ClosedHand& closed, const RunContext& context) {
  Closing(scene, start, options, context, workspace).run(closed);
}

ClosedHand close_hand(const CompiledScene& scene, const ClosingStart& start,
                      const TrialOptions& options, const RunContext& context) {
  ClosingWorkspace workspace;
  ClosedHand closed;
  close_hand(scene, start, options, workspace, closed, context);
  return closed;
}

}  // namespace prehend
