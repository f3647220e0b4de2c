#include "sim/quality/force_program.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>
#include <Eigen/SVD>

#include "sim/base/index.h"

// The program, with the cone coordinates v of all contacts (a contact transmits f = transmits v):
//
//   minimise    t, the largest normal force      or  the sum of the normal forces
//   subject to  sum of contact wrenches = -wrench    (A x = b)
//               torques of locked joints = 0         (A x = b)
//               normal force of contact i <= t       (first rows of G; not for the sum)
//               -1 <= joint torque / limit <= 1      (next rows of G)
//               v in its contact's cone              (last rows of G)
//
// The solver's result is not taken on trust. components() makes forces that are in the cones
// exactly, so that only their residual has to be looked at; lower_bound() computes from the
// multipliers what no forces can do better than. What these two show holds for any input.
namespace prehend {
namespace {

// A direction in which the contacts' wrenches are smaller than this part of their largest is one in
// which they can do nothing.
constexpr double kNothing = 1e-12;
// Part of the residual tolerance that may be left over in directions that are left out of the
// balance.
constexpr double kResidualShare = 0.1;
constexpr int kPolishRounds = 3;
constexpr double kPolishCost = 1e-8;  // relative increase of the measure that polishing may cost

}  // namespace

ForceProgram::ForceProgram(const ForceBalance& balance, const ForceOptions& options)
    : options_(options), balance_(balance) {
  for (const ContactCone& cone : balance_.cones()) {
    first_.push_back(coordinates_);
    coordinates_ += cone.size();
  }
  fill_equations();
  fill_cones();
}

// Chooses the directions of wrench space in which balance is required. Contacts that lie in a plane
// or on a line, or that have no friction, cannot act in some directions. Where the external wrench
// does not act there either, the equation reads 0 = 0 up to rounding, and rounding would decide
// whether it can be met: such directions are left out. Where the wrench does act there, the
// direction is kept, so that the equation has no solution and the grasp is found impossible.
void ForceProgram::find_basis(const Eigen::MatrixXd& wrenches) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(wrenches, Eigen::ComputeFullU);
  const double allowed = kResidualShare * options_.residual_tolerance;
  const Eigen::Index sizes = svd.singularValues().size();
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const double relative =
        i < sizes ? svd.singularValues()[i] / std::max(1.0, svd.singularValues()[0]) : 0.0;
    const bool idle = std::abs(svd.matrixU().col(i).dot(balance_.wrench())) <= allowed;
    if (!idle || relative > std::max(allowed, kNothing)) kept.push_back(i);
  }
  // The kept directions span a subspace, of which another basis is taken, as close to the axes of
  // forces and torques as possible (the pivoted QR factors of its projector): the equations along
  // singular vectors would have rows as different in size as the singular values.
  const Eigen::MatrixXd looked_at = svd.matrixU()(Eigen::all, kept);
  const Eigen::MatrixXd projector = looked_at * looked_at.transpose();
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> axes(projector);
  basis_ = Eigen::MatrixXd::Identity(6, std::ssize(kept));
  if (kept.size() < 6) basis_.applyOnTheLeft(axes.householderQ());
}

// Objective c and equations A x = b: balance, and no torque at joints with limit 0.
void ForceProgram::fill_equations() {
  const bool shared = options_.measure == ForceMeasure::sum_of_normals;
  const Eigen::Index n = coordinates_ + (shared ? 0 : 1);
  Eigen::MatrixXd wrenches(6, coordinates_);
  Eigen::MatrixXd torques(std::ssize(balance_.locked()), coordinates_);
  program_.c = Eigen::VectorXd::Zero(n);
  if (!shared) program_.c[coordinates_] = 1.0;
  for (Eigen::Index i = 0; i < std::ssize(balance_.cones()); ++i) {
    const ContactCone& cone = balance_.cones()[index(i)];
    const Eigen::Index first = first_[index(i)];
    wrenches.middleCols(first, cone.size()) = balance_.map(i) * cone.transmits;
    torques.middleCols(first, cone.size()) =
        balance_.loads(i)(balance_.locked(), Eigen::all) * cone.transmits;
    if (shared) program_.c.segment(first, cone.size()) = cone.transmits.row(0).transpose();
  }
  find_basis(wrenches);
  const Eigen::Index k = basis_.cols();
  program_.A = Eigen::MatrixXd::Zero(k + torques.rows(), n);
  program_.A.topLeftCorner(k, coordinates_) = basis_.transpose() * wrenches;
  program_.A.bottomLeftCorner(torques.rows(), coordinates_) = torques;
  // Rows that are only rounding become exact zeros: the presolve then proves 0 = b inconsistent,
  // where the solver would look for huge forces.
  const double nothing = kNothing * std::max(1.0, wrenches.cwiseAbs().maxCoeff());
  for (Eigen::Index i = 0; i < k; ++i) {
    if (program_.A.row(i).norm() <= nothing) program_.A.row(i).setZero();
  }
  program_.b = Eigen::VectorXd::Zero(program_.A.rows());
  program_.b.head(k) = -basis_.transpose() * balance_.wrench();
}

