// Sections of a wrench space as pages read them.
#pragma once

#include <nlohmann/json.hpp>

#include "sim/quality/wrench_slice.h"

namespace prehend {

// "vertices": corners of the polyhedron, "triangles": triples of their indices, both flat lists;
// empty for an empty section. Numbers are rounded to at least four digits of the largest
// coordinate: a fixed number of decimals would not do, because the size of a wrench space depends
// on the contacts and, in the torques, on their scale.
nlohmann::ordered_json slice_json(const WrenchSlice& slice);

}  // namespace prehend
