#include <algorithm>

#include "benchmarks/report/names.h"
#include "benchmarks/suite/agreement.h"
#include "benchmarks/suite/parts.h"
#include "benchmarks/suite/planning.h"
#include "benchmarks/suite/record.h"
#include "benchmarks/support/resources.h"
#include "sim/trial/run_trial.h"

namespace prehend::bench {
namespace {

using benchmark::processor_milliseconds;

double epsilon_of(const Trial& trial) {
  return trial.outcome == Outcome::stable ? trial.epsilon.lower : 0.0;
}

// The same candidates at one setting, on this thread.
struct AtSetting {
  std::vector<double> milliseconds;
  std::vector<double> epsilons;  // 0 where the grasp does not hold
};

AtSetting run_all(const CompiledScene& scene, const std::vector<Candidate>& candidates,
                  const AccuracySetting& setting) {
  AtSetting result;
  for (const Candidate& candidate : candidates) {
    Trial trial;
    result.milliseconds.push_back(processor_milliseconds(
        [&] { trial = run_trial(scene, candidate, setting.options.trial); }));
    result.epsilons.push_back(epsilon_of(trial));
  }
  return result;
}

void compare_settings(const std::string& object, const CompiledScene& scene, const Sizes& sizes,
                      Record& record) {
  constexpr std::size_t kBest = 10;
  const std::vector<AccuracySetting> settings = accuracy_settings();
  const std::vector<Candidate> candidates = propose(scene, sizes.trade_candidates);
  std::vector<AtSetting> results;
  for (const AccuracySetting& setting : settings) {
    record.say(object + ", " + setting.name);
    results.push_back(run_all(scene, candidates, setting));
  }
  const std::vector<double>& finest = results.back().epsilons;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const std::string series = object + ", " + settings[i].name;
    const std::vector<double>& epsilons = results[i].epsilons;
    record.add(kTimePerTrial, series, "ms", results[i].milliseconds);
    record.add(kEpsilonError, series, "%", relative_errors(finest, epsilons));
    record.add(kOtherVerdict, series, "%", other_verdicts(finest, epsilons));
    record.add(kBestKept, series, "1",
               static_cast<double>(kept_of_best(finest, epsilons, kBest, 2 * kBest)));
  }
}

// Until the grasps are ranked. What follows is for people: volumes, and advice where nothing holds.
double planning_seconds(const PlanResult& result) {
  double sum = 0.0;
  for (const StageTime& time : result.times) {
    if (time.stage != Stage::volumes) sum += time.seconds;
  }
  return sum;
}

// What plans with so many trials take, and what they find as the finest setting sees it.
void measure_plans(const std::string& series, const CompiledScene& scene,
                   const AccuracySetting& setting, int trials, const Sizes& sizes, Record& record) {
  const TrialOptions finest = accuracy_settings().back().options.trial;
  std::vector<double> seconds;
  std::vector<double> epsilons;
  for (int seed = 1; seed <= sizes.seeds; ++seed) {
    PlanOptions options = options_of(setting, trials, static_cast<std::uint64_t>(seed));
    options.rank.top = 1;
    const PlanResult result = plan(scene, options);
    seconds.push_back(planning_seconds(result));
    epsilons.push_back(result.grasps.empty()
                           ? 0.0
                           : epsilon_of(run_trial(scene, result.grasps.front().candidate, finest)));
  }
  record.add(kPlanTime, series, "s", seconds, trials);
  record.add(kBestEpsilon, series, "1", epsilons, trials);
}

}  // namespace

void measure_trade(const Sizes& sizes, std::vector<Entry>& entries) {
  Record record(kTrade, entries);
  record.add(kDefault, kDefaultSetting, "trials", default_trials());
  for (const std::string& object : sizes.trade_objects) {
    const CompiledScene scene = object_scene(object, 5000, kDefaultHand);
    compare_settings(object, scene, sizes, record);
    for (const AccuracySetting& setting : accuracy_settings()) {
      record.say("plans, " + object + ", " + setting.name);
      for (const int trials : sizes.plan_trials) {
        measure_plans(object + ", " + setting.name, scene, setting, trials, sizes, record);
      }
    }
  }
}

}  // namespace prehend::bench
