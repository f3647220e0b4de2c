#include "sim/robot/sound_robot.h"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/number_text.h"
#include "sim/base/range.h"

namespace prehend {
namespace {

// Lengths of axes are 1 up to rounding.
constexpr double kUnit = 1e-9;
// Poses are multiplied along the path to a joint, one call inside the other.
constexpr std::size_t kMostJoints = 1000;
constexpr Range kInertia{.lower = -kLargestMass * kFarthest * kFarthest,
                         .upper = kLargestMass * kFarthest * kFarthest};

void require_chain(const Robot& robot, const Chain& chain, const std::string& place) {
  const int last = chain.first_joint + chain.joint_count - 1;
  const auto fail = [&](const std::string& problem) {
    throw InputError({place, "chain " + chain.name, problem});
  };
  if (chain.first_joint < 0 || chain.joint_count < 1 ||
      last >= static_cast<int>(robot.joints.size())) {
    fail("names joints that the robot does not have");
  }
  for (int j = chain.first_joint + 1; j <= last; ++j) {
    if (robot.joints[index(j)].parent != j - 1) {
      fail("joint " + robot.joints[index(j)].name + " does not follow the one before it");
    }
  }
}

void require_tree(const Robot& robot, const std::string& place) {
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    const auto fail = [&](const std::string& problem) {
      throw InputError({place, "joint " + joint.name, problem});
    };
    if (joint.parent < -1 || joint.parent >= static_cast<int>(j)) {
      fail("must stand after its parent joint");
    }
    if (!(std::abs(joint.axis.norm() - 1.0) < kUnit)) fail("axis must be of length 1");
    if (joint.dof < 0 || joint.dof >= static_cast<int>(robot.dofs.size())) {
      fail("no degree of freedom drives it");
    }
  }
  for (const Link& link : robot.links) {
    if (link.joint < -1 || link.joint >= static_cast<int>(robot.joints.size())) {
      throw InputError({place, "link " + link.name, "follows no joint of the robot"});
    }
  }
  for (const RobotFrame& frame : robot.frames) {
    if (frame.joint < -1 || frame.joint >= static_cast<int>(robot.joints.size())) {
      throw InputError({place, "frame " + frame.name, "follows no joint of the robot"});
    }
  }
  for (const Chain& chain : robot.chains) require_chain(robot, chain, place);
  const int links = static_cast<int>(robot.links.size());
  for (const SuctionCup& cup : robot.hand ? robot.hand->cups : std::vector<SuctionCup>{}) {
    if (0 <= cup.link && cup.link < links && robot.links[index(cup.link)].joint < 0) continue;
    throw InputError({place, "hand", "a cup is on no link of the base"});
  }
  for (const auto& [a, b] : robot.exempt_pairs) {
    if (0 <= a && a < b && b < links) continue;
    throw InputError({place, "exempt_pairs", "not two links, the lower one first"});
  }
}

// The numbers of one part of a robot; `place` is the robot or its file.
class PartNumbers {
 public:
  PartNumbers(const std::string& place, std::string part) : place_(place), part_(std::move(part)) {}

  void require(std::string_view what, const Range& range, double value) const {
    if (range.contains(value)) return;
    throw InputError(
        {place_, part_, std::string(what) + " " + range.words(), shortest_text(value)});
  }
  void require(std::string_view what, const Range& range,
               const std::optional<double>& value) const {
    if (value) require(what, range, *value);
  }
  template <typename Derived>
  void require(std::string_view what, const Range& range,
               const Eigen::MatrixBase<Derived>& values) const {
    for (Eigen::Index c = 0; c < values.cols(); ++c) {
      for (Eigen::Index r = 0; r < values.rows(); ++r) require(what, range, values(r, c));
    }
  }

