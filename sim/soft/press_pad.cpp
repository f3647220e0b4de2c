#include "sim/soft/press_pad.h"

#include <algorithm>
#include <limits>

#include <Eigen/Cholesky>

#include "sim/base/index.h"
#include "sim/shape/proximity.h"

namespace prehend {
namespace {

constexpr double kLeastWeight = 0.1;

// The nodes that meet the object within `farthest` of the first that does.
void find_near(const ProximityMesh& object, const Pad& pad, const Pose& X_OL,
               const Vector3& direction_O, PadWorkspace& workspace) {
  const double farthest = kLargestStrain * pad.thickness;
  PressProblem& problem = workspace.problem;
  std::vector<double> gaps;
  std::vector<double> weights;
  double first = std::numeric_limits<double>::infinity();
  workspace.near.clear();
  workspace.facing.clear();
  for (std::size_t n = 0; n < pad.nodes_L.size(); ++n) {
    const Vector3 p_O = X_OL * pad.nodes_L[n];
    const RayHit hit = first_hit(object, p_O, direction_O, 2.0 * farthest);
    if (hit.triangle < 0) continue;
    const Vector3 normal_O =
        -doubled_area_vector(object.mesh(), index(hit.triangle)).normalized();  // into the object
    const double weight = normal_O.dot(direction_O);
    if (weight < kLeastWeight) continue;
    workspace.near.push_back(static_cast<int>(n));
    workspace.facing.push_back({p_O + hit.distance * direction_O, normal_O, 0.0});
    gaps.push_back(hit.distance * weight);
    weights.push_back(weight);
    first = std::min(first, hit.distance);
  }
  // Counted from where the pad first touches.
  const auto count = std::ssize(gaps);
  problem.weight = Eigen::Map<const Eigen::VectorXd>(weights.data(), count);
  problem.gap = Eigen::Map<const Eigen::VectorXd>(gaps.data(), count);
  if (count > 0) problem.gap -= first * problem.weight;
}

// How far each of the nodes yields along the normal there to a force along that of another.
void fill_compliance(const Pad& pad, const Pose& X_OL, PadWorkspace& workspace) {
  const auto count = std::ssize(workspace.near);
  Eigen::Matrix3Xd normals_L(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    normals_L.col(i) = X_OL.linear().transpose() * workspace.facing[index(i)].normal;
  }
  Eigen::MatrixXd& compliance = workspace.problem.compliance;
  compliance.resize(count, count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const Eigen::Index column = 3 * workspace.near[index(j)];
    // Displacements of all nodes by a unit force on node j, and from them those of the near ones.
    const auto block = pad.compliance.middleCols<3>(column);
    for (Eigen::Index i = 0; i <= j; ++i) {
      const Eigen::Index row = 3 * workspace.near[index(i)];
      compliance(i, j) = normals_L.col(i).dot(block.middleRows<3>(row) * normals_L.col(j));
      compliance(j, i) = compliance(i, j);
    }
  }
}

}  // namespace

void press_pad(const ProximityMesh& object, const Pad& pad, const Pose& X_OL,
               const Vector3& direction_O, double load, PadWorkspace& workspace, PadPatch& patch) {
  patch = {};
  find_near(object, pad, X_OL, direction_O, workspace);
  if (workspace.near.empty()) return;
  fill_compliance(pad, X_OL, workspace);
  const NodeForces forces = press_with(workspace.problem, load, kLargestStrain * pad.thickness);
  patch.approach = forces.approach;
  patch.load = forces.load;
  for (std::size_t i = 0; i < workspace.near.size(); ++i) {
    const double force = forces.force[static_cast<Eigen::Index>(i)];
    if (force <= 0.0) continue;
    patch.nodes.push_back(workspace.near[i]);
    patch.points.push_back(workspace.facing[i]);
    patch.points.back().force = force;
  }
}

Eigen::Matrix<double, 6, 6> patch_stiffness(const Pad& pad, const Pose& X_OL, const PadPatch& patch,
                                            const Vector3& center_O) {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  std::vector<Eigen::Index> rows;
  const auto count = std::ssize(patch.nodes);
  // What each node has to move by, in the axes of L, for each motion of the link.
  Eigen::MatrixXd moved(3 * count, 6);
  const Matrix3 R_LO = X_OL.linear().transpose();
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) rows.push_back(3 * patch.nodes[index(i)] + k);
    const Vector3 arm_O = patch.points[index(i)].position - center_O;
    Matrix3 turned;  // column k: axis k x arm
    for (Eigen::Index k = 0; k < 3; ++k) turned.col(k) = Vector3::Unit(k).cross(arm_O);
    moved.block<3, 3>(3 * i, 0) = R_LO;
    moved.block<3, 3>(3 * i, 3) = R_LO * turned;
  }
  if (count == 0) return Matrix6::Zero();
  const Eigen::MatrixXd among = pad.compliance(rows, rows);
  const Matrix6 stiffness = moved.transpose() * among.llt().solve(moved);
  return 0.5 * (stiffness + stiffness.transpose());
}

}  // namespace prehend
