#include "sim/quality/barrier_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/SVD>

#include "sim/base/index.h"

// With w the unit external wrench, W_i and J_i the maps of the forces f_i of contact i to its
// wrench and to joint torques, L the torque limits and e the normal direction, the multipliers u
// (of the balance), l (of the torques) and p (prices of the normal forces) solve
//
//   maximise    u . w - sum of |l_j| L_j
//   subject to  p_i e + W_i'u + J_i'l  in the dual of the friction cone of contact i,
//               sum of normals: p_i = 1;  largest normal: p_i >= 0, sum of p_i = 1.
//
// u = l = 0 is allowed, so there is always a place to start from. The barrier adds, for each cone,
// the logarithm of its determinant, and for the prices theirs. |l| is smoothed by the barriers of
// both signs of a multiplier, l = l+ - l-: with s = l+ + l- their best sum for a given l is
// m + sqrt(m^2 + l^2), m = 1 / (sharpness L).
//
// The forces are the derivatives of the barriers, divided by the sharpness: strictly in the cones,
// within the limits, and in balance as far as the derivative of the whole vanishes.
namespace prehend {
namespace {

// From one sharpness of the barrier to the next.
constexpr double kSharper = 50.0;
// Newton's method stops where its decrement is smaller: from there it converges quadratically.
constexpr double kNear = 0.2;
constexpr int kMostSteps = 120;  // in all; about 40 are needed
// Part of the gap's tolerance that the search uses up: a hundredth of the gap costs three steps
// more.
constexpr double kShare = 0.003;
// Pivots of the equilibrated curvature that count as zero at the start.
constexpr double kSingular = 1e-13;
constexpr double kRidge = 1e-14;
// A step is halved until the function gains this part of what its slope promises.
constexpr double kGain = 0.1;
constexpr double kShortest = 1e-9;
// Forces of so many times the wrench are seldom the least.
constexpr double kMuch = 100.0;

// What the components of all contacts add up to, and what that must be: the negative of the
// external wrench, and no torque at joints without an effort. As rows: wrench, then torques.
struct Equations {
  Eigen::MatrixXd effects;  // rows x 4n
  Eigen::VectorXd target;   // of the rows: the unit wrench, then zeros
  Eigen::MatrixXd basis;    // rows x k: the combinations of rows that are looked at
};

Equations all_equations(const ForceBalance& balance) {
  const Eigen::Index rows = 6 + std::ssize(balance.locked());
  Equations equations{Eigen::MatrixXd(rows, 4 * balance.contacts()), Eigen::VectorXd::Zero(rows),
                      Eigen::MatrixXd::Identity(rows, rows)};
  for (Eigen::Index i = 0; i < balance.contacts(); ++i) {
    equations.effects.block<6, 4>(0, 4 * i) = balance.map(i);
    equations.effects.block(6, 4 * i, rows - 6, 4) = balance.loads(i)(balance.locked(), Eigen::all);
  }
  equations.target.head<6>() = balance.wrench();
  return equations;
}

// Drops the combinations of rows on which the contacts have no effect. Returns, as factors of the
// rows, what the target asks of these: if that is more than rounding, it proves that it cannot be.
Eigen::VectorXd make_independent(const ForceBalance& balance, Equations& equations) {
  constexpr double kNoEffect = 1e-10;  // relative to the largest
  Eigen::MatrixXd effects = equations.effects;
  for (Eigen::Index i = 0; i < balance.contacts(); ++i) {
    // What a contact does not transmit has no effect.
    const Eigen::Vector4d sizes = balance.cones()[index(i)].transmits.rowwise().norm();
    effects.middleCols<4>(4 * i) *= sizes.asDiagonal();
  }
  // Torques and wrenches differ in size.
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(effects.rows());
  for (Eigen::Index row = 6; row < effects.rows(); ++row) {
    const double length = effects.row(row).norm();
    if (length > 0.0) scale[row] = 1.0 / length;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scale.asDiagonal() * effects, Eigen::ComputeThinU);
  const Eigen::VectorXd& values = svd.singularValues();
  const Eigen::Index rank = (values.array() > kNoEffect * values[0]).count();
  const Eigen::VectorXd target = scale.cwiseProduct(equations.target);
  const auto kept = svd.matrixU().leftCols(rank);
  equations.basis = scale.asDiagonal() * kept;
  return scale.cwiseProduct(target - kept * (kept.transpose() * target));
}

// Multipliers of the equations' rows, and none of the limits.
ForceBalance::Separation separation_of(const ForceBalance& balance, const Eigen::VectorXd& rows) {
  ForceBalance::Separation result{rows.head<6>(), Eigen::VectorXd::Zero(balance.limits().size())};
  for (Eigen::Index j = 6; j < rows.size(); ++j) {
    result.torques[balance.locked()[index(j - 6)]] = rows[j];
  }
  return result;
}

bool proves_impossible(const ForceBalance& balance, const ForceOptions& options,
                       const ForceBalance::Separation& separation) {
  return balance.lower_bound(separation, ForceMeasure::sum_of_normals, options.residual_tolerance) >
         kLargestForce;
}

// Multipliers: of the equations, then of the joint limits.
template <int Size>
class DualBarrier {
 public:
  using Vector = Eigen::Matrix<double, Size, 1>;
  using Matrix = Eigen::Matrix<double, Size, Size>;

