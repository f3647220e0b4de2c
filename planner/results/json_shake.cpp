#include "planner/results/json_shake.h"

#include "planner/results/shake_fields.h"
#include "sim/base/json/json_fields.h"

namespace prehend {

nlohmann::ordered_json shake_to_json(const ShakeReport& report) {
  FieldWriter fields;
  shake_fields(fields, report);
  return std::move(fields).json();
}

nlohmann::ordered_json shake_test_to_json(const ShakeTestReport& test) {
  FieldWriter fields;
  shake_test_fields(fields, test);
  return std::move(fields).json();
}

nlohmann::ordered_json effort_to_json(const SimulationEffort& effort) {
  FieldWriter fields;
  effort_fields(fields, effort);
  return std::move(fields).json();
}

}  // namespace prehend
