#include "sim/quality/conic/interior_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/quality/conic/cone_scaling.h"
#include "sim/quality/conic/kkt_system.h"

// The homogeneous self-dual embedding puts a program and its dual into one system with two more
// variables tau, kappa >= 0, which always has a solution:
//
//   0     =  A'y + G'z + c tau
//   0     =  A x - b tau
//   s     = -G x + h tau
//   kappa = -c'x - b'y - h'z       with s, z in the cone, s'z + kappa tau = 0
//
// A solution with tau > 0 gives an optimum of the program, (x, y, z, s) / tau. One with kappa > 0
// is a certificate that the primal or the dual is infeasible. So neither needs a first phase of its
// own, and any point inside the cones will do as a start.
//
// Each iteration is Mehrotra's predictor-corrector step along the central path, on which
// s o z = mu e and kappa tau = mu, mu going to zero: an affine step aims at mu = 0 at once; how far
// it gets tells how much centring the real step needs; that step corrects for the second-order term
// that the first has left out.
namespace prehend {
namespace {

// Part of the step to the border of the cone that is taken: a point on the border has no scaling.
constexpr double kStepBack = 0.99;
constexpr double kSmallestStep = 1e-7;  // shorter steps make no progress beyond rounding
constexpr int kPatience = 12;           // iterations without a better iterate before giving up

// A point of the embedding: the program's variables times tau, and kappa.
struct Point {
  KktSystem::Vector v;
  Eigen::VectorXd s;
  double tau = 1.0;
  double kappa = 1.0;
};

// By how much a point misses the embedding's equations: v the first three, t the last.
struct Residual {
  KktSystem::Vector v;
  double t = 0.0;
};

class InteriorPoint {
 public:
  InteriorPoint(const ConicProgram& program, const ConicOptions& options)
      : p_(program),
        options_(options),
        identity_(cone_identity(program.cone)),
        kkt_(program.A, program.G),
        c_size_(std::max(1.0, largest_entry(program.c))),
        b_size_(std::max({1.0, largest_entry(program.b), largest_entry(program.h)})) {}

  ConicSolution run() {
    start();
    for (; iterations_ < options_.max_iterations; ++iterations_) {
      residual_ = residual();
      const double proof = proof_error();
      if (proof <= options_.infeasible_tolerance) {
        return certificate(ConicStatus::primal_infeasible, point_);
      }
      if (dual_infeasible()) return certificate(ConicStatus::dual_infeasible, point_);
      keep_better(measure(), best_error_, best_);
      keep_better(proof, best_proof_error_, best_proof_);
      if (best_error_ <= options_.tolerance) break;
      if (iterations_ - last_better_ > kPatience || !step()) break;
    }
    return best();
  }

 private:
  // Starting point: x with the smallest slack s, and y with the smallest z, that meet the equations
  // of primal and dual (least squares: the KKT system with W = I), with s and z then moved into the
  // interior of the cone.
  void start() {
    const ConeScaling unit(p_.cone, identity_, identity_);
    kkt_.factor(unit);
    const Eigen::Index n = p_.A.cols();
    const KktSystem::Vector primal = kkt_.solve({Eigen::VectorXd::Zero(n), p_.b, p_.h});
    const KktSystem::Vector dual =
        kkt_.solve({-p_.c, Eigen::VectorXd::Zero(p_.b.size()), Eigen::VectorXd::Zero(p_.h.size())});
    point_.v = {primal.x, dual.y, inside(dual.z)};
    point_.s = inside(-primal.z);
    best_ = point_;
  }

  // v if it is well inside the cone, else v moved along the identity until its margin is 1.
  Eigen::VectorXd inside(const Eigen::VectorXd& v) const {
    const double margin = cone_margin(p_.cone, v);
    if (margin > 1e-3 * largest_entry(v)) return v;
    return v + (1.0 - margin) * identity_;
  }

  Residual residual() const {
    const KktSystem::Vector& v = point_.v;
    return {{-p_.A.transpose() * v.y - p_.G.transpose() * v.z - p_.c * point_.tau,
             p_.A * v.x - p_.b * point_.tau, point_.s + p_.G * v.x - p_.h * point_.tau},
            point_.kappa + p_.c.dot(v.x) + p_.b.dot(v.y) + p_.h.dot(v.z)};
  }

