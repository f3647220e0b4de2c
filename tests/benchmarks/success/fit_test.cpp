// The model of success from grasps that follow a known one, and the shipped one from its data.
#include "benchmarks/success/fit.h"

#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/base/random.h"

namespace prehend::bench {
namespace {

std::filesystem::path data_file() {
  return std::filesystem::path(PREHEND_SOURCE_DIR) / "benchmarks" / "success" / "success.csv";
}

// Grasps of 20 objects that lift as often as the model says.
std::vector<ExecutedGrasp> made_up(const SuccessModel& model, int count, int executions) {
  Random random(11);
  std::vector<ExecutedGrasp> grasps;
  for (int i = 0; i < count; ++i) {
    ExecutedGrasp grasp;
    grasp.object = std::to_string(i % 20);
    grasp.executions = executions;
    grasp.facts = {random.uniform(0.5, 1.0), random.uniform(0.0, 1.0),
                   std::exp(random.uniform(-9.0, 0.0)), std::exp(random.uniform(-3.0, 4.0))};
    grasp.facts.free = FreeEnd{random.index(2) == 0, std::exp(random.uniform(-9.0, 0.0)),
                               std::exp(random.uniform(-3.0, 4.0)), 0.1 * random.uniform(0.0, 1.0)};
    const double p = success_probability(grasp.facts, model);
    for (int k = 0; k < executions; ++k) grasp.lifted += random.uniform(0.0, 1.0) < p ? 1 : 0;
    grasps.push_back(grasp);
  }
  return grasps;
}

TEST(FitSuccess, FindsTheModelThatTheGraspsFollow) {
  const SuccessModel model{.intercept = -2.0, .weights = {2.5, 1.5, 1.0, 0.5, 2.0, 0.8, 1.2}};
  const SuccessModel found = fit_success(made_up(model, 4000, 40));
  EXPECT_NEAR(found.intercept, model.intercept, 0.1);
  for (std::size_t i = 0; i < model.weights.size(); ++i) {
    EXPECT_NEAR(found.weights[i], model.weights[i], 0.1) << kSuccessFeatures[i];
  }
}

TEST(FitSuccess, NoWeightIsBelow0) {
  // What holds better lifts less often.
  const SuccessModel against{.intercept = 1.0, .weights = {-3.0, 1.0, 0.5}};
  const SuccessModel found = fit_success(made_up(against, 500, 10));
  EXPECT_EQ(found.weights[0], 0.0);
  EXPECT_GT(found.weights[1], 0.0);
}

TEST(FitSuccess, PredictionsOfAFittingModelAreCalibrated) {
  const SuccessModel model{.intercept = -2.0, .weights = {2.5, 1.5, 1.0, 0.5, 2.0, 0.8, 1.2}};
  const std::vector<ExecutedGrasp> grasps = made_up(model, 2000, 20);
  const SuccessCheck check = check_predictions(grasps, predict_held_out(grasps));
  EXPECT_LT(check.calibration.expected_error, 0.02);
  EXPECT_GT(check.auc, 0.6);
}

TEST(FitSuccess, WhatIsNotKnownHasNoWeight) {
  const SuccessModel model{.intercept = -2.0, .weights = {2.5, 1.5, 1.0}};
  const SuccessModel found = fit_success(without_free(made_up(model, 4000, 40)));
  EXPECT_NEAR(found.intercept, model.intercept, 0.1);
  for (std::size_t i = 3; i < found.weights.size(); ++i) EXPECT_EQ(found.weights[i], 0.0);
}

void expect_equal(const SuccessModel& fitted, const SuccessModel& shipped) {
  EXPECT_NEAR(fitted.intercept, shipped.intercept, 1e-4);
  for (std::size_t i = 0; i < fitted.weights.size(); ++i) {
    EXPECT_NEAR(fitted.weights[i], shipped.weights[i], 1e-4) << kSuccessFeatures[i];
  }
}

TEST(FitSuccess, TheShippedModelsAreThoseOfTheirData) {
  const std::vector<ExecutedGrasp> grasps = read_executed_grasps(data_file());
  expect_equal(fit_success(grasps), shipped_success_model(true));
  expect_equal(fit_success(without_free(grasps)), shipped_success_model(false));
}

TEST(FitSuccess, ItsPredictionsForOtherObjectsAreCalibrated) {
  const std::vector<ExecutedGrasp> known = read_executed_grasps(data_file());
  for (const std::vector<ExecutedGrasp>& grasps : {known, without_free(known)}) {
    const SuccessCheck check = check_predictions(grasps, predict_held_out(grasps));
    EXPECT_LE(check.calibration.expected_error, 0.05);
    EXPECT_LT(check.calibration.brier, check.calibration.brier_of_base_rate);
  }
}

// What becomes of a free object tells more than the trials on one that stands still.
TEST(FitSuccess, AFreeObjectTellsMore) {
  const std::vector<ExecutedGrasp> known = read_executed_grasps(data_file());
  const std::vector<ExecutedGrasp> unknown = without_free(known);
  EXPECT_GT(check_predictions(known, predict_held_out(known)).auc,
            check_predictions(unknown, predict_held_out(unknown)).auc + 0.05);
}

TEST(FitSuccess, OtherFilesAreRefused) {
  const std::filesystem::path file = testing::TempDir() + "other.csv";
  EXPECT_THROW(read_executed_grasps(testing::TempDir() + "none.csv"), InputError);
  std::ofstream(file) << "object,hand\nmug,barrett\n";
  EXPECT_THROW(read_executed_grasps(file), InputError);
  const std::string columns =
      "object,hand,support,outcome,errors,mass,executions,lifted,closed,held,epsilon,strength,kept,"
      "free_epsilon,free_strength,moved\n";
  const std::string row = "mug,barrett,none,stable,1,0.3,4,2,1,1,0.1,3";
  std::ofstream(file) << columns << row << ",,,,\n";
  EXPECT_FALSE(read_executed_grasps(file).at(0).facts.free);
  for (const std::string& wrong : {std::string("mug,1,2"), row, row + ",1,0.1", row + ",,,,,"}) {
    std::ofstream(file) << columns << wrong << "\n";
    EXPECT_THROW(read_executed_grasps(file), InputError) << wrong;
  }
}

}  // namespace
}  // namespace prehend::bench
