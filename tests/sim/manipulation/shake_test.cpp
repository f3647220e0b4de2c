#include "sim/manipulation/shake.h"

#include <gtest/gtest.h>

#include "sim/base/range.h"
#include "sim/manipulation/grasp_world.h"
#include "sim/manipulation/test_procedure_file.h"
#include "sim/motion/dynamic_grasp/hand_drives.h"
#include "sim/motion/dynamic_grasp/resting.h"
#include "sim/motion/step_world.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/make_scene.h"
#include "sim/shape/basic_shapes.h"
#include "sim/trial/candidate.h"
#include "sim/trial/run_trial.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

// A cube between the jaws of the library's parallel jaw, held across its middle.
class HeldCube : public ::testing::Test {
 protected:
  static constexpr double kEdge = 0.04;

  static CompiledScene scene_of(double mass, bool on_post = false) {
    Scene scene = make_scene(
        make_graspable("cube", make_box(Vector3::Constant(kEdge)), Material::plastic, mass),
        "parallel_jaw");
    if (on_post) {
      StaticBody post{.name = "post", .mesh = make_box({0.02, 0.02, 0.1})};  // between the pads
      post.X_WB = translation({0.0, 0.0, -0.5 * (kEdge + 0.1) - 1e-4});
      scene.obstacles.push_back(std::move(post));
    }
    return compile(std::move(scene));
  }

  // The hand comes from above; its palm stays clear of the cube.
  static Trial closed(const CompiledScene& scene) {
    const Hand& hand = *scene.scene.hand.hand;
    const double depth = hand.preshapes.front().depth;
    Matrix3 R_HG;
    R_HG << hand.closing, hand.approach.cross(hand.closing), hand.approach;
    Matrix3 R_OG;
    R_OG << Vector3::UnitX(), Vector3::UnitY(), -Vector3::UnitZ();
    R_OG.col(1) = R_OG.col(2).cross(R_OG.col(0));
    Candidate candidate;
    const Matrix3 R_OH = R_OG * R_HG.transpose();
    candidate.X_OH = pose_from(R_OH, -R_OH * (hand.origin + depth * hand.approach));
    candidate.approach_O = -Vector3::UnitZ();
    candidate.approach_distance = 0.02;
    candidate.preshape = 0;
    return run_trial(scene, candidate);
  }

  static TestProcedure hanging(double friction, double seconds) {
    TestProcedure procedure{.name = "hanging", .source = "test"};
    procedure.friction = friction;
    procedure.prepare = {{.kind = PhaseKind::close, .duration = 0.5}};
    ProcedurePhase hold{.kind = PhaseKind::hold, .duration = seconds};
    hold.gravity = Vector3(0.0, 0.0, -9.81);
    hold.fails.moved = 0.01;
    procedure.tests = {{"gravity", {hold}}};
    return procedure;
  }
};

TEST_F(HeldCube, HangsWhereFrictionBearsItsWeightAndFallsWhereItDoesNot) {
  const CompiledScene scene = scene_of(0.1);
  const Trial trial = closed(scene);
  ASSERT_EQ(trial.outcome, Outcome::stable);
  const auto hand = hand_model(scene);
  // The drive moves both pads, which share its effort.
  const double press = hand->effort[0] / hand->joints_of.col(0).cwiseAbs().sum();
  const double needed = 0.1 * 9.81 / (2.0 * press);
  const ShakeReport holds = shake_grasp(scene, hand, posture_of(trial), hanging(1.1 * needed, 1.0));
  EXPECT_TRUE(holds.holds());
  EXPECT_LT(holds.tests.back().phases.back().moved, 1e-5);
  const ShakeReport falls = shake_grasp(scene, hand, posture_of(trial), hanging(0.9 * needed, 1.0));
  EXPECT_FALSE(falls.holds());
  EXPECT_EQ(falls.tests.back().outcome, ShakeOutcome::moved);
  ASSERT_TRUE(falls.tests.back().first_slip.has_value());
  // With the friction that is there it falls with a tenth of g.
  EXPECT_NEAR(falls.tests.back().failed_at, std::sqrt(2.0 * 0.01 / (0.1 * 9.81)), 0.01);
}

