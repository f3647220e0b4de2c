// A drill, a hammer and a pan, held at the end and at the centre of mass: with the forces that the
// hand's drives have the end is worse; without, nothing tells them apart.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/quality/epsilon.h"
#include "sim/quality/wrench.h"
#include "sim/scene/object_mass.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/trial/grasp_contacts.h"
#include "sim/trial/payload_margin.h"
#include "sim/trial/perturbed_trials.h"
#include "sim/trial/run_trial.h"
#include "sim/trial/uncertainty.h"
#include "tests/support/published_grasps.h"
#include "tests/support/scenes.h"
#include "tests/support/shared_data.h"
#include "tests/support/test_meshes.h"

namespace prehend {
namespace {

constexpr double kWood = 700.0;     // kg/m^3
constexpr double kSteel = 7800.0;   // kg/m^3
constexpr double kHandle = 1100.0;  // of a pan, plastic [kg/m^3]

// The Franka hand driven with 20 N a finger (the default of the library frankx), so that the weight
// at the end is more than it can hold.
Robot gentle_franka() {
  Robot hand = find_robot("franka_hand");
  for (Joint& joint : hand.joints) joint.max_effort = 20.0;
  return hand;
}

// What the tests compare of a grasp.
struct Judged {
  Trial trial;
  PayloadMargin holding = {};
  Robustness robustness = {};
};

Judged judge(const CompiledScene& scene, const Candidate& candidate) {
  Judged judged{.trial = run_trial(scene, candidate)};
  if (judged.trial.contacts.empty()) return judged;
  judged.holding = payload_margin(scene, judged.trial);
  TrialWorkspace workspace;
  judged.robustness = try_perturbed(scene, candidate, judged.trial, {},
                                    perturbations(scene, {.samples = 64}, 1), workspace);
  return judged;
}

void record(const std::string& name, const Judged& judged) {
  const PayloadMargin& holding = judged.holding;
  testing::Test::RecordProperty(name + "_strength", std::to_string(holding.given.strength));
  testing::Test::RecordProperty(name + "_worst_strength", std::to_string(holding.worst.strength));
  testing::Test::RecordProperty(name + "_probability",
                                std::to_string(judged.robustness.probability()));
  std::printf("%s: strength %.2f, worst %.2f, sum of normals %.1f N, held %d of %d, epsilon %.3g\n",
              name.c_str(), holding.given.strength, holding.worst.strength,
              holding.given.sum_of_normals, judged.robustness.held, judged.robustness.samples,
              judged.trial.epsilon.lower);
}

// The Franka hand from above, its fingers closing along x around what is at height y along the
// object, their tips `deep` below z = 0.
Candidate from_above(const CompiledScene& scene, double y, double deep) {
  Candidate candidate;
  Matrix3 down;
  down << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  const double reach = scene.scene.hand.hand->origin.z() + 0.0373;
  candidate.X_OH = pose_from(down, {0.0, y, reach - deep});
  candidate.approach_O = -Vector3::UnitZ();
  candidate.approach_distance = 0.1;
  candidate.preshape = 0;
  return candidate;
}

// With the limits of the drives the grasp at the end is worse by each measure; without, both hold.
void expect_worse(const std::string& name, const Judged& end, const Judged& center) {
  record(name + "_end", end);
  record(name + "_center", center);
  for (const Judged* judged : {&end, &center}) {
    EXPECT_EQ(judged->trial.outcome, Outcome::stable) << name;
    EXPECT_GT(judged->trial.epsilon.lower, 0.0) << name;
    EXPECT_TRUE(std::isfinite(judged->holding.given.sum_of_normals)) << name;
    EXPECT_TRUE(std::isfinite(judged->holding.worst.sum_of_normals)) << name;
  }
  EXPECT_LT(2.0 * end.holding.given.strength, center.holding.given.strength) << name;
  EXPECT_LT(end.holding.worst.strength, center.holding.worst.strength) << name;
  EXPECT_LT(end.robustness.probability() + 0.25, center.robustness.probability()) << name;
  EXPECT_FALSE(end.holding.holds()) << name;
  EXPECT_TRUE(center.holding.holds()) << name;
}

Vector3 middle_of(const Judged& judged) {
  Vector3 sum = Vector3::Zero();
  for (const GraspContact& contact : judged.trial.contacts) sum += contact.point.position;
  return sum / static_cast<double>(judged.trial.contacts.size());
}

// Epsilon about the middle of the contacts: it knows neither where the mass is nor how strong the
// drives are.
double own_epsilon(const Judged& judged) {
  const WrenchFrame frame{middle_of(judged), 10.0};
  return epsilon_l1(contact_wrenches(contacts_of(judged.trial.contacts), frame)).lower;
}

// 310 mm of wood along y with a head of steel across the end.
Scene hammer() {
  TriangleMesh mesh = make_box_grid({0.024, 0.28, 0.02}, {2, 20, 2});
  append(mesh, test::moved(make_box({0.1, 0.025, 0.025}, 4), {0.0, 0.1525, 0.0}));
  Scene scene = test::scene_with(gentle_franka(), std::move(mesh));
  const MassPart head{.name = "head", .where = MeshComponent{1}, .density = kSteel};
  state_mass(scene.object, {.density = kWood, .parts = {head}});
  return scene;
}

TEST(HeldAtTheEnd, AHammerIsHeldWorse) {
  const CompiledScene scene = compile(hammer());
  const double center = scene.scene.object.center_of_mass.y();
  // Just below the head, where the uniform hammer would not be held.
  EXPECT_NEAR(center, 0.128, 1e-3);
  const Judged end = judge(scene, from_above(scene, -0.12, 0.01));
  const Judged balanced = judge(scene, from_above(scene, center, 0.01));
  expect_worse("hammer", end, balanced);
  EXPECT_NEAR(own_epsilon(end), own_epsilon(balanced), 1e-6);
}

// Of uniform density the same hammer seems to balance in the middle of its handle: that grasp comes
// out well, and does not hold the real one.
TEST(HeldAtTheEnd, OfUniformDensityTheWrongGraspSeemsBest) {
  Scene uniform = hammer();
  state_mass(uniform.object, {.mass = uniform.object.mass});
  const double seeming = uniform.object.center_of_mass.y();
  EXPECT_LT(seeming, 0.06);
  EXPECT_TRUE(long_object_of_uniform_mass(uniform.object));
  EXPECT_FALSE(long_object_of_uniform_mass(hammer().object));
  const CompiledScene believed = compile(std::move(uniform));
  const CompiledScene real = compile(hammer());
  const Judged as_believed = judge(believed, from_above(believed, seeming, 0.01));
  const Judged as_it_is = judge(real, from_above(real, seeming, 0.01));
  record("hammer_believed", as_believed);
  record("hammer_real", as_it_is);
  EXPECT_TRUE(as_believed.holding.holds());
  EXPECT_LT(as_it_is.holding.given.strength, 0.5 * as_believed.holding.given.strength);
}

// A small saucepan with what is in it, 74 mm wide, and a handle of plastic along y.
TEST(HeldAtTheEnd, APanIsHeldWorse) {
  TriangleMesh mesh = make_cylinder(0.037, 0.06, 96, 6);
  append(mesh, test::moved(make_box_grid({0.02, 0.16, 0.015}, {2, 16, 2}), {0.0, 0.117, 0.015}));
  Scene pan = test::scene_with(gentle_franka(), std::move(mesh));
  const MassPart handle{.name = "handle", .where = MeshComponent{1}, .density = kHandle};
  state_mass(pan.object, {.density = 2000.0, .parts = {handle}});
  const CompiledScene scene = compile(std::move(pan));
  const double center = scene.scene.object.center_of_mass.y();
  const Judged end = judge(scene, from_above(scene, 0.18, -0.01));
  const Judged balanced = judge(scene, from_above(scene, center, 0.0));
  expect_worse("pan", end, balanced);
}

// What grasps have in common.
struct Summary {
  int grasps = 0;
  double strength = 0.0;     // the median
  double best = 0.0;         // strength
  double probability = 0.0;  // the mean
  double epsilon = 0.0;      // the median, about the middle of the contacts
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Summary summary_of(const std::string& name, const std::vector<Judged>& grasps) {
  std::vector<double> strengths;
  std::vector<double> epsilons;
  double sum = 0.0;
  for (const Judged& judged : grasps) {
    EXPECT_TRUE(std::isfinite(judged.holding.worst.sum_of_normals));
    strengths.push_back(judged.holding.given.strength);
    epsilons.push_back(own_epsilon(judged));
    sum += judged.robustness.probability();
  }
  const Summary summary{static_cast<int>(grasps.size()), median(strengths),
                        *std::max_element(strengths.begin(), strengths.end()),
                        sum / static_cast<double>(grasps.size()), median(epsilons)};
  std::printf("%s: %d grasps, strength %.2f, the best %.2f, probability %.3f, epsilon %.4f\n",
              name.c_str(), summary.grasps, summary.strength, summary.best, summary.probability,
              summary.epsilon);
  return summary;
}

// The drill of the YCB set, 0.895 kg, in published grasps of this hand, which are spread over all
// of it: those far from its centre of mass against those close to it.
TEST(HeldAtTheEnd, ADrillIsHeldWorse) {
  PREHEND_NEEDS_SHARED("data/ycb/power_drill.obj");
  PREHEND_NEEDS_SHARED("data/grasps/dexycb_franka_power_drill.json");
  Scene drill =
      test::scene_with(gentle_franka(), load_mesh(test::shared("data/ycb/power_drill.obj")).mesh);
  state_mass(drill.object, {.mass = 0.895});
  const CompiledScene scene = compile(std::move(drill));
  std::vector<Judged> close;
  std::vector<Judged> far;
  for (const Candidate& candidate :
       test::published_grasps(test::shared("data/grasps/dexycb_franka_power_drill.json"), scene)) {
    Judged judged = judge(scene, candidate);
    if (judged.trial.outcome != Outcome::stable) continue;
    const double lever = (middle_of(judged) - scene.scene.object.center_of_mass).norm();
    if (lever < 0.06) close.push_back(std::move(judged));
    if (lever > 0.09) far.push_back(std::move(judged));
  }
  ASSERT_GT(close.size(), 10U);
  ASSERT_GT(far.size(), 10U);
  const Summary at_center = summary_of("drill_center", close);
  const Summary at_end = summary_of("drill_end", far);
  EXPECT_LT(1.5 * at_end.strength, at_center.strength);
  EXPECT_LT(at_end.best, at_center.best);
  EXPECT_LT(2.0 * at_end.probability, at_center.probability);
  EXPECT_NEAR(at_end.epsilon / at_center.epsilon, 1.0, 0.35);
}

}  // namespace
}  // namespace prehend
