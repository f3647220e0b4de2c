// The contacts that a pad of finite elements makes.
#pragma once

#include <optional>
#include <vector>

#include "sim/robot/robot.h"
#include "sim/shape/contact/surface_contact.h"
#include "sim/soft/press_pad.h"
#include "sim/trial/pad_contact_options.h"
#include "sim/trial/trial.h"

namespace prehend {

struct CompiledLink;
struct CompiledScene;
struct GraspContactsWorkspace;
struct TrialOptions;

// Throws InputError where contacts are to be finite elements and no link of the hand has a pad.
void require_pads(const CompiledScene& scene, const TrialOptions& options);

// How a pad presses where its link touches: along the mean normal, with the largest force there
// that exceeds no effort of the joints that move it; with `otherwise` where none states one.
struct PadPressing {
  Vector3 direction_O = Vector3::UnitZ();
  double load = 0.0;  // [N]
};
std::optional<PadPressing> pad_pressing(const Robot& hand, const CompiledLink& link,
                                        const Pose& X_OH, const RobotPoses& poses,
                                        const std::vector<SurfaceContact>& touching,
                                        double otherwise);

// Presses the pad of link `l` of the hand at X_OH, which touches at these points (`workspace`:
// poses of the hand), and appends what stands for its patch; nothing where the pad bears nothing,
// as where the link touches beside it.
void add_pad_contacts(const CompiledScene& scene, const Pose& X_OH, std::size_t l,
                      const std::vector<SurfaceContact>& touching, const PadContactOptions& options,
                      GraspContactsWorkspace& workspace, std::vector<GraspContact>& contacts);

}  // namespace prehend
