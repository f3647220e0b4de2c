#include "planner/show/validation/validation_report.h"

#include "sim/base/index.h"

namespace prehend {
namespace {

// The executions for which `member` of the label is `number`.
ValidationPart part_of(const std::string& name, const std::vector<Label>& labels,
                       int Label::*member, std::size_t number,
                       const std::vector<Ranking>& rankings) {
  ValidationPart part{name, 0, 0, {}};
  std::vector<double> weights(labels.size(), 0.0);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (index(labels[i].*member) != number) continue;
    weights[i] = labels[i].times;
    (labels[i].lifted ? part.lifted : part.failed) += labels[i].times;
  }
  for (const Ranking& ranking : rankings) part.auc.push_back(ranking.auc(weights));
  return part;
}

}  // namespace

ValidationReport validation_report(const ExecutedGrasps& truth, const std::vector<Score>& scores,
                                   const JudgedExecutions& judged,
                                   const BootstrapOptions& bootstrap, const RunContext& context) {
  const std::vector<Label> labels = truth.labels();
  const std::vector<double> weights = weights_of(labels);
  std::vector<Ranking> rankings;
  for (const std::vector<double>& values : judged.scores) rankings.emplace_back(values, labels);
  const RankingEstimates estimates =
      bootstrap_auc(rankings, labels, kReferenceScore, bootstrap, context);

  ValidationReport report;
  for (const Label& label : labels) (label.lifted ? report.lifted : report.failed) += label.times;
  report.outcomes = judged.outcomes;
  report.bootstrap = bootstrap;
  report.groups = estimates.groups;
  report.undefined = estimates.undefined;
  for (std::size_t s = 0; s < scores.size(); ++s) {
    report.scores.push_back(
        {scores[s], estimates.auc[s], estimates.difference[s], rankings[s].roc(weights), {}});
    if (!scores[s].is_probability) continue;
    report.scores.back().calibration = calibration(judged.scores[s], labels);
  }
  for (std::size_t o = 0; o < truth.objects.size(); ++o) {
    ValidationPart part = part_of(truth.objects[o].name, labels, &Label::object, o, rankings);
    if (part.lifted + part.failed > 0) report.objects.push_back(std::move(part));
  }
  for (std::size_t s = 0; s < truth.sessions.size(); ++s) {
    report.sessions.push_back(part_of(truth.sessions[s], labels, &Label::session, s, rankings));
  }
  return report;
}

}  // namespace prehend
