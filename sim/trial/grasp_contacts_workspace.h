// grasp_contacts in memory that is used again and again.
#pragma once

#include <vector>

#include "sim/robot/robot.h"
#include "sim/shape/contact/contact_region.h"
#include "sim/shape/contact/soft_patch.h"
#include "sim/soft/press_pad.h"
#include "sim/trial/grasp_contacts.h"

namespace prehend {

// A contact by the materials that touch there: numbers of regions (SurfaceMaterials::region_at).
struct TouchingRegions {
  int of_object = -1;
  int of_link = -1;
  bool operator==(const TouchingRegions&) const = default;
};

// Buffers of grasp_contacts, to allocate less; one for each thread.
struct GraspContactsWorkspace {
  RobotPoses poses;
  RegionWorkspace regions;
  std::vector<SurfaceContact> touching;  // of one link
  SoftPatchWorkspace soft;
  std::vector<SoftPatch> patches;  // of one link
  PadWorkspace pad;
  PadPatch pad_patch;  // of one link
  // Where surfaces have regions of several materials.
  std::vector<SurfaceContact> all_touching;  // of one link
  std::vector<TouchingRegions> materials;    // of each of these
};

// As grasp_contacts of grasp_contacts.h; `contacts` is replaced.
void grasp_contacts(const CompiledScene& scene, const Pose& X_OH, const std::vector<double>& joints,
                    const TrialOptions& options, GraspContactsWorkspace& workspace,
                    std::vector<GraspContact>& contacts);

// As contacts_of of grasp_contacts.h; `points` is replaced.
void contacts_of(const std::vector<GraspContact>& contacts, std::vector<Contact>& points);

}  // namespace prehend
