#include "sim/motion/solve_contacts.h"

#include <utility>

#include "sim/motion/contact_pyramids.h"
#include "sim/motion/multiplier_method.h"

namespace prehend {
namespace {

// Pyramids lead cones in problems of up to so many contacts: they take much longer in others.
constexpr std::size_t kMostLed = 60;

ContactProblem without_corrections(ContactProblem problem) {
  for (ContactCondition& condition : problem.contacts) condition.correction.setZero();
  return problem;
}

// Where cones alone led nowhere: pyramids are solved exactly, and from their impulses the cones are
// not far. The better of the two.
ContactSolution led_by_pyramids(const ContactProblem& problem, const ContactSolverOptions& options,
                                ContactSolution found) {
  const ContactSolution lead = solve_with_pyramids(problem);
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
  ContactSolution found = solve_with_multipliers(problem, options, warm);
  if (found.outcome == ContactOutcome::solved) return found;
  const ContactProblem bare = without_corrections(problem);
  ContactSolution again = solve_with_multipliers(bare, options, warm);
  again.newton_steps += found.newton_steps;
  const bool is_small = problem.contacts.size() <= kMostLed;
  if (again.outcome != ContactOutcome::solved && is_small) {
    again = led_by_pyramids(bare, options, std::move(again));
  }
  again.corrected = false;
  return again;
}

}  // namespace prehend
