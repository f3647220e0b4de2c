#include "sim/motion/smoothed_contacts.h"

#include <utility>

#include "sim/base/index.h"

namespace prehend {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Momentum that a mass takes up between the free velocities and v.
VectorXd taken_up(const ContactProblem& problem, const ContactProblem::Mass& mass,
                  const VectorXd& v) {
  const Index size = mass.matrix.cols();
  const VectorXd change = v.segment(mass.first, size) - problem.free.segment(mass.first, size);
  return mass.matrix.lazyProduct(change);
}

// The squared norm of each column of L^-1 J', L the factor of the mass that J's block belongs to,
// whose rows above the block are zero. `rows` is memory to work in.
ConeVector squares_of_solution(const MassFactor& mass, const JacobianBlock& block,
                               std::vector<ConeVector>& rows) {
  const MatrixXd& factor = mass.factor.matrixLLT();
  const Index size = factor.rows();
  const Index begin = block.first - mass.first;
  const Index end = begin + block.transposed.rows();
  rows.clear();
  ConeVector squares = ConeVector::Zero();
  for (Index i = begin; i < size; ++i) {
    ConeVector row = ConeVector::Zero();
    if (i < end) row = block.transposed.row(i - begin).transpose();
    for (Index k = begin; k < i; ++k) row -= factor(i, k) * rows[index(k - begin)];
    row /= factor(i, i);
    squares += row.cwiseAbs2();
    rows.push_back(row);
  }
  return squares;
}

}  // namespace

ConeVector relative_velocity(const ContactCondition& condition, const VectorXd& v) {
  ConeVector w = condition.offset + condition.correction;
  for (const JacobianBlock& block : condition.blocks) {
    w += block.transposed.transpose().lazyProduct(v.segment(block.first, block.transposed.rows()));
  }
  return w;
}

double slip_of(const ConeVector& w) { return w.tail<3>().norm(); }

ConeProjection allowed_impulse(const ContactCondition& condition, const ConeVector& impulse) {
  if (condition.rows == 1) return project_to_interval(impulse, condition.lower, condition.upper);
  return project_to_cone(impulse, condition.friction);
}

std::vector<MassFactor> mass_factors(const ContactProblem& problem) {
  std::vector<MassFactor> result;
  result.reserve(problem.masses.size());
  for (const ContactProblem::Mass& mass : problem.masses) {
    result.push_back({mass.first, Eigen::LLT<MatrixXd>(mass.matrix)});
  }
  return result;
}

std::vector<double> felt_inertias(const ContactProblem& problem,
                                  const std::vector<MassFactor>& masses) {
  std::vector<const MassFactor*> mass_at(static_cast<std::size_t>(problem.free.size()));
  for (const MassFactor& mass : masses) {
    for (Index i = 0; i < mass.factor.cols(); ++i) {
      mass_at[static_cast<std::size_t>(mass.first + i)] = &mass;
    }
  }
  std::vector<double> inertias;
  inertias.reserve(problem.contacts.size());
  std::vector<ConeVector> rows;
  for (const ContactCondition& condition : problem.contacts) {
    double trace = 0.0;
    for (const JacobianBlock& block : condition.blocks) {
      const MassFactor& mass = *mass_at[static_cast<std::size_t>(block.first)];
      const ConeVector mobility = squares_of_solution(mass, block, rows);
      trace += mobility.head(condition.rows).sum();
    }
    inertias.push_back(condition.rows / trace);
  }
  return inertias;
}

SmoothedContacts::SmoothedContacts(const ContactProblem& problem, std::vector<double> inertias)
    : problem_(problem),
      inertia_(std::move(inertias)),
      centre_(problem.contacts.size(), ConeVector::Zero()),
      lift_(problem.contacts.size(), 0.0) {
  for (const ContactCondition& condition : problem.contacts) {
    first_seen_.push_back(seen_.size());
    for (const JacobianBlock& block : condition.blocks) {
      for (Index row = 0; row < block.transposed.rows(); ++row) {
        const ConeVector along = block.transposed.row(row).transpose();
        if (!along.isZero(0.0)) seen_.push_back({block.first + row, along});
      }
    }
  }
  first_seen_.push_back(seen_.size());
}

ConeVector SmoothedContacts::relative(std::size_t i, const VectorXd& v) const {
  ConeVector w = problem_.contacts[i].offset + problem_.contacts[i].correction;
  for (const Seen& one : seen(i)) w += v[one.velocity] * one.along;
  return w;
}

void SmoothedContacts::set_centre(std::size_t i, const ConeVector& impulse) {
  if (problem_.contacts[i].compliance == 0.0) centre_[i] = impulse;
}

double SmoothedContacts::stiffness(std::size_t i) const {
  const double compliance = problem_.contacts[i].compliance;
  return compliance > 0.0 ? 1.0 / compliance : factor_ * inertia_[i];
}

