// Rims and bars of an object: what is thin, which boxes, spheres and cylinders do not tell.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/shape/primitive.h"
#include "sim/shape/proximity.h"

namespace prehend {

// What counts as thin, relative to the diagonal of the object's bounding box.
struct ThinPartOptions {
  double rim_width = 0.05;  // thickest wall whose edge is a rim; in [0, 1], 0: no rims
  double bar_width = 0.12;  // widest bar; in [0, 1], 0: no bars
  int most_rims = 3;        // the longest of them (>= 0)
  int most_bars = 2;        // the longest of them (>= 0)
  // So many points of the surface are looked at (>= 100).
  int points = 800;
  std::uint64_t seed = 1;
};

template <SettingsOf<ThinPartOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [rim_width, bar_width, most_rims, most_bars, points, seed] = options;
  visit("rim_width", rim_width, Range{0.0, 1.0});
  visit("bar_width", bar_width, Range{0.0, 1.0});
  visit("most_rims", most_rims, kAtLeast0);
  visit("most_bars", most_bars, kAtLeast0);
  visit("thin_points", points, Range{.lower = 100.0});
}

// The rims and bars of a closed mesh, in its frame. Those that one of the `solids` describes as
// well are left out: a pencil is a cylinder, a plate of wood a box. They move and scale with the
// mesh. The same arguments give the same result, on any number of threads. Throws Cancelled.
std::vector<Primitive> find_thin_parts(const ProximityMesh& mesh,
                                       const std::vector<Primitive>& solids,
                                       const ThinPartOptions& options = {},
                                       const RunContext& context = {});

}  // namespace prehend
