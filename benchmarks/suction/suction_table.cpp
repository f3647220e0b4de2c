#include "benchmarks/suction/suction_table.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>

#include "sim/base/formatted.h"

namespace prehend::bench {
namespace {

using Choose = std::function<bool(const SuctionResult&)>;

int count_of(const std::vector<SuctionResult>& results, const Choose& chosen) {
  return static_cast<int>(std::count_if(results.begin(), results.end(), chosen));
}

bool predicted(const SuctionResult& result) { return result.margin >= 1.0; }

// Heads of columns, a line of the table each.
std::string row_of(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& cell : cells) row += " " + cell + " |";
  return row + "\n";
}

std::string head_of(const std::vector<std::string>& cells) {
  return row_of(cells) + row_of(std::vector<std::string>(cells.size(), "---"));
}

std::string agreement_table(const std::vector<SuctionResult>& results) {
  std::string table =
      head_of({"held in MuJoCo by", "predicted to hold: held", "lost", "predicted not to: held",
               "lost", "agree", "agree without the bound on bending"});
  for (const HeldReading reading : kAll<HeldReading>) {
    const auto count = [&](bool predicts, bool holds) {
      return count_of(results, [&](const SuctionResult& of) {
        return predicted(of) == predicts && of.held[reading] == holds;
      });
    };
    const int agree = count(true, true) + count(false, false);
    const int elastic = count_of(results, [&](const SuctionResult& of) {
      return (of.elastic_margin >= 1.0) == of.held[reading];
    });
    table += row_of({std::string(name_of(reading)), std::to_string(count(true, true)),
                     std::to_string(count(true, false)), std::to_string(count(false, true)),
                     std::to_string(count(false, false)),
                     formatted("**%d of %zu**", agree, results.size()), std::to_string(elastic)});
  }
  return table;
}

std::vector<std::string> reading_heads(const std::string& first) {
  std::vector<std::string> heads = {first, "picks"};
  for (const HeldReading reading : kAll<HeldReading>) heads.emplace_back(name_of(reading));
  return heads;
}

// A line of those chosen: how many, and for each reading how many of them `counts` takes.
std::string line_of(const std::string& name, const std::vector<SuctionResult>& results,
                    const Choose& chosen,
                    const std::function<bool(const SuctionResult&, HeldReading)>& counts) {
  std::vector<std::string> cells = {name, std::to_string(count_of(results, chosen))};
  for (const HeldReading reading : kAll<HeldReading>) {
    cells.push_back(std::to_string(count_of(
        results, [&](const SuctionResult& of) { return chosen(of) && counts(of, reading); })));
  }
  return row_of(cells);
}

std::string group_table(const std::vector<SuctionResult>& results) {
  const auto agrees = [](const SuctionResult& of, HeldReading reading) {
    return predicted(of) == of.held[reading];
  };
  std::string table = head_of(reading_heads("agree of"));
  std::vector<std::string> hands;
  for (const SuctionResult& of : results) {
    if (std::find(hands.begin(), hands.end(), of.hand) == hands.end()) hands.push_back(of.hand);
  }
  for (const std::string& hand : hands) {
    table += line_of(
        "`" + hand + "`", results, [&](const SuctionResult& of) { return of.hand == hand; },
        agrees);
  }
  for (const HungAttitude attitude : kAll<HungAttitude>) {
    table += line_of(
        std::string(name_of(attitude)), results,
        [&](const SuctionResult& of) { return of.attitude == attitude; }, agrees);
  }
  return table;
}

std::string margin_table(const std::vector<SuctionResult>& results) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  constexpr std::array<double, 8> kLevels = {0.0, 0.5, 0.8, 1.0, 1.25, 1.6, 2.2, kInfinite};
  std::string table = head_of(reading_heads("held with a margin of"));
  for (std::size_t k = 0; k + 1 < kLevels.size(); ++k) {
    const double low = kLevels[k];
    const double high = kLevels[k + 1];
    const std::string name = k == 0              ? formatted("below %g", high)
                             : high == kInfinite ? formatted("from %g on", low)
                                                 : formatted("%g to %g", low, high);
    table += line_of(
        name, results,
        [&](const SuctionResult& of) { return of.margin >= low && of.margin < high; },
        [](const SuctionResult& of, HeldReading reading) { return of.held[reading]; });
  }
  return table;
}

}  // namespace

std::string suction_tables(const std::vector<SuctionResult>& results) {
  return agreement_table(results) + "\n" + group_table(results) + "\n" + margin_table(results);
}

}  // namespace prehend::bench
