#include "sim/motion/solve_contacts.h"

#include <utility>

#include "sim/motion/contact_pyramids.h"
#include "sim/motion/multiplier_method.h"

namespace prehend {
namespace {

ContactProblem without_corrections(ContactProblem problem) {
  for (ContactCondition& condition : problem.contacts) condition.correction.setZero();
  return problem;
}

// Where cones alone led nowhere: pyramids are solved exactly, and from their impulses the cones are
// not far. The better of the two.
ContactSolution led_by_pyramids(const ContactProblem& problem, const ContactSolverOptions& options,
                                ContactSolution found) {
  const ContactSolution lead = solve_with_pyramids(problem, options.pyramids);
  if (!lead.velocity.allFinite()) return found;
  ContactSolution again = solve_with_multipliers(problem, options, {lead.velocity, lead.impulses});
  again.newton_steps += found.newton_steps;
  found.newton_steps = again.newton_steps;
  ContactSolution& better = again.violation < found.violation ? again : found;
  better.pivots = lead.pivots;
  return better;
}

}  // namespace

ContactSolution solve_contacts(const ContactProblem& problem, const ContactSolverOptions& options,
                               const WarmStart& warm) {
  if (problem.contacts.empty()) {
    ContactSolution solution;
    solution.velocity = problem.free;
    return solution;
  }
  if (options.method == ContactMethod::pyramids) {
    ContactSolution found = solve_with_pyramids(problem, options.pyramids);
    if (found.outcome == ContactOutcome::solved) return found;
    found = solve_with_pyramids(without_corrections(problem), options.pyramids);
    found.corrected = false;
    return found;
  }
  ContactSolution found = solve_with_multipliers(problem, options, warm);
  if (found.outcome == ContactOutcome::solved) return found;
  const ContactProblem bare = without_corrections(problem);
  ContactSolution again = solve_with_multipliers(bare, options, warm);
  again.newton_steps += found.newton_steps;
  const bool is_small = problem.contacts.size() <= static_cast<std::size_t>(options.most_led);
  if (again.outcome != ContactOutcome::solved && is_small) {
    again = led_by_pyramids(bare, options, std::move(again));
  }
  again.corrected = false;
  return again;
}

}  // namespace prehend
