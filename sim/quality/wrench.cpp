#include "sim/quality/wrench.h"

#include <cmath>
#include <numbers>
#include <string>

#include "sim/base/input_error.h"
#include "sim/quality/ranges.h"
#include "sim/quality/suction_cup.h"
#include "sim/quality/wrench_workspace.h"

namespace prehend {

// A cup: see cup_corners. A soft finger: a ring at each of three latitudes of its ellipsoid, and
// the two poles.
int pyramid_corners(ContactModel model, int edges) {
  if (model == ContactModel::suction) return cup_corner_count(edges);
  return model == ContactModel::soft_finger ? 3 * edges + 2 : edges;
}

// Points of the unit circle of tangential forces or, for a soft finger, of the unit sphere of
// tangential forces and torque. Scaled by friction and torsion they become the border of the
// contact model's disc or ellipsoid. The pyramid is inscribed in the exact cone: it allows no force
// that the contact cannot transmit.
void unit_corners(ContactModel model, int edges, Eigen::Matrix3Xd& corners) {
  const bool grips_as_soft = model == ContactModel::soft_finger || model == ContactModel::suction;
  corners.resize(3, pyramid_corners(grips_as_soft ? ContactModel::soft_finger : model, edges));
  for (int edge = 0; edge < edges; ++edge) {
    const double angle = 2.0 * std::numbers::pi * edge / edges;
    corners.col(edge) << std::cos(angle), std::sin(angle), 0.0;
  }
  if (model == ContactModel::frictionless) corners.setZero();
  if (!grips_as_soft) return;
  // Latitudes of +45 and -45 degrees, where force and torque both have the part sin 45 degrees.
  for (const int side : {1, 2}) {
    auto latitude = corners.middleCols(side * edges, edges);
    latitude = std::numbers::sqrt2 / 2.0 * corners.leftCols(edges);
    latitude.row(2).setConstant((side == 1 ? 1.0 : -1.0) * std::numbers::sqrt2 / 2.0);
  }
  corners.col(3 * edges) << 0.0, 0.0, 1.0;
  corners.col(3 * edges + 1) << 0.0, 0.0, -1.0;
}

Eigen::Matrix3Xd unit_corners(ContactModel model, int edges) {
  Eigen::Matrix3Xd corners;
  unit_corners(model, edges, corners);
  return corners;
}

// Not by require: this runs for every grasp that is judged, and the text is needed for none.
void check_edges(int edges) {
  if (edges >= kFewestEdges && edges <= kMostEdges) return;
  throw InputError({.field = "edges",
                    .problem = "of a friction pyramid: must be from " +
                               std::to_string(kFewestEdges) + " to " + std::to_string(kMostEdges),
                    .value = std::to_string(edges)});
}

Eigen::Map<const Wrenches> contact_wrenches(std::span<const Contact> contacts,
                                            const WrenchFrame& frame, int edges,
                                            WrenchWorkspace& workspace) {
  check_contacts(contacts, frame);
  check_edges(edges);
  for (const ContactModel model : kAll<ContactModel>) {
    unit_corners(model, edges, workspace.corners[static_cast<std::size_t>(model)]);
  }
  std::size_t count = 0;
  for (const Contact& contact : contacts) {
    count += static_cast<std::size_t>(pyramid_corners(contact.model, edges));
  }
  workspace.columns.resize(count);
  const auto columns = static_cast<Eigen::Index>(count);
  double* const first = count == 0 ? nullptr : workspace.columns.front().data();
  Eigen::Map<Wrenches> wrenches(first, 6, columns);
  Eigen::Index column = 0;
  for (const Contact& contact : contacts) {
    if (contact.model == ContactModel::suction) {
      auto of_cup = wrenches.middleCols(column, cup_corner_count(edges));
      cup_corners(contact, frame, edges, workspace.corners[static_cast<std::size_t>(contact.model)],
                  of_cup);
      column += of_cup.cols();
      continue;
    }
    const ContactMap map = contact_map(contact, frame);
    const Eigen::Matrix3Xd& corners = workspace.corners[static_cast<std::size_t>(contact.model)];
    // normal + friction (tangents, torsion * torque) * corners. All tangential parts of a
    // frictionless contact are 0, whatever its friction.
    auto of_contact = wrenches.middleCols(column, corners.cols());
    of_contact.noalias() = contact.friction * map.middleCols<2>(1) * corners.topRows<2>();
    of_contact.noalias() += contact.friction * contact.torsion * map.col(3) * corners.row(2);
    of_contact.colwise() += map.col(0);
    column += corners.cols();
  }
  return {first, 6, columns};
}

Wrenches contact_wrenches(std::span<const Contact> contacts, const WrenchFrame& frame, int edges) {
  WrenchWorkspace workspace;
  return contact_wrenches(contacts, frame, edges, workspace);
}

}  // namespace prehend
