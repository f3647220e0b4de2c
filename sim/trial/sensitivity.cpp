#include "sim/trial/sensitivity.h"

#include <algorithm>

#include "sim/quality/wrench.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/grasp_contacts.h"
#include "sim/trial/trial_options.h"

namespace prehend {
namespace {

constexpr double kShift = 1e-6;  // of the hand, along each axis [m]
constexpr double kTurn = 1e-5;   // of the hand, about each axis through its base [rad]
constexpr double kThreshold =
    0.1;  // part of the contact threshold by which it is larger or smaller

double epsilon_at(const CompiledScene& scene, const Trial& trial, const Pose& X_OH,
                  const TrialOptions& options) {
  const std::vector<GraspContact> contacts = grasp_contacts(scene, X_OH, trial.joints, options);
  if (contacts.empty()) return 0.0;
  return std::max(0.0, epsilon_l1(contact_wrenches(contacts_of(contacts), scene.wrench_frame,
                                                   options.cone_edges))
                           .lower);
}

}  // namespace

Interval epsilon_nearby(const CompiledScene& scene, const Trial& trial, const TrialOptions& options,
                        const RunContext& context) {
  Interval range{trial.epsilon.lower, trial.epsilon.lower};
  const auto include = [&](const Pose& X_OH, const TrialOptions& with) {
    context.cancellation.check();
    const double epsilon = epsilon_at(scene, trial, X_OH, with);
    range.lower = std::min(range.lower, epsilon);
    range.upper = std::max(range.upper, epsilon);
  };
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 unit = Vector3::Unit(axis);
    for (const double way : {-1.0, 1.0}) {
      include(trial.X_OH * translation(way * kShift * unit), options);
      include(trial.X_OH * Eigen::AngleAxisd(way * kTurn, unit), options);
    }
  }
  for (const double way : {-1.0, 1.0}) {
    TrialOptions with = options;
    with.contact.threshold *= 1.0 + way * kThreshold;
    include(trial.X_OH, with);
  }
  return range;
}

}  // namespace prehend
