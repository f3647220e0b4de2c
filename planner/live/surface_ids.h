// Names of surfaces by what they are, so that a client that draws a scene knows which of them it
// has already.
#pragma once

#include <string>
#include <vector>

#include "sim/scene/scene.h"

namespace prehend {

struct SurfaceIds {
  std::string object;                  // empty without an object
  std::vector<std::string> obstacles;  // one for each
  std::string robots;                  // of the hand, and of the platform that carries it
};

// Sixteen hexadecimal digits each. Bodies of equal names are bodies of the same vertices and
// triangles; robots of equal names have the same links and joints, too. That different ones get one
// name is as likely as for 64 random bits: this tells no friend from foe.
SurfaceIds surface_ids(const Scene& scene);

}  // namespace prehend
