// The integrals over parts of one solid.
#pragma once

#include <string>
#include <vector>

#include "sim/shape/convex_region.h"
#include "sim/shape/mass_parts.h"
#include "sim/shape/solid_components.h"

namespace prehend {

// The part of a solid's volume up to which what is in a region is taken for nothing.
inline constexpr double kNoVolume = 1e-9;

// Throws InputError with these parts.
[[noreturn]] void refuse(const std::string& field, const std::string& problem,
                         const std::string& value = {});

// Parts that have a volume, of a solid in its own frame and at its scale. `field` names the part in
// errors.
class PartedSolid {
 public:
  // `solid` must outlive it.
  explicit PartedSolid(const MassSolid& solid);

  // What of the solid is the part. Throws InputError where that is nothing.
  Moments moments(const MassPart& part, const std::string& field) const;
  // The volume that two parts share.
  double common_volume(const MassPart& a, const MassPart& b, const std::string& field) const;

 private:
  const SolidComponent& component_at(const MeshComponent& component,
                                     const std::string& field) const;
  ConvexRegion region(const MassPart& part, const std::string& field) const;

  const MassSolid& solid_;
  std::vector<SolidComponent> components_;
};

}  // namespace prehend
