// How a model that was learnt from earlier trials orders proposals (ordered_proposals.h).
#pragma once

#include <memory>

#include "sim/base/settings.h"

namespace prehend {

struct TreeModel;

struct LearnedOrder {
  static constexpr AboutSettings kAbout{
      "LearnedOrder",
      "How a model that was learnt from earlier trials orders the "
      "proposals."};
  std::shared_ptr<const TreeModel> model = {};  // not null; fits the scene's hand (require_fit)
  int choose_from = 512;
  // Without variety the first many would be nearly the same grasp, and one error of the model would
  // spoil all of them.
  double variety = 0.5;
  double unordered = 0.1;
  // A model helps a search to begin; later on the neighbours of what was found are better advice.
  int ordered_first = 200;
  // What is easy is found by these, and what becomes of them tells whether the model can judge the
  // hand: where its scores do not rank them, nothing is ordered.
  int unknown_hand_first = 32;
};

template <SettingsOf<LearnedOrder> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [model, choose_from, variety, unordered, ordered_first, unknown_hand_first] = options;
  visit("choose_from", choose_from, kCountAbove0, "",
        "Proposals of solids that wait at any time, and a quarter as many of curves; each next one "
        "is chosen among them.");
  visit("variety", variety, kRatio, "",
        "What is chosen has the largest score, less this times the square of its likeness to the "
        "most alike that came before it.");
  visit("unordered", unordered, kFraction, "",
        "Part of the proposals that come in the order of the sequence: what the model scores badly "
        "is tried as well.");
  visit("ordered_first", ordered_first, kCount, "",
        "Proposals that are ordered; behind them come all that wait, then the sequence goes on in "
        "its own order.");
  visit("unknown_hand_first", unknown_hand_first, kCount, "",
        "Proposals in the order of the sequence that come first where the model was not trained on "
        "the scene's hand.");
}

}  // namespace prehend
