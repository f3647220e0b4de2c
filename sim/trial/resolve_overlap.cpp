#include "sim/trial/resolve_overlap.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace prehend {
namespace {

// How closely the shortest way is found [m].
constexpr double kResolution = 5e-5;

// The hand with joints that do not move, as its overlaps are looked for again and again.
class RigidHand {
 public:
  RigidHand(const CompiledScene& scene, const Pose& X_OH, GiveWayWorkspace& workspace)
      : scene_(scene), X_OH_(X_OH), workspace_(workspace) {}

  bool is_free(const Vector3& move_O) const { return !overlaps(move_O, CollisionScope::all); }

  // By how much the overlaps of the hand where it stands may be resolved.
  double most(const OverlapOptions& options) const {
    return overlaps(Vector3::Zero(), CollisionScope::object) ? options.object : options.obstacle;
  }

 private:
  bool overlaps(const Vector3& move_O, CollisionScope among) const {
    const Pose X_OH = translation(move_O) * X_OH_;
    return hand_collision(scene_, X_OH, workspace_.poses, among, workspace_.near).has_value();
  }

  const CompiledScene& scene_;
  const Pose& X_OH_;
  GiveWayWorkspace& workspace_;
};

// The directions from the middle of a cube to its faces, edges and corners, unit: those to the
// faces first.
std::array<Vector3, 26> directions() {
  std::array<Vector3, 26> all;
  std::size_t count = 0;
  for (int axes = 1; axes <= 3; ++axes) {
    for (int i = 0; i < 27; ++i) {
      const std::array<int, 3> v = {i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
      if (std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]) != axes) continue;
      all[count++] = Vector3(v[0], v[1], v[2]).normalized();
    }
  }
  return all;
}

// The shortest free way along a direction whose end at `longest` is free, found by halving: between
// an overlap and a free place.
double shortest_way(const RigidHand& hand, const Vector3& direction_O, double longest) {
  double overlapping = 0.0;
  double free = longest;
  while (free - overlapping > kResolution) {
    const double middle = 0.5 * (overlapping + free);
    (hand.is_free(middle * direction_O) ? free : overlapping) = middle;
  }
  return free;
}

// The shortest move along one of the directions, of at most `longest`, that frees the hand.
std::optional<Vector3> shortest_move(const RigidHand& hand, const Pose& X_OH, double longest,
                                     const RunContext& context) {
  std::optional<Vector3> best;
  for (const Vector3& direction_H : directions()) {
    context.cancellation.check();
    if (longest <= kResolution) break;
    const Vector3 direction_O = X_OH.linear() * direction_H;
    // A direction that is to be better than the best so far must be free a little before its end.
    const double end = best ? longest - kResolution : longest;
    if (!hand.is_free(end * direction_O)) continue;
    longest = shortest_way(hand, direction_O, end);
    best = longest * direction_O;
  }
  return best;
}

}  // namespace

std::optional<Vector3> resolve_overlap(const CompiledScene& scene, const Pose& X_OH,
                                       const std::vector<double>& joints,
                                       const OverlapOptions& options, GiveWayWorkspace& workspace,
                                       const RunContext& context) {
  robot_poses(scene.scene.hand, joints, workspace.poses);
  const RigidHand hand(scene, X_OH, workspace);
  if (hand.is_free(Vector3::Zero())) return Vector3(Vector3::Zero());
  return shortest_move(hand, X_OH, hand.most(options), context);
}

std::optional<double> overlap_depth(const CompiledScene& scene, const Pose& X_OH,
                                    const std::vector<double>& joints,
                                    const OverlapOptions& options, GiveWayWorkspace& workspace,
                                    const RunContext& context) {
  robot_poses(scene.scene.hand, joints, workspace.poses);
  const RigidHand hand(scene, X_OH, workspace);
  if (hand.is_free(Vector3::Zero())) return 0.0;
  const std::optional<Vector3> move = shortest_move(hand, X_OH, options.deepest, context);
  if (!move) return std::nullopt;
  return move->norm();
}

}  // namespace prehend
