// What makes grasps less probable to lift the object, on all grasps of a plan.
#include <numeric>

#include <gtest/gtest.h>

#include "planner/plan/accuracy.h"
#include "planner/plan/plan.h"
#include "sim/trial/success.h"
#include "tests/support/library_scenes.h"

namespace prehend {
namespace {

enum class FreeObject { known, unknown };

// How probably the grasps of the mug's plan lift it, all at once.
std::vector<double> successes(const Scene& scene, const std::vector<Candidate>& grasps,
                              FreeObject free, double errors = 1.0) {
  EvaluateOptions options;
  options.robustness = true;
  UncertaintyOptions& with = options.uncertainty;
  for (double* value : {&with.across, &with.along, &with.angle, &with.hand, &with.hand_angle,
                        &with.friction, &with.center_of_mass}) {
    *value *= errors;
  }
  options.volumes = 0;
  std::vector<double> all(grasps.size());
  for (const ScoredGrasp& grasp : evaluate(compile(scene), grasps, options).grasps) {
    Robustness robustness = grasp.robustness.value();
    if (free == FreeObject::unknown) robustness.free.reset();
    all[static_cast<std::size_t>(grasp.tried)] = success_probability(robustness);
  }
  return all;
}

std::vector<Candidate> grasps_of_mug(const CompiledScene& mug) {
  PlanOptions options = plan_options(Accuracy::draft);
  options.search.trials = 200;
  std::vector<Candidate> grasps;
  for (const ScoredGrasp& grasp : plan(mug, options).grasps) grasps.push_back(grasp.candidate);
  return grasps;
}

FrictionTable scaled_friction(const FrictionTable& table, double part) {
  FrictionTable scaled;
  for (const Material a : kAll<Material>) {
    for (const Material b : kAll<Material>) scaled.set(a, b, part * table.between(a, b));
  }
  return scaled;
}

void expect_none_larger(const std::vector<double>& less, const std::vector<double>& more) {
  for (std::size_t i = 0; i < less.size(); ++i) EXPECT_LE(less[i], more[i]) << "grasp " << i;
}

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// The motions of this hand depend neither on friction nor on its efforts while the object stands
// still, so each of its samples can only get worse. A free object moves otherwise where friction is
// less, and may end in a better grasp: most do not.
TEST(Success, IsNeverHigherForLessFrictionOrLessForce) {
  const CompiledScene mug = test::compiled_library_scene("mug");
  const std::vector<Candidate> grasps = grasps_of_mug(mug);
  ASSERT_GE(grasps.size(), 3U);
  const double all = sum_of(successes(mug.scene, grasps, FreeObject::known));
  std::vector<double> before = successes(mug.scene, grasps, FreeObject::unknown);
  for (const double part : {0.7, 0.4, 0.1}) {
    Scene slippery = mug.scene;
    slippery.friction = scaled_friction(mug.scene.friction, part);
    const std::vector<double> now = successes(slippery, grasps, FreeObject::unknown);
    expect_none_larger(now, before);
    before = now;
  }
  Scene slippery = mug.scene;
  slippery.friction = scaled_friction(mug.scene.friction, 0.1);
  EXPECT_LT(sum_of(successes(slippery, grasps, FreeObject::known)), 0.9 * all);
  before = successes(mug.scene, grasps, FreeObject::unknown);
  for (const double part : {0.3, 0.05, 0.01}) {
    Scene weak = mug.scene;
    for (Joint& joint : weak.hand.joints) joint.max_effort *= part;
    const std::vector<double> now = successes(weak, grasps, FreeObject::unknown);
    expect_none_larger(now, before);
    before = now;
  }
  EXPECT_LT(before.front(), successes(mug.scene, grasps, FreeObject::unknown).front());
}

// Of one grasp an error may turn a miss into a hit; of all of them together it does not.
TEST(Success, IsLowerInTheMeanForLargerErrors) {
  const CompiledScene mug = test::compiled_library_scene("mug");
  const std::vector<Candidate> grasps = grasps_of_mug(mug);
  double before = 1.0 * static_cast<double>(grasps.size());
  for (const double errors : {0.25, 1.0, 2.0}) {
    const double sum = sum_of(successes(mug.scene, grasps, FreeObject::known, errors));
    EXPECT_LT(sum, before) << errors;
    before = sum;
  }
}

}  // namespace
}  // namespace prehend
