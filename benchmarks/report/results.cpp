#include "benchmarks/report/results.h"

#include <algorithm>

#include "benchmarks/support/percentile.h"
#include "sim/base/formatted.h"

namespace prehend::bench {

Summary summarize(const std::vector<double>& values) {
  Summary summary;
  summary.samples = static_cast<int>(values.size());
  summary.least = benchmark::percentile(values, 0.0);
  summary.p10 = benchmark::percentile(values, 0.1);
  summary.median = benchmark::percentile(values, 0.5);
  summary.p90 = benchmark::percentile(values, 0.9);
  summary.p99 = benchmark::percentile(values, 0.99);
  summary.most = benchmark::percentile(values, 1.0);
  for (const double value : values) summary.mean += value / summary.samples;
  return summary;
}

std::string name_of(const Entry& entry) {
  std::string name = entry.part + "/" + entry.group + "/" + entry.series;
  if (entry.x) name += formatted("/%.10g", *entry.x);
  return name;
}

std::vector<Entry> entries_of(const Results& results, const std::string& part,
                              const std::string& group) {
  std::vector<Entry> found;
  std::copy_if(results.entries.begin(), results.entries.end(), std::back_inserter(found),
               [&](const Entry& entry) { return entry.part == part && entry.group == group; });
  return found;
}

const Entry* find_entry(const Results& results, const std::string& name) {
  const auto found = std::find_if(results.entries.begin(), results.entries.end(),
                                  [&](const Entry& entry) { return name_of(entry) == name; });
  return found == results.entries.end() ? nullptr : &*found;
}

bool is_time(const std::string& unit) {
  return unit == "ns" || unit == "us" || unit == "ms" || unit == "s";
}

}  // namespace prehend::bench
