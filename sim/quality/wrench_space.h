// The grasp wrench space: what contacts can exert together with unit forces, as a convex set.
#pragma once

#include <memory>
#include <span>

#include "sim/base/named_enum.h"
#include "sim/base/settings.h"
#include "sim/quality/contact.h"
#include "sim/quality/epsilon.h"
#include "sim/quality/friction_cone.h"
#include "sim/quality/support.h"
#include "sim/quality/wrench.h"

namespace prehend {

// Which norm of the normal forces is limited to one: their sum (l1: the convex hull of the
// contacts' unit cones), or the largest of them (linf: the Minkowski sum of these cones). Source:
// Ferrari and Canny, ICRA 1992, section 3.
enum class WrenchNorm { l1, linf };

// Whether forces may stay below the unit. For L1 this only adds the origin to the set, and epsilon
// is the same; for L-infinity, forces that have to be exactly unit shrink and shift it.
enum class UnitForce { at_most, exactly };

constexpr auto enum_names(WrenchNorm /*of*/) {
  return std::to_array<std::string_view>({"l1", "linf"});
}
constexpr auto enum_names(UnitForce /*of*/) {
  return std::to_array<std::string_view>({"at_most", "exactly"});
}

struct WrenchSpaceOptions {
  static constexpr AboutSettings kAbout{"WrenchSpaceOptions",
                                        "The set of wrenches that contacts can exert (Ferrari and "
                                        "Canny 1992)."};
  WrenchNorm norm = WrenchNorm::l1;
  FrictionCone cone = FrictionCone::pyramid;
  int edges = 8;
  UnitForce force = UnitForce::at_most;
};

template <SettingsOf<WrenchSpaceOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [norm, cone, edges, force] = options;
  visit("norm", norm, "What is unit: the sum of all normal forces, or each of them.");
  visit("cone", cone, "The friction cone: exact, or a pyramid.");
  visit("edges", edges, kConeEdges, "", "Of a pyramid.");
  visit("force", force, "Whether forces may stay below the unit.");
}

// The set as its support function, without enumerating its points.
// Throws as check_contacts, and for a pyramid as check_edges.
std::unique_ptr<SupportMap> wrench_space(std::span<const Contact> contacts,
                                         const WrenchFrame& frame,
                                         const WrenchSpaceOptions& options = {});

// Default options of epsilon for such a set. The sets of friction pyramids are polytopes, on which
// the search ends exactly at a facet: the defaults of EpsilonOptions. The sets of exact cones are
// smooth, and every further digit takes many times as many facets as the one before: the search
// stops at a relative tolerance of 1e-2, or after 20,000 facets (about 3 ms).
EpsilonOptions epsilon_options(const WrenchSpaceOptions& space);

// Ferrari and Canny's measure of the set: epsilon of support.h's set, or epsilon_l1 where the set
// is a hull of columns. No contacts: no force closure. Throws as wrench_space and epsilon.
EpsilonBracket grasp_epsilon(std::span<const Contact> contacts, const WrenchFrame& frame,
                             const WrenchSpaceOptions& space, const EpsilonOptions& options);

// The same, with epsilon_options of the space.
EpsilonBracket grasp_epsilon(std::span<const Contact> contacts, const WrenchFrame& frame,
                             const WrenchSpaceOptions& space = {});

}  // namespace prehend
