// Surfaces that cross within a step although their contacts keep the law, and the contacts that
// were missing.
#pragma once

#include <optional>
#include <vector>

#include "sim/motion/near_pairs.h"
#include "sim/motion/step_options.h"

namespace prehend {

// A pair of the memory whose surfaces cross on their way.
struct Crossing {
  std::size_t pair = 0;               // of the memory
  Pose X_AB_from = Pose::Identity();  // where the surfaces do not cross, or do so least
  Pose X_AB = Pose::Identity();       // where they do
};

// All pairs in contact whose surfaces cross where the step leads, or on the way there, or, if they
// crossed before, are deeper in each other than they may be. In the order of the memory.
std::vector<Crossing> crossings_of(const ContactMemory& memory, const Solids& before,
                                   const Solids& after, const StepOptions& options);

// Adds contacts to the pair between those features that cross and were apart before: the law then
// keeps them apart. Whether there is any that it did not have.
bool add_contacts(const Crossing& crossing, const Solids& before, PairMemory& pair);

// Adds a contact unless there is one like it: whether it did.
bool add_unknown(const HeldContact& contact, std::vector<HeldContact>& contacts);

}  // namespace prehend
