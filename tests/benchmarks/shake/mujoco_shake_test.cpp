#include "benchmarks/shake/mujoco_shake.h"

#include <cmath>

#include <gtest/gtest.h>

#include "benchmarks/shake/mujoco_world.h"
#include "planner/plan/plan.h"
#include "planner/plan/plan_options.h"
#include "planner/show/exports/export_files.h"
#include "planner/show/exports/export_formats.h"
#include "planner/show/exports/mjcf.h"
#include "sim/base/input_error.h"
#include "tests/support/held_cube.h"
#include "tests/support/library_scenes.h"

namespace prehend::bench {
namespace {

constexpr double kGravity = 9.81;

std::string model_of(const CompiledScene& scene, const Candidate& candidate, const Trial& trial) {
  ScoredGrasp grasp;
  grasp.trial = trial;
  grasp.candidate = candidate;
  const MjcfShapes shapes = mjcf_shapes(scene, {.tolerance = 4e-3, .relative_tolerance = 1.0});
  return mjcf_text(scene, shapes, export_of(scene, grasp, 1));
}

// A cube of 50 mm on which the hand comes from above and closes along x.
struct Held {
  CompiledScene scene;
  Trial trial;
  std::string model;
};

Held held_by(const Robot& hand, double palm) {
  Held held{test::compiled(hand, make_box(Vector3::Constant(test::kCube))), {}, {}};
  Candidate candidate = test::from_above();
  candidate.X_OH.translation().z() = palm;
  if (hand.name == "franka_hand") {  // which closes along y
    candidate.X_OH.linear() =
        candidate.X_OH.linear() * Eigen::AngleAxisd(0.5 * M_PI, Vector3::UnitZ());
  }
  held.trial = run_trial(held.scene, candidate);
  EXPECT_EQ(held.trial.outcome, Outcome::stable);
  held.model = model_of(held.scene, candidate, held.trial);
  return held;
}

Held held_by(const std::string& hand, double palm) { return held_by(find_robot(hand), palm); }

TestProcedure hanging(double mass, double friction) {
  TestProcedure procedure;
  procedure.name = "hanging";
  procedure.object.mass = mass;
  procedure.friction = friction;
  procedure.gravity = {0.0, 0.0, -kGravity};
  procedure.prepare = {
      {.kind = PhaseKind::close, .duration = 0.5, .gravity = Vector3(0.0, 0.0, 0.0)}};
  procedure.tests = {{"hang",
                      {{.kind = PhaseKind::hold, .duration = 1.0},
                       {.kind = PhaseKind::hold, .duration = 2.0, .fails = {.moved = 0.02}}}}};
  return procedure;
}

// 0.1 kg between two pads of 10 N each and friction 0.5, ten times what is needed: it neither
// creeps nor sinks in. What remains of creep is what the search for forces leaves.
TEST(MujocoShake, ABoxBetweenTwoPadsHangsStill) {
  Robot jaw = find_robot("parallel_jaw");
  for (Joint& joint : jaw.joints) joint.max_effort = 10.0;
  const Held held = held_by(jaw, 0.05);
  const ShakeResult result = shake_in_mujoco(held.model, hanging(0.1, 0.5), subject_of(held.scene));
  ASSERT_TRUE(result.survived());
  const PhaseMeasure& last = result.tests.at(0).phases.at(1).measure;
  EXPECT_LT(last.moved / 2.0, 0.5e-6);
  EXPECT_LT(last.deepest, 20e-6);
  EXPECT_GT(last.deepest, 0.0);
  EXPECT_TRUE(last.in_contact);
}

// Two pads of a force N carry at most 2 mu N.
TEST(MujocoShake, AGripperHoldsWhatItsFrictionCarries) {
  for (const auto& [hand, palm, force] :
       {std::tuple("franka_hand", 0.105, 70.0), std::tuple("parallel_jaw", 0.05, 20.0)}) {
    const Held held = held_by(hand, palm);
    const double mass = 0.015 * force;
    const double least = mass * kGravity / (2.0 * force);
    const ShakeSubject subject = subject_of(held.scene);
    const ShakeResult firm = shake_in_mujoco(held.model, hanging(mass, 1.3 * least), subject);
    EXPECT_TRUE(firm.survived()) << hand;
    EXPECT_LT(firm.tests.at(0).phases.at(1).measure.moved, 1e-3) << hand;
    const ShakeResult loose = shake_in_mujoco(held.model, hanging(mass, 0.7 * least), subject);
    ASSERT_FALSE(loose.survived()) << hand;
    EXPECT_EQ(loose.tests.at(0).phases.at(1).failure, PhaseFailure::moved) << hand;
    EXPECT_FALSE(loose.tests.at(0).phases.at(1).measure.in_contact) << hand;
  }
}

// A swing of 4 cm at 2 Hz needs 6.3 m/s^2 at its ends: without gravity, friction for half of that
// lets the object go, and for twice of that it does not. So contacts feel how the base moves.
TEST(MujocoShake, ASwingNeedsItsAcceleration) {
  const Held held = held_by("parallel_jaw", 0.05);
  TestProcedure swing;
  swing.object.mass = 1.0;
  swing.prepare = {{.kind = PhaseKind::close, .duration = 0.5}};
  ProcedurePhase phase{.kind = PhaseKind::swing, .duration = 2.0};
  phase.axis = Vector3::UnitZ();
  phase.amplitude = 0.04;
  phase.frequency = 2.0;
  phase.fails.moved = 2e-3;
  swing.tests = {{"swing", {phase}}};
  const double needed = 0.04 * std::pow(4.0 * M_PI, 2.0) / (2.0 * 20.0);
  for (const double part : {0.5, 2.0}) {
    swing.friction = part * needed;
    const ShakeResult result = shake_in_mujoco(held.model, swing, subject_of(held.scene));
    EXPECT_EQ(result.survived(), part > 1.0) << part;
    if (part > 1.0) {
      EXPECT_LT(result.tests.at(0).phases.at(0).measure.moved, 1e-5);
    }
  }
}

TEST(MujocoShake, ALiftCarriesTheObjectAlongAndOpeningDropsIt) {
  const Held held = held_by("parallel_jaw", 0.05);
  TestProcedure lift = hanging(0.2, 0.5);
  lift.tests = {
      {"lift",
       {{.kind = PhaseKind::lift, .duration = 1.0, .height = 0.3, .fails = {.least_rise = 0.29}},
        {.kind = PhaseKind::circle,
         .duration = 1.5,
         .amplitude = 0.01,
         .frequency = 2.0,
         .fails = {.dropped = 1e-3}},
        {.kind = PhaseKind::open, .duration = 0.5, .fails = {.least_fall = 0.05}}}}};
  const ShakeResult result = shake_in_mujoco(held.model, lift, subject_of(held.scene));
  ASSERT_TRUE(result.survived());
  const auto& phases = result.tests.at(0).phases;
  EXPECT_NEAR(phases[0].measure.rise, 0.3, 1e-3);
  EXPECT_LT(phases[0].measure.moved, 1e-4);
  EXPECT_LT(phases[1].measure.moved, 1e-4);
  EXPECT_FALSE(phases[2].measure.in_contact);
}

// A push of 50 N along the closing axis is more than the 20 N of a finger, whose gear holds it.
TEST(MujocoShake, AGearKeepsAFingerFromBeingPushedBack) {
  const Held held = held_by("parallel_jaw", 0.05);
  TestProcedure push = hanging(0.2, 0.5);
  push.gravity.setZero();
  push.tests = {{"push", {{.kind = PhaseKind::hold, .duration = 1.0, .pull = {250.0, 0.0, 0.0}}}}};
  ShakeSubject subject = subject_of(held.scene);
  const auto moved = [&] {
    return shake_in_mujoco(held.model, push, subject).tests.at(0).phases.at(0).measure.moved;
  };
  EXPECT_GT(moved(), 5e-3);
  for (const Joint& joint : held.scene.scene.hand.joints) {
    subject.locks.push_back({joint.name, -1.0});
  }
  EXPECT_LT(moved(), 1e-3);
  subject.locks.push_back({"no_such_joint", 1.0});
  EXPECT_THROW(moved(), InputError);
}

TEST(MujocoShake, TheSameRunGivesTheSameNumbers) {
  const Held held = held_by("parallel_jaw", 0.05);
  const ShakeSubject subject = subject_of(held.scene);
  const ShakeResult a = shake_in_mujoco(held.model, hanging(0.3, 0.5), subject);
  const ShakeResult b = shake_in_mujoco(held.model, hanging(0.3, 0.5), subject);
  EXPECT_EQ(a.tests.at(0).phases.at(1).measure.moved, b.tests.at(0).phases.at(1).measure.moved);
}

// Every link of the exported hand is where forward kinematics has it.
TEST(MujocoWorld, AMugInTheBarrettHandIsWhereTheGraspHasIt) {
  const CompiledScene scene = test::compiled_library_scene("mug");
  PlanOptions options;
  options.search.trials = 40;
  options.rank.top = 1;
  options.volumes = false;
  const PlanResult result = plan(scene, options);
  ASSERT_EQ(result.grasps.size(), 1U);
  const ScoredGrasp& grasp = result.grasps.front();
  const std::string model = model_of(scene, grasp.candidate, grasp.trial);
  MujocoWorld world(model);
  world.start({.overlap = 1.0});  // whatever the pieces overlap
  std::vector<Pose> X_BL;
  link_poses(scene.scene.hand, grasp.trial.joints, X_BL);
  const Pose X_WH = scene.scene.object.X_WO * grasp.trial.X_OH;
  EXPECT_LT((world.base().matrix() - X_WH.matrix()).norm(), 1e-9);
  EXPECT_LT((world.object().matrix() - scene.scene.object.X_WO.matrix()).norm(), 1e-9);
  for (std::size_t l = 0; l < X_BL.size(); ++l) {
    const Pose X = world.body(scene.scene.hand.links[l].name);
    EXPECT_LT((X.matrix() - (X_WH * X_BL[l]).matrix()).norm(), 1e-7) << l;
  }
}

// As anybody would use the file: the hand carries its own weight and the object's on the weld.
TEST(MujocoWorld, AnExportedGraspHoldsAsSoonAsItIsLoaded) {
  EXPECT_LT(drift_as_loaded(held_by("parallel_jaw", 0.05).model, 1.0), 2e-4);
  EXPECT_LT(drift_as_loaded(held_by("franka_hand", 0.105).model, 1.0), 2e-4);
}

// Whoever steps a file from its pre-grasp finds the hand as open as it is there.
TEST(MujocoShake, ThePregraspStaysOpen) {
  for (const auto& [hand, palm] : {std::pair{"barrett", 0.12}, std::pair{"franka_hand", 0.105},
                                   std::pair{"parallel_jaw", 0.05}}) {
    EXPECT_LT(joint_drift(held_by(hand, palm).model, "pregrasp", 1.6), 5e-3) << hand;
  }
}

TEST(MujocoWorld, RefusesWhatMujocoRefuses) {
  EXPECT_THROW(MujocoWorld("<mujoco><worldbody><geom size=\"-1\"/></worldbody></mujoco>"),
               InputError);
  EXPECT_THROW(MujocoWorld("<mujoco/>"), InputError);
}

}  // namespace
}  // namespace prehend::bench
