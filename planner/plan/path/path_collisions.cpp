#include "planner/plan/path/path_collisions.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "planner/plan/path/fcl_mesh.h"
#include "planner/plan/path/second_check.h"
#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/motion/control/trajectory.h"
#include "sim/scene/carried_object.h"

namespace prehend {
namespace {

// Most steps between two samples, 8 m of motion at the default step: a guard against paths whose
// samples are absurdly far apart.
constexpr int kMostSteps = 4096;

// Joint values at the fraction `part` (0..1) of the time between samples i and i + 1, on the cubic
// Hermite polynomial of their positions and velocities. The four weights are the Hermite basis; the
// tangents are scaled by h because the basis is written for an interval of length 1.
std::vector<double> between(const Trajectory& path, std::size_t i, double part) {
  const double h = path.times[i + 1] - path.times[i];
  const double s = part;
  const double from = (1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s);
  const double to = s * s * (3.0 - 2.0 * s);
  const double leave = s * (1.0 - s) * (1.0 - s) * h;
  const double arrive = s * s * (s - 1.0) * h;
  std::vector<double> joints(path.joints.size());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    joints[j] = from * path.positions[i][j] + to * path.positions[i + 1][j] +
                leave * path.velocities[i][j] + arrive * path.velocities[i + 1][j];
  }
  return joints;
}

// A link lies in the convex hull of the corners of its bounding box, so no point of it moves
// farther from one pose to another than the farthest corner: the difference of two rigid motions is
// affine, and its norm is largest at a corner of the hull. This measures the motion with 8 points
// instead of all vertices.
std::array<Vector3, 8> box_corners(const TriangleMesh& mesh) {
  const Bounds box = bounds(mesh);
  std::array<Vector3, 8> corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    corners[k] = {(k & 1) != 0 ? box.upper.x() : box.lower.x(),
                  (k & 2) != 0 ? box.upper.y() : box.lower.y(),
                  (k & 4) != 0 ? box.upper.z() : box.lower.z()};
  }
  return corners;
}

// How far the farthest corner is in the pose X_BC of a body from where it is in the pose X_BA [m].
double farthest_move(const std::array<Vector3, 8>& corners, const Pose& X_BA, const Pose& X_BC) {
  const Matrix3 turned = X_BC.linear() - X_BA.linear();
  const Vector3 moved = X_BC.translation() - X_BA.translation();
  double most = 0.0;
  for (const Vector3& p : corners) most = std::max(most, (turned * p + moved).squaredNorm());
  return std::sqrt(most);
}

}  // namespace

PathCollisions::PathCollisions(const CompiledArm& scene_arm, const CompiledArm& arm,
                               const std::optional<Pose>& X_LO, const SecondCheck& bodies,
                               const Trajectory& path, const PathCheckOptions& options,
                               const RunContext& context)
    : arm_(arm), path_(path), options_(options), context_(context), carries_(X_LO.has_value()) {
  for (const CompiledLink& link : arm.links) corners_.push_back(box_corners(link.mesh.mesh()));
  add_bodies(bodies, X_LO);
  add_pairs(scene_arm);
}

PathCheck PathCollisions::run(std::size_t first, std::size_t last) {
  Posture here{
      .time = path_.times[first], .joints = path_.positions[first], .X_BL = {}, .moves = {}};
  arm_link_poses(arm_, here.joints, here.X_BL);
  for (Pair& pair : pairs_) {
    pair.may_touch = may_part(pair.names) && cross(pair, here);
    // Not looked at yet, as far as look() knows.
    pair.touches = true;
  }
  for (std::size_t i = first; i < last; ++i) {
    for (Posture& next : walk(i, here)) {
      look(here, &next);
      here = std::move(next);
    }
  }
  look(here, nullptr);
  return check_;
}

void PathCollisions::add_bodies(const SecondCheck& bodies, const std::optional<Pose>& X_LO) {
  for (std::size_t l = 0; l < arm_.links.size(); ++l) {
    Body body{.mesh = nullptr, .link = l, .X_FM = Pose::Identity(), .centre_F = {}, .radius = 0.0};
    if (carries_ && link_id(l) == carried_object(arm_)) {
      body.mesh = &bodies.body(BodyId::at(0));
      body.X_FM = *X_LO;
    } else {
      body.mesh = &bodies.link(link_id(l));
    }
    bodies_.push_back(body);
  }
  for (std::size_t b = 0; b < arm_.bodies.size(); ++b) {
    bodies_.push_back({.mesh = &bodies.body(BodyId::at(b)),
                       .link = std::nullopt,
                       .X_FM = arm_.bodies[b].X_RB,
                       .centre_F = {},
                       .radius = 0.0});
  }
  for (Body& body : bodies_) {
    body.centre_F = body.X_FM * body.mesh->centre();
    body.radius = body.mesh->radius();
  }
}

