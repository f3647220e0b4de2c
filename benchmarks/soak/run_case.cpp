#include "benchmarks/soak/run_case.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

#include "benchmarks/support/resources.h"
#include "planner/plan/free_grasps.h"
#include "planner/plan/plan.h"
#include "planner/plan/search_grasps.h"
#include "planner/results/grasps_file.h"
#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/scene/compiled_scene.h"
#include "tests/support/judge_path.h"
#include "tests/support/judge_plan.h"
#include "tests/support/trial_bytes.h"

namespace prehend::soak {
namespace {

using namespace std::chrono_literals;

// Stops a call that takes too long, or when the program is told to end.
class Watch {
 public:
  explicit Watch(const std::function<bool()>& interrupted)
      : thread_([this, interrupted](const std::stop_token& stop) {
          while (!stop.stop_requested()) {
            if (interrupted() || seconds() > kMostSeconds) cancellation_.request();
            std::this_thread::sleep_for(50ms);
          }
        }) {}

  double seconds() const { return benchmark::processor_seconds() - start_; }
  const Cancellation& cancellation() const { return cancellation_; }

 private:
  Cancellation cancellation_;
  double start_ = benchmark::processor_seconds();
  std::jthread thread_;
};

class CaseRun {
 public:
  CaseRun(RandomCase made, const std::function<bool()>& interrupted)
      : made_(std::move(made)), interrupted_(interrupted) {
    findings_.words = made_.words;
  }

  CaseFindings run() {
    try {
      plan_and_judge();
    } catch (const InputError& error) {
      findings_.refused = error.what();
      // Blocks around an object may overlap it or the arm's start. A lone object is valid.
      if (made_.known.scene.obstacles.empty()) fault("refused", error.what());
    } catch (const Cancelled&) {
      // While the scene was compiled: the case was interrupted, or slow.
      if (!interrupted_()) fault("slow", "cancelled");
    } catch (const std::exception& error) {
      fault("exception", error.what());
    }
    findings_.interrupted = interrupted_();
    return std::move(findings_);
  }

 private:
  void fault(const std::string& kind, const std::string& words) {
    findings_.faults.push_back({kind, words});
  }

  // plan() on one thread. Nothing when it took too long; that is then a fault.
  std::optional<PlanResult> planned() {
    benchmark::forget_most_megabytes();
    const Watch watch(interrupted_);
    const RunContext context{.threads = 1, .cancellation = watch.cancellation()};
    scene_.emplace(compile(made_.known.scene, context));
    PlanResult result = plan(*scene_, made_.options, context);
    findings_.seconds = watch.seconds();
    findings_.megabytes = benchmark::most_megabytes();
    if (interrupted_()) return {};
    if (findings_.megabytes > kMostMegabytes) {
      fault("large", std::to_string(findings_.megabytes) + " MB");
    }
    if (watch.cancellation().requested()) {
      fault("slow", std::to_string(findings_.seconds) + " s");
      return {};
    }
    return result;
  }

  void plan_and_judge() {
    const std::optional<PlanResult> result = planned();
    if (!result) return;
    std::optional<Vector3> center_O;
    if (scene_->has_obstacles()) center_O = scene_->wrench_frame.torque_origin;
    append_faults(test::judge_plan(*result, made_.options, center_O), "plan");
    around_.emplace(made_.known.scene);
    for (std::size_t i = 0; i < result->grasps.size(); ++i) {
      if (interrupted_()) return;
      const ScoredGrasp& grasp = result->grasps[i];
      ++findings_.grasps;
      judge_trial("grasp " + std::to_string(i), grasp.trial);
      judge_path("grasp " + std::to_string(i), grasp);
    }
    if (!interrupted_()) try_again(*result);
    if (made_.twice && !interrupted_()) plan_twice(*result);
  }

  void append_faults(const std::vector<test::Fault>& more, const std::string& name) {
    for (const test::Fault& one : more)
      fault(one.kind, std::string(name).append(": ").append(one.words));
  }

  void judge_trial(const std::string& name, const Trial& trial) {
    const test::GraspJudgement judged = test::GraspJudge(made_.known, *around_, trial).judge();
    append_faults(judged.faults, name);
    findings_.contacts += judged.contacts;
    findings_.epsilons += judged.epsilon_compared;
    findings_.epsilon = std::max(findings_.epsilon, judged.epsilon_difference);
    findings_.penetration = std::max(findings_.penetration, judged.penetration);
  }

  void judge_path(const std::string& name, const ScoredGrasp& grasp) {
    if (grasp.path.has_value() != made_.options.paths.has_value()) {
      return fault("path", name + (grasp.path ? ": a path not asked for" : ": no path"));
    }
    if (!grasp.path) return;
    const test::Machine machine(made_.known.scene);
    const test::Judgement judged =
        test::PathJudge(made_.known.scene, machine, *around_, grasp).judge();
    for (const std::string& words : judged.faults) append_faults({{"path", words}}, name);
    ++findings_.paths;
    findings_.postures += judged.postures;
  }

