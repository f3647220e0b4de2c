// What a report says of a grasp beyond epsilon and volume: where it is weak, and what carries it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/quality/robust_epsilon.h"
#include "sim/quality/wrench_slice.h"
#include "sim/quality/wrench_space.h"

namespace prehend {

struct LinkShare {
  std::string link;
  double epsilon_without = 0.0;  // of the contacts of the other links
};

struct GraspDetail {
  RobustEpsilon robust;
  // Epsilon of the other contacts, one a contact; 0 without force closure.
  std::vector<double> epsilon_without;
  std::vector<LinkShare> links;  // that touch, in the order of their contacts
  WrenchSections sections;
};

// All but the sections. `links`: the link of each contact, or none at all. Throws as wrench_space,
// and Cancelled.
GraspDetail grasp_detail(std::span<const Contact> contacts, std::span<const std::string> links,
                         const WrenchFrame& frame, const WrenchSpaceOptions& space,
                         std::uint64_t seed, const RunContext& context = {});

// Sections of any wrench space; smooth sets are approximated from inside.
WrenchSections space_sections(std::span<const Contact> contacts, const WrenchFrame& frame,
                              const WrenchSpaceOptions& space);

}  // namespace prehend