// Nothing new comes where all rests under a load that stays as it is. What slides with a thousandth
// of g is no rest, and a load that grows has to be borne to the end.
TEST_F(HeldCube, IsNoLongerWatchedWhereItRestsForGood) {
  const CompiledScene scene = scene_of(0.1);
  const GraspPosture grasp = posture_of(closed(scene));
  const auto hand = hand_model(scene);
  const double press = hand->effort[0] / hand->joints_of.col(0).cwiseAbs().sum();
  const double needed = 0.1 * 9.81 / (2.0 * press);
  const auto held = [&](const TestProcedure& procedure) {
    return shake_grasp(scene, hand, grasp, procedure).tests.back();
  };
  const ShakeTestReport rests = held(hanging(1.1 * needed, 5.0));
  EXPECT_EQ(rests.outcome, ShakeOutcome::survived);
  EXPECT_GE(rests.phases.back().seconds, 0.1);
  EXPECT_LT(rests.phases.back().seconds, 0.3);
  const ShakeTestReport slides = held(hanging(0.999 * needed, 5.0));
  EXPECT_EQ(slides.outcome, ShakeOutcome::moved);
  TestProcedure tugged = hanging(1.1 * needed, 0.5);
  tugged.tests.front().phases.front().pull = Vector3(0.0, 0.001, 0.0);
  tugged.tests.front().phases.front().pull_grows = true;
  EXPECT_NEAR(held(tugged).phases.back().seconds, 0.5, 1e-9);
}

// An object that tips over starts as slowly as one that rests.
TEST_F(HeldCube, DoesNotRestWhereItGetsFaster) {
  const CompiledScene scene = scene_of(0.1);
  GraspWorld grasped =
      make_grasp_world(scene, hand_model(scene), posture_of(closed(scene)), hanging(0.5, 1.0));
  grasped.world.robots.front().rate.setZero();
  Vector3& velocity = grasped.world.bodies.front().motion.linear;
  const auto rests_at = [&](double growth) {
    Resting resting(RestLimits{.slowest = 1e-5, .time = 0.1, .slows_down = true});
    velocity = Vector3(1e-9, 0.0, 0.0);
    for (int step = 1; step < 300; ++step, velocity *= growth) {
      if (resting.look(grasped.world, grasped.hand, 0.0025)) return step;
    }
    return 0;
  };
  EXPECT_NEAR(rests_at(1.0), 40, 1);
  EXPECT_NEAR(rests_at(0.9), 40, 1);
  EXPECT_EQ(rests_at(1.025), 0);
}

// But the one that pulls until the grasp gives way.
TEST_F(HeldCube, SurvivesEveryProtocolOfTheLibrary) {
  const CompiledScene floats = scene_of(0.1);
  const CompiledScene stands = scene_of(0.1, true);
  const Trial trial = closed(floats);
  const auto hand = hand_model(floats);
  for (const std::string& name : library_test_procedure_names()) {
    const TestProcedure procedure = read_test_procedure(find_test_procedure(name));
    const CompiledScene& scene = procedure.on_support ? stands : floats;
    const ShakeReport report = shake_grasp(scene, hand, posture_of(trial), procedure);
    EXPECT_EQ(report.holds(), name != "strength") << name;
    EXPECT_EQ(report.largest_pull().has_value(), name == "strength") << name;
    EXPECT_EQ(report.count(), static_cast<int>(procedure.tests.size()));
    EXPECT_EQ(report.effort.crossings, 0) << name;
  }
}

// Bodies move straight within a step, and the hand on an arc.
TEST_F(HeldCube, StaysWhereItIsInAHandThatTurns) {
  const CompiledScene scene = scene_of(0.1);
  GraspWorld grasped =
      make_grasp_world(scene, hand_model(scene), posture_of(closed(scene)), hanging(0.5, 1.0));
  World& world = grasped.world;
  WorldRobot& robot = world.robots.front();
  set_hand_drives(closing_drives(*robot.model, grasped.hand), grasped.hand, robot);
  const auto step = [&](int steps) {
    for (int i = 0; i < steps; ++i) ASSERT_EQ(step_world(world).outcome, StepOutcome::moved);
  };
  const auto in_hand = [&] { return Pose(robot.X_WB.inverse() * world.bodies[0].motion.X_WB); };
  step(200);
  const Pose before = in_hand();
  robot.base_angular = {3.0, 0.0, 0.0};  // about the axis on which the pads close
  step(400);
  EXPECT_LT((in_hand().translation() - before.translation()).norm(), 1e-6);
}

TEST_F(HeldCube, DoesNotStandOnNothing) {
  const CompiledScene scene = scene_of(0.1);
  const GraspPosture grasp = posture_of(closed(scene));
  TestProcedure procedure = hanging(1.0, 1.0);
  procedure.on_support = true;
  const InputError refusal =
      test::refusal_of([&] { shake_grasp(scene, hand_model(scene), grasp, procedure); });
  EXPECT_EQ(refusal.field(), "on_support");
}

