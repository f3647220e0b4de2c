#include "tests/sim/robot/hand/made_hand.h"

#include <numbers>
#include <string>

#include "sim/base/index.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

// Appends a joint at X_PF in the frame of the one before it, about or along `axis`, over this range
// from where it starts. Gives the pose of the frame that is not turned, in the joint's.
Pose add_joint(const std::string& name, JointType type, const Pose& X_PF, const Vector3& axis,
               double lower, double upper, const Writing& writing, int parent, Robot& robot) {
  const int joint = static_cast<int>(robot.joints.size());
  const Matrix3 back = writing.R.transpose();
  const double first = (writing.flipped ? -upper : lower) + writing.start;
  const double last = (writing.flipped ? -lower : upper) + writing.start;
  robot.joints.push_back({.name = name,
                          .type = type,
                          .X_PJ = X_PF * Pose(writing.R),
                          .axis = (writing.flipped ? -1.0 : 1.0) * (back * axis),
                          .zero = -writing.start,
                          .lower = first,
                          .upper = last,
                          .dof = joint,
                          .parent = parent,
                          .chain = static_cast<int>(robot.chains.size())});
  robot.dofs.push_back({.name = name, .lower = first, .upper = last, .initial = writing.start});
  return Pose(back);
}

// Appends a finger whose joints bend from -0.2 to 1.6 rad.
void add_finger(const MadeFinger& finger, const std::vector<Writing>& writings, Robot& robot) {
  const int first = static_cast<int>(robot.joints.size());
  int parent = -1;
  Pose X = finger.X_BF;  // of the next joint, not turned, in the frame of the one before
  if (finger.abducts) {
    X = add_joint(finger.name + "_side", JointType::revolute, X, Vector3::UnitX(), -0.35, 0.35,
                  writings[robot.joints.size()], parent, robot);
    parent = first;
  }
  for (int k = 0; k < kPhalanges; ++k) {
    const double length = finger.lengths[index(k)];
    const std::string name = finger.name + std::to_string(k);
    const int joint = static_cast<int>(robot.joints.size());
    const Pose X_JF = add_joint(name, JointType::revolute, X, Vector3::UnitY(), -0.2, 1.6,
                                writings[robot.joints.size()], parent, robot);
    const TriangleMesh bone =
        transformed(make_box({0.014, 0.014, 0.9 * length}), translation({0.0, 0.0, 0.5 * length}));
    robot.links.push_back(
        {.name = name, .material = "plastic", .joint = joint, .mesh = transformed(bone, X_JF)});
    X = X_JF * translation({0.0, 0.0, length});
    parent = joint;
  }
  robot.chains.push_back({.name = finger.name,
                          .first_joint = first,
                          .joint_count = static_cast<int>(robot.joints.size()) - first});
}

}  // namespace

std::vector<MadeFinger> random_fingers(Random& random) {
  std::vector<MadeFinger> fingers;
  const int count = random.integer(2, 4);
  const auto lengths = [&random] {
    const double first = random.uniform(0.035, 0.05);
    return std::vector<double>{first, 0.7 * first, 0.5 * first};
  };
  const std::vector<double> alike = lengths();
  for (int f = 0; f < count; ++f) {
    const double y = 0.024 * (f - 0.5 * (count - 1));
    fingers.push_back({"finger" + std::to_string(f), translation({0.0, y, 0.05}), alike});
  }
  const double lean = random.uniform(-0.2, 0.2);
  const Pose X_BT = translation({0.02, random.uniform(-0.01, 0.01), -0.03}) *
                    Eigen::AngleAxisd(0.5 * std::numbers::pi + lean, Vector3::UnitY()) *
                    Eigen::AngleAxisd(std::numbers::pi, Vector3::UnitZ());
  fingers.push_back({"thumb", X_BT, lengths()});
  return fingers;
}

std::size_t joint_count(const std::vector<MadeFinger>& fingers) {
  std::size_t count = 0;
  for (const MadeFinger& finger : fingers) count += kPhalanges + (finger.abducts ? 1 : 0);
  return count;
}

Robot made_hand(const std::vector<MadeFinger>& fingers, const std::vector<Writing>& writings) {
  Robot robot{.name = "made"};
  robot.links.push_back(
      {.name = "palm", .material = "plastic", .mesh = make_box({0.03, 0.11, 0.1})});
  for (const MadeFinger& finger : fingers) add_finger(finger, writings, robot);
  return robot;
}

Robot made_fixed_jaw(double opening, const Writing& writing) {
  Robot robot{.name = "made"};
  const TriangleMesh jaw = transformed(make_box({0.01, 0.02, 0.05}), translation({0.0, 0.0, 0.04}));
  robot.links.push_back(
      {.name = "palm", .material = "plastic", .mesh = make_box({0.15, 0.03, 0.03})});
  const double middle = 0.5 * opening + 0.005;
  robot.links.push_back({.name = "standing",
                         .material = "plastic",
                         .mesh = transformed(jaw, translation({middle, 0.0, 0.0}))});
  const Pose X_JF = add_joint("slide", JointType::prismatic, translation({-middle, 0.0, 0.0}),
                              Vector3::UnitX(), 0.0, opening, writing, -1, robot);
  robot.links.push_back(
      {.name = "sliding", .material = "plastic", .joint = 0, .mesh = transformed(jaw, X_JF)});
  robot.chains.push_back({.name = "jaw", .first_joint = 0, .joint_count = 1});
  return robot;
}

Robot turned_hand(Robot robot, const Pose& X) {
  for (Link& link : robot.links) {
    if (link.joint < 0) link.mesh = transformed(link.mesh, X);
  }
  for (Joint& joint : robot.joints) {
    if (joint.parent < 0) joint.X_PJ = X * joint.X_PJ;
  }
  return robot;
}

std::vector<Writing> random_writings(Random& random, std::size_t joints) {
  std::vector<Writing> writings(joints);
  for (Writing& writing : writings) {
    writing.flipped = random.uniform() < 0.5;
    writing.R = random.rotation();
  }
  return writings;
}

std::vector<Writing> with_random_starts(Random& random, std::vector<Writing> writings) {
  for (Writing& writing : writings) writing.start = random.uniform(-1.0, 1.0);
  return writings;
}

}  // namespace prehend
