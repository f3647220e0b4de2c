#include "sim/quality/force_program.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/QR>

namespace prehend {
namespace {

// Of a sum of the products of a separation and a contact's map, relative to them.
constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();

std::size_t index(Eigen::Index i) { return static_cast<std::size_t>(i); }

}  // namespace

ForceProgram::ForceProgram(std::span<const Contact> contacts, const WrenchFrame& frame,
                           const Wrench& wrench, double size, const HandTorques* hand,
                           const ForceOptions& options)
    : options_(options), wrench_(wrench) {
  add_contacts(contacts, frame);
  if (hand != nullptr) add_joints(contacts, *hand, size);
  fill_equations();
  fill_cones();
}

void ForceProgram::add_contacts(std::span<const Contact> contacts, const WrenchFrame& frame) {
  maps_.resize(6, 4 * std::ssize(contacts));
  loads_.resize(0, maps_.cols());
  for (const Contact& contact : contacts) {
    maps_.middleCols<4>(4 * std::ssize(cones_)) = contact_map(contact, frame);
    first_.push_back(coordinates_);
    cones_.push_back(contact_cone(contact, options_.cone, options_.edges));
    coordinates_ += cones_.back().size();
  }
}

void ForceProgram::add_joints(std::span<const Contact> contacts, const HandTorques& hand,
                              double size) {
  loads_ = Eigen::MatrixXd::Zero(hand.limits.size(), maps_.cols());
  limits_ = hand.limits / size;
  for (Eigen::Index i = 0; i < std::ssize(contacts); ++i) {
    const Eigen::Vector3d normal = contacts[index(i)].normal.normalized();
    const Tangents tangents = contact_tangents(normal);
    Eigen::Matrix3d axes;
    axes << normal, tangents.first, tangents.second;
    loads_.middleCols<3>(4 * i) = hand.jacobian.middleRows<3>(3 * i).transpose() * axes;
    if (hand.spin.size() > 0) loads_.col(4 * i + 3) = hand.spin.row(i).transpose();
  }
  for (Eigen::Index j = 0; j < limits_.size(); ++j) {
    if (limits_[j] == 0.0) locked_.push_back(j);
    if (limits_[j] > 0.0 && std::isfinite(limits_[j])) limited_.push_back(j);
  }
}

// Balance, and no torque at the joints that bear none.
void ForceProgram::fill_equations() {
  const bool shared = options_.measure == ForceMeasure::sum_of_normals;
  const Eigen::Index n = coordinates_ + (shared ? 0 : 1);
  program_.A = Eigen::MatrixXd::Zero(6 + std::ssize(locked_), n);
  program_.b = Eigen::VectorXd::Zero(program_.A.rows());
  program_.b.head<6>() = -wrench_;
  program_.c = Eigen::VectorXd::Zero(n);
  if (!shared) program_.c[coordinates_] = 1.0;
  for (Eigen::Index i = 0; i < std::ssize(cones_); ++i) {
    const ContactCone& cone = cones_[index(i)];
    auto columns = program_.A.middleCols(first_[index(i)], cone.size());
    columns.topRows<6>() = maps_.middleCols<4>(4 * i) * cone.transmits;
    columns.bottomRows(std::ssize(locked_)) =
        loads_.middleCols<4>(4 * i)(locked_, Eigen::all) * cone.transmits;
    if (shared) {
      program_.c.segment(first_[index(i)], cone.size()) = cone.transmits.row(0).transpose();
    }
  }
}

// Rows: normals below the largest, joint torques below and above their limits, coordinates of
// orthants, then the second-order cones.
void ForceProgram::fill_cones() {
  const bool shared = options_.measure == ForceMeasure::sum_of_normals;
  const Eigen::Index normals = shared ? 0 : std::ssize(cones_);
  const Eigen::Index torques = std::ssize(limited_);
  program_.G = Eigen::MatrixXd::Zero(normals + 2 * torques + coordinates_, program_.c.size());
  program_.h = Eigen::VectorXd::Zero(program_.G.rows());
  program_.h.segment(normals, 2 * torques).setOnes();
  program_.cone.orthant = static_cast<int>(normals + 2 * torques);
  if (!shared) program_.G.col(coordinates_).head(normals).setConstant(-1.0);
  for (Eigen::Index i = 0; i < std::ssize(cones_); ++i) {
    const ContactCone& cone = cones_[index(i)];
    auto columns = program_.G.middleCols(first_[index(i)], cone.size());
    if (!shared) columns.row(i) = cone.transmits.row(0);
    columns.middleRows(normals, torques) = limits_(limited_).cwiseInverse().asDiagonal() *
                                           loads_.middleCols<4>(4 * i)(limited_, Eigen::all) *
                                           cone.transmits;
    columns.middleRows(normals + torques, torques) = -columns.middleRows(normals, torques);
  }
  Eigen::Index row = normals + 2 * torques;
  for (const bool second_order : {false, true}) {
    for (std::size_t i = 0; i < cones_.size(); ++i) {
      if (cones_[i].second_order != second_order) continue;
      const Eigen::Index size = cones_[i].size();
      program_.G.block(row, first_[i], size, size) = -Eigen::MatrixXd::Identity(size, size);
      row += size;
      if (second_order) {
        program_.cone.second_order.push_back(static_cast<int>(size));
      } else {
        program_.cone.orthant += static_cast<int>(size);
      }
    }
  }
}

Eigen::Matrix4Xd ForceProgram::components(const Eigen::VectorXd& x) const {
  Eigen::Matrix4Xd result(4, std::ssize(cones_));
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const ContactCone& cone = cones_[index(i)];
    result.col(i) = cone.transmits * x.segment(first_[index(i)], cone.size());
  }
  return result;
}

