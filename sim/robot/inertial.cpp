#include "sim/robot/inertial.h"

#include <Eigen/Eigenvalues>

#include "sim/shape/mass_properties.h"

namespace prehend {
namespace {

// Numbers of data sheets are rounded: by this part of the largest moment a rule may be missed.
constexpr double kRounded = 1e-3;

}  // namespace

Inertial inertial_of_density(const TriangleMesh& mesh, double density) {
  const MassProperties unit = mass_properties(mesh);
  const double mass = density * unit.volume;
  return {mass, unit.center_of_mass, mass * unit.unit_inertia};
}

Inertial inertial_of_mass(const TriangleMesh& mesh, double mass) {
  const MassProperties unit = mass_properties(mesh);
  return {mass, unit.center_of_mass, mass * unit.unit_inertia};
}

Inertial transformed(const Inertial& inertial, const Pose& X_AB) {
  return {inertial.mass, X_AB * inertial.center_of_mass,
          X_AB.linear() * inertial.inertia * X_AB.linear().transpose()};
}

std::string inertia_defect(const Matrix3& inertia) {
  const double largest = inertia.cwiseAbs().maxCoeff();
  if (!((inertia - inertia.transpose()).cwiseAbs().maxCoeff() <= kRounded * largest)) {
    return "must be symmetric";
  }
  const Matrix3 symmetric = 0.5 * (inertia + inertia.transpose());
  const Vector3 moments =
      Eigen::SelfAdjointEigenSolver<Matrix3>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
  if (moments[0] < -kRounded * largest) return "must have no negative moment about any axis";
  if (moments[2] > moments[0] + moments[1] + kRounded * largest) {
    return "no body has such an inertia, a principal moment is larger than the sum of the others";
  }
  return "";
}

}  // namespace prehend
