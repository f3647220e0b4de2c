// What a linear elastic solid is made of.
#pragma once

#include "sim/base/range.h"

namespace prehend {

// Between foams and hard metals [Pa].
inline constexpr Range kYoungsModulus{.lower = 1e2, .upper = 1e13};
// Of materials that do not widen when they are pulled. At 0.5 the volume could not change at all,
// and pressures would not follow from displacements: rubber has 0.49 to 0.4999.
inline constexpr Range kPoissonsRatio{.lower = 0.0, .upper = 0.4999};

struct ElasticMaterial {
  double youngs_modulus = 2e6;  // Pa
  double poissons_ratio = 0.48;

  friend bool operator==(const ElasticMaterial&, const ElasticMaterial&) = default;
};

}  // namespace prehend