// The inverse of the Hessian of the logarithmic barrier of each cone: x^2 in the orthant, and
// 2 x x' - (x'J x) J in a second-order cone. A step of length below one stays inside.
Eigen::MatrixXd ForceProgram::barrier_metric(const Eigen::VectorXd& x) const {
  Eigen::MatrixXd metric = Eigen::MatrixXd::Zero(coordinates_, coordinates_);
  for (std::size_t i = 0; i < cones_.size(); ++i) {
    const Eigen::Index size = cones_[i].size();
    const Eigen::VectorXd v = x.segment(first_[i], size);
    auto block = metric.block(first_[i], first_[i], size, size);
    if (!cones_[i].second_order) {
      block = v.cwiseAbs2().asDiagonal();
      continue;
    }
    const double radius = v.tail(size - 1).norm();
    block = 2.0 * v * v.transpose();
    block.diagonal().array() += (v[0] - radius) * (v[0] + radius);
    block(0, 0) -= 2.0 * (v[0] - radius) * (v[0] + radius);
  }
  return metric;
}

Eigen::VectorXd ForceProgram::polish(const Eigen::VectorXd& x) const {
  const Eigen::MatrixXd A = program_.A.leftCols(coordinates_);
  const Eigen::MatrixXd weighted = barrier_metric(x) * A.transpose();
  const Eigen::MatrixXd normal = A * weighted;
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors(normal);
  Eigen::VectorXd best = x;
  double error = (program_.b - A * best.head(coordinates_)).norm();
  for (int round = 0; round < 3; ++round) {
    Eigen::VectorXd next = best;
    const Eigen::VectorXd missing = program_.b - A * best.head(coordinates_);
    next.head(coordinates_) += weighted * factors.solve(missing);
    const double next_error = (program_.b - A * next.head(coordinates_)).norm();
    bool inside = next.allFinite() && next_error < error;
    for (std::size_t i = 0; inside && i < cones_.size(); ++i) {
      const Eigen::VectorXd v = next.segment(first_[i], cones_[i].size());
      inside = cones_[i].second_order ? v[0] >= v.tail(v.size() - 1).norm() : v.minCoeff() >= 0.0;
    }
    if (!inside) break;
    best = next;
    error = next_error;
  }
  return best;
}

double ForceProgram::measure(const Eigen::Matrix4Xd& components) const {
  if (components.cols() == 0) return 0.0;
  return options_.measure == ForceMeasure::sum_of_normals ? components.row(0).sum()
                                                          : components.row(0).maxCoeff();
}

double ForceProgram::residual(const Eigen::Matrix4Xd& components) const {
  return (maps_ * components.reshaped() + wrench_).norm();
}

double ForceProgram::torque_excess(const Eigen::Matrix4Xd& components) const {
  const Eigen::VectorXd torques = loads_ * components.reshaped();
  const Eigen::VectorXd sizes = loads_.cwiseAbs() * components.reshaped().cwiseAbs();
  double excess = 0.0;
  for (const Eigen::Index j : limited_) {
    excess = std::max(excess, std::abs(torques[j]) / limits_[j] - 1.0);
  }
  for (const Eigen::Index j : locked_) {
    if (sizes[j] > 0.0) excess = std::max(excess, std::abs(torques[j]) / sizes[j]);
  }
  return excess;
}

ForceProgram::Separation ForceProgram::separation(const ConicSolution& solution) const {
  Separation result{solution.y.head<6>(), Eigen::VectorXd::Zero(limits_.size())};
  const bool shared = options_.measure == ForceMeasure::sum_of_normals;
  const Eigen::Index normals = shared ? 0 : std::ssize(cones_);
  const Eigen::Index torques = std::ssize(limited_);
  for (Eigen::Index i = 0; i < torques; ++i) {
    const double multiplier = solution.z[normals + i] - solution.z[normals + torques + i];
    result.torques[limited_[index(i)]] = multiplier / limits_[limited_[index(i)]];
  }
  for (Eigen::Index i = 0; i < std::ssize(locked_); ++i) {
    result.torques[locked_[index(i)]] = solution.y[6 + i];
  }
  return result;
}

// With u the wrench and l the torques of the separation: balanced forces f within the limits have
// u . external - sum |l_j| L_j <= -sum over contacts of (u'W + l'J) f <= sum of f_n times what the
// cone's lowest value lies below zero.
double ForceProgram::lower_bound(const Separation& separation, ForceMeasure measure) const {
  double value = separation.wrench.dot(wrench_);
  for (const Eigen::Index j : limited_) value -= std::abs(separation.torques[j]) * limits_[j];
  const Eigen::VectorXd loads =
      maps_.transpose() * separation.wrench + loads_.transpose() * separation.torques;
  const Eigen::VectorXd sizes = maps_.cwiseAbs().transpose() * separation.wrench.cwiseAbs() +
                                loads_.cwiseAbs().transpose() * separation.torques.cwiseAbs();
  double below = 0.0;
  for (Eigen::Index i = 0; i < std::ssize(cones_); ++i) {
    const ContactCone& cone = cones_[index(i)];
    const double rounding = -kRounding * cone.lowest(-sizes.segment<4>(4 * i));
    const double depth = std::max(0.0, -cone.lowest(loads.segment<4>(4 * i))) + rounding;
    below = measure == ForceMeasure::sum_of_normals ? std::max(below, depth) : below + depth;
  }
  if (!(value > 0.0)) return 0.0;
  return below > 0.0 ? value / below : std::numeric_limits<double>::infinity();
}

}  // namespace prehend
