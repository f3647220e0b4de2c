#include "planner/plan/path/grasp_motion.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "planner/plan/path/closing_path.h"
#include "planner/plan/path/grasp_path.h"
#include "sim/base/index.h"
#include "tests/support/block_on_table.h"
#include "tests/support/held_cube.h"

namespace prehend {
namespace {

using test::block_on_table;
using test::held_cube;
using test::HeldCube;
using test::motion_of;

void expect_sound(const GraspMotion& motion) {
  ASSERT_FALSE(motion.frames.empty());
  EXPECT_EQ(motion.frames.front().time, 0.0);
  for (std::size_t i = 1; i < motion.frames.size(); ++i) {
    EXPECT_LT(motion.frames[i - 1].time, motion.frames[i].time) << i;
  }
  ASSERT_FALSE(motion.segments.empty());
  int end = 0;
  for (const TrajectorySegment& segment : motion.segments) {
    EXPECT_EQ(segment.first, end);
    EXPECT_LE(segment.first, segment.last);
    end = segment.last;
  }
  EXPECT_EQ(index(motion.segments.back().last) + 1, motion.frames.size());
}

// The hand before its approach: moved back by what it travelled.
Pose pre_grasp(const Candidate& candidate, const Trial& trial) {
  return translation(-trial.travel * candidate.approach_O) * trial.X_OH;
}

TEST(GraspMotion, AFreeHandComesStraightAndEndsInTheGrasp) {
  const HeldCube held = held_cube();
  ASSERT_EQ(held.trial.outcome, Outcome::stable);
  const GraspMotion motion = grasp_motion(held.scene, test::from_above(), held.trial, nullptr);
  expect_sound(motion);
  const MotionFrame& first = motion.frames.front();
  const MotionFrame& last = motion.frames.back();
  EXPECT_EQ(first.X_OH.matrix(), pre_grasp(test::from_above(), held.trial).matrix());
  EXPECT_EQ(first.joints,
            joint_values(held.scene.scene.hand, held.scene.scene.hand.hand->preshapes[0].dofs));
  EXPECT_EQ(last.X_OH.matrix(), held.trial.X_OH.matrix());
  EXPECT_EQ(last.joints, held.trial.joints);
  for (const MotionFrame& frame : motion.frames) EXPECT_TRUE(frame.arm_joints.empty());
  ASSERT_EQ(motion.segments.size(), 2U);
  const MotionFrame& closes = motion.frames[index(motion.segments[1].first)];
  EXPECT_NEAR(closes.time, held.trial.travel / 0.1, 1e-12);
  EXPECT_EQ(closes.X_OH.matrix(), held.trial.X_OH.matrix());
  EXPECT_EQ(closes.joints, first.joints);
}

TEST(GraspMotion, AHandThatIsThereAndClosedIsOneFrame) {
  HeldCube held = held_cube();
  held.trial.travel = 0.0;
  Candidate there = test::from_above();
  EXPECT_GT(grasp_motion(held.scene, there, held.trial, nullptr).frames.size(), 1U);
  there.preshape.reset();
  there.joints = held.trial.joints;
  const GraspMotion motion = grasp_motion(held.scene, there, held.trial, nullptr);
  expect_sound(motion);
  EXPECT_EQ(motion.frames.size(), 1U);
  EXPECT_EQ(motion.frames.front().joints, held.trial.joints);
}

// A hand that is stopped before it moves has nothing to show but where it is.
TEST(GraspMotion, ABlockedHandStands) {
  const HeldCube held = held_cube({test::obstacle(make_box({0.5, 0.5, 0.02}), Vector3(0, 0, 0.1))});
  ASSERT_EQ(held.trial.outcome, Outcome::hand_blocked);
  const GraspMotion motion = motion_of(held);
  expect_sound(motion);
  EXPECT_EQ(motion.frames.size(), 1U);
  EXPECT_EQ(motion.frames.back().X_OH.matrix(), held.trial.X_OH.matrix());
  EXPECT_EQ(motion.frames.back().joints, held.trial.joints);
}

class ArmMotion : public testing::Test {
 protected:
  static const CompiledScene& scene() {
    static const CompiledScene kScene = compile(block_on_table());
    return kScene;
  }
  static const test::Grasp& grasp() {
    static const test::Grasp kGrasp = test::stable_grasp(scene());
    return kGrasp;
  }
  static GraspMotion motion(const Trajectory* path = nullptr) {
    return grasp_motion(scene(), grasp().candidate, grasp().trial, path);
  }

