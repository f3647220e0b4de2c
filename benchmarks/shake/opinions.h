// The simulators that are asked whether a grasp survives a protocol: a column each in the table.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "benchmarks/shake/shake_cases.h"
#include "sim/manipulation/protocol.h"

namespace prehend::bench {

struct Opinion {
  std::string name;
  std::function<ShakeResult(const ShakeCase&, const ShakenGrasp&, const Protocol&)> shake;
};

std::vector<Opinion> opinions();

}  // namespace prehend::bench
