#include "benchmarks/report/names.h"
#include "benchmarks/report/page_parts.h"
#include "sim/base/run_context.h"

namespace prehend::bench {

// A row for each run, a column for each stage that one of them has.
void add_plans(const Results& results, PageWriter& page) {
  const std::vector<Entry> runs = entries_of(results, kPlans, kRun);
  if (runs.empty()) return;
  page.heading(2, "What users wait for");
  page.paragraph(
      "`prehend plan` on one thread, from its start to the last file: medians, and what its stages "
      "take of it.");
  std::vector<std::string> headings = {"scene, options", "runs", kRun};
  std::vector<std::vector<std::string>> rows;
  for (const Entry& run : runs) {
    rows.push_back(
        {run.series, std::to_string(run.value.samples), value_text(run.value.median, run.unit)});
  }
  for (const std::string_view stage : enum_names(Stage{})) {
    const std::string group = kTimeOf + std::string(stage);
    if (entries_of(results, kPlans, group).empty()) continue;
    headings.emplace_back(stage);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const Entry* time =
          find_entry(results, std::string(kPlans) + "/" + group + "/" + runs[i].series);
      rows[i].push_back(time == nullptr ? "" : value_text(time->value.median, time->unit));
    }
  }
  page.table(headings, rows);
}

}  // namespace prehend::bench