  // A few of the candidates once more, given by name: they must end as before. Those that touch the
  // object without holding it are judged, too, which plan() does not return.
  void try_again(const PlanResult& result) {
    if (result.tried.empty()) return;
    constexpr int kAgain = 3;
    // The whole search again, which finds the same candidates in the same order.
    TrialOptions as_planned = made_.options.trial;
    as_planned.reach.kinematics.seed = derived_seed(made_.options.seed);
    const SearchResult searched =
        search_grasps(*scene_, result.primitives, made_.options.candidates, made_.options.search,
                      as_planned, {.threads = 1});
    // Behind them are the grasps that a refinement found.
    const std::size_t searched_before = result.tried.size() - refined_of(result);
    if (searched.trials.size() != searched_before) {
      return fault("again", std::to_string(searched.trials.size()) + " tried instead of " +
                                std::to_string(searched_before));
    }
    Random random(made_.seed);
    std::vector<std::size_t> again;
    std::vector<Candidate> candidates;
    for (int i = 0; i < kAgain; ++i) {
      again.push_back(random.index(searched_before));
      const auto which = static_cast<std::size_t>(result.tried[again.back()].candidate);
      candidates.push_back(searched.proposed.at(which).candidate);
    }
    EvaluateOptions options;
    options.seed = made_.options.seed;
    options.trial = made_.options.trial;
    options.trial.back_off_tries = 0;
    const std::vector<ScoredGrasp> evaluated = evaluate_freely(candidates, options);
    options.trial.back_off_tries = kBackOffs;
    for (std::size_t i = 0; i < again.size(); ++i) {
      const Trial& trial = evaluated.at(i).trial;
      const Tried& tried = result.tried[again[i]];
      const std::string name = "candidate " + std::to_string(tried.candidate);
      // Where none of the first trials held, later ones back off.
      if (is_same(tried, evaluated[i]) || !may_back_off(searched, again[i])) {
        compare(name, tried, evaluated[i], result);
      } else {
        compare(name, tried, evaluate_freely({candidates[i]}, options).at(0), result);
      }
      if (trial.outcome != Outcome::not_force_closure) continue;
      // Centring may have moved the hand to where the arm cannot follow. Such a trial has no
      // posture to judge (Trial::arm_line).
      if (scene_->arm && trial.arm_line.empty()) continue;
      ++findings_.other_trials;
      judge_trial(name, trial);
    }
  }

  std::vector<ScoredGrasp> evaluate_freely(const std::vector<Candidate>& candidates,
                                           const EvaluateOptions& options) const {
    const RunContext context{.threads = 2};
    PlanResult result = evaluate(*scene_, candidates, options, context);
    if (!options.trial.formation.dynamic) close_freely(*scene_, options.trial, context, result);
    return std::move(result.grasps);
  }

  bool may_back_off(const SearchResult& searched, std::size_t trial) const {
    int counted = 0;  // before the first that held
    for (std::size_t i = 0; i < trial && searched.trials[i].outcome != Outcome::stable; ++i) {
      counted += is_blocked(searched.trials[i].outcome) ? 0 : 1;
    }
    return counted >= made_.options.search.trials_before_back_offs;
  }

  static bool is_same(const Tried& tried, const ScoredGrasp& evaluated) {
    // A plan counts what loses a free object under how it does so.
    const bool is_lost = evaluated.trial.outcome == Outcome::stable && evaluated.free &&
                         evaluated.free->outcome == tried.outcome;
    return is_lost || tried.outcome == evaluated.trial.outcome || tried.outcome == Outcome::no_path;
  }

  static std::size_t refined_of(const PlanResult& result) {
    for (const StageCount& stage : result.stages) {
      if (stage.what == PlanCount::refined) return static_cast<std::size_t>(stage.count);
    }
    return 0;
  }

  void compare(const std::string& name, const Tried& tried, const ScoredGrasp& evaluated,
               const PlanResult& result) {
    const Trial& trial = evaluated.trial;
    if (!is_same(tried, evaluated)) {
      fault("again", name + " ended as " + std::string(name_of(tried.outcome)) + ", then as " +
                         std::string(name_of(trial.outcome)));
    }
    for (const ScoredGrasp& grasp : result.grasps) {
      const Tried& of_grasp = result.tried.at(static_cast<std::size_t>(grasp.tried));
      if (of_grasp.candidate != tried.candidate) continue;
      if (test::bytes_of(grasp.trial) != test::bytes_of(trial)) {
        fault("again", name + " gave another grasp");
      }
    }
  }

  void plan_twice(const PlanResult& first) {
    ++findings_.twice;
    RunRecord record;
    record.options = made_.options;
    const CompiledScene scene = compile(made_.known.scene, {.threads = 2});
    const PlanResult second = plan(scene, made_.options, {.threads = 2});
    if (grasps_json(*scene_, first, record) != grasps_json(scene, second, record)) {
      fault("bytes", "one and two threads differ");
    }
  }

  RandomCase made_;
  const std::function<bool()>& interrupted_;
  CaseFindings findings_;
  std::optional<CompiledScene> scene_;
  std::optional<test::Surroundings> around_;
};

}  // namespace

CaseFindings run_case(std::uint64_t seed, std::uint64_t number,
                      const std::function<bool()>& interrupted) {
  try {
    return CaseRun(random_case(seed, number), interrupted).run();
  } catch (const std::exception& error) {
    // The case could not be made.
    CaseFindings findings;
    findings.faults.push_back({"exception", error.what()});
    return findings;
  }
}

}  // namespace prehend::soak
