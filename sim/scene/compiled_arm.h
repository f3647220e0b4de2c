// The platform that carries the hand, prepared for motions: its collision bodies, and which pairs
// of them have to be checked for collision.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "sim/robot/platform.h"
#include "sim/scene/compiled_link.h"
#include "sim/scene/ids.h"
#include "sim/shape/proximity.h"

namespace prehend {

// Immutable after compile_arm, shared by threads. W is the world, B the base of the platform, O the
// object.
struct CompiledArm {
  AssembledPlatform platform;  // all robots as one, the hand among them
  int hand = 0;                // index of the hand in platform.parts
  Pose X_WB = Pose::Identity();
  Pose X_BO = Pose::Identity();
  std::vector<int> dofs;      // degrees of freedom that move the hand's base, base to tip
  std::vector<double> start;  // values of all degrees of freedom before any motion
  std::vector<CompiledLink> links;
  std::vector<PlacedBody> bodies;  // the object and the obstacles, by BodyId, in frame B
  // Pairs checked for collision: those of the hand's links with the object and the obstacles, and
  // all others (arm_pairs) except pairs that are proven to stay apart in every posture. Pairs of
  // two links of the hand are not listed: the trial checks them while the hand closes.
  std::vector<ArmPair> hand_pairs;
  std::vector<ArmPair> arm_pairs;

  const Robot& robot() const { return platform.robot; }
  const PlatformPart& hand_part() const { return platform.parts[static_cast<std::size_t>(hand)]; }
  bool is_hand_link(LinkId link) const;
  const PlacedBody& body(BodyId id) const { return bodies[index(id)]; }
  int hand_link_count = 0;  // links of the hand, from hand_part().first_link on
};

// `bodies`: the object and the obstacles in frame B. Throws InputError when the start posture
// collides or is outside limits, or the start does not fit the platform.
CompiledArm compile_arm(const Scene& scene, std::vector<PlacedBody> bodies);

// Puts the bodies of `scene`, for which the arm was compiled, to other places. `bodies`: as of
// compile_arm, with the same meshes; `moved`: whether a body stands elsewhere in frame B than
// before. Throws InputError when the start posture collides then.
void move_bodies(const Scene& scene, std::vector<PlacedBody> bodies, const std::vector<bool>& moved,
                 CompiledArm& arm);

// The pair of a link with another link or with a body.
ArmPair arm_pair(const CompiledArm& arm, LinkId link, const std::variant<LinkId, BodyId>& other);

// Joint values of the whole platform for `dofs`, with the hand's joints as given.
std::vector<double> arm_joints(const CompiledArm& arm, const std::vector<double>& dofs,
                               const std::vector<double>& hand_joints);

// Poses of all links of the platform in B, for one value per joint [rad or m].
void arm_link_poses(const CompiledArm& arm, const std::vector<double>& joints,
                    std::vector<Pose>& X_BL);

// Whether the gap between the bodies of a pair is larger than `distance` [m], with the links at
// X_BL (arm_link_poses). `larger` is proven. `meets`: the surfaces touch or cross. `not_proven`:
// the gap is not larger, or larger by no more than the query's `relative_error`, which makes it
// cheap.
enum class GapAnswer { larger, not_proven, meets };
GapAnswer gap_beyond(const CompiledArm& arm, const ArmPair& pair, const std::vector<Pose>& X_BL,
                     double distance, double relative_error);

// The same, with what the query found. `hint`: see GapOptions.
struct GapBeyond {
  GapAnswer answer = GapAnswer::larger;
  double at_least = 0.0;  // lower bound of the gap [m]
  TrianglePair nearest;   // of the other body and the link
};
GapBeyond find_gap_beyond(const CompiledArm& arm, const ArmPair& pair,
                          const std::vector<Pose>& X_BL, double distance, double relative_error,
                          const TrianglePair& hint);

// True when the surfaces cross or one body contains the other.
bool pair_meets(const CompiledArm& arm, const ArmPair& pair, const std::vector<Pose>& X_BL);

// Names of the pair's link, and of the link or body it is paired with.
std::string first_name(const CompiledArm& arm, const ArmPair& pair);
std::string second_name(const CompiledArm& arm, const ArmPair& pair);

}  // namespace prehend