  void keep_better(double error, double& best_error, Point& best) {
    if (!(error < best_error)) return;
    best_error = error;
    best = point_;
    last_better_ = iterations_;
  }

  // Largest error of A'y + G'z = 0 when y and z are scaled to a certificate of primal infeasibility
  // with b'y + h'z = -1; infinite where that value is not negative. The residual contains c tau,
  // which the certificate's equation does not.
  double proof_error() const {
    const double value = -p_.b.dot(point_.v.y) - p_.h.dot(point_.v.z);
    if (!(value > 0.0)) return std::numeric_limits<double>::infinity();
    return largest_entry(residual_.v.x + p_.c * point_.tau) / value;
  }

  // Whether x and s are a certificate of dual infeasibility within the tolerance.
  bool dual_infeasible() const {
    const double value = -p_.c.dot(point_.v.x);
    if (value <= 0.0) return false;
    const double error = std::max(largest_entry(residual_.v.y + p_.b * point_.tau),
                                  largest_entry(residual_.v.z + p_.h * point_.tau));
    return error <= options_.infeasible_tolerance * value;
  }

  // The error of the solution (x, y, z, s) / tau: the largest of its residuals and gap, relative to
  // the program's size. Infinite where it is not a number.
  double measure() const {
    const double tau = point_.tau;
    const double primal =
        std::max(largest_entry(residual_.v.y), largest_entry(residual_.v.z)) / tau / b_size_;
    const double dual = largest_entry(residual_.v.x) / tau / c_size_;
    const double primal_value = p_.c.dot(point_.v.x) / tau;
    const double dual_value = -(p_.b.dot(point_.v.y) + p_.h.dot(point_.v.z)) / tau;
    const double size = std::max({1.0, std::abs(primal_value), std::abs(dual_value)});
    const double gap =
        std::max(point_.s.dot(point_.v.z) / tau / tau, std::abs(primal_value - dual_value));
    const double error = std::max({primal, dual, gap / size});
    return std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
  }

  // Newton's direction that reduces the residuals to `centring` times what they are, and the
  // products lambda o lambda and kappa tau by `ds` and `dk`. The unknown d.tau couples all
  // equations: the system is solved once without it, and `constant`, the solution for the
  // right-hand side (-c, b, h) that belongs to tau, is added d.tau times; the last equation of the
  // embedding then gives d.tau.
  Point direction(const ConeScaling& scaling, const KktSystem::Vector& constant, double centring,
                  const Eigen::VectorXd& ds, double dk) const {
    const double rest = 1.0 - centring;
    const Eigen::VectorXd quotient = cone_quotient(p_.cone, scaling.lambda(), ds);
    const KktSystem::Vector v = kkt_.solve({rest * residual_.v.x, -rest * residual_.v.y,
                                            scaling.apply(quotient) - rest * residual_.v.z});
    Point d;
    d.tau = rest * residual_.t - dk / point_.tau + p_.c.dot(v.x) + p_.b.dot(v.y) + p_.h.dot(v.z);
    d.tau /= point_.kappa / point_.tau + scaling.apply(constant.z).squaredNorm();
    d.v = {v.x + d.tau * constant.x, v.y + d.tau * constant.y, v.z + d.tau * constant.z};
    // From the linear equation s = h tau - G x, not by W from d.v.z: the rounding of W, which is
    // ill-conditioned near the end, would stay in the residual for good.
    d.s = d.tau * p_.h - rest * residual_.v.z - p_.G * d.v.x;
    d.kappa = -(dk + point_.kappa * d.tau) / point_.tau;
    return d;
  }

  // Length of the step along the direction: `back` times the step to the border of the cone, at
  // most 1. Computed in scaled coordinates, in which s and z are the same point lambda, farther
  // from the border and with less rounding than either.
  double longest(const ConeScaling& scaling, const Point& d, double back) const {
    const Eigen::VectorXd ds = scaling.apply_inverse(d.s);
    const Eigen::VectorXd dz = scaling.apply(d.v.z);
    double step = std::min(cone_step(p_.cone, scaling.lambda(), ds),
                           cone_step(p_.cone, scaling.lambda(), dz));
    if (d.tau < 0.0) step = std::min(step, -point_.tau / d.tau);
    if (d.kappa < 0.0) step = std::min(step, -point_.kappa / d.kappa);
    return std::min(1.0, back * step);
  }

