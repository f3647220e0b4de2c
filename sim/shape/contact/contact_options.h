// The contact threshold (0.1 mm), and how the contacts of an area are reduced to a few points.
#pragma once

#include "sim/base/settings.h"

namespace prehend {

// When surfaces touch, and how the contacts of an area are reduced to a few points.
struct ContactOptions {
  // Surfaces closer than this touch [m].
  double threshold = 1e-4;
  // Points of a face contact whose gap exceeds the smallest one by at most this belong to it: two
  // faces that should be parallel are not exactly so in floating point [m].
  double evenness = 1e-5;
  // Sine of an angle. A surface may rise above the tangent plane of a contact by up to this angle,
  // and normals that differ by no more count as equal.
  double angular_tolerance = 0.02;
  // A region keeps at most this many corners (>= 3); those whose removal costs the least area are
  // dropped first.
  int max_region_corners = 8;
  // Contacts with the same normal that are nearer to each other than this part of the threshold are
  // merged. Small, so that merging does not move the corners of a region noticeably.
  double same_place = 0.01;
  // Corners of a region that stand out from the line between their neighbours by less than this
  // part of the threshold are left out.
  double flat_corner = 0.1;
  // Patches of a soft link that bear less than this part of the force of the strongest are left
  // out.
  double weakest_patch = 0.1;
};

template <SettingsOf<ContactOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [threshold, evenness, angular_tolerance, max_region_corners, same_place, flat_corner,
         weakest_patch] = options;
  visit("threshold", threshold, kAbove0);
  visit("evenness", evenness, kAtLeast0);
  visit("angular_tolerance", angular_tolerance, kAtLeast0);
  visit("max_region_corners", max_region_corners, Range{.lower = 3.0});
  visit("same_place", same_place, kAtLeast0);
  visit("flat_corner", flat_corner, kAtLeast0);
  visit("weakest_patch", weakest_patch, kAtLeast0);
}

}  // namespace prehend
