#include "planner/plan/search_settings.h"

#include "sim/base/random.h"

namespace prehend {

PlanOptions search_settings(PlanOptions options) {
  options.primitives.seed = derived_seed(options.seed);
  options.thin_parts.seed = derived_seed(options.seed);
  options.trial.reach.kinematics.seed = derived_seed(options.seed);
  options.refine.noise.seed = derived_seed(options.seed);
  options.refine.approach = options.candidates.approach;
  if (options.paths) {
    options.paths->reach.kinematics.seed = derived_seed(options.seed);
    options.paths->transfer.seed = derived_seed(options.seed);
  }
  options.trial.resolve_overlap.deepest = 0.0;
  return options;
}

}  // namespace prehend
