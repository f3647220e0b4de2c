#include "planner/plan/measure_grasps.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "planner/plan/cut_short.h"
#include "sim/base/parallel/parallel.h"
#include "sim/quality/cup_balance.h"
#include "sim/quality/set_hull.h"
#include "sim/quality/wrench_hull.h"
#include "sim/quality/wrench_space.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/grasp_contacts.h"
#include "sim/trial/sensitivity.h"

// The full 6-D hull takes much longer than epsilon, which is all that ranking needs.
namespace prehend {
namespace {

struct SpaceHull {
  double volume = 0.0;
  PointHull points;
};

// The full hull of the contacts' pyramids or, where these have many edges, as those of suction cups
// have, one inside it, whose volume is a lower bound.
SpaceHull space_hull_of(std::span<const Contact> contacts, const WrenchFrame& frame, int edges) {
  if (edges <= kMostHullEdges && !has_cup(contacts)) {
    WrenchHull hull = wrench_hull(contact_wrenches(contacts, frame, edges));
    return {hull.volume, std::move(hull.points)};
  }
  SetHull hull = set_hull(*wrench_space(contacts, frame, {.edges = edges}));
  return {hull.volume_lower, std::move(hull.hull)};
}

// Throws Cancelled.
void measure(const CompiledScene& scene, const TrialOptions& options, bool with_sections,
             const RunContext& context, ScoredGrasp& grasp) {
  if (!grasp.trial.contacts.empty()) grasp.holding = payload_margin(scene, grasp.trial, context);
  grasp.pads = held_by_pads(scene, grasp.trial, options, context);
  // The volume is defined as 0 without force closure, which needs no hull.
  if (grasp.trial.outcome != Outcome::stable) {
    grasp.volume = 0.0;
    return;
  }
  grasp.epsilon_nearby = epsilon_nearby(scene, grasp.trial, options, context);
  const std::vector<Contact> contacts = contacts_of(grasp.trial.contacts);
  const SpaceHull hull = space_hull_of(contacts, scene.wrench_frame, options.cone_edges);
  grasp.volume = hull.volume;
  context.cancellation.check();
  if (with_sections) grasp.sections = wrench_sections(hull.points);
}

}  // namespace

void measure_grasps(const CompiledScene& scene, const TrialOptions& options,
                    const WantedMeasures& wanted, const RunContext& context, PlanResult& result) {
  const std::size_t count = std::min(wanted.volumes, result.grasps.size());
  for_each_in_parallel(count, context.threads, [&](std::size_t i) {
    // The grasps that are left are skipped without an exception each.
    if (is_over(context)) return;
    try {
      measure(scene, options, i < wanted.sections, context, result.grasps[i]);
    } catch (const Cancelled&) {
      return;
    }
  });
  const auto is_missing = [&](const ScoredGrasp& grasp) { return !grasp.volume; };
  if (std::any_of(result.grasps.begin(), result.grasps.begin() + static_cast<std::ptrdiff_t>(count),
                  is_missing)) {
    result.status = cut_short(context);
  }
}

}  // namespace prehend
