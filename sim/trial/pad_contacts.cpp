#include "sim/trial/pad_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/grasp_contacts_workspace.h"
#include "sim/trial/trial_options.h"

namespace prehend {
namespace {

// Directions in the plane of a patch in which its farthest nodes stand for it.
constexpr int kRimPoints = 8;

// How fast a point moves along a direction as the joint does, in the frame of the hand's base.
double speed_along(const Joint& joint, const RobotPoses& poses, const Vector3& p_H,
                   const Vector3& direction_H) {
  const Pose X_HP = joint.parent < 0 ? Pose::Identity() : poses.X_BJ[index(joint.parent)];
  const Pose X_HJ = X_HP * joint.X_PJ;
  const Vector3 axis_H = X_HJ.linear() * joint.axis;
  const Vector3 velocity_H =
      joint.type == JointType::prismatic ? axis_H : axis_H.cross(p_H - X_HJ.translation()).eval();
  return velocity_H.dot(direction_H);
}

// The points at the rim of the patch and the one that bears most, ascending.
std::vector<std::size_t> standing_for(const std::vector<PressedPoint>& points,
                                      const LimitSurface& surface) {
  const Vector3 first = any_orthogonal(surface.normal);
  const Vector3 second = surface.normal.cross(first);
  std::vector<std::size_t> chosen;
  const auto choose_best = [&](const auto& value) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (value(points[i]) > value(points[best])) best = i;
    }
    if (std::ranges::find(chosen, best) == chosen.end()) chosen.push_back(best);
  };
  for (int k = 0; k < kRimPoints; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kRimPoints;
    const Vector3 direction = std::cos(angle) * first + std::sin(angle) * second;
    choose_best([&](const PressedPoint& point) { return point.position.dot(direction); });
  }
  choose_best([](const PressedPoint& point) { return point.force; });
  std::ranges::sort(chosen);
  return chosen;
}

// Of a uniform pressure on a disc of this area: two thirds of its radius [m]. A node bears its
// force over the area that belongs to it, which counts where few nodes touch.
double torsion_of_disc(double area) { return 2.0 / 3.0 * std::sqrt(area / std::numbers::pi); }

// Where the line of the resultant meets the object: the pressed point nearest to that line.
const PressedPoint& nearest_to_resultant(const std::vector<PressedPoint>& points,
                                         const LimitSurface& surface) {
  return *std::ranges::min_element(points, {}, [&](const PressedPoint& point) {
    return (point.position - surface.center).cross(surface.normal).squaredNorm();
  });
}

}  // namespace

void require_pads(const CompiledScene& scene, const TrialOptions& options) {
  if (options.contacts != ContactKind::fem) return;
  if (std::ranges::any_of(scene.links,
                          [](const CompiledLink& link) { return link.pad != nullptr; }))
    return;
  throw InputError({.file = scene.scene.hand.name,
                    .field = "contacts",
                    .problem = "fem needs a link with a \"pad\" in the hand's robot file "
                               "(docs/reference/robot-file.md); soft and hard need none"});
}

std::optional<PadPressing> pad_pressing(const Robot& hand, const CompiledLink& link,
                                        const Pose& X_OH, const RobotPoses& poses,
                                        const std::vector<SurfaceContact>& touching,
                                        double otherwise) {
  Vector3 normal_O = Vector3::Zero();
  Vector3 center_O = Vector3::Zero();
  for (const SurfaceContact& contact : touching) {
    normal_O += contact.normal;
    center_O += contact.position / static_cast<double>(touching.size());
  }
  // Contacts all around a link press it nowhere.
  if (normal_O.norm() < 1e-6) return std::nullopt;
  PadPressing pressing{normal_O.normalized(), std::numeric_limits<double>::infinity()};
  const Pose X_HO = X_OH.inverse();
  for (const int j : link.joints) {
    const Joint& joint = hand.joints[index(j)];
    if (joint.max_effort <= 0.0) continue;
    const double speed =
        std::abs(speed_along(joint, poses, X_HO * center_O, X_HO.linear() * pressing.direction_O));
    pressing.load = std::min(pressing.load, joint.max_effort / speed);
  }
  if (!std::isfinite(pressing.load)) pressing.load = otherwise;
  return pressing;
}

void add_pad_contacts(const CompiledScene& scene, const Pose& X_OH, std::size_t l,
                      const std::vector<SurfaceContact>& touching, const PadContactOptions& options,
                      GraspContactsWorkspace& workspace, std::vector<GraspContact>& contacts) {
  const auto append = [&](const Contact& point) {
    contacts.push_back({link_id(l), point, 0.0});
    contacts.back().point.friction_deviation = scene.links[l].friction_deviation;
  };
  const CompiledLink& link = scene.links[l];
  const auto pressing =
      pad_pressing(scene.scene.hand, link, X_OH, workspace.poses, touching, options.load);
  if (!pressing) return;
  const std::shared_ptr<const Pad> made = link.pad->get(options.elements);
  const std::vector<PressedPoint>& points = workspace.pad_patch.points;
  press_pad(scene.object().mesh, *made, X_OH * workspace.poses.X_BL[l], pressing->direction_O,
            pressing->load, workspace.pad, workspace.pad_patch);
  if (points.empty()) return;
  const LimitSurface surface = limit_surface(points);
  if (options.patch == PadPatchModel::nodes) {
    for (const std::size_t i : standing_for(points, surface)) {
      const double area = made->areas[index(workspace.pad_patch.nodes[i])];
      append({points[i].position, points[i].normal, link.friction, ContactModel::soft_finger,
              torsion_of_disc(area)});
    }
    return;
  }
  append({nearest_to_resultant(points, surface).position, surface.normal, link.friction,
          ContactModel::soft_finger, surface.fitted_torsion});
}

}  // namespace prehend
