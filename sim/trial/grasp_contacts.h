// Where a closed hand touches the object.
#pragma once

#include <vector>

#include "sim/scene/compiled_scene.h"
#include "sim/shape/contact/contact_region.h"
#include "sim/shape/contact/soft_patch.h"
#include "sim/trial/trial.h"
#include "sim/trial/trial_options.h"

namespace prehend {

// All contacts between hand and object with the hand's base at X_OH and its joints at `joints`,
// ordered by link: hard point contacts with friction, then, for compliant links and with
// options.soft_fingers, patches with torsional friction.
std::vector<GraspContact> grasp_contacts(const CompiledScene& scene, const Pose& X_OH,
                                         const std::vector<double>& joints,
                                         const TrialOptions& options);

// The contacts without link and gap, as the quality measures take them (sim/quality).
std::vector<Contact> contacts_of(const std::vector<GraspContact>& contacts);

// Buffers of grasp_contacts, to allocate less; one for each thread.
struct GraspContactsWorkspace {
  RobotPoses poses;
  RegionWorkspace regions;
  std::vector<SurfaceContact> touching;  // of one link
  SoftPatchWorkspace soft;
  std::vector<SoftPatch> patches;  // of one link
};

// As grasp_contacts above; `contacts` is replaced.
void grasp_contacts(const CompiledScene& scene, const Pose& X_OH, const std::vector<double>& joints,
                    const TrialOptions& options, GraspContactsWorkspace& workspace,
                    std::vector<GraspContact>& contacts);

// As contacts_of above; `points` is replaced.
void contacts_of(const std::vector<GraspContact>& contacts, std::vector<Contact>& points);

}  // namespace prehend
