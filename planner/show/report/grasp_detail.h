// Further analysis of a grasp for a report: robustness to noise, importance of each contact, and
// sections of the wrench space.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/quality/contact_map.h"
#include "sim/quality/robust_epsilon.h"
#include "sim/quality/wrench_slice.h"

namespace prehend {

struct WrenchSpaceOptions;

// How much a grasp depends on one link: the smaller epsilon is without it, the more it does.
struct LinkShare {
  std::string link;
  double epsilon_without = 0.0;  // of the contacts of all other links; 0 without force closure
};

// The analysis of one grasp with n contacts.
struct GraspDetail {
  RobustEpsilon robust;  // epsilon over random perturbations of the contacts
  // n numbers: epsilon without contact i; 0 when the other contacts have no force closure.
  std::vector<double> epsilon_without;
  std::vector<LinkShare> links;  // one for each link that touches, in the order of their contacts
  WrenchSections sections;       // of the wrench space; empty until filled in (space_sections)
};

// The analysis without the sections. `links`: the name of the link of each contact (n), or empty
// where there is no hand. `samples`: of perturbed contacts, for robust epsilon. Throws as
// wrench_space, and Cancelled.
GraspDetail grasp_detail(std::span<const Contact> contacts, std::span<const std::string> links,
                         const WrenchFrame& frame, const WrenchSpaceOptions& space,
                         std::uint64_t seed, int samples, const RunContext& context = {});

// Sections of the wrench space of the contacts: forces without torque, and torques without force.
// Spaces that are no polytope (exact cones, L-infinity norm) are approximated from inside.
WrenchSections space_sections(std::span<const Contact> contacts, const WrenchFrame& frame,
                              const WrenchSpaceOptions& space);

}  // namespace prehend
