// Bounds of epsilon that a trial states, compared with exact arithmetic on wrenches that are made
// here from the contacts, by their definition.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "sim/quality/contact.h"
#include "sim/quality/epsilon.h"
#include "sim/scene/scene.h"
#include "tests/support/exact_hull.h"

namespace prehend::test {

// Point and scale of torques in a scene: the object's centre of mass, and one over the distance of
// the vertex that is farthest from it.
struct TorqueFrame {
  Vector3 origin = Vector3::Zero();
  double scale = 1.0;
};

inline TorqueFrame torque_frame(const GraspableBody& object) {
  double farthest = 0.0;
  for (const Vector3& p : object.mesh.vertices) {
    farthest = std::max(farthest, (p - object.center_of_mass).norm());
  }
  return {object.center_of_mass, 1.0 / farthest};
}

// What a contact transmits at a unit normal force: a force, and a torque about the normal.
struct CornerForce {
  Vector3 force;
  double torque;
};

// The corners of a contact's pyramid of `edges` edges; a nearly unit normal is taken as its
// direction. The first edge is along normal x X (normal x
// Z where that vanishes); a soft finger's corners are on the ellipsoid |f_t|^2 + (t / torsion)^2 <=
// friction^2, at the latitudes 0 and 45 degrees and the poles.
inline std::vector<CornerForce> corner_forces(const Contact& contact, int edges) {
  const Vector3 n = contact.normal.normalized();
  Vector3 first = n.cross(Vector3::UnitX());
  if (first.norm() < 1e-6) first = n.cross(Vector3::UnitZ());
  first.normalize();
  const Vector3 second = n.cross(first);
  const bool soft = contact.model == ContactModel::soft_finger;
  const double friction = contact.model == ContactModel::frictionless ? 0.0 : contact.friction;
  std::vector<CornerForce> corners;
  for (const int latitude : soft ? std::vector<int>{0, 45, -45} : std::vector<int>{0}) {
    const double up = latitude * std::numbers::pi / 180.0;
    for (int e = 0; e < edges; ++e) {
      const double around = 2.0 * std::numbers::pi * e / edges;
      const Vector3 aside = std::cos(around) * first + std::sin(around) * second;
      corners.push_back({n + friction * std::cos(up) * aside,
                         latitude == 0 ? 0.0 : friction * contact.torsion * std::sin(up)});
    }
  }
  if (soft) {
    corners.push_back({n, friction * contact.torsion});
    corners.push_back({n, -friction * contact.torsion});
  }
  return corners;
}

inline exact::Columns judged_wrenches(const std::vector<Contact>& contacts,
                                      const TorqueFrame& frame, int edges) {
  std::vector<Eigen::Matrix<double, 6, 1>> columns;
  for (const Contact& contact : contacts) {
    for (const CornerForce& corner : corner_forces(contact, edges)) {
      const Vector3 arm = contact.position - frame.origin;
      const Vector3 torque = arm.cross(corner.force) + corner.torque * contact.normal.normalized();
      columns.emplace_back();
      columns.back() << corner.force, frame.scale * torque;
    }
  }
  exact::Columns wrenches(6, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j) {
    wrenches.col(static_cast<Eigen::Index>(j)) = columns[j];
  }
  return wrenches;
}

struct EpsilonVerdict {
  std::string fault;  // in words, empty where there is none
  // Of the worse bound from the exact value, relative; nothing where there is no value to compare.
  std::optional<double> difference;
};

// Judges `claimed`, the bounds stated for these wrenches. Sets thinner than 1e-9 of their size have
// no force closure by definition; between half and twice that, both answers are accepted, because
// these wrenches are rounded differently from the library's. That rounding is also why values may
// differ by 1e-14 of the size besides the library's tolerance of 1e-9. A search that ran into its
// limit of facets states bounds only; so does the exact one, after `most_facets`.
inline EpsilonVerdict judge_epsilon(const EpsilonBracket& claimed, const exact::Columns& wrenches,
                                    std::size_t most_facets) {
  EpsilonVerdict verdict;
  const double size = wrenches.cols() > 0 ? wrenches.cwiseAbs().maxCoeff() : 0.0;
  const exact::Epsilon judged = wrenches.cols() > 0
                                    ? exact::epsilon(wrenches, {.most_facets = most_facets})
                                    : exact::Epsilon{};
  const double lower = judged.lower.convert_to<double>();
  const double upper = judged.upper.convert_to<double>();
  std::ostringstream words;
  words.precision(17);
  words << "epsilon " << claimed.lower << " to " << claimed.upper << " (" << name_of(claimed.status)
        << "), exactly " << lower << " to " << upper;
  const double thin = 1e-9 * size;
  if (!claimed.force_closure()) {
    if (lower > 2.0 * thin) verdict.fault = words.str();
    return verdict;
  }
  if (judged.dimension < 6 || upper < 0.5 * thin) {
    verdict.fault = words.str();
    return verdict;
  }
  const double rounding = 1e-14 * size;
  const bool too_high = claimed.lower > upper * (1.0 + 1e-12) + rounding;
  const bool too_low = claimed.upper < lower * (1.0 - 1e-12) - rounding;
  const double width = claimed.upper - claimed.lower;
  const bool too_wide = claimed.status == EpsilonStatus::converged &&
                        width > 1.001e-9 * claimed.upper + 2.0 * rounding;
  if (too_high || too_low || too_wide) verdict.fault = words.str();
  if (lower == upper && claimed.status == EpsilonStatus::converged) {
    verdict.difference =
        std::max(std::abs(claimed.lower - lower), std::abs(claimed.upper - lower)) / lower;
  }
  return verdict;
}

}  // namespace prehend::test
