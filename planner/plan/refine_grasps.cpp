#include "planner/plan/refine_grasps.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "planner/plan/grasp_moves.h"
#include "planner/plan/pattern_search.h"
#include "planner/plan/run_trials.h"
#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/parallel/parallel.h"
#include "sim/base/require_settings.h"
#include "sim/quality/wrench_space.h"
#include "sim/trial/grasp_contacts.h"

namespace prehend {
namespace {

// Variables that a search looks at together: more make more trials run in parallel, and gained
// nothing otherwise. Each takes two trials.
constexpr std::size_t kVariablesAtOnce = 2;
constexpr int kTrialsOfVariable = 2;
// First change of the degrees of freedom that do not close [rad or m].
constexpr double kSpread = 0.2;
// No change is larger than the first one times this.
constexpr double kReach = 10.0 / 3.0;

// So many grasps take part in a round, and each gets so many trials.
struct Round {
  int grasps = 0;
  int trials = 0;
};

// All of them, the best quarter, and so on down to one: a grasp whose way up is long is not given
// up before its first steps have become short enough. Whole variables are looked at, so the trials
// of a grasp are even in number.
std::vector<Round> rounds_of(int grasps, int trials) {
  std::vector<Round> rounds;
  for (int left = grasps; left > 0; left = left == 1 ? 0 : (left + 3) / 4) {
    rounds.push_back({left, 0});
  }
  for (Round& round : rounds) {
    const int share = trials / static_cast<int>(rounds.size()) / round.grasps;
    round.trials = share - share % kTrialsOfVariable;
  }
  return rounds;
}

void check_parents(const std::vector<TriedGrasp>& grasps) {
  for (std::size_t i = 0; i < grasps.size(); ++i) {
    const Trial& trial = grasps[i].trial;
    require(trial.outcome == Outcome::stable && !trial.contacts.empty(),
            {.field = "grasps[" + std::to_string(i) + "].trial",
             .problem = "not stable",
             .value = std::string(name_of(trial.outcome))});
  }
}

int most_refined(std::size_t grasps, const RefineOptions& options) {
  return static_cast<int>(std::min(grasps, static_cast<std::size_t>(options.grasps)));
}

// The search around one grasp, and the best that it found.
struct ParentSearch {
  GraspMoves moves;
  PatternSearch search;
  double before = 0.0;     // the parent's objective
  bool preferred = false;  // as the parent's trial
  int used = 0;            // trials
  std::optional<TriedGrasp> best = {};
};

// One trial of a step of a search.
struct Job {
  std::size_t parent = 0;
  Candidate candidate;
  Trial trial;
  double value = 0.0;
};

class Refiner {
 public:
  Refiner(const CompiledScene& scene, const std::vector<TriedGrasp>& grasps,
          const TrialOptions& options, const RefineOptions& refine, const RunContext& context)
      : scene_(scene), options_(options), refine_(refine), context_(context) {
    options_.back_off_tries = 0;
    const auto count = static_cast<std::size_t>(most_refined(grasps.size(), refine));
    const GraspReach reach{kReach * refine.turn, kReach * refine.shift, kReach * kSpread};
    std::vector<double> values(count);
    for_each_in_parallel(count, context.threads,
                         [&](std::size_t i) { values[i] = objective(grasps[i].trial); });
    for (std::size_t i = 0; i < count; ++i) {
      GraspMoves moves(scene, grasps[i].candidate, grasps[i].trial, reach);
      PatternSearch search(moves.variables(), values[i], 1.0 / kReach);
      parents_.push_back(
          {std::move(moves), std::move(search), values[i], grasps[i].trial.preferred});
    }
    order_.resize(count);
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    progress_ = {Stage::refine, 0, refine_trials(grasps.size(), refine), 0};
  }

  std::vector<RefinedGrasp> run() {
    if (context_.progress) context_.progress(progress_);
    for (const Round& round : rounds_of(static_cast<int>(parents_.size()), refine_.trials)) {
      // The same order on any number of threads: equal grasps stay as they were.
      std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
        return parents_[a].search.best_value() > parents_[b].search.best_value();
      });
      order_.resize(static_cast<std::size_t>(round.grasps));
      for (int left = round.trials; left > 0 && !context_.deadline.has_passed();) {
        const std::size_t variables = std::min<std::size_t>(
            kVariablesAtOnce, static_cast<std::size_t>(left / kTrialsOfVariable));
        step(variables);
        left -= static_cast<int>(variables) * kTrialsOfVariable;
      }
    }
    return better_grasps();
  }

