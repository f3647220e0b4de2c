// Makes the model of success (sim/trial/success.h) and says how well it is calibrated.
//
//   fit_success FILE [OTHER]
//
// FILE and OTHER are from success_data. Prints the model of FILE; how well the grasps of each
// object are predicted by the model of all other objects; and how well it predicts those of OTHER.
#include <cstdio>
#include <exception>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/success/fit.h"
#include "sim/base/random.h"

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

// The expected calibration error that right predictions would have of as many independent
// executions, in the mean of some draws.
double calibration_error_by_chance(std::vector<ExecutedGrasp> grasps,
                                   const std::vector<double>& predictions) {
  constexpr int kDraws = 20;
  Random random(1);
  double sum = 0.0;
  for (int draw = 0; draw < kDraws; ++draw) {
    for (std::size_t i = 0; i < grasps.size(); ++i) {
      grasps[i].lifted = 0;
      for (int k = 0; k < grasps[i].executions; ++k) {
        grasps[i].lifted += random.uniform(0.0, 1.0) < predictions[i] ? 1 : 0;
      }
    }
    sum += check_predictions(grasps, predictions).calibration.expected_error;
  }
  return sum / kDraws;
}

// The same of each hand, of each kind of support, and of what was blocked or missed.
void print_parts(const std::vector<ExecutedGrasp>& grasps, const std::vector<double>& predictions) {
  std::map<std::string, std::pair<std::vector<ExecutedGrasp>, std::vector<double>>> parts;
  for (std::size_t i = 0; i < grasps.size(); ++i) {
    const ExecutedGrasp& grasp = grasps[i];
    for (const std::string& part : {grasp.hand, grasp.hand + ", " + grasp.support,
                                    "support: " + grasp.support, "alone: " + grasp.outcome}) {
      parts[part].first.push_back(grasp);
      parts[part].second.push_back(predictions[i]);
    }
  }
  for (const auto& [name, part] : parts) {
    const SuccessCheck check = check_predictions(part.first, part.second);
    std::printf("  %-28s %5zu grasps, AUC %.3f, calibration error %.3f (by chance %.3f)\n",
                name.c_str(), part.first.size(), check.auc, check.calibration.expected_error,
                calibration_error_by_chance(part.first, part.second));
  }
}

void print_model(const std::vector<ExecutedGrasp>& grasps,
                 const std::vector<ExecutedGrasp>& others) {
  const SuccessModel model = fit_success(grasps);
  std::printf("intercept %.6g\n", model.intercept);
  for (std::size_t i = 0; i < model.weights.size(); ++i) {
    std::printf("%s %.6g\n", std::string(kSuccessFeatures[i]).c_str(), model.weights[i]);
  }
  const std::vector<double> held_out = predict_held_out(grasps);
  print_check("objects held out", grasps, held_out);
  print_parts(grasps, held_out);
  if (others.empty()) return;
  std::vector<double> predictions;
  for (const ExecutedGrasp& grasp : others) {
    predictions.push_back(success_probability(grasp.facts, model));
  }
  print_check("other objects", others, predictions);
  print_parts(others, predictions);
}

void run(const std::string& file, const std::string& other) {
  const std::vector<ExecutedGrasp> grasps = read_executed_grasps(file);
  std::vector<ExecutedGrasp> others;
  if (!other.empty()) others = read_executed_grasps(other);
  std::printf("== where a free object is known\n");
  print_model(grasps, others);
  std::printf("== where it is not\n");
  print_model(without_free(grasps), without_free(others));
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
