#include "planner/plan/search_grasps.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "planner/plan/learn/ordered_proposals.h"
#include "planner/plan/propose/proposal_sequence.h"
#include "planner/plan/reach_memory.h"
#include "planner/plan/run_trials.h"
#include "sim/base/index.h"
#include "sim/base/require_settings.h"

namespace prehend {
namespace {

// While no grasp is good enough, rims and bars are tried in turn with the solids from this part of
// the trials on,
constexpr double kThinPartsAfter = 0.2;
// at least for this part of them, and longer where some of them are among the grasps that are
// followed.
constexpr double kThinPartsLeast = 0.06;

// KeptTrials::holding.
void forget_contacts(Trial& trial) {
  trial.contacts = std::vector<GraspContact>();
  trial.dofs = std::vector<double>();
  trial.joints = std::vector<double>();
  trial.arm_line = std::vector<DofValues>();
  trial.arm_dofs = DofValues();
}

class GraspSearch {
 public:
  // `ordered`: the proposals of the sequence by a model; null: in their own order.
  GraspSearch(const CompiledScene& scene, ProposalSequence& sequence, OrderedProposals* ordered,
              const SearchOptions& options, const TrialOptions& trial, const RunContext& context,
              const FoundListener& found, KeptTrials kept)
      : scene_(scene),
        sequence_(sequence),
        ordered_(ordered),
        options_(options),
        trial_(trial),
        context_(context),
        found_(found),
        kept_(kept) {
    trial_.back_off_tries = 0;
  }

  SearchResult run() {
    result_.families = sequence_.families();
    result_.smallest_width = sequence_.smallest_width();
    result_.largest_opening = sequence_.largest_opening();
    std::vector<bool> tested(index(sequence_.families()), false);
    while (counted_ < options_.trials) {
      std::vector<ProposedGrasp> batch = next_batch();
      if (batch.empty()) {
        result_.end = SearchEnd::no_proposal;
        break;
      }
      if (!try_batch(batch)) break;
      if (options_.enough > 0 && stable_ >= options_.enough) {
        result_.end = SearchEnd::enough;
        break;
      }
      if (has_settled()) {
        result_.end = SearchEnd::settled;
        break;
      }
      const auto blocked = static_cast<double>(result_.trials.size()) - counted_;
      if (blocked > static_cast<double>(options_.most_blocked) * options_.trials) {
        result_.end = SearchEnd::blocked;
        break;
      }
    }
    for (const std::size_t i : result_.candidates) tested[index(result_.proposed[i].way)] = true;
    result_.families_untested = static_cast<int>(std::count(tested.begin(), tested.end(), false));
    return std::move(result_);
  }

 private:
  // A grasp whose neighbours are to be tried.
  struct Parent {
    bool preferred = false;
    double epsilon = 0.0;
    std::size_t candidate = 0;  // index into the proposals of the result
    bool followed = false;      // its neighbours are among those that wait, or were tried
  };

  std::vector<ProposedGrasp> next_batch() {
    const auto size = index(std::min(options_.batch, options_.trials - counted_));
    const auto beside =
        static_cast<std::size_t>(options_.local_fraction * static_cast<double>(size));
    std::vector<ProposedGrasp> batch;
    while (batch.size() < beside && has_neighbour()) {
      batch.push_back(std::move(waiting_.front()));
      waiting_.pop_front();
    }
    add_from_sequence(size, batch);
    return batch;
  }

  // Whether the last trials have made the best grasps no better. As long as none holds they may.
  bool has_settled() {
    constexpr double kBetter = 1.01;
    const bool preferred = !parents_.empty() && parents_.front().preferred;
    double sum = 0.0;  // a grasp that is still missing counts as 0
    for (const Parent& parent : parents_) sum += parent.epsilon;
    if (preferred != settled_on_preferred_ || sum > kBetter * settled_on_) {
      settled_on_preferred_ = preferred;
      settled_on_ = sum;
      settled_at_ = counted_;
    }
    return stable_ > 0 && counted_ - settled_at_ >= options_.settled * options_.trials;
  }

