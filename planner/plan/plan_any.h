// Plans for several objects that stand together: which of them to grasp, and what is in the way.
#pragma once

#include <string>
#include <vector>

#include "planner/plan/plan.h"

namespace prehend {

// A grasp of one of the plans.
struct AnyGrasp {
  int scene = 0;
  int grasp = 0;  // index into PlanResult::grasps of that scene
};

struct AnyPlan {
  std::vector<PlanResult> results;  // of each scene
  // All grasps, best first. Those of a scene keep their order; of the next of each scene the one
  // comes first that touches preferred regions only, then the one that holds on more of the shapes
  // of an object that was seen in part, then the one with the larger measure by which
  // grasps are ranked (of epsilon: on a free object, where that was asked), then the earlier scene.
  std::vector<AnyGrasp> ranked = {};
  // Of each scene without a grasp: the other objects that must go before it has one; empty for
  // others, and where that does not help.
  std::vector<std::vector<std::string>> first = {};
};

// Plans each scene: in each, another one of the same objects is to be grasped, and the others are
// obstacles with their names, which nothing may touch. Where that gives no grasp, candidates are
// tried without all of the others, without each alone, and without fewer and fewer, until one holds
// (and the arm reaches it); no paths are looked for then. The time until the deadline is shared
// evenly. The same result on any number of threads; does not throw Cancelled, as plan(). Throws
// InputError as plan(), and for two objects of the same name.
AnyPlan plan_any(const std::vector<CompiledScene>& scenes, const PlanOptions& options = {},
                 const RunContext& context = {});

}  // namespace prehend
