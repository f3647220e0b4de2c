// Where a closed hand touches the object.
#pragma once

#include <vector>

#include "sim/trial/trial.h"

namespace prehend {

struct CompiledScene;
struct TrialOptions;

// All contacts between hand and object with the hand's base at X_OH and its joints at `joints`,
// ordered by link: hard point contacts with friction, then, for compliant links and unless
// options.contacts are hard, patches with torsional friction; with fem those of pad_contacts.h for
// links with a pad. Of a hand with suction cups: cup_contacts. Throws as make_pad.
std::vector<GraspContact> grasp_contacts(const CompiledScene& scene, const Pose& X_OH,
                                         const std::vector<double>& joints,
                                         const TrialOptions& options);

// The contacts without link and gap, as the quality measures take them (sim/quality).
std::vector<Contact> contacts_of(const std::vector<GraspContact>& contacts);

}  // namespace prehend