  // Goes on with the sequence until the batch has `size` candidates. Those that seem out of reach
  // are put off until the sequence has had nothing else for a while.
  void add_from_sequence(std::size_t size, std::vector<ProposedGrasp>& batch) {
    const std::size_t most_put_off = 16 * size;
    std::size_t put_off = 0;
    while (batch.size() < size && put_off < most_put_off) {
      std::optional<ProposedGrasp> next = next_proposal();
      if (!next) break;
      if (reach_.seems_out_of_reach(next->candidate.X_OH)) {
        put_off_.push_back(std::move(*next));
        ++put_off;
      } else {
        batch.push_back(std::move(*next));
      }
    }
    while (batch.size() < size && !put_off_.empty()) {
      batch.push_back(std::move(put_off_.front()));
      put_off_.pop_front();
    }
  }

  // With preferred regions, every second candidate is aimed at these as long as there are any among
  // the next few; what is passed over on the way to them waits.
  std::optional<ProposedGrasp> next_proposal() {
    constexpr int kMostPassed = 32;
    if (scene_.preferred.empty()) return next_of_sequence();
    preferred_next_ = !preferred_next_;
    for (int passed = 0; preferred_next_ ? passed < kMostPassed : passed_over_.empty(); ++passed) {
      std::optional<ProposedGrasp> next = next_of_sequence();
      if (!next) break;
      if (next->preferred || !preferred_next_) return next;
      passed_over_.push_back(std::move(*next));
    }
    if (passed_over_.empty()) return std::nullopt;
    ProposedGrasp first = std::move(passed_over_.front());
    passed_over_.pop_front();
    return first;
  }

  // Of the solids, and in turn with them of the curves, where the solids serve badly and the curves
  // better.
  std::optional<ProposedGrasp> next_of_sequence() {
    const bool served = !parents_.empty() &&
                        parents_.front().preferred == !scene_.preferred.empty() &&
                        parents_.front().epsilon >= options_.thin_parts_if_epsilon_below;
    const auto tried = static_cast<double>(result_.trials.size());
    const auto asked = static_cast<double>(options_.trials);
    const bool both =
        !served && (!scene_.preferred.empty() || tried >= kThinPartsAfter * options_.trials) &&
        (curves_proposed_ < kThinPartsLeast * std::max(tried, asked) || thin_parts_competitive());
    curve_next_ = both && !curve_next_;
    std::optional<ProposedGrasp> next = next_of(curve_next_ ? Track::curves : Track::solids);
    if (curve_next_) ++curves_proposed_;
    return next ? std::move(next) : next_of(curve_next_ ? Track::solids : Track::curves);
  }

  std::optional<ProposedGrasp> next_of(Track track) {
    return ordered_ != nullptr ? ordered_->next(track) : sequence_.next(track);
  }

  bool thin_parts_competitive() const {
    return std::any_of(parents_.begin(), parents_.end(), [&](const Parent& parent) {
      return sequence_.track_of(result_.proposed[parent.candidate]) == Track::curves;
    });
  }

  // Whether a neighbour waits to be tried, after asking the best parents for theirs.
  bool has_neighbour() {
    for (Parent& parent : parents_) {
      if (!waiting_.empty()) break;
      if (parent.followed) continue;
      parent.followed = true;
      for (ProposedGrasp& grasp : sequence_.beside(result_.proposed[parent.candidate])) {
        waiting_.push_back(std::move(grasp));
      }
    }
    return !waiting_.empty();
  }

  // Adds the trials of the batch that were finished in time; false where some were not. A hand that
  // backs off closes again, which costs as much as another candidate and seldom leads to one of the
  // best grasps. So it does only where nothing has held.
  bool try_batch(const std::vector<ProposedGrasp>& batch) {
    if (stable_ == 0 && counted_ >= options_.trials_before_back_offs) {
      trial_.back_off_tries = kBackOffs;
    }
    std::vector<Candidate> candidates;
    for (const ProposedGrasp& grasp : batch) candidates.push_back(grasp.candidate);
    const Progress before{Stage::trials, counted_, options_.trials, stable_};
    auto trials = run_trials(scene_, candidates, trial_, workers_, context_, before);
    bool is_whole = true;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      result_.proposed.push_back(batch[i]);
      if (trials[i]) {
        add(std::move(*trials[i]));
      } else {
        is_whole = false;
      }
    }
    if (!is_whole) {
      result_.end =
          context_.cancellation.requested() ? SearchEnd::cancelled : SearchEnd::out_of_time;
    }
    return is_whole;
  }

