// The grasp wrench space: what contacts can exert together with unit forces, as a convex set.
#pragma once

#include <memory>
#include <span>

#include "sim/quality/contact.h"
#include "sim/quality/epsilon.h"
#include "sim/quality/friction_cone.h"
#include "sim/quality/support.h"
#include "sim/quality/wrench.h"

namespace prehend {

// What is unit: the sum of all normal forces (the hull of the contacts' cones), or each of them
// (the Minkowski sum). Source: Ferrari and Canny, ICRA 1992, section 3.
enum class WrenchNorm { l1, linf };

// Whether forces may stay below the unit. For L1 this only adds the origin to the set, and epsilon
// is the same; for L-infinity, forces that have to be exactly unit shrink and shift it.
enum class UnitForce { at_most, exactly };

struct WrenchSpaceOptions {
  WrenchNorm norm = WrenchNorm::l1;
  FrictionCone cone = FrictionCone::pyramid;
  int edges = 8;  // of a pyramid, >= 3
  UnitForce force = UnitForce::at_most;
};

// The set as its support function; nothing is enumerated. Empty for no contacts.
// Throws as check_contacts, or for fewer than 3 edges of a pyramid.
std::unique_ptr<SupportMap> wrench_space(std::span<const Contact> contacts,
                                         const WrenchFrame& frame,
                                         const WrenchSpaceOptions& options = {});

// Default options of epsilon for such a set. The sets of pyramids are polytopes, where the search
// ends at a facet: EpsilonOptions' own defaults. The sets of exact cones are smooth, and each digit
// costs many times the facets of the one before: a bracket within 1e-2, or what 20,000 facets
// (about 3 ms) give.
EpsilonOptions epsilon_options(const WrenchSpaceOptions& space);

// Ferrari and Canny's measure of the set: epsilon of support.h's set, or epsilon_l1 where the set
// is a hull of columns. No contacts: no force closure. Throws as wrench_space and epsilon.
EpsilonBracket grasp_epsilon(std::span<const Contact> contacts, const WrenchFrame& frame,
                             const WrenchSpaceOptions& space, const EpsilonOptions& options);

// The same, with epsilon_options of the space.
EpsilonBracket grasp_epsilon(std::span<const Contact> contacts, const WrenchFrame& frame,
                             const WrenchSpaceOptions& space = {});

}  // namespace prehend
