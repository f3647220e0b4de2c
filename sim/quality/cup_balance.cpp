#include "sim/quality/cup_balance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/quality/conic/conic_program.h"
#include "sim/quality/suction_cup.h"
#include "sim/quality/wrench_space.h"

namespace prehend {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
// Forces that leave more of the wrench over do not balance it.
constexpr double kLargestResidual = 1e-7;

// A second-order cone over variables of a contact: rows of factor * variable, the first of which is
// at least the norm of the others.
struct ConeRow {
  int variable = 0;
  double factor = 1.0;
};

// The set of one contact as a cone over a few variables, of which the first is what it spends.
//   cup:    [spent, lip force, friction force (2), friction torque, tilting torque (2)], the
//           friction over the coefficient (and the radius), the tilt over radius / 2
//   finger: [normal force, friction force (2), friction torque], as far as its model has them
struct ContactSet {
  Eigen::Matrix<double, 6, Eigen::Dynamic> transmits;  // components of unit variables
  std::vector<std::vector<ConeRow>> cones;
  std::vector<std::vector<ConeRow>> positive;  // sums that are >= 0
};

ContactSet set_of_cup(const Contact& cup) {
  ContactSet set;
  set.transmits.setZero(6, 7);
  set.transmits(0, 0) = -1.0;
  set.transmits(0, 1) = 1.0;
  set.transmits(1, 2) = set.transmits(2, 3) = cup.friction;
  set.transmits(3, 4) = cup.friction * cup.torsion;
  set.transmits(4, 5) = set.transmits(5, 6) = 0.5 * cup.torsion;
  set.positive = {{{0, 2.0}, {1, -1.0}}};  // the lip force is at most twice what is spent
  set.cones = {{{1}, {2}, {3}, {4}}, {{1}, {5}, {6}}};
  const double elastic = cup.torsion > 0.0 ? cup.moment / (0.5 * cup.torsion) : 0.0;
  if (elastic < 2.0) set.cones.push_back({{0, elastic}, {5}, {6}});
  return set;
}

ContactSet set_of(const Contact& contact) {
  if (contact.model == ContactModel::suction) return set_of_cup(contact);
  const int size = contact.model == ContactModel::frictionless  ? 1
                   : contact.model == ContactModel::soft_finger ? 4
                                                                : 3;
  ContactSet set;
  set.transmits.setZero(6, size);
  set.transmits(0, 0) = 1.0;
  std::vector<ConeRow> cone = {{0}};
  for (int v = 1; v < size; ++v) {
    set.transmits(v, v) = contact.friction * (v == 3 ? contact.torsion : 1.0);
    cone.push_back({v});
  }
  set.cones = {cone};
  return set;
}

double unit_of(const Contact& contact, CupUnit unit) {
  const bool in_newtons = unit == CupUnit::newtons && contact.model == ContactModel::suction;
  return in_newtons ? contact.vacuum : 1.0;
}

// The sets of all contacts, and the maps from their variables to wrenches.
class CupProgram {
 public:
  CupProgram(std::span<const Contact> contacts, const WrenchFrame& frame, const Wrench& wrench,
             ForceMeasure measure, CupUnit unit)
      : wrench_(wrench), largest_(measure == ForceMeasure::largest_normal) {
    for (const Contact& contact : contacts) {
      sets_.push_back(set_of(contact));
      Eigen::Matrix<double, 6, 6> map;
      map << contact_map(contact, frame), tilt_map(contact, frame);
      units_.push_back(unit_of(contact, unit));
      maps_.push_back(map);
      first_.push_back(variables_);
      variables_ += sets_.back().transmits.cols();
    }
  }

  // Minimise the measure: the sum of what is spent, or a bound t of each, the last variable.
  ConicProgram program() const {
    ConicProgram program;
    const Eigen::Index n = variables_ + (largest_ ? 1 : 0);
    program.c = Eigen::VectorXd::Zero(n);
    program.A = Eigen::MatrixXd::Zero(6, n);
    program.b = -wrench_;
    if (largest_) program.c[variables_] = 1.0;
    std::vector<Eigen::RowVectorXd> orthant;
    std::vector<Eigen::RowVectorXd> second_order;
    for (std::size_t i = 0; i < sets_.size(); ++i) {
      const ContactSet& set = sets_[i];
      program.A.middleCols(first_[i], set.transmits.cols()) = wrenches_of(i);
      if (largest_) {
        Eigen::RowVectorXd bound = Eigen::RowVectorXd::Zero(n);
        bound[variables_] = 1.0;
        bound[first_[i]] = -1.0;
        orthant.push_back(bound);
      } else {
        program.c[first_[i]] = 1.0;
      }
      for (const std::vector<ConeRow>& sum : set.positive) {
        orthant.push_back(Eigen::RowVectorXd::Zero(n));
        for (const ConeRow& row : sum) orthant.back()[first_[i] + row.variable] = row.factor;
      }
      for (const std::vector<ConeRow>& cone : set.cones) {
        program.cone.second_order.push_back(static_cast<int>(cone.size()));
        for (const ConeRow& row : cone) {
          second_order.push_back(Eigen::RowVectorXd::Zero(n));
          second_order.back()[first_[i] + row.variable] = row.factor;
        }
      }
    }
    program.cone.orthant = static_cast<int>(orthant.size());
    orthant.insert(orthant.end(), second_order.begin(), second_order.end());
    program.G.resize(std::ssize(orthant), n);
    for (std::size_t r = 0; r < orthant.size(); ++r) {
      program.G.row(static_cast<Eigen::Index>(r)) = -orthant[r];
    }
    program.h = Eigen::VectorXd::Zero(program.G.rows());
    return program;
  }

