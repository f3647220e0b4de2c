// What a plan or evaluation that could not do all it was asked for says of itself.
#pragma once

#include "planner/plan/plan_result.h"
#include "sim/base/run_context.h"

namespace prehend {

// Whether no more work is to begin.
inline bool is_over(const RunContext& context) {
  return context.cancellation.requested() || context.deadline.has_passed();
}

// The status of a result whose work was not all done.
inline PlanStatus cut_short(const RunContext& context) {
  return context.cancellation.requested() ? PlanStatus::cancelled : PlanStatus::out_of_time;
}

}  // namespace prehend
