// Whether a suction cup seals on a surface: its lip as a ring of springs that is projected onto the
// mesh along the axis of the cup.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <string_view>
#include <vector>

#include "sim/base/named_enum.h"
#include "sim/base/pose.h"
#include "sim/shape/proximity_mesh.h"

namespace prehend {

// A relaxed cup in the frame of the mesh.
struct CupLip {
  Vector3 center = Vector3::Zero();  // of the lip [m]
  Vector3 axis = Vector3::UnitZ();   // unit, out of the cup towards the surface
  double radius = 0.0;               // of the lip, > 0 [m]
  double travel =
      0.0;  // by which lip and bellows give way along the axis; the cup is hollow as far [m]
  double strain = 0.1;  // largest elongation of a spring of the ring
};

enum class SealEnd {
  sealed,
  off_surface,  // a part of the lip is beside the object, or too far from it
  gap,          // a hole under the lip, or through the object inside of it
  edge,         // the lip crosses an edge or a step
  too_curved,   // the surface bends the lip more than it stretches, or more than the bellows give
                // way
  porous,       // air comes through the surface
};

constexpr auto enum_names(SealEnd /*of*/) {
  return std::to_array<std::string_view>(
      {"sealed", "off_surface", "gap", "edge", "too_curved", "porous"});
}

struct CupSeal {
  SealEnd end = SealEnd::off_surface;
  double strain = 0.0;   // largest elongation of a spring [1]
  double nearest = 0.0;  // way along the axis until the lip touches, < 0: it is in the object [m]
  double press = 0.0;    // way until all of the lip touches [m]
  Vector3 center = Vector3::Zero();  // mean of the lip on the surface
};

// Springs of the ring. Between two of its points there is another ray, for what is under the lip.
inline constexpr int kLipSprings = 32;

// Projects the points of the lip onto the mesh, from twice the travel behind it, and looks at the
// surface inside of the lip on smaller circles. The lip seals where each point meets the outer side
// of the surface, neighbours have normals less than 45 degrees apart, no spring between neighbours
// is longer by more than `strain` than it was, and lip and surface inside of it lie within `travel`
// along the axis. What is narrower than a sixty-fourth of the lip may be missed. `leaks`: whether
// the surface at a point is porous. Source: Mahler et al., "Dex-Net 3.0: Computing robust vacuum
// suction grasp targets", ICRA 2018, section IV: its perimeter springs, with the limit of 10 %; its
// cone and flexion springs are replaced by the travel.
CupSeal cup_seal(const ProximityMesh& mesh, const CupLip& cup,
                 const std::function<bool(const Vector3&)>& leaks = {});

}  // namespace prehend
