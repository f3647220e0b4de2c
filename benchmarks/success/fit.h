// The model of success that explains best what became of grasps that were carried out.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "planner/show/validation/calibration.h"
#include "sim/trial/success.h"

namespace prehend::bench {

// A row of success.csv: a grasp with what is known of it, and how often it was carried out and
// lifted its object.
struct ExecutedGrasp {
  std::string object;
  std::string hand;
  std::string support;  // "table", or "none" of an object that floats
  std::string outcome;  // of the trial without errors
  int executions = 0;
  int lifted = 0;
  SuccessFacts facts;
};

// Throws InputError for a file that cannot be read or has other columns.
std::vector<ExecutedGrasp> read_executed_grasps(const std::filesystem::path& file);

// The model of the largest likelihood, no weight below 0. Source of the method: Fisher scoring, one
// coordinate after the other (McCullagh and Nelder 1989, section 2.5), until none changes by more
// than 1e-9.
SuccessModel fit_success(std::span<const ExecutedGrasp> grasps);

// The same grasps without what is known of a free object.
std::vector<ExecutedGrasp> without_free(std::vector<ExecutedGrasp> grasps);

// The predictions for the grasps of each object by the model of those of all other objects.
std::vector<double> predict_held_out(const std::vector<ExecutedGrasp>& grasps);

// Predictions compared with what happened: calibration over 10 bins, and the AUC.
struct SuccessCheck {
  Calibration calibration;
  double auc = 0.0;
};
SuccessCheck check_predictions(const std::vector<ExecutedGrasp>& grasps,
                               std::span<const double> predictions);

}  // namespace prehend::bench
