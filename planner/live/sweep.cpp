#include "planner/live/sweep.h"

#include <algorithm>
#include <limits>

#include "sim/shape/separation.h"
#include "sim/trial/gap_tracker.h"

namespace prehend {
namespace {

// Pairs that need more tests of convex parts than this are left to the gaps of their meshes. A
// limit of time only.
constexpr std::size_t kMostParts = 400;
// Planes are looked for where the gap allows less than this part of the way that is left.
constexpr double kShortStep = 0.1;
// Bodies that are pushed against each other again and again come no nearer than this [m]: half of
// their gap each time would be lost in rounding soon.
constexpr double kLeastGap = 1e-6;
// By how much such a gap may seem smaller without being so [m].
constexpr double kSameGap = 1e-12;
// A direction of which less is left across the slide is one along it.
constexpr double kLeastNormal = 1e-6;
// Of a slide of 1 m, what counts as no motion towards a plane along it [m].
constexpr double kRounding = 1e-12;

struct PairOnTheWay {
  std::size_t place = 0;  // among the pairs
  GapTracker tracker;
  double first_gap = 0.0;  // at the start [m]
  double stop_gap = 0.0;   // at which the motion ends [m]
  double asked_at = 0.0;   // share of the way at the last query
  double safe_until = 0.0;
};

// How far along the unit `n` a part of the body reaches at most [m]: exactly where the body is one
// part, whose convex set may be a coarse one.
double farthest(const ProximityMesh& mesh, std::size_t part, const Vector3& n) {
  if (mesh.parts().size() > 1) {
    const ConvexPoints& set = mesh.parts()[part];
    return n.dot(set.farthest(n)) + set.margin() + set.search_error();
  }
  double most = -std::numeric_limits<double>::infinity();
  for (const Vector3& p : mesh.mesh().vertices) most = std::max(most, n.dot(p));
  return most;
}

class Sweep {
 public:
  Sweep(const std::vector<SweptPair>& pairs, const PoseOnTheWay& pose, const TrialOptions& options,
        const RunContext& context)
      : pairs_(pairs), pose_(pose), options_(options), context_(context) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (!may_meet(i)) continue;
      PairOnTheWay& pair = on_the_way_.emplace_back();
      pair.place = i;
      pair.stop_gap = options.contact_gap;
      pair.tracker.start(pairs[i].a->mesh, pairs[i].b->mesh);
    }
  }

  SweepEnd run() {
    const SweepEnd end = advance_all();
    for (const PairOnTheWay& pair : on_the_way_) {
      if (came_too_near(pair, end)) return {MotionEnd::touched, 0.0, pair.place};
    }
    return end;
  }

 private:
  SweepEnd advance_all() {
    for (const PairOnTheWay& pair : on_the_way_) {
      // Surfaces that cross are found by their gap; a body inside another has one.
      if (bodies_overlap(*of(pair).a, *of(pair).b, pose_(pair.place, 0.0))) {
        return {MotionEnd::starts_in_collision, 0.0, pair.place};
      }
    }
    while (!on_the_way_.empty()) {
      context_.cancellation.check();
      PairOnTheWay& next = *std::min_element(
          on_the_way_.begin(), on_the_way_.end(),
          [](const PairOnTheWay& a, const PairOnTheWay& b) { return a.safe_until < b.safe_until; });
      if (next.safe_until >= 1.0 && next.tracker.queries() > 0) break;
      if (!advance(next)) {
        const bool at_start = next.tracker.queries() == 1;
        return {at_start ? MotionEnd::starts_in_collision : MotionEnd::touched, next.safe_until,
                next.place};
      }
    }
    return {};
  }

  // Whether a pair that was very near at the start is nearer at the end.
  bool came_too_near(const PairOnTheWay& pair, const SweepEnd& end) const {
    if (end.share <= 0.0 || pair.tracker.queries() == 0) return false;
    if (pair.first_gap > 1.2 * kLeastGap) return false;
    if (end.end == MotionEnd::touched && end.pair == pair.place) return true;
    const Gap gap = find_gap(of(pair).a->mesh, of(pair).b->mesh, pose_(pair.place, end.share),
                             {.cap = kLeastGap, .hint = {}});
    return gap.lower < std::min(pair.first_gap, 0.5 * kLeastGap) - kSameGap;
  }

  const SweptPair& of(const PairOnTheWay& pair) const { return pairs_[pair.place]; }

  // Pairs that do not move against each other are left out, and those that stay farther apart than
  // their bounding balls: nothing becomes of them.
  bool may_meet(std::size_t i) const {
    const SweptPair& pair = pairs_[i];
    const double speed = pair.speed();
    if (speed <= 0.0) return false;
    const ProximityMesh& a = pair.a->mesh;
    const ProximityMesh& b = pair.b->mesh;
    const double apart = (pose_(i, 0.0) * b.ball_center() - a.ball_center()).norm();
    return apart - a.ball_radius() - b.ball_radius() < speed + options_.contact.threshold;
  }

