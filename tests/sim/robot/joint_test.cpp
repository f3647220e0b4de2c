// Joints about any axis, written in both ways, in trees.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/robot/denavit_hartenberg.h"
#include "sim/robot/robot.h"
#include "sim/robot/sound_robot.h"
#include "tests/support/refusal_of.h"
#include "tests/support/trees.h"

namespace prehend {
namespace {

using Matrix4 = Eigen::Matrix4d;

// Sums of a few products of numbers up to 1: a few units in the last place each, over a few joints.
constexpr double kJointRounding = 1e-13;

DhParameters random_parameters(Random& random) {
  return {random.uniform(-3.0, 3.0), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5),
          random.uniform(-3.0, 3.0)};
}

// Every entry of the product of the four motions, written out.
Matrix4 written_out(const DhParameters& p) {
  const double ct = std::cos(p.theta);
  const double st = std::sin(p.theta);
  const double ca = std::cos(p.alpha);
  const double sa = std::sin(p.alpha);
  Matrix4 m;
  m << ct, -st * ca, st * sa, p.a * ct,  //
      st, ct * ca, -ct * sa, p.a * st,   //
      0.0, sa, ca, p.d,                  //
      0.0, 0.0, 0.0, 1.0;
  return m;
}

// Rodrigues' formula, and a shift: a motion by matrices alone.
Matrix4 motion(const Joint& joint, double amount) {
  Matrix4 m = Matrix4::Identity();
  if (joint.type == JointType::prismatic) {
    m.topRightCorner<3, 1>() = amount * joint.axis;
    return m;
  }
  Matrix3 k;
  k << 0.0, -joint.axis.z(), joint.axis.y(),  //
      joint.axis.z(), 0.0, -joint.axis.x(),   //
      -joint.axis.y(), joint.axis.x(), 0.0;
  m.topLeftCorner<3, 3>() += std::sin(amount) * k + (1.0 - std::cos(amount)) * k * k;
  return m;
}

TEST(Joint, DenavitHartenbergKeepsItsClosedFormBitForBit) {
  Random random(301);
  for (int i = 0; i < 200; ++i) {
    DhParameters p = random_parameters(random);
    const double value = random.uniform(-3.0, 3.0);
    const bool turns = i % 2 == 0;
    const Joint joint = denavit_hartenberg(
        {.name = "j", .type = turns ? JointType::revolute : JointType::prismatic}, p);
    (turns ? p.theta : p.d) += value;
    const Matrix4 expected = written_out(p);
    EXPECT_EQ(across(joint, value).matrix(), expected) << i;
  }
}

// The same arm written by axes and origins: what follows a joint belongs to the origin of the next,
// and any frame on the axis will do, with the axis named in it.
TEST(Joint, WrittenEitherWayItIsTheSameArm) {
  Random random(302);
  for (int i = 0; i < 50; ++i) {
    Robot by_parameters;
    Robot by_axes;
    Pose X_before = Pose::Identity();  // the frame of the parameters in that of the axes
    std::vector<double> values;
    for (int j = 0; j < 6; ++j) {
      const JointType type = random.uniform() < 0.3 ? JointType::prismatic : JointType::revolute;
      const Joint joint = denavit_hartenberg({.name = "j", .type = type, .parent = j - 1},
                                             random_parameters(random));
      const Matrix3 turn = random.rotation();
      const Pose X_JK = pose_from(turn, random.uniform(-0.3, 0.3) * Vector3::UnitZ());
      by_parameters.joints.push_back(joint);
      by_axes.joints.push_back({.name = "j",
                                .type = type,
                                .X_PJ = X_before * X_JK,
                                .axis = X_JK.linear().transpose() * Vector3::UnitZ(),
                                .zero = joint.zero,
                                .parent = j - 1});
      X_before = X_JK.inverse() * joint.X_JA;
      values.push_back(random.uniform(-2.0, 2.0));
    }
    std::vector<Pose> expected;
    std::vector<Pose> found;
    joint_poses(by_parameters, values, expected);
    joint_poses(by_axes, values, found);
    EXPECT_LT(((found[5] * X_before).matrix() - expected[5].matrix()).norm(),
              10.0 * kJointRounding);
  }
}

TEST(Joint, TreesFollowAProductOfMatrices) {
  Random random(303);
  for (int i = 0; i < 50; ++i) {
    const Robot robot = test::random_tree(random, 8);
    const std::vector<double> values = test::random_posture(robot, random);
    std::vector<Pose> X_BJ;
    std::vector<Pose> X_BL;
    joint_poses(robot, values, X_BJ);
    link_poses(robot, values, X_BL);
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      Matrix4 expected = Matrix4::Identity();
      for (int k = static_cast<int>(j); k >= 0; k = robot.joints[index(k)].parent) {
        const Joint& joint = robot.joints[index(k)];
        expected = joint.X_PJ.matrix() * motion(joint, values[index(k)] + joint.zero) *
                   joint.X_JA.matrix() * expected;
      }
      EXPECT_LT((X_BJ[j].matrix() - expected).norm(), kJointRounding);
      EXPECT_LT((X_BL[j + 1].matrix() - expected).norm(), kJointRounding);
    }
  }
}

