#include "sim/motion/multiplier_method.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/motion/contact_violation.h"
#include "sim/motion/newton_matrix.h"
#include "sim/motion/smoothed_contacts.h"

namespace prehend {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// How much stiffer than the inertia that a contact feels its smoothed form is: in the first round,
// where Newton's steps have far to go, and at most. Each round takes the error of sticking contacts
// down by about this factor, and its Newton steps lose as many digits.
constexpr double kFirstStiffness = 10.0;
constexpr double kStiffness = 1e5;
constexpr double kStiffnessGrowth = 30.0;
// Where that was too stiff: softer by this, and after the next round stiffer by no more.
constexpr double kSoftening = 10.0;
// Where contacts jam, impulses are far larger than what the velocities alone would need, and change
// little in a round; then up to this.
constexpr double kMaxStiffness = 1e9;
// Newton steps end where they change the velocities by less than this part of those that occur.
constexpr double kStepTolerance = 1e-13;
// The same of the coupled form.
constexpr double kConverged = 1e-12;

// Minimises the smoothed energy from v on. Returns the number of steps.
int minimise(const SmoothedContacts& smoothed, int most, double scale, VectorXd& v) {
  constexpr double kArmijo = 1e-4;  // of the decrease that the slope promises (Armijo)
  VectorXd gradient;
  NewtonMatrix matrix;
  double energy = smoothed.energy(v);
  for (int step = 0; step < most; ++step) {
    smoothed.linearise(v, gradient, matrix);
    const VectorXd d = -matrix.solve_symmetric(gradient);
    if (!(d.lpNorm<Eigen::Infinity>() > kStepTolerance * scale)) return step;
    const double slope = gradient.dot(d);
    double length = 1.0;
    VectorXd next = v + d;
    double reached = smoothed.energy(next);
    while (reached > energy + kArmijo * length * slope && length > 1e-10) {
      length *= 0.5;
      next = v + length * d;
      reached = smoothed.energy(next);
    }
    // No more than rounding is left to gain.
    if (!(reached < energy)) return step + 1;
    v = next;
    energy = reached;
  }
  return most;
}

// Newton's method for momentum with the lifts that the velocities cause. There is no energy to go
// down, so steps are shortened until the residual shrinks; false, and v as it was, where that
// fails or leads forward slowly: softer contacts then get there in fewer steps. Multipliers change
// after it, so a step that is small beside the first one ends it, too, and so does a residual of
// which `left` is left.
bool solve_coupled(const SmoothedContacts& smoothed, double scale, double left, int& steps,
                   VectorXd& v) {
  constexpr std::size_t kSteps = 25;
  constexpr double kSmall = 1e-3;  // of the first step
  constexpr double kShorten = 0.3;
  constexpr double kShortest = 0.01;
  // What must be left of the residual at most after so many steps.
  constexpr std::size_t kLookBack = 4;
  constexpr double kSlow = 0.8;
  VectorXd at = v;
  VectorXd residual;
  VectorXd next;
  NewtonMatrix matrix;
  std::array<double, kSteps> sizes;
  double small = 0.0;
  for (std::size_t step = 0; step < kSteps; ++step) {
    ++steps;
    smoothed.linearise_coupled(at, residual, matrix);
    const VectorXd d = -matrix.solve(residual);
    if (!d.allFinite()) return false;
    const double change = d.lpNorm<Eigen::Infinity>();
    if (step == 0) small = std::max(kConverged * scale, kSmall * change);
    sizes[step] = residual.norm();
    next = at + d;
    if (change <= small) {
      v = next;
      return true;
    }
    if (step >= kLookBack && sizes[step] > kSlow * sizes[step - kLookBack]) return false;
    smoothed.residual_coupled(next, residual);
    for (double length = kShorten; !(residual.norm() < sizes[step]); length *= kShorten) {
      if (length < kShorten * kShortest) return false;
      next = at + length * d;
      smoothed.residual_coupled(next, residual);
    }
    at = next;
    if (residual.norm() <= left * sizes[0]) {
      v = at;
      return true;
    }
  }
  return false;
}

// Successive estimates of the lifts mu |w_t|, which depend on themselves through the velocities:
// Aitken's extrapolation for vectors (Anderson's with one step of memory).
class Extrapolation {
 public:
  // `given` were the lifts, `found` is what they became.
  VectorXd next(const VectorXd& given, const VectorXd& found) {
    const VectorXd residual = found - given;
    VectorXd result = found;
    if (last_residual_.size() == residual.size()) {
      const VectorXd change = residual - last_residual_;
      const double size = change.squaredNorm();
      if (size > 0.0) result -= residual.dot(change) / size * (found - last_found_);
    }
    last_residual_ = residual;
    last_found_ = found;
    return result.cwiseMax(0.0);
  }

 private:
  VectorXd last_residual_;
  VectorXd last_found_;
};

// Rounds of the proximal method of multipliers: velocities at given multipliers, then multipliers
// at these velocities.
class MultiplierRounds {
 public:
  MultiplierRounds(const ContactProblem& problem, const ContactSolverOptions& options,
                   const WarmStart& warm)
      : problem_(problem),
        options_(options),
        masses_(mass_factors(problem)),
        inertias_(felt_inertias(problem, masses_)),
        smoothed_(problem, inertias_),
        velocity_(warm.velocity.size() > 0 ? warm.velocity : problem.free),
        lifts_(VectorXd::Zero(static_cast<Index>(problem.contacts.size()))),
        scale_(free_velocity_scale(problem)),
        is_cold_(warm.impulses.empty()),
        stiffness_(is_cold_ ? kFirstStiffness
                            : std::clamp(warm.stiffness, kFirstStiffness, kStiffness)) {
    for (std::size_t i = 0; i < warm.impulses.size(); ++i) {
      smoothed_.set_centre(i, warm.impulses[i]);
    }
    impulses_.resize(problem.contacts.size());
    is_near_ = !is_cold_;
  }

