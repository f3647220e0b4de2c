// What shaking showed of a grasp, in grasps.json.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim/manipulation/shake.h"

namespace prehend {

// {protocol, survived, of, holds, tests: [...], simulation: {...}} (docs/grasp-file.md).
nlohmann::ordered_json shake_to_json(const ShakeReport& report);

}  // namespace prehend
