// A platform as planners know it that see nothing but spheres.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/robot/platform.h"
#include "sim/shape/sphere_cover.h"

namespace prehend {

// A link under its name in URDF, with spheres in its frame there.
struct SphereLink {
  std::string name;
  std::vector<CoverSphere> spheres;
  double error = 0.0;  // none reaches farther out of the link's mesh [m]
};

struct SphereModel {
  std::string name;
  std::vector<Robot> robots;  // the platform's, as in URDF (urdf_form.h)
  std::vector<SphereLink> links;
  // Pairs of links (indices, the lower one first) that are never checked for collision: neighbours
  // (`adjacent`), and those that the robots and the platform exempt.
  struct Pair {
    int a = 0;
    int b = 0;
    bool adjacent = false;
  };
  std::vector<Pair> unchecked;
};

// The spheres of a link reach out of it by at most 12 % of its size, but between 3 and 30 mm.
// Throws InputError for a robot whose joints are no tree.
SphereModel sphere_model(const Platform& platform);

}  // namespace prehend