 private:
  double objective(const Trial& trial) const {
    if (trial.outcome != Outcome::stable) return 0.0;
    if (refine_.objective == RefineObjective::epsilon) return trial.epsilon.lower;
    const RunContext one_thread = {.threads = 1, .cancellation = context_.cancellation};
    return robust_epsilon(contacts_of(trial.contacts), scene_.wrench_frame,
                          {.edges = options_.cone_edges}, refine_.noise, one_thread)
        .mean;
  }

  // One step of every search of the round. All trials of the step are made before any search goes
  // on, so what is tried depends on earlier steps only.
  void step(std::size_t variables) {
    std::vector<Job> jobs;
    for (const std::size_t p : order_) {
      for (const std::vector<double>& x : parents_[p].search.next(variables)) {
        jobs.push_back({p, parents_[p].moves.at(x), {}, 0.0});
      }
    }
    for_each_in_parallel(jobs.size(), context_.threads, [&](std::size_t i) { try_it(jobs[i]); });
    auto job = jobs.begin();
    for (const std::size_t p : order_) {
      ParentSearch& parent = parents_[p];
      std::vector<double> values;
      double most = parent.search.best_value();
      for (; job != jobs.end() && job->parent == p; ++job) {
        values.push_back(job->value);
        ++parent.used;
        // As the search decides: to a larger value, of equal ones to the first.
        if (job->value <= most) continue;
        most = job->value;
        parent.best = TriedGrasp{std::move(job->candidate), std::move(job->trial)};
      }
      parent.search.tell(values);
    }
  }

  // A grasp that may not be approached like that is worth nothing, nor is one that leaves the
  // preferred regions.
  void try_it(Job& job) {
    if (is_allowed(job)) {
      make_trial(job);
      const bool turned_away =
          refine_.approach && !allows(*refine_.approach, scene_, job.candidate, job.trial);
      const bool left = parents_[job.parent].preferred && !job.trial.preferred;
      if (turned_away || left) job.value = 0.0;
    }
    if (!context_.progress) return;
    // Never called by two threads at once, and with counts that increase.
    const std::lock_guard lock(progress_lock_);
    ++progress_.done;
    if (job.trial.outcome == Outcome::stable) ++progress_.stable;
    context_.progress(progress_);
  }

  bool is_allowed(const Job& job) const {
    return !refine_.approach || allows(*refine_.approach, scene_, job.candidate.approach_O);
  }

  void make_trial(Job& job) {
    const RunContext one_thread = {.threads = 1, .cancellation = context_.cancellation};
    {
      const TrialWorkers::Loan worker(workers_);
      run_trial(scene_, job.candidate, options_, worker->workspace, worker->trial, one_thread);
      job.trial = worker->trial;
    }
    job.value = objective(job.trial);
  }

  std::vector<RefinedGrasp> better_grasps() {
    std::vector<RefinedGrasp> refined;
    for (std::size_t p = 0; p < parents_.size(); ++p) {
      ParentSearch& parent = parents_[p];
      if (!parent.best) continue;
      refined.push_back({std::move(parent.best->candidate), std::move(parent.best->trial),
                         static_cast<int>(p), parent.search.best_value() - parent.before,
                         parent.used});
    }
    return refined;
  }

  const CompiledScene& scene_;
  TrialOptions options_;
  const RefineOptions& refine_;
  const RunContext& context_;
  std::vector<ParentSearch> parents_;
  std::vector<std::size_t> order_;  // the parents of the round, best first
  TrialWorkers workers_;
  std::mutex progress_lock_;
  Progress progress_;
};

}  // namespace

int refine_trials(std::size_t grasps, const RefineOptions& options) {
  require_settings(options);
  int trials = 0;
  for (const Round& round : rounds_of(most_refined(grasps, options), options.trials)) {
    trials += round.grasps * round.trials;
  }
  return trials;
}

std::vector<RefinedGrasp> refine_grasps(const CompiledScene& scene,
                                        const std::vector<TriedGrasp>& grasps,
                                        const TrialOptions& options, const RefineOptions& refine,
                                        const RunContext& context) {
  require_settings(options);
  require_settings(refine);
  check_parents(grasps);
  context.cancellation.check();
  return Refiner(scene, grasps, options, refine, context).run();
}

}  // namespace prehend
