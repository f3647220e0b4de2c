// What a run of the benchmarks found: values, each with its name, unit and spread, and the machine.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace prehend::bench {

// The spread of repeated measurements of one thing.
struct Summary {
  int samples = 0;
  double least = 0.0;
  double p10 = 0.0;
  double median = 0.0;
  double p90 = 0.0;
  double p99 = 0.0;
  double most = 0.0;
  double mean = 0.0;
};

// All zeros where there are no values.
Summary summarize(const std::vector<double>& values);

// One measured quantity. Entries that are shown in one table or plot share their part and group;
// those that are one line of it share the series.
struct Entry {
  std::string part;         // of the suite: "kernels", "trials", ...
  std::string group;        // what was measured: "trial", "share of closing", ...
  std::string series;       // of what: "barrett, mug", ...
  std::optional<double> x;  // size of the problem, where that was varied
  std::string unit;         // "1" without a dimension
  Summary value;
};

// Its parts joined by "/": the name by which two result files are compared.
std::string name_of(const Entry& entry);

// What was measured, with what, and when.
struct Machine {
  std::string prehend;    // version
  std::string compiler;   // with its version
  std::string build;      // type of the build: "Release"
  std::string processor;  // model
  int cores = 0;
  std::string date;  // UTC, as 2026-01-31T23:59:59Z
};

struct Results {
  std::string effort;  // "full", "quick" or "smoke": how many repetitions and sizes
  Machine machine;
  std::vector<Entry> entries;
};

// The entries of one part and group, in their order.
std::vector<Entry> entries_of(const Results& results, const std::string& part,
                              const std::string& group);
// The entry of that name; null where there is none.
const Entry* find_entry(const Results& results, const std::string& name);

// Whether the unit is one of time, in which more is slower: ns, us, ms, s.
bool is_time(const std::string& unit);

}  // namespace prehend::bench
