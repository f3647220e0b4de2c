// How a search chooses the candidates that it tries (search_grasps.h).
#pragma once

#include <functional>
#include <optional>

#include "planner/plan/learn/learned_order.h"
#include "sim/base/settings.h"

namespace prehend {

struct Candidate;
struct Trial;

// How often the hand backs off where none of the first trials has held.
constexpr int kBackOffs = 4;

struct SearchOptions {
  static constexpr AboutSettings kAbout{
      "SearchOptions",
      "How many candidates are tried, and how much the search follows what it finds."};
  // With an arm, candidates come first whose hand has an orientation near which the arm reached
  // others.
  int trials = 800;
  int most_blocked = 10;
  int enough = 0;
  // On 18 meshes, a plan with the Barrett hand takes 0.78 of the time of one that makes all trials,
  // with the Franka hand 0.62; the best epsilon is the same in the median, and 0.97 and 0.98 times
  // as large in the mean.
  double settled = 0.2;
  // What is chosen depends on all trials of the batches before, in whatever order threads finish
  // them.
  int batch = 32;
  double local_fraction = 0.3;
  int followed = 10;
  double thin_parts_if_epsilon_below = 0.15;
  // Fingers that swing while they close, as those of the Robotiq 2F-85, may hold a box only at
  // their tips.
  int trials_before_back_offs = 100;
  // Set: a model that was learnt from earlier trials orders the proposals of the sequence
  // (docs/how-to/learning.md).
  std::optional<LearnedOrder> learned = {};
};

// The settings of a learned order, where there is one, are visited through LearnedOrder.
template <SettingsOf<SearchOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [trials, most_blocked, enough, settled, batch, local_fraction, followed,
         thin_parts_if_epsilon_below, trials_before_back_offs, learned] = options;
  visit("trials", trials, kCountAbove0, "",
        "Most trials; those whose hand is blocked on its way cost next to nothing and are not "
        "counted.");
  visit("most_blocked", most_blocked, kCount, "",
        "Most candidates whose hand is blocked on its way, as a multiple of `trials`.");
  visit("enough", enough, kCount, "",
        "The search ends after the batch in which it has so many stable grasps; 0: after all "
        "trials.");
  visit(
      "settled", settled, kFractionAbove0, "",
      "The search ends when this part of `trials` has made the best grasps (`followed`) no better, "
      "in the mean by 1 %; 1: after all trials.");
  visit("batch", batch, kCountAbove0, "",
        "Candidates that are chosen together; more: better use of many processors, later use of "
        "what was found.");
  visit("follow", local_fraction, kFraction, "",
        "Part of a batch that lies beside the best grasps so far; the others continue the sequence "
        "of proposals.");
  visit("followed", followed, kCount, "", "How many of the best grasps are followed.");
  visit("well_served", thin_parts_if_epsilon_below, kRatio, "",
        "While no grasp has an epsilon of at least this, rims and bars are tried in turn with "
        "boxes, spheres, cylinders and cones.");
  visit(
      "patience", trials_before_back_offs, kCount, "",
      "After so many trials of which none has held, the hand backs off; until then a search tries "
      "its candidates once.");
  visit.unlisted("learned", learned, "Set: a model orders the proposals of the sequence.");
}

// Is told of each stable trial of a search as soon as its batch is finished, in the order of the
// candidates; may be empty. Never called by two threads at once.
using FoundListener = std::function<void(const Candidate&, const Trial&)>;

}  // namespace prehend
