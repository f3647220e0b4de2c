// A row of a table of comma separated values.
#pragma once

#include <string>
#include <vector>

#include "sim/base/pose.h"

namespace prehend {

// A row that grows. A text with a comma, a quote or a line break is put in quotes, with quotes
// inside it doubled (RFC 4180, section 2). Numbers are written by number_text, which throws
// InputError for those that are not finite.
class CsvRow {
 public:
  void text(const std::string& value);
  // A cell for each name, with what comes before and after it.
  void texts(const std::string& prefix, const std::vector<std::string>& names,
             const std::string& suffix);
  void number(double value);
  void numbers(const std::vector<double>& values);
  // Three cells.
  void vector(const Vector3& v);
  // Seven cells: position [m] and the unit quaternion, w first.
  void pose(const Pose& pose);

  // With a line break behind it.
  std::string line() const { return line_ + "\n"; }

 private:
  void separate();

  std::string line_;
  bool first_ = true;
};

}  // namespace prehend
