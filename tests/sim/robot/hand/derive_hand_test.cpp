#include "sim/robot/hand/derive_hand.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/robot/files/robot_file.h"
#include "sim/robot/hand/self_collision.h"
#include "tests/sim/robot/hand/made_hand.h"

namespace prehend {
namespace {

Robot without_hand(const char* name) {
  Robot robot = find_robot(name);
  robot.hand.reset();
  for (DegreeOfFreedom& dof : robot.dofs) dof.closing_velocity = 0.0;
  return robot;
}

// A jaw's widths follow from its strokes, its origin is on the palm, its depth the pads' middle.
TEST(DerivedHand, OfAJawIsTheStatedOne) {
  for (const char* name : {"parallel_jaw", "parallel_jaw_wide"}) {
    const Robot stated = find_robot(name);
    const Robot derived = with_hand(without_hand(name));
    EXPECT_NEAR((derived.hand->approach - stated.hand->approach).norm(), 0.0, 1e-9) << name;
    EXPECT_NEAR(std::abs(derived.hand->closing.dot(stated.hand->closing)), 1.0, 1e-9) << name;
    EXPECT_NEAR((derived.hand->origin - stated.hand->origin).norm(), 0.0, 1e-9) << name;
    ASSERT_EQ(derived.hand->preshapes.size(), 1U) << name;
    const Preshape& open = derived.hand->preshapes.front();
    EXPECT_NEAR(open.max_width, stated.hand->preshapes.front().max_width, 1e-9) << name;
    EXPECT_NEAR(open.min_width, 0.0, 1e-6) << name;
    EXPECT_NEAR(open.depth, stated.hand->preshapes.front().depth, 1e-9) << name;
  }
}

// The stated closing axis may point from either finger to the other one.
TEST(DerivedHand, FitsAClosingAxisOfEitherSense) {
  for (const char* name : {"parallel_jaw", "franka_hand"}) {
    Robot robot = find_robot(name);
    const double stated = robot.hand->preshapes.front().max_width;
    robot.hand->preshapes.clear();
    for (const double sense : {1.0, -1.0}) {
      Robot turned = robot;
      turned.hand->closing = sense * robot.hand->closing;
      EXPECT_NEAR(with_hand(turned).hand->preshapes.at(0).max_width, stated, 1e-6) << name;
    }
  }
}

TEST(DerivedHand, HasTheDirectionsThatTheLibraryStates) {
  for (const char* name : {"barrett", "franka_hand"}) {
    const Robot stated = find_robot(name);
    const Robot derived = with_hand(without_hand(name));
    EXPECT_NEAR(derived.hand->approach.dot(stated.hand->approach), 1.0, 1e-9) << name;
    EXPECT_NEAR(std::abs(derived.hand->closing.dot(stated.hand->closing)), 1.0, 1e-9) << name;
    for (std::size_t d = 0; d < stated.dofs.size(); ++d) {
      const double a = stated.dofs[d].closing_velocity;
      const double b = derived.dofs[d].closing_velocity;
      EXPECT_EQ(a > 0.0, b > 0.0) << name << " " << stated.dofs[d].name;
      EXPECT_EQ(a < 0.0, b < 0.0) << name << " " << stated.dofs[d].name;
    }
  }
}

TEST(DerivedHand, HasPreshapesInsideLimitsWithoutCollisionAndOrderedWidths) {
  for (const char* name : {"barrett", "franka_hand", "parallel_jaw"}) {
    const Robot robot = with_hand(without_hand(name));
    const SelfCollision collision(robot);
    for (const Preshape& preshape : robot.hand->preshapes) {
      EXPECT_TRUE(collision.colliding(preshape.dofs).empty()) << name << " " << preshape.name;
      EXPECT_LT(preshape.min_width, preshape.max_width) << name << " " << preshape.name;
      EXPECT_GT(preshape.depth, 0.0) << name << " " << preshape.name;
      for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
        EXPECT_TRUE(within_limits(robot.dofs[d], preshape.dofs[d])) << name;
      }
    }
  }
}

TEST(DerivedHand, TurnsWithTheRobot) {
  const Robot robot = without_hand("barrett");
  const Hand hand = *with_hand(robot).hand;
  const Pose X =
      translation({0.1, -0.2, 0.3}) * Eigen::AngleAxisd(0.7, Vector3(1.0, 2.0, -0.5).normalized());
  const Hand other = *with_hand(turned_hand(robot, X)).hand;
  EXPECT_NEAR((other.approach - X.linear() * hand.approach).norm(), 0.0, 1e-9);
  EXPECT_NEAR((other.closing - X.linear() * hand.closing).norm(), 0.0, 1e-9);
  EXPECT_NEAR((other.origin - X * hand.origin).norm(), 0.0, 1e-9);
  ASSERT_EQ(other.preshapes.size(), hand.preshapes.size());
  for (std::size_t k = 0; k < hand.preshapes.size(); ++k) {
    EXPECT_NEAR(other.preshapes[k].max_width, hand.preshapes[k].max_width, 1e-9);
    EXPECT_NEAR(other.preshapes[k].min_width, hand.preshapes[k].min_width, 1e-6);
  }
}

// The gap of upright last links; of Barrett's and Robotiq's three fingers its source measures other
// points of them.
TEST(DerivedHand, OpensAndReachesAsFarAsTheLibraryStates) {
  for (const char* name : {"barrett", "franka_hand", "parallel_jaw", "parallel_jaw_wide",
                           "robotiq_2f85", "robotiq_3f"}) {
    const double stated = find_robot(name).hand->preshapes.front().max_width;
    const Robot derived = with_hand(without_hand(name));
    EXPECT_NEAR(derived.hand->preshapes.front().max_width, stated, 0.1 * stated) << name;
  }
  for (const char* name : {"barrett", "franka_hand", "robotiq_2f85"}) {
    const Robot stated = find_robot(name);
    const double depth = stated.hand->preshapes.front().depth;
    const Robot derived = with_hand(without_hand(name));
    EXPECT_NEAR(derived.hand->preshapes.front().depth, depth, 0.1 * depth) << name;
  }
}

// The palm of hands like a human's faces what the fingers close on, not where they point.
TEST(DerivedHand, FacesWithThePalm) {
  for (const char* name : {"allegro", "shadow_like"}) {
    const Robot stated = find_robot(name);
    const Robot derived = with_hand(without_hand(name));
    EXPECT_GT(derived.hand->approach.dot(stated.hand->approach), 0.94) << name;
    EXPECT_GT(std::abs(derived.hand->closing.dot(stated.hand->closing)), 0.9) << name;
  }
}

// Whatever axes and frames the joints are written with, and turned as a whole.
TEST(DerivedHand, OfMadeFingersFacesWhereTheyBend) {
  constexpr int kHands = 6;
  Random random(5);
  for (int hand = 0; hand < kHands; ++hand) {
    const std::vector<MadeFinger> fingers = random_fingers(random);
    const std::size_t joints = joint_count(fingers);
    const Robot robot = with_hand(made_hand(fingers, random_writings(random, joints)));
    EXPECT_GT(robot.hand->approach.x(), 0.7) << hand;
    EXPECT_GT(std::abs(robot.hand->closing.z()), 0.7) << hand;
    const Preshape& open = robot.hand->preshapes.front();
    EXPECT_GT(open.max_width, 0.05) << hand;
    EXPECT_LT(open.max_width, 0.2) << hand;
    EXPECT_GT(open.depth, 0.01) << hand;
  }
}

void expect_same_hand(const Hand& hand, const Hand& other, const Pose& X, const std::string& what) {
  EXPECT_NEAR((other.approach - X.linear() * hand.approach).norm(), 0.0, 1e-6) << what;
  EXPECT_NEAR((other.closing - X.linear() * hand.closing).norm(), 0.0, 1e-6) << what;
  EXPECT_NEAR((other.origin - X * hand.origin).norm(), 0.0, 1e-6) << what;
  ASSERT_EQ(other.preshapes.size(), hand.preshapes.size()) << what;
  for (std::size_t k = 0; k < hand.preshapes.size(); ++k) {
    EXPECT_NEAR(other.preshapes[k].max_width, hand.preshapes[k].max_width, 1e-6) << what;
    EXPECT_NEAR(other.preshapes[k].min_width, hand.preshapes[k].min_width, 1e-6) << what;
    EXPECT_NEAR(other.preshapes[k].depth, hand.preshapes[k].depth, 1e-6) << what;
  }
}

Pose random_turn(Random& random) {
  const Matrix3 R = random.rotation();
  return translation(random.uniform(0.0, 0.3) * Vector3(1.0, -2.0, 0.5)) * Pose(R);
}

// Also of fingers that swing sideways as far to one side as to the other, with joints whose zero is
// anywhere.
TEST(DerivedHand, OfMadeFingersIsTheSameHoweverJointsAreWritten) {
  constexpr int kHands = 6;
  Random random(6);
  for (int hand = 0; hand < kHands; ++hand) {
    std::vector<MadeFinger> fingers = random_fingers(random);
    for (MadeFinger& finger : fingers) finger.abducts = hand % 2 == 0;
    const std::size_t joints = joint_count(fingers);
    const Robot plain = with_hand(made_hand(fingers, std::vector<Writing>(joints)));
    const Pose X = random_turn(random);
    const std::vector<Writing> writings =
        with_random_starts(random, random_writings(random, joints));
    const Robot other = with_hand(turned_hand(made_hand(fingers, writings), X));
    expect_same_hand(*plain.hand, *other.hand, X, "hand " + std::to_string(hand));
  }
}

TEST(DerivedHand, OfAMadeFixedJawIsTheSameHoweverItsJointIsWritten) {
  constexpr int kHands = 20;
  Random random(7);
  for (int hand = 0; hand < kHands; ++hand) {
    const double opening = random.uniform(0.03, 0.1);
    const Robot plain = with_hand(made_fixed_jaw(opening, {}));
    EXPECT_GT(plain.hand->approach.z(), 0.9) << hand;
    EXPECT_NEAR(plain.hand->preshapes.front().max_width, opening, 1e-6) << hand;
    const Pose X = random_turn(random);
    const Writing writing = with_random_starts(random, random_writings(random, 1)).front();
    const Robot other = with_hand(turned_hand(made_fixed_jaw(opening, writing), X));
    expect_same_hand(*plain.hand, *other.hand, X, "jaw " + std::to_string(hand));
  }
}

// Each was closed on spheres, cylinders and boxes.
TEST(DerivedHand, OffersPreshapesThatHoldTestBodies) {
  for (const char* name : {"barrett", "franka_hand", "robotiq_2f85"}) {
    const Robot robot = with_hand(without_hand(name));
    const auto held = std::count_if(robot.notes.begin(), robot.notes.end(), [](const auto& note) {
      return note.find("held when closed on test bodies") != std::string::npos;
    });
    EXPECT_EQ(held, static_cast<std::ptrdiff_t>(robot.hand->preshapes.size())) << name;
  }
}

// Its pads hang on linkages, whose levers are no fingers.
TEST(DerivedHand, OfALinkageOpensAsWideAsStated) {
  const Robot stated = find_robot("robotiq_2f85");
  const Robot derived = with_hand(without_hand("robotiq_2f85"));
  EXPECT_NEAR(derived.hand->preshapes.front().max_width, stated.hand->preshapes.front().max_width,
              1e-3);
  EXPECT_GT(derived.dofs.front().closing_velocity, 0.0);
}

// As files of GraspIt! do: approach and origin, no closing axis, no preshapes.
TEST(DerivedHand, KeepsWhatIsStated) {
  const Robot stated = find_robot("barrett");
  Robot robot = stated;
  robot.hand->closing = Vector3::Zero();
  robot.hand->preshapes.clear();
  const Vector3 origin = stated.hand->origin + Vector3(0.001, 0.002, 0.003);
  robot.hand->origin = origin;
  const Robot derived = with_hand(robot);
  EXPECT_EQ(derived.hand->approach, stated.hand->approach);
  EXPECT_EQ(derived.hand->origin, origin);
  EXPECT_NEAR(std::abs(derived.hand->closing.dot(stated.hand->closing)), 1.0, 1e-9);
  EXPECT_FALSE(derived.hand->preshapes.empty());
  for (std::size_t d = 0; d < stated.dofs.size(); ++d) {
    EXPECT_EQ(derived.dofs[d].closing_velocity, stated.dofs[d].closing_velocity);
  }
}

TEST(DerivedHand, ClosesWhereTheStatedVelocitiesOpenIt) {
  Robot robot = without_hand("parallel_jaw");
  const Robot stated = find_robot("parallel_jaw");
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    robot.dofs[d].closing_velocity = -stated.dofs[d].closing_velocity;
  }
  const Robot derived = with_hand(robot);
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    EXPECT_GT(derived.dofs[d].closing_velocity * stated.dofs[d].closing_velocity, 0.0);
  }
  EXPECT_NEAR(derived.hand->preshapes.front().max_width, stated.hand->preshapes.front().max_width,
              1e-9);
}

