// epsilon_l1 beside the full hull of the same wrenches.
#pragma once

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/quality/epsilon.h"
#include "sim/quality/start_simplex.h"
#include "sim/quality/wrench_hull.h"
#include "tests/support/grasp_families.h"

namespace prehend::test {

// The grasp, to paste into a test.
inline std::string print(const NamedGrasp& grasp) {
  std::ostringstream text;
  text.precision(17);
  text << grasp.name << ", " << grasp.edges << " edges: {";
  for (const Contact& contact : grasp.contacts) {
    const Eigen::Vector3d& p = contact.position;
    const Eigen::Vector3d& n = contact.normal;
    text << "{{" << p.x() << ", " << p.y() << ", " << p.z() << "}, {" << n.x() << ", " << n.y()
         << ", " << n.z() << "}, " << contact.friction << "}, ";
  }
  return text.str() + "}";
}

// Whether qhull had to move the wrenches of near-duplicates: its hull is then inexact.
inline bool joggled(const WrenchHull& hull, const Wrenches& wrenches) {
  return hull.doubt > 1.01 * kFlatness * wrenches.cwiseAbs().maxCoeff();
}

// That epsilon_l1 says what the full hull says.
inline void expect_agreement(const NamedGrasp& grasp) {
  const Wrenches wrenches = contact_wrenches(grasp.contacts, {}, grasp.edges);
  const WrenchHull hull = wrench_hull(wrenches);
  const EpsilonBracket bracket = epsilon_l1(wrenches);
  ASSERT_EQ(bracket.force_closure(), hull.force_closure()) << print(grasp);
  if (!hull.force_closure()) {
    EXPECT_EQ(bracket.status, EpsilonStatus::no_force_closure) << print(grasp);
    EXPECT_EQ(bracket.upper, 0.0) << print(grasp);
    return;
  }
  EXPECT_EQ(bracket.status, EpsilonStatus::converged) << print(grasp);
  // Rounding of qhull's own planes, and the joggle where it needed one.
  const double scale = wrenches.cwiseAbs().maxCoeff();
  const double joggle = joggled(hull, wrenches) ? hull.doubt : 0.0;
  const double tolerance = 1e-9 * hull.min_offset + joggle + 1e-14 * scale;
  EXPECT_NEAR(bracket.lower, hull.min_offset, tolerance) << print(grasp);
  EXPECT_NEAR(bracket.upper, hull.min_offset, tolerance) << print(grasp);
}

// Flat grasps thickened to 1e-8: their epsilon is near the limit of flatness, and growth stalls on
// some of them (number 123), so that the hull decides.
inline std::vector<NamedGrasp> thin_grasps() {
  Random random(16);
  std::vector<NamedGrasp> grasps;
  for (int i = 0; i < 130; ++i) {
    Contacts contacts = i % 2 == 1 ? ring_grasp(2, 0.4) : cube_grasp(0.0);
    Contacts copies = contacts;
    const double shift = std::pow(10.0, random.uniform(-8.0, -7.0));
    for (Contact& contact : copies) {
      contact.position += shift * random.direction();
      contact.normal = (contact.normal + shift * random.direction()).normalized();
    }
    append(contacts, copies);
    grasps.push_back({"thin " + std::to_string(i), contacts, 8});
  }
  return grasps;
}

}  // namespace prehend::test
