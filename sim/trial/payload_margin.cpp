#include "sim/trial/payload_margin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "sim/base/gravity.h"
#include "sim/base/index.h"
#include "sim/base/range.h"
#include "sim/motion/clutches.h"
#include "sim/quality/cup_balance.h"
#include "sim/quality/forces.h"
#include "sim/quality/ranges.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/grasp_contacts.h"

namespace prehend {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// The axis of a joint, unit, and a point on it, in the hand's base frame.
struct JointAxis {
  Vector3 direction_H;
  Vector3 point_H;
};

std::vector<JointAxis> joint_axes(const Robot& hand, const std::vector<double>& joints) {
  std::vector<JointAxis> axes;
  for (const Joint& joint : hand.joints) {
    const Pose X_HP = joint.parent < 0 ? Pose::Identity() : joint_pose(hand, joint.parent, joints);
    const Pose X_HJ = X_HP * joint.X_PJ;
    axes.push_back({X_HJ.linear() * joint.axis, X_HJ.translation()});
  }
  return axes;
}

// What the gear of a clutch bears, in units of its degree of freedom.
double gear_of(const Robot& hand, const Clutch& clutch) {
  return clutch.gear_effort * std::abs(hand.joints[index(clutch.joints.front())].ratio);
}

// Sums of joint torques that the drives of a hand bear, one column each.
struct DriveLoads {
  Eigen::MatrixXd of_joints;  // joints x loads: how much of each torque
  Eigen::VectorXd limits;
};

// A degree of freedom bears the torques of its joints through their ratios. Those behind a clutch
// reach it only as far as the clutch passes them on: what its gear bears does not, and where it
// slips only its own effort does. With loads l of k clutches, gears g and clutches c, the drive
// bears rest + sum of max(l - g, -c): for each choice of clutches one sum.
DriveLoads drive_loads(const Robot& hand) {
  const Eigen::VectorXd efforts = stated_efforts(hand);
  const std::vector<Clutch> clutches = clutches_of(hand, efforts);
  std::vector<Eigen::VectorXd> columns;
  std::vector<double> limits;
  const auto add = [&](const Eigen::VectorXd& column, double limit) {
    columns.push_back(column);
    limits.push_back(limit);
  };
  for (int d = 0; d < static_cast<int>(hand.dofs.size()); ++d) {
    std::vector<Clutch> own;
    std::vector<Eigen::VectorXd> behind;  // each clutch
    Eigen::VectorXd rest = Eigen::VectorXd::Zero(std::ssize(hand.joints));
    for (std::size_t j = 0; j < hand.joints.size(); ++j) {
      if (hand.joints[j].dof == d) rest[static_cast<Eigen::Index>(j)] = hand.joints[j].ratio;
    }
    for (const Clutch& clutch : clutches) {
      // The stop of a linkage takes what pushes its joint ahead; what pushes it back is not limited
      // here, where limits are the same for both signs.
      if (clutch.dof != d || clutch.stays_behind != 0.0) continue;
      own.push_back(clutch);
      behind.push_back(joints_of_slip(hand, clutch));
      rest -= behind.back();
    }
    const bool is_known = efforts[d] > 0.0;
    for (unsigned chosen = 0; chosen < 1U << own.size(); ++chosen) {
      Eigen::VectorXd column = rest;
      double limit = efforts[d];
      for (std::size_t c = 0; c < own.size(); ++c) {
        const bool passes = (chosen >> c & 1U) != 0;
        if (passes) column += behind[c];
        limit += passes ? gear_of(hand, own[c]) : own[c].effort;
      }
      if (!column.isZero(0.0)) add(column, is_known ? limit : kInfinite);
    }
    for (std::size_t c = 0; c < own.size(); ++c) {
      if (is_known) add(behind[c], own[c].effort + gear_of(hand, own[c]));
    }
  }
  DriveLoads loads{Eigen::MatrixXd(std::ssize(hand.joints), std::ssize(columns)),
                   Eigen::Map<Eigen::VectorXd>(limits.data(), std::ssize(limits))};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    loads.of_joints.col(static_cast<Eigen::Index>(k)) = columns[k];
  }
  return loads;
}

// An attitude on the unit sphere: a vertex of an icosahedron, or the middle of an edge.
struct Attitude {
  Vector3 down_O;
  std::array<int, 2> ends{-1, -1};  // of the edge, among the attitudes before
};

std::vector<Attitude> attitudes() {
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  std::vector<Attitude> all;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-golden, golden}) {
      for (int turn = 0; turn < 3; ++turn) {
        Vector3 corner = Vector3::Zero();
        corner[(turn + 1) % 3] = a;
        corner[(turn + 2) % 3] = b;
        all.push_back({corner.normalized()});
      }
    }
  }
  const std::size_t corners = all.size();
  // Neighbours are 63 degrees apart, others at least 116.
  for (std::size_t i = 0; i < corners; ++i) {
    for (std::size_t j = i + 1; j < corners; ++j) {
      const Vector3& a = all[i].down_O;
      const Vector3& b = all[j].down_O;
      if (a.dot(b) <= 0.0) continue;
      all.push_back({(a + b).normalized(), {static_cast<int>(i), static_cast<int>(j)}});
    }
  }
  return all;
}

