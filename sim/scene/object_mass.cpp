#include "sim/scene/object_mass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Eigenvalues>

#include "sim/base/formatted.h"

namespace prehend {

std::string_view mass_basis_text(MassBasis basis) {
  constexpr std::array<std::string_view, 4> kWords = {"uniform density", "stated centre of mass",
                                                      "stated parts", "named materials"};
  return kWords[static_cast<std::size_t>(basis)];
}

void state_center_of_mass(GraspableBody& object, const Vector3& center_O) {
  object.center_of_mass = center_O;
  object.mass_basis = MassBasis::center;
  object.stated_mass.reset();
}

void state_mass(GraspableBody& object, const StatedMass& stated) {
  const MassOfParts found = mass_of_parts(object.mesh, stated);
  object.mass = found.mass;
  object.center_of_mass = found.center_of_mass;
  object.inertia = found.inertia;
  object.mass_source = found.source;
  object.mass_basis = stated.parts.empty() ? MassBasis::uniform : MassBasis::parts;
  object.stated_mass.reset();
  if (!stated.parts.empty()) object.stated_mass = stated;
}

std::optional<LongObject> long_object_of_uniform_mass(const GraspableBody& object) {
  if (object.mass_basis != MassBasis::uniform || !(object.mass > 0.0)) return std::nullopt;
  // The second central moment of a mass of 1, from the inertia.
  const Matrix3 spread =
      (0.5 * object.inertia.trace() * Matrix3::Identity() - object.inertia) / object.mass;
  const Eigen::SelfAdjointEigenSolver<Matrix3> axes(spread);
  const Vector3& squares = axes.eigenvalues();
  if (!(squares[2] > kLongObject * kLongObject * std::max(squares[1], 0.0))) return std::nullopt;
  const Vector3 axis = axes.eigenvectors().col(2);
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const Vector3& p : object.mesh.vertices) {
    lowest = std::min(lowest, axis.dot(p));
    highest = std::max(highest, axis.dot(p));
  }
  return LongObject{axis, highest - lowest};
}

void note_uniform_mass(Scene& scene) {
  const std::string advice =
      "mass is taken as uniform: state center_of_mass or parts if it is heavier at one end";
  std::erase_if(scene.notes, [&](const std::string& note) { return note.ends_with(advice); });
  const std::optional<LongObject> object = long_object_of_uniform_mass(scene.object);
  if (!object) return;
  scene.notes.push_back(formatted("%.3g mm long and its ", 1000.0 * object->length) + advice);
}

}  // namespace prehend
