// The contact threshold (0.1 mm), and how the contacts of an area are reduced to a few points.
#pragma once

#include "sim/base/settings.h"

namespace prehend {

struct ContactOptions {
  static constexpr AboutSettings kAbout{"ContactOptions", "What counts as a contact."};
  double threshold = 1e-4;
  // Two faces that should be parallel are not exactly so in floating point.
  double evenness = 1e-5;
  double angular_tolerance = 0.02;
  int max_region_corners = 8;
};

template <SettingsOf<ContactOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [threshold, evenness, angular_tolerance, max_region_corners] = options;
  visit("threshold", threshold, kLengthAbove0, "m", "Surfaces closer than this touch.");
  visit("evenness", evenness, kDistance, "m",
        "Points of a face contact whose gap exceeds the smallest one by at most this belong to "
        "it.");
  visit("angular_tolerance", angular_tolerance, kRatio, "",
        "Sine of the angle by which a surface may rise above the tangent plane of a contact, and "
        "within which normals count as equal.");
  visit("max_region_corners", max_region_corners, Range{.lower = 3.0, .upper = kLargestCount}, "",
        "Most corners of a region of contact; those go first whose removal costs the least area.");
}

}  // namespace prehend
