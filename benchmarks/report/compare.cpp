#include "benchmarks/report/compare.h"

#include <algorithm>
#include <limits>
#include <map>

#include "sim/base/formatted.h"

namespace prehend::bench {
namespace {

double ratio_of(double before, double after) {
  if (before == after) return 1.0;
  if (before == 0.0) return std::numeric_limits<double>::infinity();
  return after / before;
}

void warn_if_different(const char* what, const std::string& before, const std::string& after,
                       std::vector<std::string>& warnings) {
  if (before != after) {
    warnings.push_back(std::string(what) + " differs: " + before + ", then " + after);
  }
}

}  // namespace

Comparison compare(const Results& before, const Results& after) {
  Comparison comparison;
  const auto key = [](const Entry& entry) { return name_of(entry) + " [" + entry.unit + "]"; };
  std::map<std::string, const Entry*> old_entries;
  for (const Entry& entry : before.entries) old_entries[key(entry)] = &entry;
  for (const Entry& entry : after.entries) {
    const auto old = old_entries.find(key(entry));
    if (old == old_entries.end()) {
      comparison.only_after.push_back(key(entry));
      continue;
    }
    const double then = old->second->value.median;
    const double now = entry.value.median;
    comparison.ratios.push_back(
        {name_of(entry), entry.unit, then, now, ratio_of(then, now), is_time(entry.unit)});
    old_entries.erase(old);
  }
  for (const Entry& entry : before.entries) {
    if (old_entries.contains(key(entry))) comparison.only_before.push_back(key(entry));
  }
  std::stable_sort(comparison.ratios.begin(), comparison.ratios.end(),
                   [](const Ratio& a, const Ratio& b) {
                     return a.ratio != b.ratio ? a.ratio > b.ratio : a.name < b.name;
                   });
  const Machine& a = before.machine;
  const Machine& b = after.machine;
  warn_if_different("processor", a.processor, b.processor, comparison.warnings);
  warn_if_different("number of cores", std::to_string(a.cores), std::to_string(b.cores),
                    comparison.warnings);
  warn_if_different("compiler", a.compiler, b.compiler, comparison.warnings);
  warn_if_different("build", a.build, b.build, comparison.warnings);
  warn_if_different("effort", before.effort, after.effort, comparison.warnings);
  return comparison;
}

std::vector<Ratio> slower_than(const Comparison& comparison, double most) {
  std::vector<Ratio> slower;
  std::copy_if(comparison.ratios.begin(), comparison.ratios.end(), std::back_inserter(slower),
               [most](const Ratio& entry) { return entry.is_time && entry.ratio > most; });
  return slower;
}

std::string comparison_text(const Comparison& comparison, double most) {
  std::string text;
  for (const std::string& warning : comparison.warnings) text += "warning: " + warning + "\n";
  for (const Ratio& entry : comparison.ratios) {
    const bool slower = entry.is_time && entry.ratio > most;
    text += formatted("%8.3f  %12.6g -> %12.6g %-4s %s%s\n", entry.ratio, entry.before, entry.after,
                      entry.unit.c_str(), entry.name.c_str(), slower ? "  SLOWER" : "");
  }
  for (const std::string& name : comparison.only_before)
    text += "only in the first: " + name + "\n";
  for (const std::string& name : comparison.only_after)
    text += "only in the second: " + name + "\n";
  const auto times = std::count_if(comparison.ratios.begin(), comparison.ratios.end(),
                                   [](const Ratio& entry) { return entry.is_time; });
  text += formatted("%zu entries in both, %td of them times, %zu slower by more than %.3g\n",
                    comparison.ratios.size(), times, slower_than(comparison, most).size(), most);
  return text;
}

}  // namespace prehend::bench
