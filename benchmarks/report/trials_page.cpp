#include "benchmarks/report/names.h"
#include "benchmarks/report/page_parts.h"
#include "benchmarks/report/row_chart.h"

namespace prehend::bench {
namespace {

// The median of another group for the same series; 0 where it was not measured.
double median_of(const Results& results, const std::string& group, const std::string& series) {
  const Entry* entry = find_entry(results, std::string(kTrials) + "/" + group + "/" + series);
  return entry == nullptr ? 0.0 : entry->value.median;
}

ShareChart shares_of(const Results& results, const std::vector<Entry>& times) {
  ShareChart chart{"What a trial spends its time on", {}, {}};
  for (const char* stage : kTrialStages) chart.parts.emplace_back(stage);
  for (const Entry& entry : times) {
    ShareRow row{entry.series, {}};
    for (const char* stage : kTrialStages) {
      row.shares.push_back(median_of(results, std::string(kShareOf) + stage, entry.series));
    }
    chart.rows.push_back(row);
  }
  return chart;
}

void add_trial_tables(const Results& results, const std::vector<Entry>& times,
                      const ShareChart& shares, PageWriter& page) {
  std::vector<std::string> headings = {"hand, object", "median",     "90 %", "99 %",
                                       "trials",       "in contact", "hold", "trials/s"};
  for (const std::string& part : shares.parts) headings.push_back(part);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Entry& entry = times[i];
    const Summary& value = entry.value;
    rows.push_back({entry.series, value_text(value.median, entry.unit),
                    value_text(value.p90, entry.unit), value_text(value.p99, entry.unit),
                    std::to_string(value.samples),
                    value_text(median_of(results, kInContact, entry.series), "%"),
                    value_text(median_of(results, kHolds, entry.series), "%"),
                    value_text(median_of(results, kTriedPerSecond, entry.series), "1")});
    for (const double share : shares.rows[i].shares) rows.back().push_back(value_text(share, "%"));
  }
  page.table(headings, rows);
}

void add_arms(const Results& results, PageWriter& page) {
  std::vector<std::vector<std::string>> rows;
  for (const char* group : {kReach, kPath, kPathCheck, kMotion}) {
    for (const Entry& entry : entries_of(results, kTrials, group)) {
      const Summary& value = entry.value;
      const std::string unit = entry.group == kMotion ? "s" : entry.unit;
      rows.push_back({std::string(group) + ", " + entry.series, value_text(value.median, unit),
                      value_text(value.p90, unit), value_text(value.p99, unit),
                      std::to_string(value.samples)});
    }
  }
  if (rows.empty()) return;
  page.heading(3, "With an arm");
  page.paragraph(
      "For the best grasps of each scene: the arm along the approach, then the whole path. The "
      "duration of the motion is that of the robot, not of the planner.");
  page.table({"what, scene", "median", "90 %", "99 %", "grasps"}, rows);
}

}  // namespace

void add_trials(const Results& results, PageWriter& page) {
  const std::vector<Entry> times = entries_of(results, kTrials, kTrialTime);
  if (!times.empty()) {
    page.heading(2, "Whole trials");
    page.paragraph(
        "Trials that end with contacts, from the pre-grasp to ε; trials that end before are "
        "cheaper, and are left out. \"In contact\", \"hold\" and trials a second are of all "
        "trials. "
        "The shares are sums over the same trials: approach and reach as each trial measures them, "
        "the others by calling the stages once more, one by one.");
    RangeChart chart{
        "Trials that end in contact, by hand and object", "median, 90 %, 99 % [ms]", {}};
    for (const Entry& entry : times) chart.rows.push_back({entry.series, entry.value});
    page.picture("trials", "Times of trials", range_chart_svg(chart));
    const ShareChart shares = shares_of(results, times);
    page.picture("stages", "Shares of the stages", share_chart_svg(shares));
    add_trial_tables(results, times, shares, page);
  }
  add_arms(results, page);
}

}  // namespace prehend::bench
