// Collisions along a timed path as another engine sees them (second_check.h).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "planner/plan/path/check_path.h"
#include "sim/base/pose.h"
#include "sim/scene/compiled_arm.h"

namespace prehend {

class FclMesh;
struct Trajectory;

// Walks along the cubics between the samples of a path, in steps so short that no corner of a
// link's bounding box moves by more than PathCheckOptions::step, and asks of each pair of bodies
// whether they cross: in the first posture and the last, and in between before a point of one has
// moved by `step` against the other since the last look. Where the balls around two bodies were
// apart, by as much more as they were.
class PathCollisions {
 public:
  // `X_LO`: of an arm whose last link L is the object, which the hand holds: its frame in that
  // link's. All but `X_LO` must outlive this.
  PathCollisions(const CompiledArm& scene_arm, const CompiledArm& arm,
                 const std::optional<Pose>& X_LO, const SecondCheck& bodies, const Trajectory& path,
                 const PathCheckOptions& options, const RunContext& context);

  // Along the samples `first` to `last`: fills in `postures`, `collisions` and `first_collision`.
  // Throws Cancelled.
  PathCheck run(std::size_t first, std::size_t last);

 private:
  // A body of the second engine: in the frame of a link, or of the base for an obstacle.
  struct Body {
    const FclMesh* mesh = nullptr;
    std::optional<std::size_t> link;  // that it moves with
    Pose X_FM = Pose::Identity();     // in the frame F of that link or of the base
    Vector3 centre_F;                 // of the ball around it
    double radius = 0.0;
  };

  struct Pair {
    ArmPair names;
    std::size_t a = 0;     // body
    std::size_t b = 0;     // body of a link
    double moved = 0.0;    // the most that a point of b has moved against a since the last look [m]
    double apart = 0.0;    // the balls, at the last look [m]
    bool touches = false;  // at the last look
    bool may_touch = false;  // until they have been apart
  };

  // A posture of the walk, and how far the farthest corner of each link moves to get there.
  struct Posture {
    double time = 0.0;
    std::vector<double> joints;
    std::vector<Pose> X_BL;
    std::vector<double> moves;
  };

  void add_bodies(const SecondCheck& bodies, const std::optional<Pose>& X_LO);
  void add_pairs(const CompiledArm& scene_arm);
  bool may_part(const ArmPair& pair) const;
  std::vector<Posture> walk(std::size_t i, const Posture& from) const;
  std::vector<Posture> steps(std::size_t i, int count, const Posture& from) const;
  void look(const Posture& here, const Posture* next);
  double motion(const Pair& pair, const Posture& from, const Posture& to) const;
  bool cross(Pair& pair, const Posture& here) const;
  Pose place(const Body& body, const Posture& here) const;

  const CompiledArm& arm_;
  const Trajectory& path_;
  const PathCheckOptions& options_;
  const RunContext& context_;
  const bool carries_;
  std::vector<std::array<Vector3, 8>> corners_;  // of each link's bounding box
  std::vector<Body> bodies_;                     // of the links, then the others by BodyId
  std::vector<Pair> pairs_;
  PathCheck check_;
};

}  // namespace prehend
