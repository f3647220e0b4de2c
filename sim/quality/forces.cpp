#include "sim/quality/forces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

#include "sim/base/input_error.h"
#include "sim/base/range.h"
#include "sim/base/require_settings.h"
#include "sim/quality/barrier_forces.h"
#include "sim/quality/conic/conic_program.h"
#include "sim/quality/cup_balance.h"
#include "sim/quality/force_program.h"
#include "sim/quality/ranges.h"
#include "sim/quality/wrench.h"

// Forces scale with the wrench that they balance. The program is therefore solved for the external
// wrench scaled to length one, which makes all tolerances relative to it, and the forces are scaled
// back at the end.
//
// The result is judged by two quantities that are computed from the forces and multipliers alone:
// the residual of the forces, and the lower bound that the multipliers prove
// (ForceBalance::lower_bound). Impossibility is judged by the same bound, on the sum of the normal
// forces. This is the same for both measures, and stronger than a status of the solver: the bound
// holds up to rounding however inexact the multipliers are.
namespace prehend {
namespace {

// The time of one program of all contacts grows with the cube of their number, and its matrices
// with the square.
constexpr std::size_t kMostProgramContacts = 100;
constexpr int kMostProgramCorners = 1000;

// Of times_borne: the price of what is missing, in sums of the least normal forces for the whole;
// what is tried after a weight that was borne; where that starts from nothing; and the part that
// counts as the whole.
constexpr double kMissing = 1e6;
constexpr double kLoadStep = 8.0;
constexpr double kSmallestTimes = 1e-6;
constexpr double kWhole = 1.0 - 1e-4;

// Whether the contacts are few enough for one program.
bool has_program(std::span<const Contact> contacts, const ForceOptions& options) {
  if (contacts.size() > kMostProgramContacts) return false;
  if (options.cone == FrictionCone::exact) return true;
  int corners = 0;
  for (const Contact& contact : contacts) {
    corners += pyramid_corners(contact.model, options.edges);
  }
  return corners <= kMostProgramCorners;
}

[[noreturn]] void refuse(const std::string& field, const std::string& problem, double value) {
  std::ostringstream text;
  text << value;
  throw InputError({.field = field, .problem = problem, .value = text.str()});
}

// Files have torques in N m; the largest is multiplied by the scale as they are.
void check_external(const Wrench& external, const WrenchFrame& frame) {
  require(external.allFinite(), {.field = "external", .problem = "not finite"});
  const double force = external.head<3>().cwiseAbs().maxCoeff();
  const double torque = external.tail<3>().cwiseAbs().maxCoeff();
  if (force > kLargestLoad) refuse("external", "a force must be within 1e9 N of 0", force);
  if (torque > frame.torque_scale * kLargestLoad) {
    refuse("external", "a torque must be within 1e9 N m of 0", torque / frame.torque_scale);
  }
}

void check(const HandTorques& hand, Eigen::Index contacts) {
  const Eigen::Index joints = hand.limits.size();
  require(hand.jacobian.rows() == 3 * contacts && hand.jacobian.cols() == joints,
          {.field = "jacobian", .problem = "must have three rows a contact and a column a joint"});
  require(
      hand.spin.size() == 0 || (hand.spin.rows() == contacts && hand.spin.cols() == joints),
      {.field = "spin", .problem = "must have a row a contact and a column a joint, or be empty"});
  // The comparisons also turn away what is not a number.
  const auto accepted = [](double entry) { return std::abs(entry) <= kLargestJacobian; };
  for (const auto& [name, matrix] : {std::pair("jacobian", &hand.jacobian), {"spin", &hand.spin}}) {
    for (const double entry : matrix->reshaped()) {
      if (!accepted(entry)) refuse(name, "entries must be within 1e6 of 0", entry);
    }
  }
  for (const double limit : hand.limits) {
    const bool known = limit == 0.0 || std::isinf(limit) || std::abs(limit) <= kLargestLoad;
    if (!known || limit < 0.0 || (limit > 0.0 && limit < kSmallestLoad)) {
      refuse("limits", "must be 0, from 1e-9 to 1e9 N m, or infinite", limit);
    }
  }
}

// Judges the components for the unit wrench; true where they are good enough. Without any normal
// force there is no force at all, and the unit wrench is not balanced: the gap counts as complete.
bool judge_forces(const ForceBalance& balance, const ForceOptions& options, ContactForces& result) {
  result.residual = balance.residual(result.components);
  const double measure = balance.measure(result.components);
  result.gap = measure > 0.0 ? std::max(0.0, (measure - result.lowest) / measure) : 1.0;
  return result.residual <= options.residual_tolerance && result.gap <= options.gap_tolerance &&
         balance.torque_excess(result.components) <= options.residual_tolerance;
}

// The forces on the object, and sums over contacts, from the components for a wrench of one unit.
void finish(std::span<const Contact> contacts, double size, ContactForces& result) {
  result.components *= size;
  result.lowest *= size;
  result.forces.resize(3, result.components.cols());
  for (Eigen::Index i = 0; i < result.components.cols(); ++i) {
    const ContactMap map = contact_map(contacts[static_cast<std::size_t>(i)], {});
    result.forces.col(i) = map.topRows<3>() * result.components.col(i);
  }
  if (result.components.cols() == 0) return;
  result.largest_normal = result.components.row(0).maxCoeff();
  result.sum_of_normals = result.components.row(0).sum();
}

// No force at all. It leaves the whole wrench over, except where the wrench is zero (balanced).
ContactForces no_forces(Eigen::Index contacts, ForceOutcome outcome) {
  ContactForces result;
  result.outcome = outcome;
  result.components.setZero(4, contacts);
  result.forces.setZero(3, contacts);
  if (outcome == ForceOutcome::impossible) result.residual = result.gap = 1.0;
  return result;
}

// The forces of the second-order cone program. The solver's tolerances are well below those of
// ForceOptions. That of certificates is below 1 / kLargestForce, because a certificate with an
// error e only excludes solutions smaller than 1 / e.
ProposedForces program_forces(const ForceBalance& balance, const ForceOptions& options) {
  const ForceProgram program(balance, options);
  const ConicSolution solution =
      solve(program.program(), {.tolerance = 1e-11, .infeasible_tolerance = 1e-12});
  return {program.components(solution), program.separation(solution)};
}

// The multipliers that were found, or the wrench itself where that proves more: of contacts that
// push all with the same norm, none pushes farther along the wrench. It is a finite bound even
// where rounding has spoiled the multipliers.
ForceBalance::Separation best_separation(const ForceBalance& balance, const ForceOptions& options,
                                         const ForceBalance::Separation& found) {
  const ForceBalance::Separation plain{balance.wrench(),
                                       Eigen::VectorXd::Zero(balance.limits().size())};
  const bool better =
      balance.lower_bound(plain, options.measure) > balance.lower_bound(found, options.measure);
  return better ? plain : found;
}

// The forces for a wrench of one unit, however the search for them ended.
ContactForces judged(const ForceBalance& balance, const ForceOptions& options,
                     const ProposedForces& found) {
  const ForceBalance::Separation separation = best_separation(balance, options, found.separation);
  // Also forces that leave over as much as the tolerance allows would have to be this large.
  const double smallest_sum =
      balance.lower_bound(separation, ForceMeasure::sum_of_normals, options.residual_tolerance);
  if (smallest_sum > kLargestForce) {
    ContactForces result = no_forces(balance.contacts(), ForceOutcome::impossible);
    const double length = separation.wrench.norm();
    result.separating = separation.wrench / length;
    result.torque_multipliers = separation.torques / length;
    result.lowest = std::numeric_limits<double>::infinity();
    return result;
  }
  ContactForces result;
  result.lowest = balance.lower_bound(separation, options.measure);
  result.components = found.components;
  if (judge_forces(balance, options, result)) result.outcome = ForceOutcome::balanced;
  return result;
}

// The barrier answers for all but degenerate contacts, in a fraction of the time of the program.
ContactForces solve_forces(std::span<const Contact> contacts, const WrenchFrame& frame,
                           const Wrench& external, const HandTorques* hand,
                           const ForceOptions& options) {
  // The squares of small forces are not doubles.
  const double size = external.stableNorm();
  const ForceBalance balance(contacts, frame, external / size, size, hand, options);
  ContactForces result = judged(balance, options, barrier_forces(balance, options));
  if (result.outcome == ForceOutcome::limit && has_program(contacts, options)) {
    result = judged(balance, options, program_forces(balance, options));
  }
  if (result.outcome != ForceOutcome::impossible) finish(contacts, size, result);
  return result;
}

ContactForces checked_forces(std::span<const Contact> contacts, const WrenchFrame& frame,
                             const Wrench& external, const HandTorques* hand,
                             const ForceOptions& options) {
  check_contacts(contacts, frame);
  require(!has_cup(contacts),
          {.field = "contacts", .problem = "forces of suction cups are those of cup_forces"});
  check_external(external, frame);
  require_settings(options);
  if (hand != nullptr) check(*hand, std::ssize(contacts));
  if (external.isZero(0.0)) return no_forces(std::ssize(contacts), ForceOutcome::balanced);
  if (!contacts.empty()) return solve_forces(contacts, frame, external, hand, options);
  ContactForces result = no_forces(0, ForceOutcome::impossible);
  // Without contacts there is no contact wrench: the external wrench itself separates.
  result.separating = external.stableNormalized();
  result.lowest = std::numeric_limits<double>::infinity();
  if (hand != nullptr) result.torque_multipliers.setZero(hand->limits.size());
  return result;
}

// How many times the forces can be taken before a joint torque exceeds its limit.
double times_within_limits(const ContactForces& forces, const HandTorques& hand) {
  Eigen::VectorXd torques = hand.jacobian.transpose() * forces.forces.reshaped();
  if (hand.spin.size() > 0) torques += hand.spin.transpose() * forces.components.row(3).transpose();
  double times = std::numeric_limits<double>::infinity();
  for (Eigen::Index j = 0; j < torques.size(); ++j) {
    if (torques[j] != 0.0) times = std::min(times, hand.limits[j] / std::abs(torques[j]));
  }
  return times;
}

// The part of the unit wrench that the forces balance; 0 where they are out of balance otherwise,
// or beyond the joint limits.
double balanced_part(const ForceBalance& balance, const ForceOptions& options,
                     const ProposedForces& found) {
  Wrench sum = Wrench::Zero();
  for (Eigen::Index i = 0; i < balance.contacts(); ++i) {
    sum += balance.map(i) * found.components.col(i);
  }
  const double part = -sum.dot(balance.wrench());
  const double rest = (sum + part * balance.wrench()).norm();
  const bool is_good = rest <= options.residual_tolerance * part &&
                       balance.torque_excess(found.components) <= options.residual_tolerance;
  return is_good ? part : 0.0;
}

// wrench_resistance of contacts with suction cups among them.
Resistance resistance_of_cups(std::span<const Contact> contacts, const WrenchFrame& frame,
                              const Wrench& external, const ForceOptions& options) {
  const CupForces forces = cup_forces(contacts, frame, external, options.measure, CupUnit::vacuum);
  const auto times = [](double measure) {
    return measure > 0.0 ? 1.0 / measure : std::numeric_limits<double>::infinity();
  };
  const bool balances = forces.outcome == ForceOutcome::balanced;
  return {balances ? times(forces.measure) : 0.0, times(forces.lowest), forces.outcome};
}

}  // namespace

ContactForces balancing_forces(std::span<const Contact> contacts, const WrenchFrame& frame,
                               const Wrench& external, const ForceOptions& options) {
  return checked_forces(contacts, frame, external, nullptr, options);
}

ContactForces balancing_forces(std::span<const Contact> contacts, const WrenchFrame& frame,
                               const Wrench& external, const HandTorques& hand,
                               const ForceOptions& options) {
  return checked_forces(contacts, frame, external, &hand, options);
}

double times_borne(std::span<const Contact> contacts, const WrenchFrame& frame,
                   const Wrench& external, const HandTorques& hand, double most) {
  const ForceOptions options{.measure = ForceMeasure::sum_of_normals};
  check(hand, std::ssize(contacts));
  const ContactForces least = balancing_forces(contacts, frame, external, options);
  // Forces may be good although the solver could not prove how good.
  const bool balances =
      least.outcome != ForceOutcome::impossible && least.residual <= options.residual_tolerance;
  if (!balances) return 0.0;
  if (external.isZero(0.0)) return most;
  // Forces scale with the wrench, so the least bear as much as the joint that they load the most
  // allows. Others may load the joints more evenly.
  double borne = std::min(most, times_within_limits(least, hand));
  const double size = external.stableNorm();
  const double price = kMissing * least.sum_of_normals / size;
  while (borne < most) {
    const double times = std::min(most, std::max(kLoadStep * borne, kSmallestTimes));
    const ForceBalance balance(contacts, frame, external / size, times * size, &hand, options);
    const double part = balanced_part(balance, options, partial_forces(balance, options, price));
    if (times * part <= borne) break;
    borne = times * part;
    if (part < kWhole) break;
  }
  return borne;
}

Resistance wrench_resistance(std::span<const Contact> contacts, const WrenchFrame& frame,
                             const Wrench& external, const ForceOptions& options) {
  if (has_cup(contacts)) return resistance_of_cups(contacts, frame, external, options);
  const ContactForces forces = balancing_forces(contacts, frame, external, options);
  if (forces.outcome == ForceOutcome::impossible) return {0.0, 0.0, forces.outcome};
  const double largest = std::numeric_limits<double>::infinity();
  const bool shared = options.measure == ForceMeasure::sum_of_normals;
  const double measure = shared ? forces.sum_of_normals : forces.largest_normal;
  // Forces of measure m balance the wrench, hence forces of measure 1 balance 1 / m times it. This
  // is a lower bound because forces of a smaller measure may exist; the proved bound of the measure
  // gives the upper one.
  const bool balances = forces.residual <= options.residual_tolerance;
  Resistance result;
  result.outcome = forces.outcome;
  if (balances) result.lower = measure > 0.0 ? 1.0 / measure : largest;
  result.upper = forces.lowest > 0.0 ? 1.0 / forces.lowest : largest;
  // Forces that leave a little of the wrench over may be smaller than the proved bound.
  result.lower = std::min(result.lower, result.upper);
  return result;
}

}  // namespace prehend
