#include "sim/trial/payload_margin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "sim/base/gravity.h"
#include "sim/base/index.h"
#include "sim/quality/forces.h"
#include "sim/quality/ranges.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/grasp_contacts.h"

namespace prehend {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// The strength is known to this part of itself.
constexpr double kStrengthStep = 1.01;

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

// The vertices of an icosahedron and the middles of its edges, on the unit sphere.
std::vector<Vector3> attitudes() {
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  std::vector<Vector3> all;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-golden, golden}) {
      for (int turn = 0; turn < 3; ++turn) {
        Vector3 corner = Vector3::Zero();
        corner[(turn + 1) % 3] = a;
        corner[(turn + 2) % 3] = b;
        all.push_back(corner.normalized());
      }
    }
  }
  const std::size_t corners = all.size();
  // Neighbours are 63 degrees apart, others at least 116.
  for (std::size_t i = 0; i < corners; ++i) {
    for (std::size_t j = i + 1; j < corners; ++j) {
      if (all[i].dot(all[j]) > 0.0) all.push_back((all[i] + all[j]).normalized());
    }
  }
  return all;
}

// Where gravity pulls as the object lies.
Vector3 given_down(const CompiledScene& scene) {
  return scene.scene.object.X_WO.linear().transpose() * -Vector3::UnitZ();
}

// The contacts of one grasp and the weight on them.
class Weighed {
 public:
  Weighed(const CompiledScene& scene, const Trial& trial, double friction = 1.0,
          const Vector3& center_of_mass_O = Vector3::Zero())
      : frame_(scene.wrench_frame),
        weight_(scene.scene.object.mass * kStandardGravity),
        center_of_mass_O_(center_of_mass_O),
        contacts_(contacts_of(trial.contacts)),
        hand_(hand_torques(scene, trial)) {
    for (Contact& contact : contacts_) contact.friction *= friction;
  }

  // The least sum of normal forces; infinite where nothing balances the weight.
  double least_sum(const Vector3& down_O) const {
    const ContactForces forces = balancing_forces(contacts_, frame_, wrench(down_O), kSum);
    return balances(forces, kSum) ? forces.sum_of_normals : kInfinite;
  }

  LoadCase load_case(const Vector3& down_O) const {
    LoadCase load_case{down_O, kInfinite, kInfinite, 0.0};
    const ContactForces forces = balancing_forces(contacts_, frame_, wrench(down_O), kSum);
    if (!balances(forces, kSum)) return load_case;
    load_case.sum_of_normals = forces.sum_of_normals;
    load_case.largest_normal = least_largest(down_O);
    load_case.strength = strength(down_O, forces);
    return load_case;
  }

  // Burden::strength alone.
  double strength(const Vector3& down_O) const {
    const ContactForces forces = balancing_forces(contacts_, frame_, wrench(down_O), kSum);
    return balances(forces, kSum) ? strength(down_O, forces) : 0.0;
  }

  bool bears_times(const Vector3& down_O, double times) const {
    const ContactForces forces =
        balancing_forces(contacts_, frame_, wrench(down_O, times), hand_, kSum);
    return forces.outcome == ForceOutcome::balanced;
  }

 private:
  static constexpr ForceOptions kSum{.measure = ForceMeasure::sum_of_normals};

  Wrench wrench(const Vector3& down_O, double times = 1.0) const {
    Wrench wrench = Wrench::Zero();
    wrench.head<3>() = times * weight_ * down_O;
    wrench.tail<3>() = frame_.torque_scale * center_of_mass_O_.cross(Vector3(wrench.head<3>()));
    return wrench;
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

  // Forces scale with the weight, so those of the least sum bear as much as the joint that they
  // load the most allows. Other forces may load the joints more evenly: larger weights are tried,
  // with the limits, until one cannot be borne.
  double strength(const Vector3& down_O, const ContactForces& forces) const {
    double borne = times_within_limits(forces);
    double too_much = kInfinite;
    // The first step answers for the usual grasp, of which the least forces are the best.
    double next = kStrengthStep * borne;
    const double most = std::min(kMostTimes, kLargestLoad / weight_);
    while (borne < most && too_much > kStrengthStep * borne) {
      (bears_times(down_O, next) ? borne : too_much) = next;
      next = std::isfinite(too_much) ? std::sqrt(borne * too_much) : std::min(2.0 * borne, most);
    }
    return borne < most ? borne : kInfinite;
  }

  double times_within_limits(const ContactForces& forces) const {
    const Eigen::VectorXd torques = hand_.jacobian.transpose() * forces.forces.reshaped() +
                                    hand_.spin.transpose() * forces.components.row(3).transpose();
    double times = kInfinite;
    for (Eigen::Index j = 0; j < torques.size(); ++j) {
      if (torques[j] != 0.0) times = std::min(times, hand_.limits[j] / std::abs(torques[j]));
    }
    return times;
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
  HandTorques torques;
  torques.jacobian.setZero(3 * contacts, std::ssize(axes));
  torques.spin.setZero(contacts, std::ssize(axes));
  torques.limits.resize(std::ssize(axes));
  for (Eigen::Index j = 0; j < std::ssize(axes); ++j) {
    const double effort = hand.joints[index(j)].max_effort;
    torques.limits[j] = effort > 0.0 ? effort : kInfinite;
  }
  for (Eigen::Index i = 0; i < contacts; ++i) {
    const GraspContact& contact = trial.contacts[index(i)];
    for (int j = hand.links[index(contact.link)].joint; j >= 0; j = hand.joints[index(j)].parent) {
      const Vector3 axis_O = trial.X_OH.linear() * axes[index(j)].direction_H;
      auto velocity = torques.jacobian.block<3, 1>(3 * i, j);
      if (hand.joints[index(j)].type == JointType::prismatic) {
        velocity = axis_O;
        continue;
      }
      velocity = axis_O.cross(contact.point.position - trial.X_OH * axes[index(j)].point_H);
      torques.spin(i, j) = axis_O.dot(contact.point.normal);
    }
  }
  return torques;
}

PayloadMargin payload_margin(const CompiledScene& scene, const Trial& trial,
                             const RunContext& context) {
  const Weighed weighed(scene, trial);
  Vector3 worst_O = Vector3::Zero();
  double largest = -1.0;
  for (const Vector3& down_O : attitudes()) {
    context.cancellation.check();
    const double sum = weighed.least_sum(down_O);
    if (sum <= largest) continue;
    largest = sum;
    worst_O = down_O;
    if (std::isinf(sum)) break;
  }
  return {weighed.load_case(given_down(scene)), weighed.load_case(worst_O)};
}

double weight_strength(const CompiledScene& scene, const Trial& trial) {
  return Weighed(scene, trial).strength(given_down(scene));
}

bool can_lift(const CompiledScene& scene, const Trial& trial, double friction,
              const Vector3& center_of_mass_O) {
  return Weighed(scene, trial, friction, center_of_mass_O).bears_times(given_down(scene), 1.0);
}

}  // namespace prehend
