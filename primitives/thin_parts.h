// Rims and bars of an object: what is thin, which boxes, spheres and cylinders do not tell.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/base/settings.h"
#include "sim/shape/primitive.h"

namespace prehend {

class ProximityMesh;

struct ThinPartOptions {
  static constexpr AboutSettings kAbout{"ThinPartOptions",
                                        "What counts as a rim or a bar; widths are parts of the "
                                        "bounding box's diagonal."};
  double rim_width = 0.05;
  double bar_width = 0.12;
  int most_rims = 3;
  int most_bars = 2;
  int points = 800;
  std::uint64_t seed = 1;
};

template <SettingsOf<ThinPartOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [rim_width, bar_width, most_rims, most_bars, points, seed] = options;
  visit("rim_width", rim_width, kFraction, "", "Thickest wall whose edge is a rim; 0: no rims.");
  visit("bar_width", bar_width, kFraction, "", "Widest bar, such as a handle; 0: no bars.");
  visit("most_rims", most_rims, kCount, "", "Most rims, the longest of them.");
  visit("most_bars", most_bars, kCount, "", "Most bars, the longest of them.");
  visit({"points", "thin_points"}, points, kPointCount, "",
        "Points of the surface that are looked at; more find shorter rims and bars, and take "
        "longer.");
  visit.unlisted("seed", seed, kAtLeast0, "", "Of these points.");
}

// The rims and bars of a closed mesh, in its frame. Those that one of the `solids` describes as
// well are left out: a pencil is a cylinder, a plate of wood a box. They move and scale with the
// mesh. The same arguments give the same result, on any number of threads. Throws Cancelled.
std::vector<Primitive> find_thin_parts(const ProximityMesh& mesh,
                                       const std::vector<Primitive>& solids,
                                       const ThinPartOptions& options = {},
                                       const RunContext& context = {});

}  // namespace prehend
