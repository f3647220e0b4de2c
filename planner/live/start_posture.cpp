#include "planner/live/start_posture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "planner/live/arm_posture.h"
#include "planner/live/grasp_score.h"

namespace prehend {
namespace {

// How far the hand stands off the object, one after the other [m].
constexpr std::array kStandOffs = {0.1, 0.05, 0.2, 0.3};
// Of so many free places an arm is asked whether it reaches them, which takes far longer than to
// see that they are free.
constexpr int kMostReaches = 6;

// Directions from the object to the hand, in the world: from above, aslant, from the sides.
std::vector<Vector3> directions() {
  std::vector<Vector3> all = {Vector3::UnitZ()};
  for (const double up : {1.0, 0.0}) {
    for (int k = 0; k < 8; ++k) {
      const double angle = k * std::numbers::pi / 4.0;
      all.push_back(Vector3(std::cos(angle), std::sin(angle), up).normalized());
    }
  }
  return all;
}

// Where the hand's origin is at the start of a direction: the middle of the object's bounding box
// along the world's axes, and how far the object reaches from there [m].
struct Side {
  Vector3 direction_W;
  Vector3 farthest_W;
};

std::vector<Side> sides_of(const GraspableBody& object) {
  std::vector<Vector3> points_W;
  points_W.reserve(object.mesh.vertices.size());
  for (const Vector3& p_O : object.mesh.vertices) points_W.push_back(object.X_WO * p_O);
  Vector3 lower = points_W.front();
  Vector3 upper = lower;
  for (const Vector3& p_W : points_W) {
    lower = lower.cwiseMin(p_W);
    upper = upper.cwiseMax(p_W);
  }
  const Vector3 middle_W = 0.5 * (lower + upper);
  std::vector<Side> all;
  for (const Vector3& direction_W : directions()) {
    double reach = 0.0;
    for (const Vector3& p_W : points_W) reach = std::max(reach, direction_W.dot(p_W - middle_W));
    all.push_back({direction_W, middle_W + reach * direction_W});
  }
  return all;
}

// Turned about as little as possible; a hand that points the other way is turned about an axis that
// is the same in every run. `quarter`: a quarter turn about the approach besides.
Pose pointing(const Hand& hand, const Side& side, double distance, bool quarter) {
  Matrix3 turn =
      Eigen::Quaterniond::FromTwoVectors(hand.approach, -side.direction_W).toRotationMatrix();
  if (quarter) turn = Eigen::AngleAxisd(0.5 * std::numbers::pi, side.direction_W) * turn;
  return pose_from(turn, side.farthest_W + distance * side.direction_W - turn * hand.origin);
}

// All places, the best one first.
std::vector<HandPosture> places(const Scene& scene, const HandPosture& posture) {
  std::vector<HandPosture> all;
  const Pose X_OW = scene.object.X_WO.inverse();
  const std::vector<Side> sides = sides_of(scene.object);
  for (const double distance : kStandOffs) {
    for (const Side& side : sides) {
      for (const bool quarter : {false, true}) {
        all.push_back(posture);
        all.back().X_OH = X_OW * pointing(*scene.hand.hand, side, distance, quarter);
      }
    }
  }
  return all;
}

}  // namespace

std::vector<double> start_dofs(const Robot& hand) {
  return hand.hand->preshapes.empty() ? initial_dofs(hand) : hand.hand->preshapes.front().dofs;
}

HandPosture start_posture(const EditedScene& world, const ReachOptions& options) {
  const Scene& scene = world.scene();
  HandPosture posture;
  posture.dofs = start_dofs(scene.hand);
  posture.joints = joint_values(scene.hand, posture.dofs);
  if (!world.has_object()) return posture;
  const std::vector<HandPosture> all = places(scene, posture);
  if (!world.is_ready()) return all.front();
  const CompiledScene& compiled = world.compiled();
  const HandPosture* first = nullptr;
  int reaches = 0;
  for (const HandPosture& place : all) {
    if (!overlaps_of(compiled, place.X_OH, place.joints).empty()) continue;
    if (!compiled.arm) return place;
    if (first == nullptr) first = &place;
    if (reaches++ == kMostReaches) break;
    if (reach_hand(*compiled.arm, place, compiled.arm->start, options).reached()) return place;
  }
  return first != nullptr ? *first : all.front();
}

}  // namespace prehend
