#include "planner/plan/accuracy.h"

#include <algorithm>

namespace prehend {
namespace {

// Settling takes time for candidates that do not hold, and rarely leads to one of the best. The
// second half of the trials adds neighbours of grasps that the first half found; half a refinement
// raises the best epsilon more than that half.
PlanOptions draft_options() {
  PlanOptions options;
  options.search.trials /= 2;
  options.trial.back_off_tries = 0;
  options.trial.settle.steps = 12;
  options.refine.trials /= 2;
  options.free_closing = 0;
  options.uncertainty.samples /= 4;
  options.volumes = false;
  return options;
}

// Sixteen edges leave 2 % of a friction cone's width out where eight leave 8 %.
PlanOptions fine_options() {
  PlanOptions options;
  options.search.trials *= 4;
  options.search.followed *= 2;
  options.trial.back_off_tries = 3;
  options.trial.cone_edges = 16;
  options.uncertainty.samples *= 4;
  options.free_closing *= 2;
  options.refine.grasps = 8;
  options.refine.trials *= 4;
  return options;
}

}  // namespace

PlanOptions plan_options(Accuracy accuracy) {
  switch (accuracy) {
    case Accuracy::draft:
      return draft_options();
    case Accuracy::standard:
      break;
    case Accuracy::fine:
      return fine_options();
  }
  return {};
}

}  // namespace prehend
