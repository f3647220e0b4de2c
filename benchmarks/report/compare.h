// The difference between two result files, entry by entry.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/report/results.h"

namespace prehend::bench {

// One entry of both files.
struct Ratio {
  std::string name;
  std::string unit;
  double before = 0.0;  // medians
  double after = 0.0;
  // after / before; 1 where both are 0, infinite where only `before` is.
  double ratio = 1.0;
  // Whether a larger value is slower. Other entries are listed only.
  bool is_time = false;
};

struct Comparison {
  std::vector<Ratio> ratios;  // largest ratio first, equal ones by name
  std::vector<std::string> only_before;
  std::vector<std::string> only_after;
  // What keeps the two from being comparable: another processor, build or effort. In words.
  std::vector<std::string> warnings;
};

// Entries are the same where their names and units are.
Comparison compare(const Results& before, const Results& after);

// The entries of time whose ratio is above `most`.
std::vector<Ratio> slower_than(const Comparison& comparison, double most);

// All of it as text: warnings, a line an entry, what only one file has, and the verdict.
std::string comparison_text(const Comparison& comparison, double most);

}  // namespace prehend::bench
