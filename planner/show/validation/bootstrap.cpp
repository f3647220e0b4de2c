#include "planner/show/validation/bootstrap.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"
#include "sim/base/random.h"

namespace prehend {
namespace {

int count_of(std::span<const Label> labels, int Label::*member) {
  int count = 0;
  for (const Label& label : labels) count = std::max(count, label.*member + 1);
  return count;
}

// How many different values of `member` there are; numbers may have gaps.
int distinct(std::span<const Label> labels, int Label::*member) {
  std::vector<bool> seen(index(count_of(labels, member)), false);
  for (const Label& label : labels) seen[index(label.*member)] = true;
  return static_cast<int>(std::count(seen.begin(), seen.end(), true));
}

// A way to part the executions: the group of each, numbered without gaps.
struct Parts {
  std::vector<std::size_t> group;
  std::size_t count = 0;
};

Parts parts_by(std::span<const Label> labels, int Label::*member) {
  Parts parts;
  std::vector<std::size_t> number(index(count_of(labels, member)), labels.size());
  for (const Label& label : labels) {
    std::size_t& known = number[index(label.*member)];
    if (known == labels.size()) known = parts.count++;
    parts.group.push_back(known);
  }
  return parts;
}

Parts each_apart(std::span<const Label> labels) {
  Parts parts{{}, labels.size()};
  for (std::size_t i = 0; i < labels.size(); ++i) parts.group.push_back(i);
  return parts;
}

std::vector<Parts> parts_of(std::span<const Label> labels, Grouping grouping) {
  switch (grouping) {
    case Grouping::object:
      return {parts_by(labels, &Label::object)};
    case Grouping::session:
      return {parts_by(labels, &Label::session)};
    case Grouping::both:
      return {parts_by(labels, &Label::object), parts_by(labels, &Label::session)};
    case Grouping::each:
      break;
  }
  return {each_apart(labels)};
}

// Draws as many groups of each way to part them as there are, with replacement.
void draw(const std::vector<Parts>& ways, std::span<const Label> labels, Random& random,
          std::vector<double>& weights) {
  for (std::size_t i = 0; i < labels.size(); ++i) weights[i] = labels[i].times;
  for (const Parts& parts : ways) {
    std::vector<int> drawn(parts.count, 0);
    for (std::size_t g = 0; g < parts.count; ++g) ++drawn[random.index(parts.count)];
    for (std::size_t i = 0; i < labels.size(); ++i) weights[i] *= drawn[parts.group[i]];
  }
}

// Of sorted values, interpolated between the two beside it (Hyndman and Fan 1996, type 7).
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

std::optional<Interval> interval_of(std::vector<double> values, const BootstrapOptions& options) {
  if (2 * values.size() < static_cast<std::size_t>(options.resamples)) return std::nullopt;
  std::sort(values.begin(), values.end());
  return Interval{quantile(values, 0.5 * (1.0 - options.level)),
                  quantile(values, 0.5 * (1.0 + options.level))};
}

}  // namespace

Grouping natural_grouping(std::span<const Label> labels) {
  if (distinct(labels, &Label::object) > 1) return Grouping::object;
  return distinct(labels, &Label::session) > 1 ? Grouping::session : Grouping::each;
}

RankingEstimates bootstrap_auc(std::span<const Ranking> rankings, std::span<const Label> labels,
                               std::size_t reference, const BootstrapOptions& options,
                               const RunContext& context) {
  RankingEstimates estimates;
  const std::vector<double> given = weights_of(labels);
  const std::optional<double> base = rankings[reference].auc(given);
  for (const Ranking& ranking : rankings) {
    const std::optional<double> auc = ranking.auc(given);
    estimates.auc.push_back({auc, {}});
    estimates.difference.push_back({auc && base ? std::optional(*auc - *base) : std::nullopt, {}});
  }
  const std::vector<Parts> ways = parts_of(labels, options.grouping);
  std::size_t most = 0;
  for (const Parts& parts : ways) {
    estimates.groups += static_cast<int>(parts.count);
    most = std::max(most, parts.count);
  }
  if (most < 2) return estimates;
  std::vector<std::vector<double>> drawn(rankings.size());
  std::vector<std::vector<double>> apart(rankings.size());
  std::vector<double> weights(labels.size());
  Random random(derived_seed(options.seed));
  for (int r = 0; r < options.resamples; ++r) {
    context.cancellation.check();
    draw(ways, labels, random, weights);
    // Whether there are both outcomes does not depend on the score.
    const std::optional<double> of_base = rankings[reference].auc(weights);
    if (!of_base) {
      ++estimates.undefined;
      continue;
    }
    for (std::size_t s = 0; s < rankings.size(); ++s) {
      const double auc = s == reference ? *of_base : *rankings[s].auc(weights);
      drawn[s].push_back(auc);
      apart[s].push_back(auc - *of_base);
    }
  }
  for (std::size_t s = 0; s < rankings.size(); ++s) {
    estimates.auc[s].interval = interval_of(std::move(drawn[s]), options);
    estimates.difference[s].interval = interval_of(std::move(apart[s]), options);
  }
  return estimates;
}

}  // namespace prehend
