// The robots that carry the hand, made ready for motions: bodies, and which of them may ever meet.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/geometry/proximity.h"
#include "sim/robot/platform.h"
#include "sim/scene/compiled_link.h"

namespace prehend {

// The object or an obstacle, in the base frame B of the platform.
struct FixedBody {
  std::string name;
  ProximityMesh mesh;
  Pose X_BF = Pose::Identity();
  std::vector<Vector3> probes = {};  // one vertex of each of its components, its own frame
  bool is_solid = false;             // closed and oriented: inside has a meaning
};

// Two bodies that may meet: a link with another link or with a fixed body.
struct ArmPair {
  int link = 0;
  int other_link = -1;
  int fixed = -1;  // where other_link is -1
  // What moves the one relative to the other, and by how much at most: see CompiledLink.
  std::vector<int> joints = {};
  std::vector<double> reach = {};
};

struct CompiledArm {
  AssembledPlatform platform;  // robots, joints, links: with the hand
  int hand = 0;                // which of the parts is the hand
  Pose X_WB = Pose::Identity();
  Pose X_BO = Pose::Identity();
  std::vector<int> dofs;      // that move the hand, base to tip
  std::vector<double> start;  // of all degrees of freedom
  std::vector<CompiledLink> links;
  std::vector<FixedBody> fixed;  // the object, then the obstacles
  // Pairs that were not proven to stay apart in all postures: those of the hand with fixed bodies,
  // and all others. Two links of the hand are no pair here: the trial sees to them.
  std::vector<ArmPair> hand_pairs;
  std::vector<ArmPair> arm_pairs;

  const Robot& robot() const { return platform.robot; }
  const PlatformPart& hand_part() const { return platform.parts[static_cast<std::size_t>(hand)]; }
  bool is_hand_link(int link) const;
  int hand_link_count = 0;
};

// `fixed` as the arm has them. Throws InputError when the start posture collides or is outside
// limits, or the start does not fit the platform.
CompiledArm compile_arm(const Scene& scene, std::vector<FixedBody> fixed);

// Joint values of all robots for `dofs`, with the hand's joints as given.
std::vector<double> arm_joints(const CompiledArm& arm, const std::vector<double>& dofs,
                               const std::vector<double>& hand_joints);

// Poses of all links in B.
void arm_link_poses(const CompiledArm& arm, const std::vector<double>& joints,
                    std::vector<Pose>& X_BL);

// Whether the gap between the bodies is larger than `distance`, as far as a query at little cost
// tells; `meets` where there is none.
enum class GapAnswer { larger, not_proven, meets };
GapAnswer gap_beyond(const CompiledArm& arm, const ArmPair& pair, const std::vector<Pose>& X_BL,
                     double distance);

// True when the bodies meet or one is inside the other.
bool pair_meets(const CompiledArm& arm, const ArmPair& pair, const std::vector<Pose>& X_BL);

// "LINK" and "LINK or BODY" of a pair.
std::string first_name(const CompiledArm& arm, const ArmPair& pair);
std::string second_name(const CompiledArm& arm, const ArmPair& pair);

}  // namespace prehend
