// Adds entries, and says on stderr what is being measured.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "benchmarks/report/results.h"

namespace prehend::bench {

// Entries of one part.
class Record {
 public:
  Record(std::string part, std::vector<Entry>& entries);

  // Nothing where there are no values.
  void add(const std::string& group, const std::string& series, const std::string& unit,
           const std::vector<double>& values, std::optional<double> x = {});
  void add(const std::string& group, const std::string& series, const std::string& unit,
           double value, std::optional<double> x = {}) {
    add(group, series, unit, std::vector<double>{value}, x);
  }

  // One line of progress.
  void say(const std::string& words) const;

 private:
  std::string part_;
  std::vector<Entry>& entries_;
};

}  // namespace prehend::bench