  DualBarrier(const ForceBalance& balance, const ForceOptions& options, const Equations& equations)
      : balance_(balance),
        options_(options),
        basis_(equations.basis),
        target_(equations.basis.transpose() * equations.target),
        is_priced_(options.measure == ForceMeasure::largest_normal),
        first_limited_(equations.basis.cols()) {
    const Eigen::Index size = first_limited_ + std::ssize(balance.limited());
    effects_.resize(size, 4 * balance.contacts());
    effects_.topRows(first_limited_).noalias() = basis_.transpose() * equations.effects;
    for (Eigen::Index i = 0; i < balance.contacts(); ++i) {
      effects_.block(first_limited_, 4 * i, size - first_limited_, 4) =
          balance.loads(i)(balance.limited(), Eigen::all);
      const ContactCone& cone = balance.cones()[index(i)];
      complexity_ += cone.second_order ? 2.0 : static_cast<double>(cone.size());
    }
    complexity_ += 2.0 * static_cast<double>(balance.limited().size());
    here_.y = Vector::Zero(size);
    if (is_priced_) {
      const auto contacts = static_cast<double>(balance.contacts());
      complexity_ += contacts;
      here_.prices = Eigen::VectorXd::Constant(balance.contacts(), 1.0 / contacts);
    }
  }

  // Lets the forces balance a part of the wrench only: what is missing costs `most` times itself.
  void allow_part(double most) {
    most_ = most;
    complexity_ += 1.0;
    // From multipliers of zero far from what they may be.
    sharpness_ = 1.0 / most;
  }

  // Whether the equations are independent, up to rounding.
  bool is_regular() const { return newton(kSingular).has_value(); }

  ProposedForces run() {
    ProposedForces found{Eigen::Matrix4Xd::Zero(4, balance_.contacts()), {}};
    here_.value = *value_at(here_);
    while (true) {
      if (!centre() || steps_ > kMostSteps) break;
      if (separates()) break;
      const double gap = kShare * options_.gap_tolerance * objective(here_);
      if (complexity_ <= gap * sharpness_) {
        if (const auto forces = components()) found.components = *forces;
        break;
      }
      // No sharper than is needed: the sharper, the larger the part of rounding.
      sharpness_ *=
          gap > 0.0 ? std::min(kSharper, 1.01 * complexity_ / (gap * sharpness_)) : kSharper;
      here_.value = *value_at(here_);
    }
    found.separation = separation();
    return found;
  }

 private:
  // Coordinates of a second-order cone.
  using Few = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1>;
  using FewByFew = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4>;

  // A set of multipliers, and the value there of what is maximised.
  struct Point {
    Vector y;
    Eigen::VectorXd prices;  // of each contact; empty for the sum of normals
    double value = 0.0;
  };

  // Along the function's rise: the step of Newton's method, and what the slope promises.
  struct Step {
    Vector y;
    Eigen::VectorXd prices;
    double decrement = 0.0;  // squared
  };

  bool is_partial() const { return std::isfinite(most_); }

  double price(const Point& point, Eigen::Index i) const {
    return is_priced_ ? point.prices[i] : 1.0;
  }

