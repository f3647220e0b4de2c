#include "benchmarks/report/hands_page.h"

#include <algorithm>
#include <utility>

#include "benchmarks/report/page_writer.h"
#include "benchmarks/support/percentile.h"
#include "sim/base/joined.h"

namespace prehend::bench {
namespace {

using Row = std::vector<std::string>;

std::vector<std::string> hands_of(const std::vector<HandOnObject>& plans) {
  std::vector<std::string> names;
  for (const HandOnObject& plan : plans) {
    if (std::find(names.begin(), names.end(), plan.hand) == names.end()) {
      names.push_back(plan.hand);
    }
  }
  return names;
}

Row summary_of(const std::string& hand, const std::vector<HandOnObject>& plans) {
  std::vector<double> epsilons;
  std::vector<double> seconds;
  std::string without;
  for (const HandOnObject& plan : plans) {
    if (plan.hand != hand || !plan.of_its_size) continue;
    epsilons.push_back(plan.epsilon);
    seconds.push_back(plan.seconds);
    if (!(plan.epsilon > 0.0)) add_part(without, plan.object);
  }
  const auto held =
      std::count_if(epsilons.begin(), epsilons.end(), [](double e) { return e > 0.0; });
  const std::string count = std::to_string(held) + " of " + std::to_string(epsilons.size());
  if (epsilons.empty()) return {hand, count, "–", "–", ""};
  return {hand, count, value_text(benchmark::percentile(epsilons, 0.5), "1"),
          value_text(benchmark::percentile(seconds, 0.5), "s"), without};
}

Row row_of(const HandOnObject& plan) {
  const bool holds = plan.epsilon > 0.0;
  return {plan.hand,
          plan.object + (plan.of_its_size ? "" : " (not of its size)"),
          holds ? value_text(plan.epsilon, "1") : "–",
          std::to_string(plan.stable),
          value_text(plan.seconds, "s"),
          plan.rule};
}

}  // namespace

std::string hands_page(const std::vector<HandOnObject>& plans) {
  PageWriter page;
  page.heading(1, "Hands and objects");
  page.paragraph(
      "Every hand of the library, free in space, on every object: a plan with the defaults. Made "
      "by "
      "`./run bench hands FOLDER...`. An object is of a hand's size when its smallest extent along "
      "its principal axes is one that a preshape of the hand takes.");
  std::vector<Row> rows;
  for (const std::string& hand : hands_of(plans)) rows.push_back(summary_of(hand, plans));
  page.table({"hand", "grasped, of its size", "best ε, median", "time, median", "no grasp on"},
             rows);
  page.heading(2, "All plans");
  rows.clear();
  for (const HandOnObject& plan : plans) rows.push_back(row_of(plan));
  page.table({"hand", "object", "best ε", "grasps that hold", "time", "rule of the best"}, rows);
  return std::move(page).files().back().content;
}

}  // namespace prehend::bench