  CupForces forces(const ConicSolution& solution) const {
    CupForces result;
    result.components.resize(6, std::ssize(sets_));
    result.spent.resize(std::ssize(sets_));
    Wrench left = wrench_;
    for (std::size_t i = 0; i < sets_.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      const Eigen::VectorXd v = solution.x.segment(first_[i], sets_[i].transmits.cols());
      result.components.col(at) = units_[i] * (sets_[i].transmits * v);
      result.spent[at] = v[0];
      left += maps_[i] * result.components.col(at);
    }
    result.residual = left.norm();
    result.measure = largest_ ? result.spent.maxCoeff() : result.spent.sum();
    return result;
  }

 private:
  Eigen::MatrixXd wrenches_of(std::size_t i) const {
    return units_[i] * (maps_[i] * sets_[i].transmits);
  }

  Wrench wrench_;
  bool largest_;
  std::vector<ContactSet> sets_;
  std::vector<double> units_;
  std::vector<Eigen::Matrix<double, 6, 6>> maps_;
  std::vector<Eigen::Index> first_;  // variable of each contact
  Eigen::Index variables_ = 0;
};

// A lower bound of the measure from any wrench u: what balances `wrench` has the power -u . wrench
// against u, of which a contact that spends 1 has at most its support value.
double proved(std::span<const Contact> contacts, const WrenchFrame& frame, const Wrench& wrench,
              const Wrench& u, ForceMeasure measure, CupUnit unit) {
  const double needed = -u.dot(wrench);
  if (!(needed > 0.0)) return 0.0;
  double most = 0.0;
  for (const Contact& contact : contacts) {
    const auto set = wrench_space({&contact, 1}, frame, {.cone = FrictionCone::exact});
    const double one = unit_of(contact, unit) * std::max(0.0, u.dot(Wrench(set->support(u))));
    most = measure == ForceMeasure::largest_normal ? most + one : std::max(most, one);
  }
  return most > 0.0 ? needed / most : kInfinite;
}

}  // namespace

bool has_cup(std::span<const Contact> contacts) {
  return std::any_of(contacts.begin(), contacts.end(),
                     [](const Contact& contact) { return contact.model == ContactModel::suction; });
}

CupForces cup_forces(std::span<const Contact> contacts, const WrenchFrame& frame,
                     const Wrench& external, ForceMeasure measure, CupUnit unit) {
  check_contacts(contacts, frame);
  require(external.allFinite() && external.cwiseAbs().maxCoeff() <= kLargestLoad,
          {.field = "external", .problem = "each part must be within 1e9 of 0"});
  CupForces none;
  none.components.setZero(6, std::ssize(contacts));
  none.spent.setZero(std::ssize(contacts));
  none.outcome = ForceOutcome::balanced;
  if (external.isZero(0.0)) return none;
  none.outcome = ForceOutcome::impossible;
  none.measure = none.lowest = kInfinite;
  none.residual = 1.0;
  if (contacts.empty()) return none;
  const double size = external.stableNorm();
  const Wrench wrench = external / size;
  const CupProgram program(contacts, frame, wrench, measure, unit);
  const ConicSolution solution = solve(program.program());
  if (solution.status == ConicStatus::primal_infeasible) return none;
  CupForces result = program.forces(solution);
  const auto bound = [&](const Wrench& u) {
    return proved(contacts, frame, wrench, u, measure, unit);
  };
  const Wrench multipliers = solution.y;
  result.lowest = std::max({bound(multipliers), bound(-multipliers), bound(-wrench)});
  if (result.residual > kLargestResidual && result.lowest > kLargestForce) return none;
  if (result.residual <= kLargestResidual) result.outcome = ForceOutcome::balanced;
  result.lowest = size * std::min(result.lowest, result.measure);
  result.measure *= size;
  result.components *= size;
  result.spent *= size;
  return result;
}

}  // namespace prehend