// Two pads bear a pull of a = 2 mu N / m between them. What grows beyond by k a second accelerates
// the cube by k t, so that it has moved by k t^3 / 6 when the pull is a + k t.
TEST_F(HeldCube, BearsAGrowingPullAsFarAsFrictionSays) {
  const CompiledScene scene = scene_of(0.1);
  const GraspPosture grasp = posture_of(closed(scene));
  const auto hand = hand_model(scene);
  const double press = hand->effort[0] / hand->joints_of.col(0).cwiseAbs().sum();
  constexpr double kFriction = 0.2;
  constexpr double kFarthest = 0.002;
  const double bears = 2.0 * kFriction * press / 0.1;
  TestProcedure procedure{.name = "tug", .source = "test"};
  procedure.friction = kFriction;
  procedure.prepare = {{.kind = PhaseKind::close, .duration = 0.5}};
  ProcedurePhase tug{.kind = PhaseKind::hold, .duration = 2.0};
  tug.pull = Vector3(0.0, 2.0 * bears, 0.0);
  tug.pull_grows = true;
  tug.fails.moved = kFarthest;
  ProcedurePhase weaker = tug;
  weaker.pull = Vector3(0.0, 0.0, 0.5 * bears);
  procedure.tests = {{"tug", {tug}}, {"weaker", {weaker}}};
  const ShakeReport report = shake_grasp(scene, hand, grasp, procedure);
  ASSERT_EQ(report.tests.size(), 3U);
  const double growth = bears;  // twice that in two seconds
  const double beyond = growth * std::cbrt(6.0 * kFarthest / growth);
  EXPECT_EQ(report.tests[1].outcome, ShakeOutcome::moved);
  EXPECT_NEAR(report.tests[1].largest_pull.value_or(0.0), bears + beyond, 0.01 * bears);
  EXPECT_EQ(report.tests[2].outcome, ShakeOutcome::survived);
  EXPECT_NEAR(report.tests[2].largest_pull.value_or(0.0), 0.5 * bears, 1e-9);
  EXPECT_EQ(report.largest_pull(), report.tests[2].largest_pull);
}

TEST_F(HeldCube, WhatIsShakenTwiceMovesTheSame) {
  const CompiledScene scene = scene_of(0.1);
  const GraspPosture grasp = posture_of(closed(scene));
  const auto hand = hand_model(scene);
  const TestProcedure procedure = read_test_procedure(find_test_procedure("acronym"));
  const ShakeReport a = shake_grasp(scene, hand, grasp, procedure);
  const ShakeReport b = shake_grasp(scene, hand, grasp, procedure);
  ASSERT_EQ(a.tests.size(), b.tests.size());
  for (std::size_t t = 0; t < a.tests.size(); ++t) {
    for (std::size_t p = 0; p < a.tests[t].phases.size(); ++p) {
      EXPECT_EQ(a.tests[t].phases[p].moved, b.tests[t].phases[p].moved);
      EXPECT_EQ(a.tests[t].phases[p].turned, b.tests[t].phases[p].turned);
    }
  }
}

// About the axis on which the fingers close: across it they would give way, since each of them is
// driven by its own effort alone.
TEST_F(HeldCube, ATurningHandTakesItsObjectAlong) {
  const CompiledScene scene = scene_of(0.1);
  const GraspPosture grasp = posture_of(closed(scene));
  TestProcedure procedure{.name = "turning", .source = "test"};
  procedure.friction = 1.0;
  procedure.prepare = {{.kind = PhaseKind::close, .duration = 0.5}};
  ProcedurePhase turn{.kind = PhaseKind::turn, .duration = 2.0};
  turn.axis = Vector3::UnitX();
  turn.amplitude = 0.5;
  turn.frequency = 1.0;
  procedure.tests = {{"turn", {turn}}};
  const ShakeReport report = shake_grasp(scene, hand_model(scene), grasp, procedure);
  EXPECT_LT(report.tests.back().phases[0].moved, 1e-4);
  EXPECT_LT(report.tests.back().phases[0].turned, 1e-3);
}

TEST_F(HeldCube, AnObjectWithoutMassCannotBeShaken) {
  CompiledScene scene = scene_of(0.1);
  const GraspPosture grasp = posture_of(closed(scene));
  scene.scene.object.mass = 0.0;
  const TestProcedure procedure = hanging(1.0, 0.1);
  const auto hand = hand_model(scene);
  EXPECT_EQ(test::refusal_of([&] { (void)shake_grasp(scene, hand, grasp, procedure); }).field(),
            "cube");
}

}  // namespace
}  // namespace prehend
