#include "sim/trial/pad_patches.h"

#include <algorithm>

#include <Eigen/Eigenvalues>

#include "sim/scene/compiled_scene.h"
#include "sim/shape/contact/contact_region.h"
#include "sim/trial/pad_contacts.h"

namespace prehend {
namespace {

double softest_motion(const Eigen::Matrix<double, 6, 6>& stiffness, double torque_scale) {
  Eigen::Matrix<double, 6, 1> scale;
  scale << 1.0, 1.0, 1.0, torque_scale, torque_scale, torque_scale;
  const Eigen::Matrix<double, 6, 6> scaled = scale.asDiagonal() * stiffness * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(scaled,
                                                                          Eigen::EigenvaluesOnly);
  return std::max(0.0, solver.eigenvalues()[0]);
}

}  // namespace

std::optional<HeldByPads> held_by_pads(const CompiledScene& scene, const Trial& trial,
                                       const TrialOptions& options, const RunContext& context) {
  if (options.contacts != ContactKind::fem || trial.contacts.empty()) return std::nullopt;
  RobotPoses poses;
  robot_poses(scene.scene.hand, trial.joints, poses);
  RegionWorkspace regions;
  std::vector<SurfaceContact> touching;
  PadWorkspace workspace;
  PadPatch patch;
  HeldByPads held;
  for (std::size_t l = 0; l < scene.links.size(); ++l) {
    context.cancellation.check();
    const CompiledLink& link = scene.links[l];
    if (!link.pad) continue;
    const Pose X_OL = trial.X_OH * poses.X_BL[l];
    find_contacts(scene.object().mesh, link.mesh, X_OL, options.contact, regions, touching);
    const auto pressing =
        pad_pressing(scene.scene.hand, link, trial.X_OH, poses, touching, options.pads.load);
    if (!pressing) continue;
    const auto pad = link.pad->get(options.pads.elements);
    press_pad(scene.object().mesh, *pad, X_OL, pressing->direction_O, pressing->load, workspace,
              patch);
    if (patch.points.empty()) continue;
    held.patches.push_back({link_id(l), static_cast<int>(patch.points.size()), patch.approach,
                            limit_surface(patch.points)});
    held.stiffness += patch_stiffness(*pad, X_OL, patch, scene.wrench_frame.torque_origin);
  }
  if (held.patches.empty()) return std::nullopt;
  held.softest = softest_motion(held.stiffness, scene.wrench_frame.torque_scale);
  return held;
}

}  // namespace prehend