  // What has to be in the dual cone of a contact, as a linear function of its components.
  Eigen::Vector4d loads(const Point& point, Eigen::Index i) const {
    Eigen::Vector4d loads = effects(i).transpose().lazyProduct(point.y);
    loads[0] += price(point, i);
    return loads;
  }
  auto effects(Eigen::Index i) const { return effects_.template middleCols<4>(4 * i); }

  // Of the multiplier j.
  double limit(Eigen::Index j) const {
    return balance_.limits()[balance_.limited()[index(j - first_limited_)]];
  }
  // The sum of both multipliers of a joint's limit.
  double both_signs(const Point& point, Eigen::Index j) const {
    const double m = 1.0 / (sharpness_ * limit(j));
    const double l = point.y[j];
    return m + std::sqrt(m * m + l * l);
  }

  double objective(const Point& point) const {
    double value = point.y.head(first_limited_).dot(target_);
    for (Eigen::Index j = first_limited_; j < point.y.size(); ++j) {
      value -= limit(j) * std::abs(point.y[j]);
    }
    return value;
  }

  // What is maximised; nothing outside of the cones.
  std::optional<double> value_at(const Point& point) const {
    const double power = point.y.head(first_limited_).dot(target_);
    double value = sharpness_ * power;
    if (is_partial()) {
      if (!(most_ > power)) return std::nullopt;
      value += std::log(most_ - power);
    }
    for (Eigen::Index i = 0; i < balance_.contacts(); ++i) {
      const ContactCone& cone = balance_.cones()[index(i)];
      slack_.noalias() = cone.transmits.transpose().lazyProduct(loads(point, i));
      if (cone.second_order) {
        const double radius = slack_.tail(slack_.size() - 1).norm();
        if (!(slack_[0] > radius)) return std::nullopt;
        value += std::log((slack_[0] - radius) * (slack_[0] + radius));
      } else {
        if (!(slack_.minCoeff() > 0.0)) return std::nullopt;
        value += slack_.array().log().sum();
      }
    }
    if (is_priced_) {
      if (!(point.prices.minCoeff() > 0.0)) return std::nullopt;
      value += point.prices.array().log().sum();
    }
    for (Eigen::Index j = first_limited_; j < point.y.size(); ++j) {
      const double s = both_signs(point, j);
      value += std::log(2.0 * s / (sharpness_ * limit(j))) - sharpness_ * limit(j) * s;
    }
    return value;
  }

  // The first derivative of a cone's barrier by the contact's loads, and the second, negative.
  struct Derivatives {
    Eigen::Vector4d first;
    Eigen::Matrix4d second;
  };
  Derivatives derivatives(const Point& point, Eigen::Index i) const {
    const ContactCone& cone = balance_.cones()[index(i)];
    slack_.noalias() = cone.transmits.transpose().lazyProduct(loads(point, i));
    if (!cone.second_order) {
      const Eigen::VectorXd inverse = slack_.cwiseInverse();
      const Eigen::Matrix4Xd scaled = cone.transmits * inverse.asDiagonal();
      return {scaled.rowwise().sum(), scaled * scaled.transpose()};
    }
    const Eigen::Index size = slack_.size();
    const double radius = slack_.tail(size - 1).norm();
    const double twice = 2.0 / ((slack_[0] - radius) * (slack_[0] + radius));
    slack_.tail(size - 1) *= -1.0;
    Derivatives result;
    result.first = twice * (cone.transmits * slack_);
    result.second = result.first * result.first.transpose();
    // Mirrored: + for the normal force, - for the rest.
    for (Eigen::Index k = 0; k < size; ++k) {
      const auto axis = cone.transmits.col(k);
      result.second += (k == 0 ? -twice : twice) * axis * axis.transpose();
    }
    return result;
  }