// Rows of G that hold the normal forces below the largest; the sum of normals needs none.
Eigen::Index ForceProgram::normal_rows() const {
  return options_.measure == ForceMeasure::sum_of_normals ? 0 : std::ssize(balance_.cones());
}

// G and h. Rows: normal forces below the largest, joint torques below and above their limits, the
// coordinates of pyramids (>= 0), then those of second-order cones, as ConeSizes orders them.
// Torques are divided by their limits, so that these rows are of the order of one.
void ForceProgram::fill_cones() {
  const Eigen::Index normals = normal_rows();
  const Eigen::Index torques = std::ssize(balance_.limited());
  program_.G = Eigen::MatrixXd::Zero(normals + 2 * torques + coordinates_, program_.c.size());
  program_.h = Eigen::VectorXd::Zero(program_.G.rows());
  program_.h.segment(normals, 2 * torques).setOnes();
  program_.cone.orthant = static_cast<int>(normals + 2 * torques);
  if (normals > 0) program_.G.col(coordinates_).head(normals).setConstant(-1.0);
  for (Eigen::Index i = 0; i < std::ssize(balance_.cones()); ++i) {
    const ContactCone& cone = balance_.cones()[index(i)];
    auto columns = program_.G.middleCols(first_[index(i)], cone.size());
    if (normals > 0) columns.row(i) = cone.transmits.row(0);
    columns.middleRows(normals, torques) =
        balance_.limits()(balance_.limited()).cwiseInverse().asDiagonal() *
        balance_.loads(i)(balance_.limited(), Eigen::all) * cone.transmits;
    columns.middleRows(normals + torques, torques) = -columns.middleRows(normals, torques);
  }
  slack_.resize(balance_.cones().size());
  Eigen::Index row = normals + 2 * torques;
  for (const bool second_order : {false, true}) {
    for (std::size_t i = 0; i < balance_.cones().size(); ++i) {
      if (balance_.cones()[i].second_order != second_order) continue;
      const Eigen::Index size = balance_.cones()[i].size();
      program_.G.block(row, first_[i], size, size) = -Eigen::MatrixXd::Identity(size, size);
      slack_[i] = row;
      row += size;
      if (second_order) {
        program_.cone.second_order.push_back(static_cast<int>(size));
      } else {
        program_.cone.orthant += static_cast<int>(size);
      }
    }
  }
}

// By the equations of the program the slacks of the cones equal the coordinates, but rounding makes
// them differ. The solver keeps the slacks strictly inside the cones, not the coordinates; a
// coordinate that is less far inside its cone than its slack is moved as far inside.
Eigen::Matrix4Xd ForceProgram::components(const ConicSolution& solution) const {
  Eigen::VectorXd v = solution.x.head(coordinates_);
  for (std::size_t i = 0; i < balance_.cones().size(); ++i) {
    const Eigen::Index size = balance_.cones()[i].size();
    auto part = v.segment(first_[i], size);
    const auto slack = solution.s.segment(slack_[i], size);
    if (balance_.cones()[i].second_order) {
      const double margin = slack[0] - slack.tail(size - 1).norm();
      part[0] = std::max(part[0], part.tail(size - 1).norm() + margin);
    } else {
      part = part.cwiseMax(slack).eval();
    }
  }
  return transmitted(polish(v));
}

