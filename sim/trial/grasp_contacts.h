// Where a closed hand touches the object, found in memory that is kept from call to call.
#pragma once

#include <vector>

#include "sim/shape/contact/contact_region.h"
#include "sim/shape/contact/soft_patch.h"
#include "sim/trial/trial.h"

namespace prehend {

// Buffers of grasp_contacts, to allocate less; one for each thread.
struct GraspContactsWorkspace {
  RobotPoses poses;
  RegionWorkspace regions;
  std::vector<SurfaceContact> touching;  // of one link
  SoftPatchWorkspace soft;
  std::vector<SoftPatch> patches;  // of one link
};

// As grasp_contacts in trial.h; `contacts` is replaced.
void grasp_contacts(const CompiledScene& scene, const Pose& X_OH, const std::vector<double>& joints,
                    const TrialOptions& options, GraspContactsWorkspace& workspace,
                    std::vector<GraspContact>& contacts);

// As contacts_of in trial.h; `points` is replaced.
void contacts_of(const std::vector<GraspContact>& contacts, std::vector<Contact>& points);

}  // namespace prehend
