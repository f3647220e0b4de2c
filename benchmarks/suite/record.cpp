#include "benchmarks/suite/record.h"

#include <cstdio>
#include <utility>

namespace prehend::bench {

Record::Record(std::string part, std::vector<Entry>& entries)
    : part_(std::move(part)), entries_(entries) {}

void Record::add(const std::string& group, const std::string& series, const std::string& unit,
                 const std::vector<double>& values, std::optional<double> x) {
  if (values.empty()) return;
  entries_.push_back({part_, group, series, x, unit, summarize(values)});
}

void Record::say(const std::string& words) const {
  std::fprintf(stderr, "bench: %s: %s\n", part_.c_str(), words.c_str());
}

}  // namespace prehend::bench