// Where gravity pulls as the object lies.
Vector3 given_down(const CompiledScene& scene) {
  return scene.scene.object.X_WO.linear().transpose() * -Vector3::UnitZ();
}

// The torques of several hands, each loaded by its own contacts, which follow one another.
HandTorques joined_torques(std::span<const HoldingHand> hands) {
  HandTorques all;
  for (const HoldingHand& hand : hands) {
    const HandTorques own = hand_torques(hand.scene, hand.trial);
    const auto beside = [](const Eigen::MatrixXd& before, const Eigen::MatrixXd& added) {
      Eigen::MatrixXd both =
          Eigen::MatrixXd::Zero(before.rows() + added.rows(), before.cols() + added.cols());
      both.topLeftCorner(before.rows(), before.cols()) = before;
      both.bottomRightCorner(added.rows(), added.cols()) = added;
      return both;
    };
    all.jacobian = beside(all.jacobian, own.jacobian);
    all.spin = beside(all.spin, own.spin);
    Eigen::VectorXd limits(all.limits.size() + own.limits.size());
    limits << all.limits, own.limits;
    all.limits = std::move(limits);
  }
  return all;
}

std::vector<Contact> joined_contacts(std::span<const HoldingHand> hands) {
  std::vector<Contact> all;
  for (const HoldingHand& hand : hands) {
    for (const GraspContact& contact : hand.trial.contacts) all.push_back(contact.point);
  }
  return all;
}

// The contacts of one grasp, or of several hands, and the weight on them.
class Weighed {
 public:
  explicit Weighed(std::span<const HoldingHand> hands, const Perturbation& perturbation = {})
      : frame_(hands.front().scene.wrench_frame),
        weight_(hands.front().scene.scene.object.mass * kStandardGravity),
        center_of_mass_O_(perturbation.center_of_mass_O),
        contacts_(with_friction_of(perturbation, joined_contacts(hands))),
        hand_(joined_torques(hands)) {}

  Weighed(const CompiledScene& scene, const Trial& trial, const Perturbation& perturbation = {})
      : Weighed(std::array<HoldingHand, 1>{{{scene, trial}}}, perturbation) {}

  // The least sum of normal forces; infinite where nothing balances the weight.
  double least_sum(const Vector3& down_O) const {
    if (has_cup(contacts_)) return vacuum_spent(down_O, ForceMeasure::sum_of_normals).sum();
    const ContactForces forces = balancing_forces(contacts_, frame_, wrench(down_O), kSum);
    return balances(forces, kSum) ? forces.sum_of_normals : kInfinite;
  }

  LoadCase load_case(const Vector3& down_O) const {
    LoadCase load_case{down_O, kInfinite, kInfinite, 0.0};
    if (has_cup(contacts_)) {
      load_case.sum_of_normals = vacuum_spent(down_O, ForceMeasure::sum_of_normals).sum();
      load_case.largest_normal = vacuum_spent(down_O, ForceMeasure::largest_normal).maxCoeff();
      load_case.strength = strength(down_O);
      return load_case;
    }
    const ContactForces forces = balancing_forces(contacts_, frame_, wrench(down_O), kSum);
    if (!balances(forces, kSum)) return load_case;
    load_case.sum_of_normals = forces.sum_of_normals;
    load_case.largest_normal = least_largest(down_O);
    load_case.strength = strength(down_O);
    return load_case;
  }

  // LoadCase::strength.
  double strength(const Vector3& down_O) const {
    if (has_cup(contacts_)) return times_sucked(down_O);
    const double most = std::min(kMostTimes, kLargestLoad / weight_);
    const double times = times_borne(contacts_, frame_, wrench(down_O), hand_, most);
    return times < most ? times : kInfinite;
  }

  bool is_borne(const Vector3& down_O) const {
    if (has_cup(contacts_)) return times_sucked(down_O) >= 1.0;
    // A little more than the whole, so that rounding does not decide.
    return times_borne(contacts_, frame_, wrench(down_O), hand_, 1.01) >= 1.0;
  }

 private:
  static constexpr ForceOptions kSum{.measure = ForceMeasure::sum_of_normals};

  Wrench wrench(const Vector3& down_O) const {
    Wrench wrench = Wrench::Zero();
    wrench.head<3>() = weight_ * down_O;
    wrench.tail<3>() = frame_.torque_scale * center_of_mass_O_.cross(Vector3(wrench.head<3>()));
    return wrench;
  }

