// How a world is stepped through time.
#pragma once

#include "sim/base/range.h"
#include "sim/motion/contact_problem.h"

namespace prehend {

// Of StepOptions::step [s]. A second in shorter steps takes minutes; longer ones miss what a hand
// does.
inline constexpr Range kSteps{.lower = 1e-5, .upper = 0.1};

struct StepOptions {
  double step = 2.5e-3;  // longest step, within kSteps [s]
  // What bodies at rest keep between them, of which steps may use up all [m].
  double rest_gap = 5e-5;
  // Surfaces may cross by this much where no contact was found that keeps them apart [m].
  double shallow = 1e-5;
  // Violations of the law of contact: at which the search for a solution ends, and up to which a
  // solution that cannot be made better with little work is taken (ContactSolverOptions).
  double tolerance = ContactSolverOptions{}.tolerance;
  double acceptable = ContactSolverOptions{}.acceptable;
  // A step is not made shorter than this part of `step`.
  double shortest = 1e-6;
  // Impacts slower than this do not bounce [m/s].
  double slowest_bounce = 0.01;
  // Contacts that slid faster than this in the last step have kinetic friction [m/s].
  double sliding = 1e-3;
  // Bodies slower than this at all their points for so long fall asleep [m/s, s].
  double still = 1e-5;
  double sleep_after = 0.5;
};

}  // namespace prehend
