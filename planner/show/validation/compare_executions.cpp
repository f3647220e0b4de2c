#include "planner/show/validation/compare_executions.h"

#include <vector>

#include "planner/show/validation/judge_executions.h"

namespace prehend {

ValidationReport compare_executions(const ExecutedGrasps& truth, const std::filesystem::path& file,
                                    const CompareOptions& options, const RunContext& context) {
  const FrameCheck frames = check_frames(truth, context);
  const std::vector<Score> chosen = scores(options.volumes);
  const JudgedExecutions judged = judge_executions(truth, chosen, options.evaluation, context);
  BootstrapOptions bootstrap;
  bootstrap.grouping = options.grouping ? *options.grouping : natural_grouping(truth.labels());
  bootstrap.resamples = options.resamples;
  bootstrap.seed = options.evaluation.seed;
  ValidationReport report = validation_report(truth, chosen, judged, bootstrap, context);
  report.name = file.filename().string();
  report.samples = options.evaluation.uncertainty.samples;
  report.frames = frames;
  return report;
}

}  // namespace prehend
