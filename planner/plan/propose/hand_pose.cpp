#include "planner/plan/propose/hand_pose.h"

#include <algorithm>
#include <limits>

#include "sim/shape/separation.h"

namespace prehend {
namespace {

// A rule gives a target point, a direction of approach and one of closing. Together with the same
// three of the hand (Hand::origin, approach, closing) they determine the pose of the hand's base.

// Rotation whose columns are the approach, the closing direction and their cross product.
Matrix3 frame_of(const Vector3& approach, const Vector3& closing) {
  Matrix3 frame;
  frame << approach, closing, approach.cross(closing);
  return frame;
}

// How far a surface reaches along a unit direction, from the origin of its frame [m]: that of the
// convex sets around it, which is hardly more and much quicker to find.
double extent(const ProximityMesh& mesh, const Vector3& direction) {
  double most = -std::numeric_limits<double>::infinity();
  for (const ConvexPoints& part : mesh.parts()) {
    most = std::max(most,
                    direction.dot(part.farthest(direction)) + part.margin() + part.search_error());
  }
  return most;
}

}  // namespace

// With frames F built from both directions, R_OF = R_OH R_HF gives R_OH = R_OF R_HF^T.
Pose hand_pose(const Hand& hand, const AimedGrasp& aimed, double stand_off) {
  const Matrix3 rotation = frame_of(aimed.approach_O, aimed.closing_O) *
                           frame_of(hand.approach, hand.closing).transpose();
  const Vector3 origin_O = aimed.target_O - stand_off * aimed.approach_O;
  return pose_from(rotation, origin_O - rotation * hand.origin);
}

double hand_reach(const CompiledScene& scene, const std::vector<double>& dofs) {
  const Hand& hand = *scene.scene.hand.hand;
  std::vector<Pose> X_HL;
  link_poses(scene.scene.hand, joint_values(scene.scene.hand, dofs), X_HL);
  double reach = -std::numeric_limits<double>::infinity();
  for (std::size_t l = 0; l < scene.links.size(); ++l) {
    const Vector3 approach_L = X_HL[l].linear().transpose() * hand.approach;
    const double beyond = hand.approach.dot(X_HL[l].translation() - hand.origin);
    reach = std::max(reach, beyond + extent(scene.links[l].mesh, approach_L));
  }
  return reach;
}

double approach_distance(const CompiledScene& scene, const Pose& X_OH, const Vector3& approach_O,
                         double reach, double clearance) {
  const Vector3 origin_O = X_OH * scene.scene.hand.hand->origin;
  const double object = extent(scene.object().mesh, -approach_O) + approach_O.dot(origin_O);
  return std::max(0.0, object + reach + clearance);
}

}  // namespace prehend
