// How well prehend's scores of executed grasps tell what became of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planner/show/validation/bootstrap.h"
#include "planner/show/validation/calibration.h"
#include "planner/show/validation/frame_check.h"
#include "planner/show/validation/judge_executions.h"

namespace prehend {

// What is said of a score.
struct ScoreFigures {
  Score score;
  Estimate auc;
  Estimate over_epsilon;                   // AUC minus that of epsilon
  std::vector<RocPoint> roc;               // Ranking::roc
  std::optional<Calibration> calibration;  // of a score that is a probability
};

// The executions of one object or one session.
struct ValidationPart {
  std::string name;
  int lifted = 0;
  int failed = 0;
  std::vector<std::optional<double>> auc;  // of each score; nothing where one outcome is missing
};

struct ValidationReport {
  std::string name;  // of the file that was read
  int lifted = 0;    // executions
  int failed = 0;
  EnumArray<Outcome, int> outcomes;  // of the trials: one for each entry of the file
  BootstrapOptions bootstrap;
  int samples = 0;    // disturbed trials of a grasp
  int groups = 0;     // RankingEstimates::groups
  int undefined = 0;  // RankingEstimates::undefined
  std::vector<ScoreFigures> scores;
  std::vector<ValidationPart> objects;   // those with executions, in the order of the file
  std::vector<ValidationPart> sessions;  // as above
  FrameCheck frames;
};

// All figures but `name`, `samples` and `frames`, which stay empty. `judged` has the scores of the
// executions of `truth`. Throws Cancelled.
ValidationReport validation_report(const ExecutedGrasps& truth, const std::vector<Score>& scores,
                                   const JudgedExecutions& judged,
                                   const BootstrapOptions& bootstrap,
                                   const RunContext& context = {});

}  // namespace prehend
