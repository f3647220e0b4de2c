// What shaking showed of a grasp, in grasps.json.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim/manipulation/shake_report.h"

namespace prehend {

// {protocol, survived, of, holds, tests: [...], simulation: {...}} (docs/reference/grasps-file.md).
nlohmann::ordered_json shake_to_json(const ShakeReport& report);

// One of its tests, and how much work the simulation was.
nlohmann::ordered_json shake_test_to_json(const ShakeTestReport& test);
nlohmann::ordered_json effort_to_json(const SimulationEffort& effort);

}  // namespace prehend