  // The second derivative, negative, with the contact's price eliminated, whose own barrier bends
  // by `bend`. As the difference of derivatives it would be lost to rounding near the border: here
  // all terms are positive.
  Eigen::Matrix4d condensed(Eigen::Index i, double bend) const {
    const ContactCone& cone = balance_.cones()[index(i)];
    slack_.noalias() = cone.transmits.transpose().lazyProduct(loads(here_, i));
    if (!cone.second_order) {
      const Eigen::VectorXd weights = slack_.cwiseAbs2().cwiseInverse();
      const Eigen::Vector4d mean = cone.transmits * weights / (weights.sum() + bend);
      const Eigen::Matrix4Xd apart = cone.transmits.colwise() - mean;
      return apart * weights.asDiagonal() * apart.transpose() + bend * mean * mean.transpose();
    }
    const Few slack = slack_;
    const Eigen::Index rest = slack.size() - 1;
    const double radius = slack.tail(rest).norm();
    const double det = (slack[0] - radius) * (slack[0] + radius);
    const double twice = 2.0 / det;
    const double squares = 2.0 * (slack[0] * slack[0] + radius * radius);
    const double stiffness = squares / (det * det) + bend;  // of the price
    const double share = bend / stiffness;
    FewByFew bent = FewByFew::Identity(rest + 1, rest + 1) * twice;
    bent(0, 0) = share * squares / (det * det);
    if (radius > 0.0) {
      const Few along = slack.tail(rest) / radius;
      const double pull = twice * radius;
      bent.col(0).tail(rest) = -share * twice * slack[0] * pull * along;
      bent.row(0).tail(rest) = bent.col(0).tail(rest).transpose();
      const double stretched =
          twice * det * (2.0 + bend * det) / (squares + bend * det * det) + pull * pull * share;
      bent.bottomRightCorner(rest, rest) +=
          ((stretched - twice) * along).lazyProduct(along.transpose());
    }
    const Eigen::Matrix<double, 4, Eigen::Dynamic, 0, 4, 4> half = cone.transmits.lazyProduct(bent);
    return half.lazyProduct(cone.transmits.transpose());
  }

  // Newton's step. The prices are eliminated: each is coupled to its own contact and, by their sum,
  // to all others. Nothing where the second derivative is singular.
  std::optional<Step> newton(double least_pivot = 0.0) const {
    const Eigen::Index size = here_.y.size();
    Vector slope = Vector::Zero(size);
    Matrix curvature = Matrix::Zero(size, size);
    slope.head(first_limited_) = sharpness_ * target_;
    if (is_partial()) {
      const double inverse = 1.0 / (most_ - here_.y.head(first_limited_).dot(target_));
      slope.head(first_limited_) -= inverse * target_;
      curvature.topLeftCorner(first_limited_, first_limited_) +=
          (inverse * target_) * (inverse * target_).transpose();
    }
    Coupling coupling(size, is_priced_ ? balance_.contacts() : 0);
    for (Eigen::Index i = 0; i < balance_.contacts(); ++i) {
      auto [first, second] = derivatives(here_, i);
      slope.noalias() += effects(i).lazyProduct(first);
      if (is_priced_) {
        const double inverse = 1.0 / here_.prices[i];
        const double bend = inverse * inverse;
        coupling.add(i, effects(i) * second.col(0), first[0] + inverse, second(0, 0) + bend);
        second = condensed(i, bend);
      }
      const Eigen::Matrix<double, Size, 4> bent = effects(i).lazyProduct(second);
      curvature.noalias() += bent.lazyProduct(effects(i).transpose());
    }
    for (Eigen::Index j = first_limited_; j < size; ++j) {
      const double s = both_signs(here_, j);
      const double m = 1.0 / (sharpness_ * limit(j));
      slope[j] -= here_.y[j] / (m * s);
      curvature(j, j) += 1.0 / (s * (s - m));
    }
    return is_priced_ ? coupling.step(slope, curvature, least_pivot)
                      : plain_step(slope, curvature, least_pivot);
  }

  static std::optional<Vector> solve(const Matrix& curvature, const Vector& slope,
                                     double least_pivot) {
    // Multipliers of torques and of wrenches differ in size.
    const Vector scale = curvature.diagonal().cwiseSqrt().cwiseInverse();
    if (!scale.allFinite()) return std::nullopt;
    Matrix even = scale.asDiagonal() * curvature * scale.asDiagonal();
    Eigen::LDLT<Matrix> factors(even);
    if (!(factors.vectorD().minCoeff() > least_pivot)) {
      if (least_pivot > 0.0) return std::nullopt;
      // Positive but for rounding.
      even.diagonal().array() += kRidge;
      factors.compute(even);
      if (!(factors.vectorD().minCoeff() > 0.0)) return std::nullopt;
    }
    const Vector step = scale.cwiseProduct(factors.solve(scale.cwiseProduct(slope)));
    if (!step.allFinite()) return std::nullopt;
    return step;
  }
  static std::optional<Step> plain_step(const Vector& slope, const Matrix& curvature,
                                        double least_pivot) {
    const std::optional<Vector> y = solve(curvature, slope, least_pivot);
    if (!y) return std::nullopt;
    return Step{*y, {}, y->dot(slope)};
  }

