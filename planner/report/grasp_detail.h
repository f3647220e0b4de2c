// What a report says of a grasp beyond epsilon and volume: where it is weak, and what carries it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

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
  WrenchSlice forces;            // without torque; empty where the wrench space is flat
  WrenchSlice torques;           // without force, times the torque scale
};

// `links`: the link of each contact, or none at all. Throws as wrench_space does.
GraspDetail grasp_detail(std::span<const Contact> contacts, std::span<const std::string> links,
                         const WrenchFrame& frame, const WrenchSpaceOptions& space,
                         std::uint64_t seed);

}  // namespace prehend