  // Extends the proof for the pair that it is free of contact; false where it touches.
  bool advance(PairOnTheWay& pair) {
    const double share = std::min(pair.safe_until, 1.0);
    const double speed = of(pair).speed();
    const double left = (1.0 - share) * speed + options_.contact.threshold;
    const Pose X_AB = pose_(pair.place, share);
    const Gap gap = pair.tracker.query(X_AB, (share - pair.asked_at) * speed, left);
    pair.asked_at = share;
    if (pair.tracker.queries() == 1) {
      if (!(gap.lower > 0.0)) return false;
      pair.first_gap = gap.lower;
      // What touches already.
      if (gap.lower <= options_.closed_gap()) pair.stop_gap = 0.5 * gap.lower;
      if (gap.lower > 1.2 * kLeastGap) pair.stop_gap = std::max(pair.stop_gap, kLeastGap);
    }
    const bool touches =
        gap.upper <= 1.1 * pair.stop_gap || pair.tracker.queries() > kMaxGapQueries;
    if (touches) return false;
    const double step =
        gap.lower > 1.1 * pair.stop_gap ? gap.lower - pair.stop_gap : 0.25 * gap.lower;
    double advance = step / speed;
    if (advance < kShortStep * (1.0 - share)) {
      advance = std::max(advance, free_by_planes(pair, X_AB, gap));
    }
    pair.safe_until = share + advance;
    return true;
  }

  // How much farther the way is free because planes keep the bodies apart.
  double free_by_planes(const PairOnTheWay& pair, const Pose& X_AB, const Gap& gap) const {
    const SweptPair& bodies = of(pair);
    const std::size_t parts_a = bodies.a->mesh.parts().size();
    const std::size_t parts_b = bodies.b->mesh.parts().size();
    if (parts_a * parts_b > kMostParts) return 0.0;
    Vector3 nearest = Vector3::Zero();
    if (gap.pair.a >= 0) {
      const TriangleGap between = triangle_gap(bodies.a->mesh, bodies.b->mesh, X_AB, gap.pair);
      nearest = X_AB * between.p_B - between.p_A;
    }
    double free = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < parts_a && free > 0.0; ++i) {
      for (std::size_t j = 0; j < parts_b && free > 0.0; ++j) {
        Vector3 direction = nearest;
        (void)separation(bodies.a->mesh.parts()[i], bodies.b->mesh.parts()[j], X_AB, direction);
        const double by_either =
            std::max(free_by_plane(bodies, i, j, X_AB, nearest, pair.stop_gap),
                     free_by_plane(bodies, i, j, X_AB, direction, pair.stop_gap));
        free = std::min(free, by_either);
      }
    }
    return free;
  }

  // The same of part i of a and part j of b, by the plane across `direction` (frame of a) or by
  // the one that is nearest to it along which b slides.
  static double free_by_plane(const SweptPair& bodies, std::size_t i, std::size_t j,
                              const Pose& X_AB, const Vector3& direction, double stop_gap) {
    const double speed = bodies.slide_A.norm();
    Vector3 along = direction;
    if (speed > 0.0) along -= direction.dot(bodies.slide_A) / (speed * speed) * bodies.slide_A;
    double free = 0.0;
    for (const Vector3& across : {direction, along}) {
      if (!(across.norm() > kLeastNormal * direction.norm())) continue;
      const Vector3 n = across.normalized();
      // b lies as far along n as its farthest point against n does.
      const double of_b =
          n.dot(X_AB.translation()) - farthest(bodies.b->mesh, j, -(X_AB.linear().transpose() * n));
      const double room = of_b - farthest(bodies.a->mesh, i, n) - stop_gap;
      // A slide along the plane is towards it by rounding only.
      const double towards = std::max(0.0, -n.dot(bodies.slide_A) - kRounding * speed);
      // A point p turns by the axis times p, which has no part along the axis itself.
      const double rate = towards + n.cross(bodies.turn_A).norm() + bodies.rest;
      if (room <= 0.0) continue;
      free = rate > 0.0 ? std::max(free, room / rate) : std::numeric_limits<double>::infinity();
    }
    return free;
  }

  const std::vector<SweptPair>& pairs_;
  const PoseOnTheWay& pose_;
  const TrialOptions& options_;
  const RunContext& context_;
  std::vector<PairOnTheWay> on_the_way_;
};

}  // namespace

SweepEnd sweep(const std::vector<SweptPair>& pairs, const PoseOnTheWay& pose,
               const TrialOptions& options, const RunContext& context) {
  return Sweep(pairs, pose, options, context).run();
}

StraightMotion::StraightMotion(const Pose& X_AB_from, const Pose& X_AB_to)
    : from(X_AB_from),
      to(X_AB_to),
      slide(to.translation() - from.translation()),
      turn(Matrix3(from.linear().transpose() * to.linear())) {}

Pose StraightMotion::at(double share) const {
  if (share >= 1.0) return to;
  if (share <= 0.0) return from;
  Pose X_AB = from;
  X_AB.linear() = from.linear() * Eigen::AngleAxisd(share * turn.angle(), turn.axis()).matrix();
  X_AB.translation() += share * slide;
  return X_AB;
}

}  // namespace prehend
