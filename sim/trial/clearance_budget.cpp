#include "sim/trial/clearance_budget.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/base/index.h"
#include "sim/shape/proximity.h"

// Like a motion that advances by lower bounds of the gap, a turn is free when no point moves as far
// as the smallest gap. Gaps are costly and motions cheap to compute, so that a gap is computed
// once, and each turn carried out lowers what is known of it by its own motion. Only where that is
// too small is the gap computed again.
namespace prehend {
namespace {

// A lower bound of the gap between two bodies [m]. The gap of their bounding balls is returned
// where it is larger than `enough`; otherwise the gap of the surfaces, which takes longer.
double gap_between(const CollisionBody& a, const CollisionBody& b, const Pose& X_AB,
                   double enough) {
  const double apart = (X_AB * b.mesh.ball_center() - a.mesh.ball_center()).norm() -
                       a.mesh.ball_radius() - b.mesh.ball_radius();
  return apart > enough ? apart : find_gap(a.mesh, b.mesh, X_AB).lower;
}

// Bound on how far a point of a body moves when the body turns by `angle` about any axis through
// the origin of `center`'s frame: the arc of the farthest point of its bounding ball [m].
double turning_motion(const Vector3& center, double radius, double angle) {
  return angle * (center.norm() + radius);
}

}  // namespace

void ClearanceBudget::start(const CompiledScene& scene, const Trial& start,
                            const TrialOptions& options) {
  scene_ = &scene;
  X_OH_start_ = start.X_OH;
  least_gap_ = options.contact.threshold;
  object_gap_ = 0.0;
  hand_gap_ = 0.0;
}

bool ClearanceBudget::allows(const Trial& now, const HandTurn& turn) {
  if (!scene_->has_obstacles()) return true;
  // The bounds known from earlier turns are tried first. Only where they are too small are the gaps
  // computed again.
  const double object = object_motion(turn) + least_gap_;
  if (object_gap_ <= object) object_gap_ = object_gap(now, object);
  if (object_gap_ <= object) return false;
  const double hand = hand_motion(now, turn) + least_gap_;
  if (hand_gap_ <= hand) hand_gap_ = hand_gap(now, hand);
  return hand_gap_ > hand;
}

void ClearanceBudget::consume(const Trial& now, const HandTurn& turn) {
  if (!scene_->has_obstacles()) return;
  object_gap_ -= object_motion(turn);
  hand_gap_ -= hand_motion(now, turn);
}

double ClearanceBudget::object_motion(const HandTurn& turn) const {
  const ProximityMesh& object = scene_->object().mesh;
  return turning_motion(object.ball_center() - turn.middle_O, object.ball_radius(), turn.angle) +
         turn.slide + turn.shift;
}

double ClearanceBudget::hand_motion(const Trial& now, const HandTurn& turn) {
  robot_poses(scene_->scene.hand, now.joints, poses_);
  double farthest = 0.0;
  for (std::size_t l = 0; l < scene_->links.size(); ++l) {
    const CompiledLink& link = scene_->links[l];
    // How far the link moves relative to the palm: its joints open, then close, and `closed` holds
    // their values after centring, before which a finger may have been a shift away.
    double relative_to_palm = link.joints.empty() ? 0.0 : turn.shift;
    for (std::size_t k = 0; k < link.joints.size(); ++k) {
      const std::size_t j = index(link.joints[k]);
      relative_to_palm += link.reach[k] * (std::abs(turn.opened[j] - now.joints[j]) +
                                           std::abs(turn.opened[j] - turn.closed[j]));
    }
    const Vector3 center = now.X_OH * poses_.X_BL[l] * link.mesh.ball_center() - turn.middle_O;
    farthest = std::max(
        farthest,
        relative_to_palm +
            turning_motion(center, link.mesh.ball_radius() + relative_to_palm, turn.angle));
  }
  return farthest + turn.slide + turn.shift;
}

double ClearanceBudget::object_gap(const Trial& now, double enough) {
  // Here the hand rests at its pose of the start, and all turns so far have moved the object. So
  // the object is where its pose relative to the hand is the present one: X_SO X_OH = X_OH_start.
  const Pose X_SO = X_OH_start_ * now.X_OH.inverse();  // S: the object's frame at the start
  return smallest_gap(scene_->object(), X_SO, enough);
}

double ClearanceBudget::hand_gap(const Trial& now, double enough) {
  robot_poses(scene_->scene.hand, now.joints, poses_);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t l = 0; l < scene_->links.size(); ++l) {
    least = std::min(least, smallest_gap(scene_->links[l], now.X_OH * poses_.X_BL[l], enough));
  }
  return least;
}

// A lower bound of the gap between a body at X_OB and all obstacles, exact where it is not above
// `enough` [m]. Obstacles that are several times as far away are not looked at; that far is enough
// for several turns.
double ClearanceBudget::smallest_gap(const CollisionBody& body, const Pose& X_OB, double enough) {
  const double far = 8.0 * enough;
  const Vector3 center_O = X_OB * body.mesh.ball_center();
  scene_->near_obstacles.find({center_O, center_O, body.mesh.ball_radius() + far}, near_);
  const Pose X_BO = X_OB.inverse();
  double least = far;
  for (const BodyId id : near_.found) {
    const PlacedBody& obstacle = scene_->body(id);
    least = std::min(least, gap_between(body, obstacle, X_BO * obstacle.X_RB, enough));
  }
  return least;
}

}  // namespace prehend
