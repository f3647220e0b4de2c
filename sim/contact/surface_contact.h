// Where a link touches an object, as points with normals.
#pragma once

#include <vector>

#include "sim/base/settings.h"
#include "sim/geometry/proximity.h"

namespace prehend {

// In the object's frame O. `normal` is unit and points from the link into the object.
struct SurfaceContact {
  Vector3 position = Vector3::Zero();  // on the object's surface [m]
  Vector3 normal = Vector3::UnitZ();
  double gap = 0.0;  // between the surfaces along the normal [m]
};

struct ContactOptions {
  // Surfaces closer than this touch [m].
  double threshold = 1e-4;
  // Of a face contact, the points this much farther than its nearest still count: parallel faces
  // are never parallel to the last bit [m].
  double evenness = 1e-5;
  // Sine of the angle by which a surface may rise above its tangent plane and still be supported by
  // it, and within which normals count as one.
  double angular_tolerance = 0.02;
  // A region keeps at most this many corners; those that matter least to its area go first (>= 3).
  int max_region_corners = 8;
  // Points with one normal that are nearer to each other than this part of the threshold are one:
  // far less than what regions are told apart by, so that the corners of a region stay in place.
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
  visit("threshold", threshold);
  visit("evenness", evenness);
  visit("angular_tolerance", angular_tolerance);
  visit("max_region_corners", max_region_corners);
  visit("same_place", same_place);
  visit("flat_corner", flat_corner);
  visit("weakest_patch", weakest_patch);
}

// Reused between calls so that a trial allocates little.
struct ContactWorkspace {
  std::vector<TrianglePair> pairs;
  std::vector<SurfaceContact> points;
};

// Every contact between two bodies at rest, before regions are formed: for each pair of triangles
// within the threshold, the points of face contacts (the other triangle projected on the face and
// cut by it, nearest points only), and the one point of edge and vertex contacts. Points that the
// surfaces around them do not support are left out, points at the same place with the same normal
// are given once, nearest first. `X_OL` is the link's pose in O. Source: Miller and Allen 2004,
// "Contact Determination", figures 6 and 7.
void find_contact_points(const ProximityMesh& object, const ProximityMesh& link, const Pose& X_OL,
                         const ContactOptions& options, ContactWorkspace& workspace,
                         std::vector<SurfaceContact>& points);

}  // namespace prehend
