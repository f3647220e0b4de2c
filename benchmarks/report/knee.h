// Where a curve of gain over cost stops being worth it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "benchmarks/report/power_law.h"

namespace prehend::bench {

// The index of the point that lies highest above the line from the first point to the last, both
// axes scaled to that line's extent (Satopaa, Albrecht, Irwin and Raghavan 2011, "Finding a
// 'kneedle' in a haystack"). x must ascend. Of points equally high it is the first. Nothing with
// fewer than three points, and where none lies above the line: the curve has no knee.
std::optional<std::size_t> knee_of(const std::vector<DataPoint>& curve);

}  // namespace prehend::bench
