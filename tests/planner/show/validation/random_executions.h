// Made-up executions whose scores tell the outcome more or less well.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "planner/show/validation/labels.h"
#include "sim/base/random.h"

namespace prehend::test {

struct RandomExecutions {
  std::vector<double> scores;
  std::vector<Label> labels;
};

struct ExecutionsWanted {
  int executions = 100;
  int objects = 10;
  int sessions = 4;
  // By how much scores of lifted grasps are larger on average, in standard deviations. The AUC is
  // then the normal distribution function at separation / sqrt(2).
  double separation = 1.0;
  bool ties = false;  // scores are rounded to halves
};

inline RandomExecutions random_executions(const ExecutionsWanted& wanted, std::uint64_t seed) {
  Random random(seed);
  RandomExecutions made;
  for (int i = 0; i < wanted.executions; ++i) {
    Label label;
    label.lifted = random.uniform() < 0.5;
    label.object = i % wanted.objects;
    label.session = static_cast<int>(random.index(static_cast<std::size_t>(wanted.sessions)));
    const double score = random.normal() + (label.lifted ? wanted.separation : 0.0);
    made.scores.push_back(wanted.ties ? 0.5 * std::round(2.0 * score) : score);
    made.labels.push_back(label);
  }
  return made;
}

}  // namespace prehend::test
