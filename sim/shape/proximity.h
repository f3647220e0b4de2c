// Distance and intersection queries between two triangle meshes, and the pairs of triangles in
// contact.
#pragma once

#include <limits>
#include <vector>

#include "sim/shape/proximity_mesh.h"
#include "sim/shape/ray.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Triangle `a` of the first mesh and triangle `b` of the second; -1: none.
struct TrianglePair {
  int a = -1;
  int b = -1;
};

// Accuracy of find_gap. A coarser answer takes less time.
struct GapOptions {
  // Distances beyond this value [m] need not be determined.
  double cap = std::numeric_limits<double>::infinity();
  // Permitted relative error: lower >= upper / (1 + relative_error).
  double relative_error = 0.0;
  // A pair that is probably close, for instance the one found by the previous query; {-1, -1} for
  // none. It speeds up the search and does not change the result beyond its error.
  TrianglePair hint;
};

// Bounds of the distance between two surfaces [m]: lower <= distance <= upper, both 0 where they
// touch or intersect. A surface that lies inside the other without intersecting it has a positive
// distance: test for that with is_inside.
struct Gap {
  double lower = 0.0;
  double upper = std::numeric_limits<double>::infinity();  // may be infinite beyond the cap
  TrianglePair pair;                                       // the pair with distance upper
};

// The distance between the surfaces of a and b. X_AB: pose of mesh b's frame in mesh a's frame.
Gap find_gap(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
             const GapOptions& options = {});

// Whether any two triangles touch or intersect. Stops at the first such pair.
bool surfaces_cross(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB);

// A pair of triangles and their nearest points, both in the frame of the first mesh [m]. The points
// are not meaningful when the distance is 0.
struct ClosePair {
  TrianglePair pair;
  double distance = 0.0;
  Vector3 on_a_A = Vector3::Zero();
  Vector3 on_b_A = Vector3::Zero();
};

// Collects all pairs of triangles whose distance is at most `distance` [m], in the order of the
// traversal. The content of `pairs` is replaced; passing the same vector again saves allocations.
void find_pairs_within(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
                       double distance, std::vector<ClosePair>& pairs);

// The same pairs and some that are farther apart, though neither has all of its corners farther
// than `distance` before or behind the other's plane. In a fraction of the time.
void find_pairs_maybe_within(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
                             double distance, std::vector<TrianglePair>& pairs);

// Collects the triangles whose bounding boxes meet `box` (mesh frame), in the order of the tree,
// and possibly a few that miss it by rounding of single precision. The content of `triangles` is
// replaced.
void find_triangles_in(const ProximityMesh& mesh, const Bounds& box, std::vector<int>& triangles);

// A pair of triangles and a lower bound of its distance [m].
struct NearPair {
  TrianglePair pair;
  double at_least = 0.0;
};

// Which pairs find_near_pairs lists: those closer than `reach` times the gap of the surfaces, and
// those closer than the gap plus `least_reach` [m].
struct NearPairsOptions {
  double reach = 1.5;
  double least_reach = 0.0;
  std::size_t most = std::numeric_limits<std::size_t>::max();  // pairs in the list
  TrianglePair hint;                                           // as in GapOptions
};

// All pairs that are near each other, in the order of the traversal, and a bound of the others.
struct NearPairs {
  std::vector<NearPair> pairs;
  double beyond = 0.0;  // no pair that is not listed is closer than this [m]
};

// Lists the pairs; `near` is replaced, and passing the same one again saves allocations. Most
// bounds are rough ones that cost little, so that a few pairs may be listed that are farther away.
// Where there would be more than `most`, it stops early and returns false: `near` is then useless.
bool find_near_pairs(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
                     const NearPairsOptions& options, NearPairs& near);

// The smallest distance among listed pairs and the pair that has it, after a motion in which no
// point came closer to the other mesh by more than `moved` [m] since the list was made or last
// asked. Lower and upper are infinite when there are no pairs. Only pairs whose bound admits it are
// measured; their bounds are raised, all others lowered by `moved`, which is also taken from
// `beyond`. The nearest pair is put first: it is probably the nearest again. The same as find_gap
// where the result is at most `beyond`.
Gap gap_of_pairs(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB, double moved,
                 NearPairs& near);

// Distance between two triangles [m], 0 where they intersect, and the nearest points: p_A on the
// first in a's frame, p_B on the second in b's frame. The points are not meaningful when the
// distance is 0.
struct TriangleGap {
  double distance = 0.0;
  Vector3 p_A = Vector3::Zero();
  Vector3 p_B = Vector3::Zero();
};
// The distance between triangles pair.a of a and pair.b of b.
TriangleGap triangle_gap(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
                         TrianglePair pair);

// The first triangle that the ray from `from` along the unit vector `direction` meets, both in the
// frame of the mesh (ray.h).
RayHit first_hit(const ProximityMesh& mesh, const Vector3& from, const Vector3& direction,
                 double cap = std::numeric_limits<double>::infinity());

// Whether point p_M (mesh frame) is inside the solid that the mesh bounds: its generalized winding
// number is at least one half (winding_number.h), which tolerates small holes. The mesh must face
// outward.
bool is_inside(const ProximityMesh& mesh, const Vector3& p_M);

}  // namespace prehend