// Robots that state all of a hand stay as they are.
TEST(DerivedHand, IsNotDerivedWhereItIsStated) {
  for (const std::string& name : library_robot_names()) {
    const Robot robot = find_robot(name);
    if (!robot.hand) continue;
    const Robot same = with_hand(robot);
    EXPECT_EQ(same.notes, robot.notes) << name;
    EXPECT_EQ(same.hand->preshapes.size(), robot.hand->preshapes.size()) << name;
  }
}

TEST(DerivedHand, OfAnArmIsRefused) {
  try {
    (void)with_hand(find_robot("puma560"));
    FAIL() << "an arm is no hand";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "puma560: hand: nothing that could grasp: its joints branch nowhere");
  }
}

// Strategies that a file states without preshapes stay; else there is a gentle one.
TEST(DeriveHand, StatedStrategiesStay) {
  Robot robot = find_robot("barrett");
  const std::vector<ClosingStrategy> stated = robot.hand->strategies;
  ASSERT_EQ(stated.size(), 2U);
  robot.hand->preshapes.clear();
  const Hand hand = *with_hand(robot).hand;
  ASSERT_FALSE(hand.preshapes.empty());
  ASSERT_EQ(hand.strategies.size(), 2U);
  EXPECT_EQ(hand.strategies[1].name, stated[1].name);
  robot.hand->strategies.clear();
  EXPECT_EQ(with_hand(robot).hand->strategies.size(), 1U);
}

}  // namespace
}  // namespace prehend
