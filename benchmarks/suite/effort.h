// How much a run of the benchmarks measures.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace prehend::bench {

enum class Effort {
  full,   // about five minutes on two cores
  quick,  // a few minutes; the same entries as far as they take no long time
  smoke   // seconds: only whether everything runs
};

// "full", "quick", "smoke": words of the command line and of result files.
std::string_view effort_name(Effort effort);

// Sizes and repetitions of all parts.
struct Sizes {
  Effort effort = Effort::full;
  // Kernels.
  int repetitions = 15;
  double kernel_seconds = 0.15;  // of each repetition, at least
  // Trials: of each hand and object.
  std::vector<std::string> objects;
  std::vector<std::string> hands;
  int trials = 120;
  // Scenes with an arm: paths are planned for so many of the best grasps.
  std::vector<std::string> arm_scenes;
  int path_trials = 800;  // of the plan that finds these
  int paths = 20;
  // Plans: the first so many of the list in plans.cpp, each run so often.
  int plans = 8;
  int plan_runs = 5;
  // The trade.
  std::vector<std::string> trade_objects;
  int trade_candidates = 200;
  std::vector<int> plan_trials;
  int seeds = 4;
  // Scaling.
  std::vector<int> triangles;
  std::vector<int> candidates;
  std::vector<int> contacts;
  std::vector<int> obstacles;
  int scaling_trials = 24;      // at each size
  int grasps = 15;              // at each number of contacts
  int thread_runs = 5;          // plans at each number of threads
  double longest_point = 20.0;  // a series ends where its next point would take longer [s]
};

Sizes sizes_of(Effort effort);

}  // namespace prehend::bench
