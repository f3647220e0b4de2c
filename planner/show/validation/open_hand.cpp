#include "planner/show/validation/open_hand.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"
#include "sim/robot/hand/opposition.h"
#include "sim/shape/proximity.h"

namespace prehend {
namespace {

// Measured poses of objects are off by some millimetres, and meshes are, too: a palm that is so
// little in the object is no sign of another frame [m].
constexpr double kPalmOverlap = 0.005;

// How far the tips are apart along the closing axis, and how far in front of the base.
struct TipExtent {
  double across = 0.0;
  double reach = 0.0;
};

// How far the fingers' surfaces in front of `from` (along the approach) are to the sides of the
// plane in which the hand closes, at most.
double half_width(const Robot& hand, const HandParts& parts, const std::vector<Pose>& X_HL,
                  double from) {
  const Vector3 side = hand.hand->approach.cross(hand.hand->closing);
  double width = 0.0;
  for (const Finger& finger : parts.fingers) {
    for (const int link : finger.tip_links) {
      for (const Vector3& p_L : hand.links[index(link)].mesh.vertices) {
        const Vector3 p_H = X_HL[index(link)] * p_L;
        if (p_H.dot(hand.hand->approach) < from) continue;
        width = std::max(width, std::abs((p_H - hand.hand->origin).dot(side)));
      }
    }
  }
  return width;
}

TipExtent extent_of(const Robot& hand, const HandParts& parts, const std::vector<double>& dofs) {
  const std::vector<Vector3> tips = tips_at(hand, parts, dofs);
  if (tips.empty()) return {};
  double least = tips.front().dot(hand.hand->closing);
  double most = least;
  TipExtent extent{0.0, tips.front().dot(hand.hand->approach)};
  for (const Vector3& tip : tips) {
    least = std::min(least, tip.dot(hand.hand->closing));
    most = std::max(most, tip.dot(hand.hand->closing));
    extent.reach = std::max(extent.reach, tip.dot(hand.hand->approach));
  }
  extent.across = most - least;
  return extent;
}

bool faces_against(const ProximityMesh& mesh, const RayHit& hit, const Vector3& direction) {
  const auto triangle = index(hit.triangle);
  return doubled_area_vector(mesh.mesh(), triangle).dot(direction) < 0.0;
}

}  // namespace

double tool_reach(const Hand& hand, const Preshape& preshape) {
  return hand.origin.dot(hand.approach) + preshape.depth;
}

const Preshape& widest_preshape(const Hand& hand) {
  return *std::max_element(
      hand.preshapes.begin(), hand.preshapes.end(),
      [](const Preshape& a, const Preshape& b) { return a.max_width < b.max_width; });
}

OpenHand::OpenHand(const CompiledScene& scene, const Candidate& grasp) : scene_(&scene) {
  const Robot& robot = scene.scene.hand;
  const Hand& hand = *robot.hand;
  const Preshape& preshape =
      grasp.preshape ? hand.preshapes[index(*grasp.preshape)] : widest_preshape(hand);
  const std::vector<double>& dofs = grasp.preshape ? preshape.dofs : grasp.dofs;
  link_poses(robot, joint_values(robot, dofs), X_HL_);
  const HandParts parts = find_hand_parts(robot);
  for (const int link : parts.palm_links) palm_.push_back(index(link));
  const TipExtent tips = extent_of(robot, parts, dofs);
  // Tips say how far a hand is open that was given by its degrees of freedom.
  opening_ = grasp.preshape ? preshape.max_width : std::min(preshape.max_width, tips.across);
  // What is left of the fingers in front of the place where they meet, and to its sides: objects
  // are also held there. Not quite to the edges, which may be round.
  constexpr double kInner = 0.8;
  const double reach = tool_reach(hand, preshape);
  const double rest = std::max(0.0, tips.reach - reach);
  const double side = half_width(robot, parts, X_HL_, reach - rest);
  const Vector3 sideways = hand.approach.cross(hand.closing);
  const Vector3 meeting =
      hand.origin + preshape.depth * hand.approach - 0.5 * opening_ * hand.closing;
  for (const double along : {0.0, -1.0, kInner}) {
    for (const double beside : {0.0, -kInner, kInner}) {
      line_starts_.emplace_back(meeting + along * rest * hand.approach + beside * side * sideways);
    }
  }
}

ObjectPlace OpenHand::along(const Vector3& from_O, const Vector3& closing_O) const {
  const PlacedBody& object = scene_->object();
  const Vector3 to_O = from_O + opening_ * closing_O;
  const RayHit there = first_hit(object.mesh, from_O, closing_O, opening_);
  const RayHit back = first_hit(object.mesh, to_O, -closing_O, opening_);
  if (there.triangle < 0 || back.triangle < 0) {
    const bool within = object.is_solid && is_inside(object.mesh, from_O);
    return within ? ObjectPlace::inside : ObjectPlace::beside;
  }
  // Who looks at the inner side of the surface stands in the object. An open surface has none.
  const bool outside = !object.is_solid || (faces_against(object.mesh, there, closing_O) &&
                                            faces_against(object.mesh, back, -closing_O));
  return outside ? ObjectPlace::between : ObjectPlace::inside;
}

ObjectPlace OpenHand::place(const Pose& X_OH) const {
  const Vector3 closing_O = X_OH.linear() * scene_->scene.hand.hand->closing;
  ObjectPlace found = ObjectPlace::beside;
  for (const Vector3& start_H : line_starts_) {
    const ObjectPlace here = along(X_OH * start_H, closing_O);
    if (here != ObjectPlace::beside) found = here;
    if (here == ObjectPlace::between) break;
  }
  if (found != ObjectPlace::between) return found;
  const Vector3 back_O = -kPalmOverlap * (X_OH.linear() * scene_->scene.hand.hand->approach);
  return palm_meets_object(translation(back_O) * X_OH) ? ObjectPlace::palm : found;
}

bool OpenHand::palm_meets_object(const Pose& X_OH) const {
  return std::any_of(palm_.begin(), palm_.end(), [&](std::size_t link) {
    const Pose X_LO = (X_OH * X_HL_[link]).inverse();
    return surfaces_cross(scene_->links[link].mesh, scene_->object().mesh, X_LO);
  });
}

bool OpenHand::meets_obstacle(const Pose& X_OH) const {
  for (const PlacedBody& obstacle : scene_->obstacles()) {
    for (std::size_t l = 0; l < X_HL_.size(); ++l) {
      const Pose X_LB = (X_OH * X_HL_[l]).inverse() * obstacle.X_RB;
      if (surfaces_cross(scene_->links[l].mesh, obstacle.mesh, X_LB)) return true;
    }
  }
  return false;
}

}  // namespace prehend
