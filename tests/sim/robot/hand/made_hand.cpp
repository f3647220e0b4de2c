#include "tests/sim/robot/hand/made_hand.h"

#include <numbers>
#include <string>

#include "sim/base/index.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

// Appends a finger whose joints bend from -0.2 to 1.6 rad.
void add_finger(const MadeFinger& finger, const std::vector<Writing>& writings, Robot& robot) {
  int parent = -1;
  Pose X = finger.X_BF;  // of the next joint, not turned, in the frame of the one before
  for (int k = 0; k < kPhalanges; ++k) {
    const Writing& writing = writings[robot.joints.size()];
    const double length = finger.lengths[index(k)];
    const Matrix3 back = writing.R.transpose();
    const std::string name = finger.name + std::to_string(k);
    const int joint = static_cast<int>(robot.joints.size());
    robot.joints.push_back({.name = name,
                            .X_PJ = X * Pose(writing.R),
                            .axis = (writing.flipped ? -1.0 : 1.0) * (back * Vector3::UnitY()),
                            .lower = writing.flipped ? -1.6 : -0.2,
                            .upper = writing.flipped ? 0.2 : 1.6,
                            .dof = joint,
                            .parent = parent,
                            .chain = static_cast<int>(robot.chains.size())});
    robot.dofs.push_back(
        {.name = name, .lower = robot.joints.back().lower, .upper = robot.joints.back().upper});
    const TriangleMesh bone =
        transformed(make_box({0.014, 0.014, 0.9 * length}), translation({0.0, 0.0, 0.5 * length}));
    robot.links.push_back({.name = name,
                           .material = "plastic",
                           .joint = joint,
                           .mesh = transformed(bone, Pose(back))});
    X = Pose(back) * translation({0.0, 0.0, length});
    parent = joint;
  }
  robot.chains.push_back({.name = finger.name,
                          .first_joint = static_cast<int>(robot.joints.size()) - kPhalanges,
                          .joint_count = kPhalanges});
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

Robot made_hand(const std::vector<MadeFinger>& fingers, const std::vector<Writing>& writings) {
  Robot robot{.name = "made"};
  robot.links.push_back(
      {.name = "palm", .material = "plastic", .mesh = make_box({0.03, 0.11, 0.1})});
  for (const MadeFinger& finger : fingers) add_finger(finger, writings, robot);
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

}  // namespace prehend
