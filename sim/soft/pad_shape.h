// What a robot file states of a pad.
#pragma once

#include "sim/base/pose.h"
#include "sim/soft/elastic_material.h"

namespace prehend {

// A layer of elastic material on a link, in the frame L of the link.
struct PadShape {
  Vector3 outward_L = Vector3::UnitZ();  // unit: the pad covers what faces this way
  double thickness = 2e-3;               // from the surface of the link inward, bonded beneath [m]
  ElasticMaterial material;

  friend bool operator==(const PadShape&, const PadShape&) = default;
};

}  // namespace prehend
