// How far rankings would be from what they are with other objects and sessions.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "planner/show/validation/ranking.h"
#include "sim/base/named_enum.h"
#include "sim/base/run_context.h"
#include "sim/quality/interval.h"

namespace prehend {

// What is drawn as a whole when executions are drawn again. Grasps of one object have much in
// common, so have those of one session; to draw them one by one makes intervals too narrow.
enum class Grouping {
  object,   // all executions of an object
  session,  // all of a session
  both,     // objects and sessions independently, an execution counts as often as both were drawn:
            // the pigeonhole bootstrap (Owen, Annals of Applied Statistics 1, 2007)
  each      // every execution by itself
};

// The same word as the enumerator.
constexpr auto enum_names(Grouping /*of*/) {
  return std::to_array<std::string_view>({"object", "session", "both", "each"});
}

// The grouping that suits: by object where there are several, else by session where there are
// several, else each by itself.
Grouping natural_grouping(std::span<const Label> labels);

struct BootstrapOptions {
  Grouping grouping = Grouping::object;
  int resamples = 2000;  // >= 1
  double level = 0.95;   // of the intervals, in (0, 1)
  std::uint64_t seed = 1;
};

// A value with its interval: between the quantiles (1 - level) / 2 and (1 + level) / 2 of the
// resamples (percentile interval; Efron and Tibshirani, An Introduction to the Bootstrap, 1993).
// No interval where there is but one group, or where fewer than half of the resamples have a value.
struct Estimate {
  std::optional<double> value;
  std::optional<Interval> interval;
};

struct RankingEstimates {
  std::vector<Estimate> auc;  // of each ranking
  // AUC of each ranking minus that of the reference, in the same resamples.
  std::vector<Estimate> difference;
  int groups = 0;     // that were drawn from; of `both`, objects and sessions together
  int undefined = 0;  // resamples in which all executions had the same outcome
};

// The same on any machine. `rankings` are of the executions of `labels`; `reference` is the index
// of one of them. Throws Cancelled.
RankingEstimates bootstrap_auc(std::span<const Ranking> rankings, std::span<const Label> labels,
                               std::size_t reference, const BootstrapOptions& options,
                               const RunContext& context = {});

}  // namespace prehend