  // The trial of the last proposal.
  void add(Trial trial) {
    const std::size_t candidate = result_.proposed.size() - 1;
    if (!is_blocked(trial.outcome)) ++counted_;
    remember_reach(trial.outcome, result_.proposed.back().candidate.X_OH);
    if (ordered_ != nullptr) {
      const bool holds = trial.outcome == Outcome::stable;
      ordered_->tell(result_.proposed.back(), holds ? trial.epsilon.lower : 0.0);
    }
    if (trial.outcome == Outcome::stable) {
      if (stable_ == 0 && kept_ == KeptTrials::holding) {
        std::for_each(result_.trials.begin(), result_.trials.end(), forget_contacts);
      }
      ++stable_;
      add_parent({trial.preferred, trial.epsilon.lower, candidate, false});
      if (found_) found_(result_.proposed.back().candidate, trial);
    }
    if (trial.outcome != Outcome::stable && stable_ > 0 && kept_ == KeptTrials::holding) {
      forget_contacts(trial);
    }
    result_.candidates.push_back(candidate);
    result_.trials.push_back(std::move(trial));
  }

  // The arm is not asked for candidates whose hand is blocked on its way.
  void remember_reach(Outcome outcome, const Pose& X_OH) {
    if (scene_.arm && !is_blocked(outcome)) reach_.add(X_OH, outcome != Outcome::unreachable);
  }

  // Parents are in the order of rank(), best first, the earlier one first where it is equal.
  void add_parent(const Parent& parent) {
    const auto place = std::upper_bound(
        parents_.begin(), parents_.end(), parent, [](const Parent& a, const Parent& b) {
          return std::pair(a.preferred, a.epsilon) > std::pair(b.preferred, b.epsilon);
        });
    parents_.insert(place, parent);
    if (parents_.size() > index(options_.followed)) parents_.pop_back();
  }

  const CompiledScene& scene_;
  ProposalSequence& sequence_;
  OrderedProposals* ordered_;
  const SearchOptions& options_;
  TrialOptions trial_;
  const RunContext& context_;
  const FoundListener& found_;
  KeptTrials kept_;
  TrialWorkers workers_;
  SearchResult result_;
  int counted_ = 0;  // trials that were not blocked
  int stable_ = 0;
  // The best grasps when they last got better, and counted_ then.
  bool settled_on_preferred_ = false;
  double settled_on_ = 0.0;  // the sum of their epsilons
  int settled_at_ = 0;
  std::vector<Parent> parents_;
  std::deque<ProposedGrasp> waiting_;  // beside the best parents
  int curves_proposed_ = 0;            // in turn with solids
  bool curve_next_ = false;            // the last proposal of the sequence was of a curve
  ReachMemory reach_;
  std::deque<ProposedGrasp> put_off_;      // seem out of reach
  std::deque<ProposedGrasp> passed_over_;  // aimed elsewhere than at preferred regions
  bool preferred_next_ = false;
};

}  // namespace

SearchResult search_grasps(const CompiledScene& scene, const std::vector<Primitive>& primitives,
                           const CandidateOptions& candidates, const SearchOptions& search,
                           const TrialOptions& trial, const RunContext& context,
                           const FoundListener& found, KeptTrials kept) {
  require_settings(candidates);
  require_settings(search);
  require_settings(trial);
  ProposalSequence sequence(scene, primitives, candidates);
  std::optional<OrderedProposals> ordered;
  if (search.learned) {
    ordered.emplace(scene, primitives, candidates, sequence, *search.learned);
  }
  return GraspSearch(scene, sequence, ordered ? &*ordered : nullptr, search, trial, context, found,
                     kept)
      .run();
}

}  // namespace prehend
