#include "planner/propose/candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace prehend {
namespace {

// A rule gives a target point, a direction of approach and one of closing. Together with the same
// three of the hand (Hand::origin, approach, closing) they determine the pose of the hand's base.

// How far the hand at a preshape reaches beyond its origin along the approach [m].
double reach_of(const Robot& robot, const Preshape& preshape) {
  std::vector<Pose> X_HL;
  link_poses(robot, joint_values(robot, preshape.dofs), X_HL);
  const Hand& hand = *robot.hand;
  double reach = -std::numeric_limits<double>::infinity();
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    for (const Vector3& p_L : robot.links[l].mesh.vertices) {
      reach = std::max(reach, hand.approach.dot(X_HL[l] * p_L - hand.origin));
    }
  }
  return reach;
}

// How far the object reaches from `target` against the approach, towards the hand [m].
double object_reach(const TriangleMesh& mesh, const Vector3& target, const Vector3& approach) {
  double reach = -std::numeric_limits<double>::infinity();
  for (const Vector3& p : mesh.vertices) reach = std::max(reach, -approach.dot(p - target));
  return reach;
}

// Rotation whose columns are the approach, the closing direction and their cross product.
Matrix3 frame_of(const Vector3& approach, const Vector3& closing) {
  Matrix3 frame;
  frame << approach, closing, approach.cross(closing);
  return frame;
}

// Pose X_OH of the hand whose approach and closing directions are those of the aimed grasp, and
// whose grasp origin is `stand_off` [m] short of the target. With frames F built from both
// directions, R_OF = R_OH R_HF gives R_OH = R_OF R_HF^T.
Pose hand_pose(const Hand& hand, const AimedGrasp& aimed, double stand_off) {
  const Matrix3 rotation = frame_of(aimed.approach_O, aimed.closing_O) *
                           frame_of(hand.approach, hand.closing).transpose();
  const Vector3 origin_O = aimed.target_O - stand_off * aimed.approach_O;
  return pose_from(rotation, origin_O - rotation * hand.origin);
}

bool is_duplicate(const Candidate& a, const Candidate& b, const CandidateOptions& options) {
  if (a.preshape != b.preshape) return false;
  if ((a.X_OH.translation() - b.X_OH.translation()).norm() > options.duplicate_distance) {
    return false;
  }
  const Eigen::AngleAxisd turn(a.X_OH.linear().transpose() * b.X_OH.linear());
  return std::abs(turn.angle()) <= options.duplicate_angle;
}

// Every (size / most)-th of the list. The list is ordered by primitive and rule, so that a limit
// thins all of them out alike instead of cutting off the last primitives.
void keep_evenly(std::vector<ProposedGrasp>& grasps, std::size_t most) {
  if (grasps.size() <= most) return;
  std::vector<ProposedGrasp> kept;
  for (std::size_t i = 0; i < most; ++i) kept.push_back(grasps[i * grasps.size() / most]);
  grasps = std::move(kept);
}

}  // namespace

Proposals propose_grasps(const CompiledScene& scene, const std::vector<Primitive>& primitives,
                         const CandidateOptions& options, const RunContext& context) {
  const Robot& robot = scene.scene.hand;
  const Hand& hand = *robot.hand;
  Proposals proposals;
  proposals.smallest_width = std::numeric_limits<double>::infinity();
  std::vector<double> reach;
  for (const Preshape& preshape : hand.preshapes) {
    reach.push_back(reach_of(robot, preshape));
    proposals.largest_opening = std::max(proposals.largest_opening, preshape.max_width);
  }
  for (std::size_t p = 0; p < primitives.size(); ++p) {
    for (const AimedGrasp& aimed : aim_at(primitives[p], options.rules)) {
      context.cancellation.check();
      proposals.smallest_width = std::min(proposals.smallest_width, aimed.width);
      // The approach starts so far back that, measured along the approach, the foremost point of
      // the hand is start_clearance before the nearest point of the object: then the two cannot
      // overlap at the pre-grasp, whatever their shapes.
      const double depth = object_reach(scene.scene.object.mesh, aimed.target_O, aimed.approach_O);
      for (std::size_t s = 0; s < hand.preshapes.size(); ++s) {
        const Preshape& preshape = hand.preshapes[s];
        if (aimed.width < preshape.min_width || aimed.width > preshape.max_width) continue;
        // Two depths: the palm aimed at the target, for a grasp that encloses the primitive, and
        // the meeting point of the fingers aimed at it, for a grasp with the fingertips.
        for (const double stand_off : {0.0, preshape.depth}) {
          Candidate candidate;
          candidate.X_OH = hand_pose(hand, aimed, stand_off);
          candidate.approach_O = aimed.approach_O;
          // A hand that stops short by stand_off reaches less far by that much.
          candidate.approach_distance =
              std::max(0.0, depth + reach[s] - stand_off + options.start_clearance);
          candidate.preshape = static_cast<int>(s);
          // Symmetric primitives, and primitives that overlap, give the same hand pose repeatedly.
          const bool known = std::any_of(proposals.grasps.begin(), proposals.grasps.end(),
                                         [&](const ProposedGrasp& other) {
                                           return is_duplicate(other.candidate, candidate, options);
                                         });
          if (!known) proposals.grasps.push_back({candidate, static_cast<int>(p), aimed.rule});
        }
      }
    }
  }
  proposals.in_all = static_cast<int>(proposals.grasps.size());
  keep_evenly(proposals.grasps, static_cast<std::size_t>(options.max_candidates));
  return proposals;
}

}  // namespace prehend
