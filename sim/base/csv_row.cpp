#include "sim/base/csv_row.h"

#include "sim/base/number_text.h"

namespace prehend {

void CsvRow::text(const std::string& value) {
  separate();
  if (value.find_first_of(",\"\r\n") == std::string::npos) {
    line_ += value;
    return;
  }
  line_ += '"';
  for (const char c : value) {
    if (c == '"') line_ += '"';
    line_ += c;
  }
  line_ += '"';
}

void CsvRow::texts(const std::string& prefix, const std::vector<std::string>& names,
                   const std::string& suffix) {
  for (const std::string& name : names) text(std::string(prefix).append(name).append(suffix));
}

void CsvRow::number(double value) { text(number_text(value)); }

void CsvRow::numbers(const std::vector<double>& values) {
  for (const double value : values) number(value);
}

void CsvRow::vector(const Vector3& v) { numbers({v.x(), v.y(), v.z()}); }

void CsvRow::pose(const Pose& pose) {
  const Eigen::Quaterniond q = quaternion_of(pose).normalized();
  vector(pose.translation());
  numbers({q.w(), q.x(), q.y(), q.z()});
}

void CsvRow::separate() {
  if (!first_) line_ += ',';
  first_ = false;
}

}  // namespace prehend
