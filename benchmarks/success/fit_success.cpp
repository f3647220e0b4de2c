// Makes the model of success (sim/trial/success.h) and says how well it is calibrated.
//
//   fit_success FILE [OTHER]
//
// FILE and OTHER are from success_data. Prints the model of FILE; how well the grasps of each
// object are predicted by the model of all other objects; and how well it predicts those of OTHER.
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "benchmarks/success/fit.h"

namespace prehend::bench {
namespace {

void print_check(const char* of, const std::vector<ExecutedGrasp>& grasps,
                 const std::vector<double>& predictions) {
  const SuccessCheck check = check_predictions(grasps, predictions);
  std::printf("%s: %zu grasps, AUC %.3f, expected calibration error %.3f, Brier %.3f (base %.3f)\n",
              of, grasps.size(), check.auc, check.calibration.expected_error,
              check.calibration.brier, check.calibration.brier_of_base_rate);
  for (const ReliabilityBin& bin : check.calibration.bins) {
    if (bin.count == 0) continue;
    std::printf("  %.1f to %.1f: %5d executions, predicted %.3f, lifted %.3f\n", bin.from, bin.to,
                bin.count, bin.predicted, bin.share());
  }
}

void run(const std::string& file, const std::string& other) {
  const std::vector<ExecutedGrasp> grasps = read_executed_grasps(file);
  const SuccessModel model = fit_success(grasps);
  std::printf("intercept %.6g\n", model.intercept);
  for (std::size_t i = 0; i < model.weights.size(); ++i) {
    std::printf("%s %.6g\n", std::string(kSuccessFeatures[i]).c_str(), model.weights[i]);
  }
  print_check("objects held out", grasps, predict_held_out(grasps));
  if (other.empty()) return;
  const std::vector<ExecutedGrasp> others = read_executed_grasps(other);
  std::vector<double> predictions;
  for (const ExecutedGrasp& grasp : others) {
    predictions.push_back(success_probability(grasp.facts, model));
  }
  print_check("other objects", others, predictions);
}

}  // namespace
}  // namespace prehend::bench

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::fprintf(stderr, "usage: fit_success FILE [OTHER]\n");
    return 2;
  }
  try {
    prehend::bench::run(argv[1], argc == 3 ? argv[2] : "");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fit_success: %s\n", error.what());
    return 2;
  }
  return 0;
}
