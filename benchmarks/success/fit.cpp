#include "benchmarks/success/fit.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "planner/show/validation/ranking.h"
#include "sim/base/input_error.h"

namespace prehend::bench {
namespace {

constexpr std::string_view kColumns =
    "object,hand,support,outcome,errors,mass,executions,lifted,closed,held,epsilon,strength,kept,"
    "free_epsilon,free_strength,moved";

constexpr std::size_t kCells = 16;

// First derivative of the log-likelihood along one coefficient, and its expected second one.
struct Slope {
  double first = 0.0;
  double second = 0.0;
};

// Coefficient 0 is the intercept, the others are the weights.
double feature(const SuccessFeatures& features, std::size_t coefficient) {
  return coefficient == 0 ? 1.0 : features[coefficient - 1];
}

double& coefficient_of(SuccessModel& model, std::size_t coefficient) {
  return coefficient == 0 ? model.intercept : model.weights[coefficient - 1];
}

// With p = c s and s the logistic function of z: dp/dz = p (1 - s), so that the likelihood of k out
// of n has the slope (k - n p) (1 - s) / (1 - p) along z.
Slope slope(std::span<const ExecutedGrasp> grasps, const SuccessModel& model,
            std::size_t coefficient) {
  Slope sum;
  for (const ExecutedGrasp& grasp : grasps) {
    const double closed = grasp.facts.closed;
    const double p = success_probability(grasp.facts, model);
    if (closed <= 0.0 || p >= 1.0) continue;
    const double x = feature(success_features(grasp.facts), coefficient);
    const double s = p / closed;
    const double share = (1.0 - s) / (1.0 - p);
    sum.first += (grasp.lifted - grasp.executions * p) * share * x;
    sum.second += grasp.executions * p * (1.0 - p) * share * share * x * x;
  }
  return sum;
}

double number(const std::string& text, const std::filesystem::path& file) {
  try {
    return std::stod(text);
  } catch (const std::exception&) {
    throw InputError(
        {.file = file.string(), .problem = "has a cell that is no number", .value = text});
  }
}

ExecutedGrasp row_of(const std::string& line, const std::filesystem::path& file) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  if (line.ends_with(',')) cells.emplace_back();  // getline leaves out an empty last cell
  if (cells.size() != kCells) {
    throw InputError(
        {.file = file.string(), .problem = "has a row without 16 cells", .value = line});
  }
  const auto at = [&](std::size_t i) { return number(cells[i], file); };
  ExecutedGrasp grasp{cells[0],
                      cells[1],
                      cells[2],
                      cells[3],
                      static_cast<int>(at(6)),
                      static_cast<int>(at(7)),
                      {at(8), at(9), at(10), at(11)}};
  if (!cells[12].empty()) grasp.facts.free = FreeEnd{at(12) > 0.0, at(13), at(14), at(15)};
  return grasp;
}

}  // namespace

std::vector<ExecutedGrasp> read_executed_grasps(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  if (!std::getline(stream, line) || line != kColumns) {
    throw InputError({.file = file.string(),
                      .problem = "must begin with the columns",
                      .value = std::string(kColumns)});
  }
  std::vector<ExecutedGrasp> grasps;
  while (std::getline(stream, line)) grasps.push_back(row_of(line, file));
  return grasps;
}

SuccessModel fit_success(std::span<const ExecutedGrasp> grasps) {
  SuccessModel model;
  constexpr int kMostRounds = 10000;
  for (int round = 0; round < kMostRounds; ++round) {
    double largest = 0.0;
    for (std::size_t c = 0; c <= kSuccessFeatures.size(); ++c) {
      const Slope along = slope(grasps, model, c);
      if (along.second <= 0.0) continue;
      double& value = coefficient_of(model, c);
      const double before = value;
      value += std::clamp(along.first / along.second, -1.0, 1.0);
      if (c > 0) value = std::max(0.0, value);
      largest = std::max(largest, std::abs(value - before));
    }
    if (largest < 1e-9) break;
  }
  return model;
}

std::vector<ExecutedGrasp> without_free(std::vector<ExecutedGrasp> grasps) {
  for (ExecutedGrasp& grasp : grasps) grasp.facts.free.reset();
  return grasps;
}

std::vector<double> predict_held_out(const std::vector<ExecutedGrasp>& grasps) {
  std::vector<double> predictions(grasps.size());
  std::vector<std::string> objects;
  for (const ExecutedGrasp& grasp : grasps) objects.push_back(grasp.object);
  std::sort(objects.begin(), objects.end());
  objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
  for (const std::string& object : objects) {
    std::vector<ExecutedGrasp> others = grasps;
    std::erase_if(others, [&](const ExecutedGrasp& grasp) { return grasp.object == object; });
    const SuccessModel model = fit_success(others);
    for (std::size_t i = 0; i < grasps.size(); ++i) {
      if (grasps[i].object == object) predictions[i] = success_probability(grasps[i].facts, model);
    }
  }
  return predictions;
}

SuccessCheck check_predictions(const std::vector<ExecutedGrasp>& grasps,
                               std::span<const double> predictions) {
  std::vector<double> each;
  std::vector<Label> labels;
  const auto add = [&](std::size_t i, bool lifted, int times) {
    if (times == 0) return;
    each.push_back(predictions[i]);
    labels.push_back({.lifted = lifted, .times = times});
  };
  for (std::size_t i = 0; i < grasps.size(); ++i) {
    add(i, true, grasps[i].lifted);
    add(i, false, grasps[i].executions - grasps[i].lifted);
  }
  return {calibration(each, labels), Ranking(each, labels).auc(weights_of(labels)).value_or(0.5)};
}

}  // namespace prehend::bench
