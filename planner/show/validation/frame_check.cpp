#include "planner/show/validation/frame_check.h"

#include <algorithm>

#include "planner/show/validation/frame_guesses.h"
#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/parallel/parallel.h"

namespace prehend {
namespace {

const CompiledScene& scene_grasped(const ExecutedGrasps& truth, const Execution& execution) {
  return truth.objects[index(execution.label.object)].scene;
}

// Whether `count` of `all` grasps are clearly more than `given`.
bool clearly_more(int count, int given, int all) {
  const int gain = count - given;
  if (gain < 4 || 5 * gain < all) return false;
  return count >= 2 * given || 2 * (all - count) <= all - given;
}

// The likeliest of the guesses that are as good as the best of them, up to a fortieth of the
// grasps.
std::size_t likeliest(const std::vector<FrameGuess>& guesses, const std::vector<int>& counts,
                      bool steps, int all) {
  int best = -1;
  for (std::size_t g = 0; g < guesses.size(); ++g) {
    if (guesses[g].is_step == steps) best = std::max(best, counts[g]);
  }
  std::size_t g = 0;
  while (guesses[g].is_step != steps || 40 * (best - counts[g]) > all) ++g;
  return g;
}

std::optional<std::size_t> suspected(const std::vector<FrameGuess>& guesses,
                                     const std::vector<int>& counts, int given, int all) {
  const std::size_t meaning = likeliest(guesses, counts, false, all);
  const std::size_t step = likeliest(guesses, counts, true, all);
  const bool needs_step = 10 * (counts[step] - counts[meaning]) > all;
  const std::size_t found = needs_step ? step : meaning;
  if (!clearly_more(counts[found], given, all)) return std::nullopt;
  return found;
}

}  // namespace

FrameCheck check_frames(const ExecutedGrasps& truth, const RunContext& context) {
  std::vector<OpenHand> hands;
  FrameCheck check;
  for (const Execution& execution : truth.executions) {
    context.cancellation.check();
    const OpenHand hand(scene_grasped(truth, execution), execution.grasp);
    ++check.places[static_cast<std::size_t>(hand.place(execution.grasp.X_OH))];
    check.in_obstacles += hand.meets_obstacle(execution.grasp.X_OH) ? 1 : 0;
    hands.push_back(hand);
  }
  check.grasps = static_cast<int>(hands.size());
  const CompiledScene& first = scene_grasped(truth, truth.executions.front());
  const std::vector<FrameGuess> guesses = frame_guesses(*first.scene.hand.hand);
  std::vector<int> counts(guesses.size(), 0);
  for_each_in_parallel(guesses.size(), context.threads, [&](std::size_t g) {
    for (std::size_t i = 0; i < hands.size(); ++i) {
      context.cancellation.check();
      const Execution& execution = truth.executions[i];
      const Pose X_OH = guesses[g].corrected(execution.grasp.X_OH, scene_grasped(truth, execution));
      counts[g] += hands[i].place(X_OH) == ObjectPlace::between ? 1 : 0;
    }
  });
  const auto found = suspected(guesses, counts, check.between(), check.grasps);
  if (found) check.suspicion = {guesses[*found].words, guesses[*found].question, counts[*found]};
  return check;
}

std::string frame_text(const FrameCheck& check) {
  if (check.suspicion) {
    return formatted("%s the object is between the fingers of %d of %d grasps, as given of %d: %s",
                     check.suspicion->words.c_str(), check.suspicion->between, check.grasps,
                     check.between(), check.suspicion->question.c_str());
  }
  if (2 * check.between() >= check.grasps) {
    return formatted("as given the object is between the fingers of %d of %d grasps",
                     check.between(), check.grasps);
  }
  return formatted(
      "the object is between the fingers of only %d of %d grasps, and no other frame or unit that "
      "was tried is clearly better",
      check.between(), check.grasps);
}

}  // namespace prehend