ConeVector SmoothedContacts::pull(std::size_t i, ConeVector w, double lift) const {
  w[0] += lift;
  return centre_[i] - stiffness(i) * w;
}

ConeVector SmoothedContacts::impulse(std::size_t i, const VectorXd& v, bool coupled) const {
  const ContactCondition& condition = problem_.contacts[i];
  const ConeVector w = relative(i, v);
  const double lift = coupled ? condition.friction * slip_of(w) : lift_[i];
  return allowed_impulse(condition, pull(i, w, lift)).point;
}

// The function whose gradient is the nearest allowed impulse P(x) is (|x|^2 - |x - P(x)|^2) / 2.
double SmoothedContacts::energy(const VectorXd& v) const {
  double sum = 0.0;
  for (const ContactProblem::Mass& mass : problem_.masses) {
    const Index size = mass.matrix.cols();
    sum += 0.5 * taken_up(problem_, mass, v)
                     .dot(v.segment(mass.first, size) - problem_.free.segment(mass.first, size));
  }
  for (std::size_t i = 0; i < centre_.size(); ++i) {
    const ContactCondition& condition = problem_.contacts[i];
    const ConeVector x = pull(i, relative(i, v), lift_[i]);
    const ConeVector p = allowed_impulse(condition, x).point;
    // As p . (x - p / 2), since the squares would cancel far outside an interval.
    sum += p.dot(x - 0.5 * p) / stiffness(i);
  }
  return sum;
}

void SmoothedContacts::start(const VectorXd& v, VectorXd& gradient) const {
  gradient.resize(v.size());
  for (const ContactProblem::Mass& mass : problem_.masses) {
    gradient.segment(mass.first, mass.matrix.cols()) = taken_up(problem_, mass, v);
  }
}

void SmoothedContacts::add_force(std::size_t i, const ConeVector& impulse,
                                 VectorXd& gradient) const {
  for (const Seen& one : seen(i)) gradient[one.velocity] -= one.along.dot(impulse);
}

// Most of a step is spent here.
void SmoothedContacts::add_stiffness(std::size_t i, const ConeMatrix& derivative, bool symmetric,
                                     NewtonMatrix& matrix) const {
  if (derivative.isZero(0.0)) return;
  const ConeMatrix stiff = stiffness(i) * derivative;
  // A joint has one row.
  const bool is_joint = problem_.contacts[i].rows == 1;
  for (const Seen& across : seen(i)) {
    ConeVector pulled = ConeVector::Zero();
    if (is_joint) {
      pulled[0] = stiff(0, 0) * across.along[0];
    } else {
      pulled = stiff.lazyProduct(across.along);
    }
    for (const Seen& one : seen(i)) {
      if (symmetric && one.velocity < across.velocity) continue;
      matrix.add(one.velocity, across.velocity, one.along.dot(pulled));
    }
  }
}

void SmoothedContacts::linearise(const VectorXd& v, VectorXd& gradient,
                                 NewtonMatrix& matrix) const {
  start(v, gradient);
  matrix.start(v.size());
  for (const ContactProblem::Mass& mass : problem_.masses) {
    matrix.add(mass.first, mass.first, mass.matrix);
  }
  for (std::size_t i = 0; i < centre_.size(); ++i) {
    const ContactCondition& condition = problem_.contacts[i];
    const ConeProjection p = allowed_impulse(condition, pull(i, relative(i, v), lift_[i]));
    add_force(i, p.point, gradient);
    add_stiffness(i, p.derivative, true, matrix);
  }
}

void SmoothedContacts::residual_coupled(const VectorXd& v, VectorXd& residual) const {
  start(v, residual);
  for (std::size_t i = 0; i < centre_.size(); ++i) add_force(i, impulse(i, v, true), residual);
}

void SmoothedContacts::linearise_coupled(const VectorXd& v, VectorXd& residual,
                                         NewtonMatrix& matrix) const {
  start(v, residual);
  matrix.start(v.size());
  for (const ContactProblem::Mass& mass : problem_.masses) {
    matrix.add(mass.first, mass.first, mass.matrix);
  }
  for (std::size_t i = 0; i < centre_.size(); ++i) {
    const ContactCondition& condition = problem_.contacts[i];
    const ConeVector w = relative(i, v);
    const double slip = slip_of(w);
    const ConeProjection p = allowed_impulse(condition, pull(i, w, condition.friction * slip));
    ConeMatrix derivative = p.derivative;
    if (slip > 0.0) {
      derivative.rightCols<3>() +=
          condition.friction / slip * p.derivative.col(0) * w.tail<3>().transpose();
    }
    add_force(i, p.point, residual);
    add_stiffness(i, derivative, false, matrix);
  }
}

}  // namespace prehend