  CupForces cup_forces_of(const Vector3& down_O, ForceMeasure measure) const {
    return cup_forces(contacts_, frame_, wrench(down_O), measure, CupUnit::newtons);
  }

  // How many times the weight the vacuum of all cups holds: each has its own.
  double times_sucked(const Vector3& down_O) const {
    const CupForces forces = cup_forces_of(down_O, ForceMeasure::largest_normal);
    return forces.outcome == ForceOutcome::balanced ? 1.0 / forces.measure : 0.0;
  }

  // The vacuum force of each cup that would do [N]; infinite where nothing balances the weight.
  Eigen::VectorXd vacuum_spent(const Vector3& down_O, ForceMeasure measure) const {
    const CupForces forces = cup_forces_of(down_O, measure);
    Eigen::VectorXd spent = forces.spent;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      spent[static_cast<Eigen::Index>(i)] *= contacts_[i].vacuum;
    }
    if (forces.outcome != ForceOutcome::balanced) spent.setConstant(kInfinite);
    return spent;
  }

  // Forces may be good although the solver could not prove how good.
  static bool balances(const ContactForces& forces, const ForceOptions& options) {
    return forces.outcome != ForceOutcome::impossible &&
           forces.residual <= options.residual_tolerance;
  }

  double least_largest(const Vector3& down_O) const {
    const ForceOptions options;
    const ContactForces forces = balancing_forces(contacts_, frame_, wrench(down_O), options);
    return balances(forces, options) ? forces.largest_normal : kInfinite;
  }

  // A weight that is borne so many times loads no drive but by rounding.
  static constexpr double kMostTimes = 1e6;

  const WrenchFrame& frame_;
  double weight_;             // N
  Vector3 center_of_mass_O_;  // from the torque origin [m]
  std::vector<Contact> contacts_;
  HandTorques hand_;
};

}  // namespace

HandTorques hand_torques(const CompiledScene& scene, const Trial& trial) {
  const Robot& hand = scene.scene.hand;
  const std::vector<JointAxis> axes = joint_axes(hand, trial.joints);
  const Eigen::Index contacts = std::ssize(trial.contacts);
  Eigen::MatrixXd velocities = Eigen::MatrixXd::Zero(3 * contacts, std::ssize(axes));
  Eigen::MatrixXd turning = Eigen::MatrixXd::Zero(contacts, std::ssize(axes));
  for (Eigen::Index i = 0; i < contacts; ++i) {
    const GraspContact& contact = trial.contacts[index(i)];
    for (int j = hand.links[index(contact.link)].joint; j >= 0; j = hand.joints[index(j)].parent) {
      const Vector3 axis_O = trial.X_OH.linear() * axes[index(j)].direction_H;
      auto velocity = velocities.block<3, 1>(3 * i, j);
      if (hand.joints[index(j)].type == JointType::prismatic) {
        velocity = axis_O;
        continue;
      }
      velocity = axis_O.cross(contact.point.position - trial.X_OH * axes[index(j)].point_H);
      turning(i, j) = axis_O.dot(contact.point.normal);
    }
  }
  const DriveLoads loads = drive_loads(hand);
  return {velocities * loads.of_joints, loads.limits, turning * loads.of_joints};
}

PayloadMargin payload_margin(const CompiledScene& scene, const Trial& trial,
                             const RunContext& context) {
  const Weighed weighed(scene, trial);
  const std::vector<Attitude> all = attitudes();
  std::vector<double> sums;  // of the vertices
  Vector3 worst_O = Vector3::Zero();
  double largest = -1.0;
  for (const Attitude& attitude : all) {
    context.cancellation.check();
    const auto& [from, to] = attitude.ends;
    // Sums of forces for both ends of an edge balance the sum of both weights: the middle needs no
    // more. Most middles cannot be the worst by that, and are not computed.
    if (from >= 0) {
      const double length = (all[index(from)].down_O + all[index(to)].down_O).norm();
      if (sums[index(from)] + sums[index(to)] <= length * largest) continue;
    }
    const double sum = weighed.least_sum(attitude.down_O);
    if (from < 0) sums.push_back(sum);
    if (sum <= largest) continue;
    largest = sum;
    worst_O = attitude.down_O;
    if (std::isinf(sum)) break;
  }
  return {weighed.load_case(given_down(scene)), weighed.load_case(worst_O)};
}

double weight_strength(const CompiledScene& scene, const Trial& trial) {
  return Weighed(scene, trial).strength(given_down(scene));
}

double weight_strength(std::span<const HoldingHand> hands) {
  return Weighed(hands).strength(given_down(hands.front().scene));
}

bool can_lift(const CompiledScene& scene, const Trial& trial, const Perturbation& perturbation) {
  return Weighed(scene, trial, perturbation).is_borne(given_down(scene));
}

}  // namespace prehend