  // The hand comes along one straight line, and stands still while it closes.
  static void expect_approach(const GraspMotion& motion) {
    std::size_t count = 0;
    while (count < motion.segments.size() && motion.segments[count].name != "close") ++count;
    ++count;
    ASSERT_GE(count, 2U);
    ASSERT_LE(count, motion.segments.size());
    EXPECT_EQ(motion.segments[count - 2].name, "approach");
    EXPECT_EQ(motion.segments[count - 1].name, "close");
    const Pose from = pre_grasp(grasp().candidate, grasp().trial);
    double behind = grasp().trial.travel + 1e-9;
    for (int i = motion.segments[count - 2].first; i <= motion.segments[count - 1].last; ++i) {
      const Pose& X_OH = motion.frames[index(i)].X_OH;
      const double left = (grasp().trial.X_OH.translation() - X_OH.translation()).norm();
      EXPECT_LE(left, behind + 1e-6) << i;
      behind = left;
      const Vector3 way = X_OH.translation() - from.translation();
      EXPECT_LT(way.cross(grasp().candidate.approach_O).norm(), 1e-3) << i;
    }
    EXPECT_LT(behind, 1e-6);
  }
};

TEST_F(ArmMotion, WithoutAPathTheArmCarriesTheHandAlongItsApproach) {
  const GraspMotion found = motion();
  expect_sound(found);
  expect_approach(found);
  EXPECT_EQ(found.segments.size(), 2U);
  EXPECT_GT(found.segments.front().last, 5);
  const MotionFrame& first = found.frames.front();
  EXPECT_TRUE(first.X_OH.isApprox(pre_grasp(grasp().candidate, grasp().trial), 1e-6));
  const MotionFrame& last = found.frames.back();
  EXPECT_TRUE(last.X_OH.isApprox(grasp().trial.X_OH, 1e-6));
  EXPECT_EQ(last.joints, grasp().trial.joints);
  EXPECT_EQ(last.arm_joints,
            arm_joints(*scene().arm, grasp().trial.arm_dofs, grasp().trial.joints));
  for (const MotionFrame& frame : found.frames) {
    EXPECT_EQ(frame.arm_joints.size(), scene().arm->robot().joints.size());
  }
}

// An arm that reached in another posture than the nearest to its start is shown in that posture.
TEST_F(ArmMotion, ShowsTheBranchOfTheTrialNotTheNearest) {
  const CompiledScene& scene = test::block_in_the_air();
  const auto [candidate, trial] = test::grasp_in_the_farther_posture(scene);
  const HandLine line = approach_line(scene, candidate, trial);
  const std::vector<DofValues>& other = trial.arm_line;
  ASSERT_FALSE(other.empty());
  ASSERT_NE(other, find_reach(*scene.arm, line, {}).line);
  const GraspMotion found = grasp_motion(scene, candidate, trial, nullptr);
  expect_sound(found);
  for (std::size_t i = 0; i < other.size(); ++i) {
    EXPECT_EQ(found.frames[i].arm_joints, arm_joints(*scene.arm, other[i], line.hand_joints)) << i;
  }
  EXPECT_EQ(found.frames.back().arm_joints, arm_joints(*scene.arm, trial.arm_dofs, trial.joints));
}

TEST_F(ArmMotion, WhereOnlyTheLastPostureIsKnownTheArmStandsThere) {
  Trial trial = grasp().trial;
  trial.arm_line = {trial.arm_dofs};
  const GraspMotion found = grasp_motion(scene(), grasp().candidate, trial, nullptr);
  expect_sound(found);
  for (const MotionFrame& frame : found.frames) {
    EXPECT_TRUE(frame.X_OH.isApprox(trial.X_OH, 1e-6));
  }
}

// The last posture of the segment "close".
const std::vector<double>& at_grasp(const Trajectory& path) {
  for (const TrajectorySegment& segment : path.segments) {
    if (segment.name == "close") return path.positions[index(segment.last)];
  }
  return path.positions.back();
}

// Where the trial reached in another posture than the nearest to the start, so does the path.
TEST_F(ArmMotion, APathEndsInThePostureOfTheTrial) {
  const CompiledScene& scene = test::block_in_the_air();
  const auto [candidate, trial] = test::grasp_in_the_farther_posture(scene);
  GraspPathOptions options;
  options.alternatives = 1;
  const auto path = plan_grasp_path(scene, candidate, trial, options);
  ASSERT_TRUE(path.has_value());
  EXPECT_EQ(at_grasp(path->motion), arm_joints(*scene.arm, trial.arm_dofs, trial.joints));
}

TEST_F(ArmMotion, WhereTheArmDidNotReachTheHandFlies) {
  Trial trial = grasp().trial;
  trial.arm_line.clear();
  trial.arm_dofs.clear();
  const GraspMotion found = grasp_motion(scene(), grasp().candidate, trial, nullptr);
  expect_sound(found);
  EXPECT_EQ(found.frames.back().X_OH.matrix(), trial.X_OH.matrix());
  for (const MotionFrame& frame : found.frames) EXPECT_TRUE(frame.arm_joints.empty());
}

TEST_F(ArmMotion, APathIsShownAsItIs) {
  const auto path = plan_grasp_path(scene(), grasp().candidate, grasp().trial);
  ASSERT_TRUE(path.has_value());
  const GraspMotion found = motion(&path->motion);
  expect_sound(found);
  expect_approach(found);
  ASSERT_EQ(found.frames.size(), path->motion.times.size());
  const MotionFrame& grasped = found.frames[found.grasp()];
  EXPECT_EQ(grasped.arm_joints, at_grasp(path->motion));
  for (std::size_t i = 0; i < found.frames.size(); ++i) {
    EXPECT_EQ(found.frames[i].time, path->motion.times[i]);
    EXPECT_EQ(found.frames[i].arm_joints, path->motion.positions[i]);
  }
  EXPECT_TRUE(grasped.X_OH.isApprox(grasp().trial.X_OH, 1e-6));
  const std::vector<double>& joints = grasped.joints;
  ASSERT_EQ(joints.size(), grasp().trial.joints.size());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    EXPECT_NEAR(joints[j], grasp().trial.joints[j], 1e-9);
  }
  // The object stands until it is grasped, and is then at rest in the hand.
  EXPECT_EQ(path->lift, LiftEnd::complete);
  for (std::size_t i = 0; i < found.frames.size(); ++i) {
    const MotionFrame& frame = found.frames[i];
    const Pose X_HC = frame.X_OH.inverse() * frame.X_OC;
    if (i <= found.grasp()) {
      EXPECT_EQ(frame.X_OC.matrix(), Pose::Identity().matrix()) << i;
    } else {
      EXPECT_TRUE(X_HC.isApprox(grasped.X_OH.inverse(), 1e-9)) << i;
    }
  }
  EXPECT_GT(found.frames.back().X_OC.translation().norm(), 0.05);
  const GraspMotion few = thinned(found, 40);
  expect_sound(few);
  EXPECT_EQ(few.frames[few.grasp()].arm_joints, grasped.arm_joints);
  EXPECT_EQ(few.frames.back().arm_joints, found.frames.back().arm_joints);
}

// Frames that say which they are.
GraspMotion numbered(const std::vector<int>& ends) {
  GraspMotion motion;
  for (int i = 0; i <= ends.back(); ++i) {
    motion.frames.push_back({0.01 * i, translation(Vector3(i, 0, 0)), {1.0 / (i + 3)}});
  }
  int first = 0;
  for (const int last : ends) {
    motion.segments.push_back({"segment " + std::to_string(last), first, last});
    first = last;
  }
  return motion;
}

int number_of(const MotionFrame& frame) {
  return static_cast<int>(std::lround(frame.X_OH.translation().x()));
}

void expect_thinned(const GraspMotion& motion, int most) {
  const GraspMotion few = thinned(motion, most);
  expect_sound(few);
  EXPECT_LE(few.frames.size(), index(most) + motion.segments.size());
  ASSERT_EQ(few.segments.size(), motion.segments.size());
  for (std::size_t s = 0; s < motion.segments.size(); ++s) {
    EXPECT_EQ(few.segments[s].name, motion.segments[s].name);
    EXPECT_EQ(number_of(few.frames[index(few.segments[s].first)]), motion.segments[s].first);
    EXPECT_EQ(number_of(few.frames[index(few.segments[s].last)]), motion.segments[s].last);
  }
  const int widest = (static_cast<int>(motion.frames.size()) + most - 1) / most;
  int before = 0;
  for (const MotionFrame& frame : few.frames) {
    const MotionFrame& whole = motion.frames[index(number_of(frame))];
    EXPECT_EQ(frame.time, whole.time);
    EXPECT_EQ(frame.joints, whole.joints);
    EXPECT_LE(number_of(frame) - before, widest);
    before = number_of(frame);
  }
}

TEST(Thinned, KeepsTheEndsOfSegmentsAndTheOrder) {
  Random random(31);
  for (int round = 0; round < 300; ++round) {
    std::vector<int> ends;
    int end = 0;
    for (std::size_t s = 0; s < 1 + random.index(5); ++s) {
      end += static_cast<int>(random.index(random.index(2) == 0 ? 3 : 400));
      ends.push_back(end);
    }
    for (const int most : {2, 3, 10, 160, 5000}) {
      SCOPED_TRACE(testing::Message() << testing::PrintToString(ends) << " to " << most);
      expect_thinned(numbered(ends), most);
    }
  }
}

TEST(Thinned, AMotionThatIsShortEnoughIsTheSame) {
  const GraspMotion motion = numbered({7, 7, 19});
  EXPECT_EQ(thinned(motion, 20).frames.size(), motion.frames.size());
}

// Postures between `from` and `to` in which no joint turns back or is faster than it closes.
void expect_closing(const Robot& hand, const std::vector<double>& from,
                    const std::vector<double>& to) {
  const ClosingPath path = closing_path(hand, from, to);
  ASSERT_EQ(path.times.size(), path.postures.size());
  EXPECT_EQ(path.times.front(), 0.0);
  EXPECT_EQ(path.postures.front(), from);
  EXPECT_EQ(path.postures.back(), to);
  for (std::size_t i = 1; i < path.times.size(); ++i) {
    const double seconds = path.times[i] - path.times[i - 1];
    EXPECT_GT(seconds, 0.0);
    for (std::size_t j = 0; j < from.size(); ++j) {
      const Joint& joint = hand.joints[j];
      const double closes =
          joint.ratio * hand.dofs[static_cast<std::size_t>(joint.dof)].closing_velocity;
      const double way = to[j] - from[j];
      const double step = path.postures[i][j] - path.postures[i - 1][j];
      EXPECT_GE(step * way, -1e-15) << hand.joints[j].name;
      // What does not close goes its way in one second.
      const double rate = closes * way > 0.0 ? std::abs(closes) : std::abs(way);
      EXPECT_LE(std::abs(step), rate * seconds + 1e-12) << hand.joints[j].name;
    }
  }
}

TEST(ClosingPath, EveryHandGoesOneWayAndEndsWhereItShould) {
  Random random(32);
  for (const std::string& name : library_robot_names()) {
    const Robot hand = find_robot(name);
    if (!hand.hand) continue;
    SCOPED_TRACE(name);
    for (int round = 0; round < 50; ++round) {
      std::vector<double> from;
      std::vector<double> to;
      for (const Joint& joint : hand.joints) {
        from.push_back(random.uniform(joint.lower, joint.upper));
        to.push_back(random.index(4) == 0 ? from.back() : random.uniform(joint.lower, joint.upper));
      }
      expect_closing(hand, from, to);
    }
  }
}

TEST(ClosingPath, AHandWithoutClosingVelocitiesTakesASecond) {
  Robot hand = find_robot("parallel_jaw");
  for (DegreeOfFreedom& dof : hand.dofs) dof.closing_velocity = 0.0;
  const std::vector<double> from(hand.joints.size(), 0.0);
  const std::vector<double> to(hand.joints.size(), 0.01);
  const ClosingPath path = closing_path(hand, from, to);
  EXPECT_EQ(path.times, (std::vector<double>{0.0, 1.0}));
  EXPECT_EQ(path.postures, (JointPath{from, to}));
  EXPECT_EQ(closing_path(hand, from, from).postures, (JointPath{from}));
}

}  // namespace
}  // namespace prehend
