#include "benchmarks/learn/learn_file.h"

#include <fstream>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>

#include "planner/plan/learn/grasp_features.h"
#include "sim/base/input_error.h"

namespace prehend::bench {
namespace {

bool read_trial(const std::string& line, GraspSetEntry& grasp) {
  std::istringstream words(line);
  int outcome = 0;
  if (!(words >> outcome >> grasp.epsilon.lower)) return false;
  grasp.outcome = static_cast<Outcome>(outcome);
  float value = 0.0F;
  while (words >> value) grasp.features.push_back(value);
  return grasp.features.size() == kGraspFeatures.size();
}

}  // namespace

void write_run(const LearnRun& run, std::ostream& stream) {
  stream.precision(9);
  stream << "set " << run.object << ' ' << run.hand << ' ' << run.seed << ' '
         << run.set.grasps.size() << '\n';
  for (const GraspSetEntry& grasp : run.set.grasps) {
    stream << static_cast<int>(grasp.outcome) << ' ' << grasp.epsilon.lower;
    for (const float value : grasp.features) stream << ' ' << value;
    stream << '\n';
  }
  stream.flush();
}

std::vector<LearnRun> read_runs(const std::filesystem::path& file) {
  std::ifstream stream(file);
  require(stream.good(), {.file = file.string(), .problem = "cannot be read"});
  std::vector<LearnRun> runs;
  std::string line;
  while (std::getline(stream, line)) {
    std::istringstream words(line);
    std::string set;
    LearnRun run;
    std::size_t count = 0;
    words >> set >> run.object >> run.hand >> run.seed >> count;
    require(set == "set" && !words.fail(),
            {.file = file.string(), .problem = "is no file of runs", .value = line.substr(0, 40)});
    run.set.hand = run.hand;
    run.set.object.file = run.object;
    run.set.feature_names = grasp_feature_names();
    while (run.set.grasps.size() < count && std::getline(stream, line)) {
      if (!read_trial(line, run.set.grasps.emplace_back())) break;
    }
    if (run.set.grasps.size() < count ||
        run.set.grasps.back().features.size() != kGraspFeatures.size()) {
      break;
    }
    run.best = best_so_far(run.set);
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace prehend::bench