Eigen::Matrix4Xd ForceProgram::transmitted(const Eigen::VectorXd& v) const {
  Eigen::Matrix4Xd result(4, std::ssize(balance_.cones()));
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const ContactCone& cone = balance_.cones()[index(i)];
    result.col(i) = cone.transmits * v.segment(first_[index(i)], cone.size());
  }
  return result;
}

// Whether all coordinates are in their cones.
bool ForceProgram::inside(const Eigen::VectorXd& v) const {
  for (std::size_t i = 0; i < balance_.cones().size(); ++i) {
    const auto part = v.segment(first_[i], balance_.cones()[i].size());
    const double margin = balance_.cones()[i].second_order
                              ? part[0] - part.tail(part.size() - 1).norm()
                              : part.minCoeff();
    if (!(margin >= 0.0)) return false;
  }
  return true;
}

// The inverse of the Hessian of the logarithmic barrier of each cone: x^2 in the orthant, and
// 2 x x' - (x'J x) J in a second-order cone. A step of length below one stays inside.
Eigen::MatrixXd ForceProgram::barrier_metric(const Eigen::VectorXd& v) const {
  Eigen::MatrixXd metric = Eigen::MatrixXd::Zero(coordinates_, coordinates_);
  for (std::size_t i = 0; i < balance_.cones().size(); ++i) {
    const Eigen::Index size = balance_.cones()[i].size();
    const auto part = v.segment(first_[i], size);
    auto block = metric.block(first_[i], first_[i], size, size);
    if (!balance_.cones()[i].second_order) {
      block = part.cwiseAbs2().asDiagonal();
      continue;
    }
    const double radius = part.tail(size - 1).norm();
    const double determinant = (part[0] - radius) * (part[0] + radius);
    block = 2.0 * part * part.transpose();
    block.diagonal().array() += determinant;
    block(0, 0) -= 2.0 * determinant;
  }
  return metric;
}

// Corrects v towards A v = b by steps d of least length in the metric M of the cones' barrier at v:
// minimise d' M^-1 d subject to A d = b - A v, with the solution d = M A' (A M A')^+ (b - A v). The
// metric keeps a coordinate near the border of its cone almost where it is, so that the step stays
// inside, where one of least Euclidean length would often leave. Rounds repeat because one solution
// is only as accurate as the conditioning allows; a round counts only if the residual falls, v
// stays in the cones, and the measure stays near its optimum.
Eigen::VectorXd ForceProgram::polish(Eigen::VectorXd v) const {
  const Eigen::MatrixXd A = program_.A.leftCols(coordinates_);
  const Eigen::MatrixXd weighted = barrier_metric(v) * A.transpose();
  const Eigen::MatrixXd products = A * weighted;
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors(products);
  const double highest = (1.0 + kPolishCost) * balance_.measure(transmitted(v));
  Eigen::VectorXd missing = program_.b - A * v;
  for (int round = 0; round < kPolishRounds; ++round) {
    const Eigen::VectorXd next = v + weighted * factors.solve(missing);
    const Eigen::VectorXd still_missing = program_.b - A * next;
    const bool better = still_missing.norm() < missing.norm() && inside(next);
    if (!better || balance_.measure(transmitted(next)) > highest) break;
    v = next;
    missing = still_missing;
  }
  return v;
}

// The multipliers as a wrench and joint torques. Balance is required in the directions of the basis
// only, so the basis turns its multipliers back into a wrench. A limited joint has a row for each
// sign of its torque, and both rows are divided by the limit.
ForceBalance::Separation ForceProgram::separation(const ConicSolution& solution) const {
  ForceBalance::Separation result{basis_ * solution.y.head(basis_.cols()),
                                  Eigen::VectorXd::Zero(balance_.limits().size())};
  const Eigen::Index normals = normal_rows();
  const Eigen::Index torques = std::ssize(balance_.limited());
  for (Eigen::Index i = 0; i < torques; ++i) {
    const double multiplier = solution.z[normals + i] - solution.z[normals + torques + i];
    result.torques[balance_.limited()[index(i)]] =
        multiplier / balance_.limits()[balance_.limited()[index(i)]];
  }
  for (Eigen::Index i = 0; i < std::ssize(balance_.locked()); ++i) {
    result.torques[balance_.locked()[index(i)]] = solution.y[basis_.cols() + i];
  }
  return result;
}

}  // namespace prehend
