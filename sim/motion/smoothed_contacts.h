// A contact problem with each rigid condition replaced by a stiff spring.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Cholesky>

#include "sim/motion/contact_problem.h"
#include "sim/motion/newton_matrix.h"

namespace prehend {

// J v + offset.
ConeVector relative_velocity(const ContactCondition& condition, const Eigen::VectorXd& v);

// |w_t|; 0 of a joint.
double slip_of(const ConeVector& w);

// The nearest impulse that the condition allows.
ConeProjection allowed_impulse(const ContactCondition& condition, const ConeVector& impulse);

// The mass matrices of a problem as Cholesky factors, to divide by.
struct MassFactor {
  int first = 0;
  Eigen::LLT<Eigen::MatrixXd> factor;
};
std::vector<MassFactor> mass_factors(const ContactProblem& problem);

// The inertia that each condition feels: the inverse of its mean mobility J M^-1 J'.
std::vector<double> felt_inertias(const ContactProblem& problem,
                                  const std::vector<MassFactor>& masses);

// The smoothed problem of one round of the method of multipliers: condition i pulls with
// P(centre - stiffness (w + mu |w_t| n)), P the nearest allowed impulse. Conditions with a
// compliance are springs already: their stiffness is its inverse, their centre 0.
class SmoothedContacts {
 public:
  SmoothedContacts(const ContactProblem& problem, std::vector<double> inertias);

  double inertia(std::size_t i) const { return inertia_[i]; }
  // The stiffness of rigid conditions, as a multiple of the inertia they feel.
  void set_stiffness(double factor) { factor_ = factor; }
  void set_centre(std::size_t i, const ConeVector& impulse);
  // mu |w_t| in the convex form, where it is a constant.
  void set_lift(std::size_t i, double lift) { lift_[i] = lift; }

  // The impulse of condition i at velocities v, with the lift as it was set, or (`coupled`) with
  // the one that v causes.
  ConeVector impulse(std::size_t i, const Eigen::VectorXd& v, bool coupled) const;

  // The convex function that the round minimises, with the lifts as they were set.
  double energy(const Eigen::VectorXd& v) const;
  // Its gradient, and the matrix of its Newton step, of which only the lower triangle is set.
  void linearise(const Eigen::VectorXd& v, Eigen::VectorXd& gradient, NewtonMatrix& matrix) const;
  // What momentum lacks where the lifts follow the velocities, and its derivative.
  void linearise_coupled(const Eigen::VectorXd& v, Eigen::VectorXd& residual,
                         NewtonMatrix& matrix) const;
  // The same without the derivative.
  void residual_coupled(const Eigen::VectorXd& v, Eigen::VectorXd& residual) const;

 private:
  // A velocity that a condition sees, and what one of it adds to the condition's rows: those of a
  // finger are one in three of the hand's.
  struct Seen {
    Eigen::Index velocity = 0;
    ConeVector along = ConeVector::Zero();
  };

  std::span<const Seen> seen(std::size_t i) const {
    return {seen_.data() + first_seen_[i], first_seen_[i + 1] - first_seen_[i]};
  }
  ConeVector relative(std::size_t i, const Eigen::VectorXd& v) const;
  double stiffness(std::size_t i) const;
  ConeVector pull(std::size_t i, ConeVector w, double lift) const;
  void start(const Eigen::VectorXd& v, Eigen::VectorXd& gradient) const;
  void add_force(std::size_t i, const ConeVector& impulse, Eigen::VectorXd& gradient) const;
  void add_stiffness(std::size_t i, const ConeMatrix& derivative, bool symmetric,
                     NewtonMatrix& matrix) const;

  const ContactProblem& problem_;
  std::vector<Seen> seen_;               // of all conditions
  std::vector<std::size_t> first_seen_;  // of each condition, into seen_, and the end
  std::vector<double> inertia_;
  std::vector<ConeVector> centre_;
  std::vector<double> lift_;
  double factor_ = 1.0;
};

}  // namespace prehend