  // One predictor-corrector step; false where rounding allows none.
  bool step() {
    const ConeScaling scaling(p_.cone, point_.s, point_.v.z);
    if (!scaling.valid() || !(point_.tau > 0.0) || !(point_.kappa > 0.0)) return false;
    kkt_.factor(scaling);
    const KktSystem::Vector constant = kkt_.solve({-p_.c, p_.b, p_.h});
    const Eigen::VectorXd& lambda = scaling.lambda();
    const Eigen::VectorXd square = cone_product(p_.cone, lambda, lambda);
    const double product = point_.kappa * point_.tau;
    const double mu = (lambda.squaredNorm() + product) / (p_.cone.degree() + 1);

    // Predictor: the affine step to mu = 0. The farther it gets, the less centring is needed.
    const Point affine = direction(scaling, constant, 0.0, square, product);
    const double centring = std::pow(1.0 - longest(scaling, affine, 1.0), 3);
    // Corrector: the products of the affine step with itself are what its linearisation misses.
    const Eigen::VectorXd second =
        cone_product(p_.cone, scaling.apply_inverse(affine.s), scaling.apply(affine.v.z));
    const Point d =
        direction(scaling, constant, centring, square + second - centring * mu * identity_,
                  product + affine.kappa * affine.tau - centring * mu);
    const double length = longest(scaling, d, kStepBack);
    if (!(length > kSmallestStep)) return false;
    advance(d, length);
    return point_.v.x.allFinite() && point_.v.y.allFinite();
  }

  void advance(const Point& d, double length) {
    point_.v.x += length * d.v.x;
    point_.v.y += length * d.v.y;
    point_.v.z += length * d.v.z;
    point_.s += length * d.s;
    point_.tau += length * d.tau;
    point_.kappa += length * d.kappa;
  }

  // The certificate scaled to the value -1.
  ConicSolution certificate(ConicStatus status, const Point& point) const {
    const KktSystem::Vector& v = point.v;
    ConicSolution solution;
    solution.status = status;
    solution.iterations = iterations_;
    const bool primal = status != ConicStatus::dual_infeasible;
    const double size = primal ? -p_.b.dot(v.y) - p_.h.dot(v.z) : -p_.c.dot(v.x);
    solution.x = (primal ? 0.0 : 1.0 / size) * v.x;
    solution.s = (primal ? 0.0 : 1.0 / size) * point.s;
    solution.y = (primal ? 1.0 / size : 0.0) * v.y;
    solution.z = (primal ? 1.0 / size : 0.0) * v.z;
    return solution;
  }

  // The best iterate, for when rounding or the limit of iterations ended the search: a solution if
  // it is acceptable, else whichever is less wrong of a solution and a certificate.
  ConicSolution best() const {
    const bool good = best_error_ <= std::max(options_.tolerance, options_.acceptable);
    if (!good && best_proof_error_ < best_error_) {
      return certificate(ConicStatus::limit, best_proof_);
    }
    ConicSolution solution;
    solution.status = good ? ConicStatus::optimal : ConicStatus::limit;
    solution.iterations = iterations_;
    solution.x = best_.v.x / best_.tau;
    solution.y = best_.v.y / best_.tau;
    solution.z = best_.v.z / best_.tau;
    solution.s = best_.s / best_.tau;
    return solution;
  }

  const ConicProgram& p_;
  const ConicOptions& options_;
  Eigen::VectorXd identity_;
  KktSystem kkt_;
  double c_size_;
  double b_size_;
  Point point_;
  Residual residual_;
  Point best_;
  double best_error_ = std::numeric_limits<double>::infinity();
  Point best_proof_;
  double best_proof_error_ = std::numeric_limits<double>::infinity();
  int last_better_ = 0;
  int iterations_ = 0;
};

}  // namespace

ConicSolution interior_point(const ConicProgram& program, const ConicOptions& options) {
  return InteriorPoint(program, options).run();
}

}  // namespace prehend