  // How prices and the other multipliers act on each other in Newton's equations.
  class Coupling {
   public:
    Coupling(Eigen::Index size, Eigen::Index contacts)
        : mixed_(size, contacts), slopes_(contacts), bends_(contacts) {}
    void add(Eigen::Index i, const Vector& mixed, double slope, double bend) {
      mixed_.col(i) = mixed;
      slopes_[i] = slope;
      bends_[i] = bend;
    }
    // `curvature` is that without the prices, whose sum stays as it is.
    std::optional<Step> step(const Vector& slope, const Matrix& curvature,
                             double least_pivot) const {
      const Eigen::VectorXd free = bends_.cwiseInverse();
      const double all = free.sum();
      const Vector mean = mixed_ * free / all;
      const double level = slopes_.dot(free) / all;
      const Matrix reduced = curvature + all * mean * mean.transpose();
      const Vector remaining =
          slope - mixed_ * free.cwiseProduct((slopes_.array() - level).matrix());
      const std::optional<Vector> y = solve(reduced, remaining, least_pivot);
      if (!y) return std::nullopt;
      Step step{*y, {}, 0.0};
      const double shared = level - mean.dot(*y);
      step.prices =
          free.cwiseProduct(((slopes_ - mixed_.transpose() * *y).array() - shared).matrix());
      step.decrement = y->dot(slope) + step.prices.dot(slopes_);
      return step;
    }

   private:
    Eigen::Matrix<double, Size, Eigen::Dynamic> mixed_;
    Eigen::VectorXd slopes_;
    Eigen::VectorXd bends_;
  };

  // Moves along the step as far as the function gains enough; whether it could.
  bool move(const Step& step) {
    const bool is_near = step.decrement < kNear * kNear;
    for (double length = 1.0; length > kShortest; length *= 0.5) {
      std::optional<Point> next = ahead(step, length);
      if (!next) continue;
      if (!is_near && next->value - here_.value < kGain * length * step.decrement) continue;
      here_ = std::move(*next);
      grow(step, length);
      return true;
    }
    return false;
  }

  std::optional<Point> ahead(const Step& step, double length) const {
    Point next{here_.y + length * step.y, {}};
    if (is_priced_) next.prices = here_.prices + length * step.prices;
    const std::optional<double> value = value_at(next);
    if (!value) return std::nullopt;
    next.value = *value;
    return next;
  }

  // Where multipliers are as large as only an impossible balance makes them, the way they grow is
  // mostly one that has no end, and steps double: Newton's would lose it to rounding before the
  // proof is complete.
  void grow(const Step& step, double length) {
    while (!is_partial() && objective(here_) > kMuch && objective(here_) < kLargestForce * kMuch) {
      std::optional<Point> next = ahead(step, length *= 2.0);
      if (!next || next->value <= here_.value) return;
      here_ = std::move(*next);
    }
  }

  // The maximum at this sharpness; false where it was not found.
  bool centre() {
    while (++steps_ <= kMostSteps) {
      const std::optional<Step> step = newton();
      if (!step || !(step->decrement >= 0.0)) return false;
      if (!move(*step)) return false;
      if (step->decrement < kNear * kNear) return true;
      if (separates()) return true;
    }
    return false;
  }

  // Where nothing balances the wrench, the multipliers grow without end.
  bool separates() const {
    return !is_partial() && objective(here_) > kMuch &&
           proves_impossible(balance_, options_, separation());
  }