TEST(Joint, SlidesAlongItsAxisAndTurnsAboutIt) {
  Random random(304);
  for (int i = 0; i < 20; ++i) {
    const Vector3 axis = random.direction();
    const Joint slide{.name = "s", .type = JointType::prismatic, .axis = axis};
    EXPECT_LT((across(slide, 0.3).translation() - 0.3 * axis).norm(), kJointRounding);
    EXPECT_EQ(across(slide, 0.3).linear(), Matrix3::Identity());
    const Joint turn{.name = "t", .axis = axis};
    EXPECT_LT((across(turn, 1.1) * axis - axis).norm(), kJointRounding);
    EXPECT_NEAR(across(turn, 1.1).linear().trace(), 1.0 + 2.0 * std::cos(1.1), kJointRounding);
  }
}

Matrix4 put_together(const AxisStep& step) {
  const Pose end =
      translation(step.beyond * Vector3::UnitZ()) * Eigen::AngleAxisd(step.twist, Vector3::UnitZ());
  return written_out(step.dh) * end.matrix();
}

TEST(StepBetweenAxes, PutTogetherIsThePoseAgain) {
  Random random(305);
  for (int i = 0; i < 200; ++i) {
    const Pose X = random.pose(0.5);
    EXPECT_LT((put_together(step_between_axes(X)) - X.matrix()).norm(), 1e-12) << i;
  }
}

TEST(StepBetweenAxes, TakesParallelAndCommonAxes) {
  Random random(306);
  for (int i = 0; i < 50; ++i) {
    Pose X(Eigen::AngleAxisd(random.uniform(-3.0, 3.0), Vector3::UnitZ()));
    if (i % 2 == 1) {
      const Vector3 across = random.index(2) == 0 ? Vector3::UnitX() : Vector3::UnitY();
      X = X * Eigen::AngleAxisd(std::numbers::pi, across);
    }
    const bool common = i % 4 < 2;
    X.translation() = common ? Vector3(0.0, 0.0, 0.2) : random.in_box(0.3);
    const AxisStep step = step_between_axes(X);
    EXPECT_LT((put_together(step) - X.matrix()).norm(), 1e-12) << i;
    EXPECT_EQ(step.dh.alpha, i % 2 == 1 ? std::numbers::pi : 0.0);
    EXPECT_EQ(step.beyond, 0.0);
    if (common) {
      EXPECT_EQ(step.dh.theta, 0.0);
    }
  }
}

TEST(StepBetweenAxes, GivesParametersAsTheyAreWritten) {
  const DhParameters p{.d = 0.149, .a = 0.0203, .alpha = -std::numbers::pi / 2.0};
  const Joint joint = denavit_hartenberg({.name = "elbow"}, p);
  const AxisStep step = step_between_axes(joint.X_JA);
  EXPECT_EQ(step.dh.theta, 0.0);
  EXPECT_EQ(step.dh.d, p.d);
  EXPECT_EQ(step.dh.a, p.a);
  EXPECT_NEAR(step.dh.alpha, p.alpha, kJointRounding);
  EXPECT_EQ(step.beyond, 0.0);
  EXPECT_EQ(step.twist, 0.0);
}

std::string refusal(const Robot& robot) {
  try {
    require_sound(robot);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SoundRobot, NamesWhatIsNoTree) {
  Random random(307);
  const Robot tree = test::random_tree(random, 4);
  EXPECT_EQ(refusal(tree), "");
  Robot robot = tree;
  robot.joints[1].parent = 1;
  EXPECT_EQ(refusal(robot), "tree: joint joint_1: must stand after its parent joint");
  robot = tree;
  robot.joints[2].axis *= 2.0;
  EXPECT_EQ(refusal(robot), "tree: joint joint_2: axis must be of length 1");
  robot = tree;
  robot.joints[3].dof = 4;
  EXPECT_EQ(refusal(robot), "tree: joint joint_3: no degree of freedom drives it");
  robot = tree;
  robot.links[1].joint = 4;
  EXPECT_EQ(refusal(robot), "tree: link link_0: follows no joint of the robot");
  robot = tree;
  robot.chains[3].joint_count = 2;
  EXPECT_EQ(refusal(robot), "tree: chain chain_3: names joints that the robot does not have");
  robot = tree;
  robot.joints[1].parent = -1;
  robot.chains[0].joint_count = 2;
  EXPECT_EQ(refusal(robot), "tree: chain chain_0: joint joint_1 does not follow the one before it");
}

TEST(SoundRobot, TellsRobotAndPartApart) {
  Random random(307);
  Robot robot = test::random_tree(random, 4);
  robot.joints[1].parent = 1;
  const InputError error = test::refusal_of([&] { require_sound(robot); });
  EXPECT_EQ(error.file(), "tree");
  EXPECT_EQ(error.field(), "joint joint_1");
}

}  // namespace
}  // namespace prehend
