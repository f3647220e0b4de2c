#include "sim/trial/approach.h"

#include <algorithm>
#include <limits>

#include "sim/base/index.h"

namespace prehend {
namespace {

// Directions are unit vectors up to this [m/m].
constexpr double kRoundingOfDirection = 1e-9;

// Lists the pairs that may meet on the way: each link with the object, and with the obstacles that
// reach into the region which the ball around the link sweeps.
void list_pairs(const CompiledScene& scene, const ApproachMotion& motion,
                const TrialOptions& options, ApproachWorkspace& workspace) {
  const std::vector<Pose>& X_HL = workspace.poses.X_BL;
  workspace.pairs.clear();
  const auto add = [&](std::size_t l, BodyId body) {
    ApproachPair& pair = workspace.pairs.add();
    pair.link = link_id(l);
    pair.body = body;
    pair.tracker.start(scene.body(body).mesh, scene.links[l].mesh);
    pair.asked_at = 0.0;
    pair.safe_until = 0.0;
    pair.gap_then = 0.0;
  };
  for (std::size_t l = 0; l < scene.links.size(); ++l) {
    const ProximityMesh& mesh = scene.links[l].mesh;
    const Vector3 center_H = X_HL[l] * mesh.ball_center();
    add(l, BodyId::object());
    scene.near_obstacles.find({motion.at(0.0) * center_H, motion.at(motion.distance) * center_H,
                               mesh.ball_radius() + options.contact.threshold},
                              workspace.near);
    for (const BodyId body : workspace.near.found) add(l, body);
  }
}

// A pair whose link starts wholly inside the body or around it, null: none. Conservative
// advancement finds surfaces that cross, because their gap is 0. It would miss such a pair: the
// surfaces have a gap, and the hand seems free to move.
const ApproachPair* enclosed_at_start(const CompiledScene& scene, const ApproachMotion& motion,
                                      const std::vector<Pose>& X_HL,
                                      const ReusedList<ApproachPair>& pairs) {
  for (const ApproachPair& pair : pairs) {
    const Pose X_OL = motion.at(0.0) * X_HL[index(pair.link)];
    if (one_contains_other(scene.body(pair.body), scene.links[index(pair.link)],
                           scene.pose_in(pair.body, X_OL))) {
      return &pair;
    }
  }
  return nullptr;
}

// A pair that crosses at the start and was not looked at before another one was found to touch
// there, null: none.
const ApproachPair* crosses_at_start(const CompiledScene& scene, const ApproachMotion& motion,
                                     const std::vector<Pose>& X_HL,
                                     const ReusedList<ApproachPair>& pairs) {
  for (const ApproachPair& pair : pairs) {
    if (pair.tracker.queries() > 0) continue;
    const Pose X_OL = motion.at(0.0) * X_HL[index(pair.link)];
    if (surfaces_cross(scene.body(pair.body).mesh, scene.links[index(pair.link)].mesh,
                       scene.pose_in(pair.body, X_OL))) {
      return &pair;
    }
  }
  return nullptr;
}

// How the approach ends with this gap of a pair. A hand that starts near a body but apart from it
// touches it; only an overlap is an error of the start.
ApproachEnd end_at(const ApproachPair& pair, const Gap& gap) {
  const bool at_start = pair.tracker.queries() == 1;
  if (at_start && !(gap.lower > 0.0)) return ApproachEnd::starts_in_collision;
  return pair.body.is_object() ? ApproachEnd::touched_object : ApproachEnd::touched_obstacle;
}

// How far the hand may go on along `direction`, in the body's frame. Convex parts that are apart
// along a direction stay so as long as the hand does not move against it by their distance.
double safe_way(const ApproachPair& pair, const Gap& gap, const Vector3& direction_T,
                const TrialOptions& options) {
  double along = pair.tracker.parts_apart().empty() ? 0.0 : std::numeric_limits<double>::infinity();
  for (const PartsApart& parts : pair.tracker.parts_apart()) {
    const double nearing = -parts.direction.dot(direction_T) + kRoundingOfDirection;
    if (nearing > 0.0) along = std::min(along, (parts.distance - options.contact_gap) / nearing);
  }
  return std::max(safe_step(gap, options), along);
}

// What is left of each gap bounds it at the end from below, which saves the closing hand its first
// queries.
void note_clearances(const ReusedList<ApproachPair>& pairs, ApproachResult& result) {
  for (const ApproachPair& pair : pairs) {
    if (!pair.body.is_object()) continue;
    result.object_clearance[index(pair.link)] =
        std::max(0.0, pair.gap_then - (result.travel - pair.asked_at));
  }
}

}  // namespace

Pose ApproachMotion::at(double travel) const {
  return translation((travel - distance) * approach_O) * X_OH_end;
}

ApproachResult approach(const CompiledScene& scene, const std::vector<double>& joints,
                        const ApproachMotion& motion, const TrialOptions& options,
                        const RunContext& context) {
  ApproachWorkspace workspace;
  ApproachResult result;
  approach(scene, joints, motion, options, workspace, result, context);
  return result;
}

void approach(const CompiledScene& scene, const std::vector<double>& joints,
              const ApproachMotion& motion, const TrialOptions& options,
              ApproachWorkspace& workspace, ApproachResult& result, const RunContext& context) {
  robot_poses(scene.scene.hand, joints, workspace.poses);
  const std::vector<Pose>& X_HL = workspace.poses.X_BL;
  result.end = ApproachEnd::stand_off;
  result.travel = 0.0;
  result.touch.reset();
  result.object_clearance.assign(scene.links.size(), 0.0);
  list_pairs(scene, motion, options, workspace);
  ReusedList<ApproachPair>& all = workspace.pairs;
  if (const ApproachPair* enclosed = enclosed_at_start(scene, motion, X_HL, all)) {
    result.end = ApproachEnd::starts_in_collision;
    result.touch = {enclosed->link, enclosed->body};
    return;
  }
  const auto earlier = [](const ApproachPair& a, const ApproachPair& b) {
    return a.safe_until < b.safe_until;
  };
  // Conservative advancement. The hand only translates, so no gap shrinks by more than the hand
  // travels, and a pair with a gap g at travel s is free of contact up to s + g. Each pair keeps
  // how far it is proven free. The pair whose proof ends first is queried there, which extends its
  // proof or finds the contact. Pairs that are far apart are thus queried rarely, near ones often,
  // and the first contact found is the first along the way. Every pair is queried at least once,
  // also when the distance is 0.
  while (true) {
    context.cancellation.check();
    ApproachPair& next = *std::min_element(all.begin(), all.end(), earlier);
    if (next.safe_until >= motion.distance && next.tracker.queries() > 0) {
      result.travel = motion.distance;
      break;
    }
    const double travel = std::min(next.safe_until, motion.distance);
    const Pose X_TL = scene.pose_in(next.body, motion.at(travel) * X_HL[index(next.link)]);
    // A gap beyond the rest of the way need not be known more exactly. The threshold, which is
    // above closed_gap(), keeps a gap at the very end of the way distinguishable from a contact.
    const double left = motion.distance - travel + options.contact.threshold;
    const Gap gap = next.tracker.query(X_TL, travel - next.asked_at, left);
    next.asked_at = travel;
    next.gap_then = gap.lower;
    // A pair that slides along a narrow gap would take very many short steps: after too many
    // queries it counts as a contact.
    if (gap.upper <= options.closed_gap() || next.tracker.queries() > kMaxGapQueries) {
      result.end = end_at(next, gap);
      result.touch = {next.link, next.body};
      result.travel = travel;
      next.safe_until = travel;
      next.gap_then = 0.0;
      if (const ApproachPair* other = crosses_at_start(scene, motion, X_HL, all)) {
        result.end = ApproachEnd::starts_in_collision;
        result.touch = {other->link, other->body};
      }
      break;
    }
    const Matrix3 R_TO = scene.pose_in(next.body, Pose::Identity()).linear();
    next.safe_until = travel + safe_way(next, gap, R_TO * motion.approach_O, options);
  }
  note_clearances(all, result);
}

}  // namespace prehend