// All pairs of the scene's arm, and with the object in the hand those of the object.
void PathCollisions::add_pairs(const CompiledArm& scene_arm) {
  const auto with_link = [&](LinkId link, LinkId other) {
    pairs_.push_back({.names = arm_pair(arm_, link, other), .a = index(other), .b = index(link)});
  };
  for (const LinkPair& pair : collision_pairs(scene_arm.links, scene_arm.robot())) {
    with_link(pair.a, pair.b);
  }
  for (std::size_t l = 0; l < arm_.links.size(); ++l) {
    for (std::size_t b = carries_ ? 1 : 0; b < arm_.bodies.size(); ++b) {
      // Neither moves; the start was checked when the scene was compiled.
      if (arm_.links[l].joints.empty() && b > 0) continue;
      pairs_.push_back(
          {.names = arm_pair(arm_, link_id(l), BodyId::at(b)), .a = arm_.links.size() + b, .b = l});
    }
    if (!carries_ || arm_.is_hand_link(link_id(l))) continue;
    if (arm_.robot().links[l].joint == arm_.hand_part().joint) continue;
    with_link(carried_object(arm_), link_id(l));
  }
}

// Whether the bodies may touch where the path begins, until they part: a held object lies on
// something, and the fingers of a closed hand touch each other.
bool PathCollisions::may_part(const ArmPair& pair) const {
  const LinkId* other = std::get_if<LinkId>(&pair.other);
  return carries_ ||
         (other != nullptr && arm_.is_hand_link(pair.link) && arm_.is_hand_link(*other));
}

// The postures after sample i up to and including sample i + 1. How far a link moves in a step is
// known only once its poses are computed, so they are divided until the longest step is short
// enough.
std::vector<PathCollisions::Posture> PathCollisions::walk(std::size_t i,
                                                          const Posture& from) const {
  int count = 1;
  while (true) {
    context_.cancellation.check();
    std::vector<Posture> postures = steps(i, count, from);
    double longest = 0.0;
    for (const Posture& posture : postures) {
      for (const double move : posture.moves) longest = std::max(longest, move);
    }
    if (longest <= options_.step || count == kMostSteps) return postures;
    const double wanted = std::ceil(count * longest / options_.step);
    count = static_cast<int>(std::clamp(wanted, count + 1.0, double{kMostSteps}));
  }
}

std::vector<PathCollisions::Posture> PathCollisions::steps(std::size_t i, int count,
                                                           const Posture& from) const {
  std::vector<Posture> postures(index(count));
  const Posture* before = &from;
  for (int k = 1; k <= count; ++k) {
    const double part = static_cast<double>(k) / count;
    Posture& posture = postures[index(k - 1)];
    posture.time = path_.times[i] + part * (path_.times[i + 1] - path_.times[i]);
    posture.joints = between(path_, i, part);
    arm_link_poses(arm_, posture.joints, posture.X_BL);
    for (std::size_t l = 0; l < corners_.size(); ++l) {
      posture.moves.push_back(farthest_move(corners_[l], before->X_BL[l], posture.X_BL[l]));
    }
    before = &posture;
  }
  return postures;
}

// Looks at the pairs that must be looked at before the next posture; at all where there is none.
// The description is kept of the first collision only.
void PathCollisions::look(const Posture& here, const Posture* next) {
  ++check_.postures;
  const Pair* met = nullptr;
  for (Pair& pair : pairs_) {
    const double way = next == nullptr ? 0.0 : motion(pair, here, *next);
    pair.moved += way;
    const bool is_far = pair.moved <= std::max(options_.step, pair.apart);
    if (next != nullptr && !pair.touches && is_far) continue;
    pair.touches = cross(pair, here);
    pair.moved = way;
    pair.may_touch = pair.may_touch && pair.touches;
    if (pair.touches && !pair.may_touch && met == nullptr) met = &pair;
  }
  if (met == nullptr || ++check_.collisions > 1) return;
  check_.first_collision = first_name(arm_, met->names) + " meets " +
                           second_name(arm_, met->names) + formatted(" at %.3f s", here.time);
}

// The most that a point of one body moves against the other from one posture to the next [m].
double PathCollisions::motion(const Pair& pair, const Posture& from, const Posture& to) const {
  const Body& a = bodies_[pair.a];
  if (!a.link) return to.moves[pair.b];
  const std::vector<int>& between = pair.names.joints;
  if (std::all_of(between.begin(), between.end(), [&](int joint) {
        return from.joints[index(joint)] == to.joints[index(joint)];
      })) {
    return 0.0;
  }
  return farthest_move(corners_[pair.b], from.X_BL[*a.link].inverse() * from.X_BL[pair.b],
                       to.X_BL[*a.link].inverse() * to.X_BL[pair.b]);
}

// Whether the surfaces cross. Most pairs are far apart, which the balls around them tell in a
// fraction of the time.
bool PathCollisions::cross(Pair& pair, const Posture& here) const {
  const Body& a = bodies_[pair.a];
  const Body& b = bodies_[pair.b];
  const Vector3 centre_a = a.link ? here.X_BL[*a.link] * a.centre_F : a.centre_F;
  const Vector3 centre_b = here.X_BL[*b.link] * b.centre_F;
  pair.apart = (centre_a - centre_b).norm() - a.radius - b.radius;
  if (pair.apart > 0.0) return false;
  return a.mesh->crosses(place(a, here), *b.mesh, place(b, here));
}

Pose PathCollisions::place(const Body& body, const Posture& here) const {
  return body.link ? here.X_BL[*body.link] * body.X_FM : body.X_FM;
}

}  // namespace prehend
