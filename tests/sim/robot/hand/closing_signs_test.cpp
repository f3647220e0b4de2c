#include "sim/robot/hand/closing_signs.h"

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

constexpr int kPhalanges = 3;

// Where a finger begins, towards what it bends, and its sizes.
struct MadeFinger {
  std::string name;
  Pose X_BF = Pose::Identity();  // z along the finger, bends about y towards x
  std::vector<double> lengths;   // of its phalanges [m]
};

// How a joint is written: with the opposite axis, and with its frame turned.
struct Writing {
  bool flipped = false;
  Matrix3 R = Matrix3::Identity();
};

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

// A palm in the plane y z with two to four fingers at its upper edge, which bend towards x, and a
// thumb that stands out of it and bends towards them.
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

// Each finger closes over the long part of its range, whatever its joints' axes and frames are.
TEST(ClosingSigns, DoNotDependOnHowJointsAreWritten) {
  constexpr int kHands = 200;
  Random random(3);
  for (int hand = 0; hand < kHands; ++hand) {
    const std::vector<MadeFinger> fingers = random_fingers(random);
    std::vector<Writing> writings(kPhalanges * fingers.size());
    for (Writing& writing : writings) {
      writing.flipped = random.uniform() < 0.5;
      writing.R = random.rotation();
    }
    const Robot robot = made_hand(fingers, writings);
    const std::vector<int> signs = find_closing_signs(robot, find_hand_parts(robot));
    for (std::size_t d = 0; d < signs.size(); ++d) {
      EXPECT_EQ(signs[d], writings[d].flipped ? -1 : 1) << hand << " " << robot.dofs[d].name;
    }
  }
}

// Two jaws that turn without end: the ranges say nothing, the tips do.
TEST(ClosingSigns, OfJointsWithoutEndBringTheTipsTogether) {
  Robot robot{.name = "made"};
  robot.links.push_back(
      {.name = "palm", .material = "plastic", .mesh = make_box({0.1, 0.04, 0.03})});
  for (const double side : {-1.0, 1.0}) {
    const std::string name = side < 0.0 ? "left" : "right";
    const int joint = static_cast<int>(robot.joints.size());
    robot.joints.push_back({.name = name,
                            .X_PJ = translation({0.04 * side, 0.0, 0.02}),
                            .axis = Vector3::UnitY(),
                            .lower = -6.28,
                            .upper = 6.28,
                            .dof = joint,
                            .chain = joint});
    robot.dofs.push_back({.name = name, .lower = -6.28, .upper = 6.28});
    robot.links.push_back(
        {.name = name,
         .material = "plastic",
         .joint = joint,
         .mesh = transformed(make_box({0.01, 0.02, 0.08}), translation({0.0, 0.0, 0.045}))});
    robot.chains.push_back({.name = name, .first_joint = joint, .joint_count = 1});
  }
  EXPECT_EQ(find_closing_signs(robot, find_hand_parts(robot)), (std::vector<int>{1, -1}));
}

}  // namespace
}  // namespace prehend