  // The forces of contact i at the end of a step, by the first derivatives and what the second ones
  // add: slacks near the border are differences of large numbers, so that the first derivatives by
  // themselves are in balance to about eight digits only. Nothing outside of the cone.
  std::optional<Eigen::Vector4d> force(Eigen::Index i, const Step& step) const {
    const ContactCone& cone = balance_.cones()[index(i)];
    Eigen::Vector4d change = effects(i).transpose().lazyProduct(step.y);
    if (is_priced_) change[0] += step.prices[i];
    const Eigen::VectorXd slack = cone.transmits.transpose() * loads(here_, i);
    const Eigen::VectorXd moved = cone.transmits.transpose() * change;
    Eigen::VectorXd v;
    if (cone.second_order) {
      const Eigen::Index rest = slack.size() - 1;
      const double radius = slack.tail(rest).norm();
      const double twice = 2.0 / ((slack[0] - radius) * (slack[0] + radius));
      Eigen::VectorXd mirrored = slack;
      mirrored.tail(rest) *= -1.0;
      v = twice * (1.0 - twice * mirrored.dot(moved)) * mirrored;
      v[0] += twice * moved[0];
      v.tail(rest) -= twice * moved.tail(rest);
      if (!(v[0] >= v.tail(rest).norm())) return std::nullopt;
    } else {
      const Eigen::VectorXd inverse = slack.cwiseInverse();
      v = inverse - inverse.cwiseAbs2().cwiseProduct(moved);
      if (!(v.minCoeff() >= 0.0)) return std::nullopt;
    }
    return Eigen::Vector4d(cone.transmits * v / sharpness_);
  }

  // The forces, in balance up to rounding; nothing where that would leave the cones.
  std::optional<Eigen::Matrix4Xd> components() const {
    const std::optional<Step> step = newton();
    if (!step) return std::nullopt;
    Eigen::Matrix4Xd result(4, balance_.contacts());
    for (Eigen::Index i = 0; i < balance_.contacts(); ++i) {
      const std::optional<Eigen::Vector4d> components = force(i, *step);
      if (!components) return std::nullopt;
      result.col(i) = *components;
    }
    return result;
  }

  ForceBalance::Separation separation() const {
    ForceBalance::Separation result =
        separation_of(balance_, basis_ * here_.y.head(first_limited_));
    for (Eigen::Index j = first_limited_; j < here_.y.size(); ++j) {
      result.torques[balance_.limited()[index(j - first_limited_)]] = here_.y[j];
    }
    return result;
  }

  const ForceBalance& balance_;
  const ForceOptions& options_;
  Eigen::MatrixXd basis_;
  Eigen::VectorXd target_;
  bool is_priced_;
  Eigen::Index first_limited_;                             // among the multipliers
  Eigen::Matrix<double, Size, Eigen::Dynamic> effects_;    // of the components, 4 columns a contact
  double most_ = std::numeric_limits<double>::infinity();  // what power may be; see allow_part
  double complexity_ = 0.0;  // of the barrier: the gap to the best is this over the sharpness
  double sharpness_ = 1.0;
  Point here_;
  int steps_ = 0;
  mutable Eigen::VectorXd slack_;
};

// Searches with the equations as they are, or without those that say nothing.
ProposedForces search(const ForceBalance& balance, const ForceOptions& options, double most) {
  Equations equations = all_equations(balance);
  const auto found_by = [&](auto barrier) -> std::optional<ProposedForces> {
    if (!barrier.is_regular()) return std::nullopt;
    if (std::isfinite(most)) barrier.allow_part(most);
    return barrier.run();
  };
  const bool has_joints = !balance.locked().empty() || !balance.limited().empty();
  const std::optional<ProposedForces> found =
      has_joints ? found_by(DualBarrier<Eigen::Dynamic>(balance, options, equations))
                 : found_by(DualBarrier<6>(balance, options, equations));
  if (found) return *found;
  const ForceBalance::Separation separation =
      separation_of(balance, make_independent(balance, equations));
  if (proves_impossible(balance, options, separation)) {
    return {Eigen::Matrix4Xd::Zero(4, balance.contacts()), separation};
  }
  DualBarrier<Eigen::Dynamic> barrier(balance, options, equations);
  if (std::isfinite(most)) barrier.allow_part(most);
  return barrier.run();
}

}  // namespace

ProposedForces barrier_forces(const ForceBalance& balance, const ForceOptions& options) {
  return search(balance, options, std::numeric_limits<double>::infinity());
}

ProposedForces partial_forces(const ForceBalance& balance, const ForceOptions& options,
                              double price) {
  return search(balance, options, price);
}

}  // namespace prehend