  ContactSolution run() {
    // Rounds without much progress, of a solution that will do and of one that will not.
    constexpr int kPatience = 2;
    constexpr int kMostPatience = 8;
    constexpr double kNearlyThere = 100.0;  // of the tolerance
    ContactSolution best;
    best.violation = std::numeric_limits<double>::infinity();
    for (int round = 0; round < options_.max_rounds; ++round) {
      move();
      if (round == 0 && !is_cold_) best.stiffness = stiffness_;
      update_multipliers();
      const double found = violation();
      if (!std::isfinite(found)) break;
      note_progress(found < 0.5 * best.violation, found <= options_.acceptable);
      // What is left of a round that ends early may then be more than what was left before it.
      if (found < kNearlyThere * options_.tolerance) is_exact_ = true;
      if (found < best.violation) keep(found, best);
      // Where impulses may be shared in many ways, rounding and slow shifts between these are all
      // that is left to gain.
      if (found <= options_.tolerance) break;
      if (stalled_ >= (found <= options_.acceptable ? kPatience : kMostPatience)) break;
      adapt_stiffness();
      update_lifts();
    }
    if (best.impulses.empty()) keep(best.violation, best);
    const bool is_solved = best.violation <= options_.acceptable;
    best.outcome = is_solved ? ContactOutcome::solved : ContactOutcome::not_converged;
    best.newton_steps = steps_;
    return best;
  }

 private:
  // Where a round led forward slowly, those after it are solved to the end. It is their progress
  // that counts, unless the solution will do.
  void note_progress(bool is_fast, bool will_do) {
    const bool counts = is_exact_ || !coupled_ || will_do;
    if (!is_fast) is_exact_ = true;
    if (is_fast || counts) stalled_ = is_fast ? 0 : stalled_ + 1;
  }

  void adapt_stiffness() {
    if (!coupled_) {
      soften();
    } else {
      stiffness_ = std::min(growth_ * stiffness_,
                            stalled_ > 0 ? kMaxStiffness : std::max(kStiffness, stiffness_));
      growth_ = kStiffnessGrowth;
    }
  }

  void keep(double violation, ContactSolution& best) {
    best.violation = violation;
    best.velocity = velocity_;
    best.impulses = impulses_;
  }

  // Velocities at the multipliers as they are. Stiff contacts may keep Newton's steps for the
  // coupled form from converging, where softer ones do not. Where these do not either, or rounds
  // bring no progress, the convex form with the lifts of the round before leads there: it always
  // has a solution, but takes many steps.
  void move() {
    constexpr int kLeastStalls = 2;
    coupled_ = is_near_ && moves_coupled();
    while (!coupled_ && is_near_ && stalled_ < kLeastStalls && stiffness_ > kFirstStiffness) {
      soften();
      coupled_ = moves_coupled();
    }
    if (!coupled_) {
      smoothed_.set_stiffness(stiffness_);
      steps_ += minimise(smoothed_, options_.max_newton, scale_, velocity_);
      coupled_ = moves_coupled();
    }
    is_near_ = coupled_;
  }

  bool moves_coupled() {
    smoothed_.set_stiffness(stiffness_);
    // Of the first residual.
    constexpr double kLeft = 1e-3;
    const double left = is_exact_ ? 0.0 : kLeft;
    return solve_coupled(smoothed_, scale_, left, steps_, velocity_);
  }

  void soften() {
    stiffness_ = std::max(stiffness_ / kSoftening, kFirstStiffness);
    growth_ = kSoftening;
  }

  void update_multipliers() {
    for (std::size_t i = 0; i < impulses_.size(); ++i) {
      impulses_[i] = smoothed_.impulse(i, velocity_, coupled_);
    }
    for (std::size_t i = 0; i < impulses_.size(); ++i) smoothed_.set_centre(i, impulses_[i]);
  }

  void update_lifts() {
    VectorXd slips(lifts_.size());
    for (std::size_t i = 0; i < problem_.contacts.size(); ++i) {
      const ContactCondition& condition = problem_.contacts[i];
      slips[static_cast<Index>(i)] =
          condition.friction * slip_of(relative_velocity(condition, velocity_));
    }
    lifts_ = coupled_ ? slips : extrapolation_.next(lifts_, slips);
    for (std::size_t i = 0; i < problem_.contacts.size(); ++i) {
      smoothed_.set_lift(i, lifts_[static_cast<Index>(i)]);
    }
  }

  double violation() const {
    return violation_of(problem_, masses_, inertias_, scale_, velocity_, impulses_);
  }

  const ContactProblem& problem_;
  const ContactSolverOptions& options_;
  std::vector<MassFactor> masses_;
  std::vector<double> inertias_;
  SmoothedContacts smoothed_;
  std::vector<ConeVector> impulses_;
  VectorXd velocity_;
  VectorXd lifts_;
  double scale_;  // of the velocities that occur
  bool is_cold_;  // no impulses were known
  double stiffness_;
  double growth_ = kStiffnessGrowth;  // of the stiffness after the next round
  bool is_near_ = false;   // the velocities are probably near a solution of the coupled form
  bool coupled_ = false;   // the last round solved the coupled form
  bool is_exact_ = false;  // rounds are solved to the end
  int stalled_ = 0;        // rounds without much progress
  int steps_ = 0;
  Extrapolation extrapolation_;
};

}  // namespace

ContactSolution solve_with_multipliers(const ContactProblem& problem,
                                       const ContactSolverOptions& options, const WarmStart& warm) {
  return MultiplierRounds(problem, options, warm).run();
}

}  // namespace prehend
