// How close two triangle meshes are: gaps, intersection, and the triangle pairs that make contact.
// The only place that knows FCL.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/geometry/separation.h"
#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// A mesh with its bounding-volume tree. Immutable and shared by threads; cheap to copy.
class ProximityMesh {
 public:
  // Throws InputError for a mesh without triangles, and Cancelled.
  explicit ProximityMesh(TriangleMesh mesh, const RunContext& context = {});

  // As it was given.
  const TriangleMesh& mesh() const;
  // Indices of the triangles around vertex `v`, ascending.
  std::span<const int> triangles_at(int v) const;
  // Centre and radius of a ball that holds all vertices, mesh frame [m].
  const Vector3& ball_center() const;
  double ball_radius() const;
  // Convex sets that together hold the surface: one for each component while they are few.
  const std::vector<ConvexPoints>& parts() const;

  // For the functions of this room.
  struct Data;
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

// Triangle `a` of the first mesh, triangle `b` of the second.
struct TrianglePair {
  int a = -1;
  int b = -1;
};

// How exact an answer of find_gap has to be: what need not be known costs no time.
struct GapOptions {
  // Gaps beyond this need not be told apart [m].
  double cap = std::numeric_limits<double>::infinity();
  // The answer may be off by this fraction: lower >= upper / (1 + relative_error).
  double relative_error = 0.0;
  // A pair that is probably close, for instance the one of the last query; {-1, -1} for none.
  TrianglePair hint;
};

// lower <= true distance between the surfaces <= upper. 0 where they meet or cross. A surface
// inside the other without crossing has a positive gap: ask `is_inside`.
struct Gap {
  double lower = 0.0;
  double upper = std::numeric_limits<double>::infinity();  // infinity when beyond the cap
  TrianglePair pair;                                       // where upper was found
};

// X_AB: the pose of mesh b's frame in mesh a's frame.
Gap find_gap(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
             const GapOptions& options = {});

// True as soon as any two triangles meet.
bool surfaces_cross(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB);

// All pairs of triangles at most `distance` [m] apart, in the order of the trees; `pairs` is
// reused.
void find_pairs_within(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
                       double distance, std::vector<TrianglePair>& pairs);

// The smallest distance among `pairs` and the pair that has it: what find_gap gives when every pair
// that matters is listed.
Gap gap_of_pairs(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
                 std::span<const TrianglePair> pairs);

// Distance between triangles pair.a and pair.b [m], 0 where they meet, and the nearest points in
// their own frames (meaningless at 0).
struct TriangleGap {
  double distance = 0.0;
  Vector3 p_A = Vector3::Zero();
  Vector3 p_B = Vector3::Zero();
};
TriangleGap triangle_gap(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
                         TrianglePair pair);

// True when point p_M is inside the solid that the mesh bounds: generalized winding number of at
// least one half (Jacobson, Kavan and Sorkine-Hornung 2013), so that small holes do not matter.
bool is_inside(const ProximityMesh& mesh, const Vector3& p_M);

}  // namespace prehend
