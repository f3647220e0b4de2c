#include "benchmarks/report/names.h"
#include "benchmarks/report/page_parts.h"
#include "benchmarks/report/row_chart.h"

namespace prehend::bench {

void add_kernels(const Results& results, PageWriter& page) {
  const std::vector<Entry> entries = entries_of(results, kKernels, kCall);
  if (entries.empty()) return;
  page.heading(2, "Kernels");
  page.paragraph(
      "One call each, measured by Google Benchmark. A sample is the mean of the "
      "many calls of one "
      "repetition, so that the spread is that of the machine, not of the inputs.");
  RangeChart chart{"Kernels: one call", "median, 90 %, 99 % of the repetitions [ns]", {}};
  std::vector<std::vector<std::string>> rows;
  for (const Entry& entry : entries) {
    const Summary& value = entry.value;
    chart.rows.push_back({entry.series, value});
    rows.push_back({entry.series, value_text(value.median, entry.unit),
                    value_text(value.p90, entry.unit), value_text(value.p99, entry.unit),
                    std::to_string(value.samples)});
  }
  page.picture("kernels", "Times of kernels", range_chart_svg(chart));
  page.table({"kernel", "median", "90 %", "99 %", "repetitions"}, rows);
}

}  // namespace prehend::bench