 private:
  const std::string& place_;
  std::string part_;
};

void require_numbers(const std::string& place, const Joint& joint) {
  const PartNumbers numbers(place, "joint " + joint.name);
  numbers.require("each coordinate", kCoordinate, joint.X_PJ.translation());
  numbers.require("each coordinate", kCoordinate, joint.X_JA.translation());
  numbers.require("zero", kCoordinate, joint.zero);
  numbers.require("lower limit", kCoordinate, joint.lower);
  numbers.require("upper limit", kCoordinate, joint.upper);
  if (joint.ratio != 0.0 || joint.across < 0) {
    numbers.require("size of the ratio", kRatioSize, std::abs(joint.ratio));
  }
  numbers.require("ahead", kCoordinate, joint.ahead);
  numbers.require("offset", kCoordinate, joint.offset);
  numbers.require("effort", kEffort, joint.max_effort);
  numbers.require("friction", kEffort, joint.friction.coulomb);
  numbers.require("viscous friction", kGain, joint.friction.viscous);
  numbers.require("stiffness of its spring", kGain, joint.spring.stiffness);
  numbers.require("rest of its spring", kCoordinate, joint.spring.rest);
}

void require_numbers(const std::string& place, const DegreeOfFreedom& dof) {
  const PartNumbers numbers(place, "degree of freedom " + dof.name);
  numbers.require("lower limit", kCoordinate, dof.lower);
  numbers.require("upper limit", kCoordinate, dof.upper);
  numbers.require("initial value", kCoordinate, dof.initial);
  numbers.require("closing velocity", kVelocity, dof.closing_velocity);
  numbers.require("velocity", kRate, dof.max_velocity);
  numbers.require("acceleration", kRate, dof.max_acceleration);
  numbers.require("breakaway effort", kEffort, dof.breakaway_effort);
  numbers.require("stiffness", kGain, dof.stiffness);
  numbers.require("damping", kGain, dof.damping);
}

void require_numbers(const std::string& place, const Link& link) {
  const PartNumbers numbers(place, "link " + link.name);
  numbers.require("mass", {.upper = kLargestMass}, link.inertial.mass);
  numbers.require("centre of mass", kCoordinate, link.inertial.center_of_mass);
  numbers.require("inertia", kInertia, link.inertial.inertia);
  for (const Vector3& vertex : link.mesh.vertices)
    numbers.require("each vertex", kCoordinate, vertex);
}

void require_numbers(const std::string& place, const RobotFrame& frame) {
  const PartNumbers numbers(place, "frame " + frame.name);
  numbers.require("each coordinate", kCoordinate, frame.X_AF.translation());
}

void require_numbers(const std::string& place, const Hand& hand) {
  const PartNumbers numbers(place, "hand");
  numbers.require("origin", kCoordinate, hand.origin);
  for (const SuctionCup& cup : hand.cups) {
    numbers.require("position of a cup", kCoordinate, cup.position);
    numbers.require("radius of a cup", kLengthAbove0, cup.radius);
    numbers.require("lip_stiffness of a cup", kGainAbove0, cup.lip_stiffness);
    numbers.require("travel of a cup", kLengthAbove0, cup.travel);
    numbers.require("pull of a cup", kEffortAbove0, cup.pull);
    numbers.require("strain of a cup", kFractionAbove0, cup.strain);
  }
  for (const Preshape& preshape : hand.preshapes) {
    const PartNumbers own(place, "preshape " + preshape.name);
    own.require("width", kDistance, preshape.min_width);
    own.require("width", kDistance, preshape.max_width);
    own.require("depth", kDistance, preshape.depth);
  }
}

}  // namespace

void require_sound(const Robot& robot) { require_sound(robot, robot.name); }

void require_sound(const Robot& robot, const std::string& place) {
  if (robot.joints.size() > kMostJoints) {
    throw InputError({place, "joints", "more than " + std::to_string(kMostJoints)});
  }
  require_tree(robot, place);
  for (const Joint& joint : robot.joints) require_numbers(place, joint);
  for (const DegreeOfFreedom& dof : robot.dofs) require_numbers(place, dof);
  for (const Link& link : robot.links) require_numbers(place, link);
  for (const RobotFrame& frame : robot.frames) require_numbers(place, frame);
  if (robot.hand) require_numbers(place, *robot.hand);
}

}  // namespace prehend
