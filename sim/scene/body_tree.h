// Which bodies of a scene may be near a place, without going through all of them.
#pragma once

#include <memory>
#include <vector>

#include "sim/scene/collision_body.h"
#include "sim/scene/ids.h"

namespace prehend {

// All points within `radius` [m] of the segment between two points.
struct SweptBall {
  Vector3 from = Vector3::Zero();
  Vector3 to = Vector3::Zero();
  double radius = 0.0;
};

// What a search of a BodyTree found. Passing the same one again saves allocations.
struct NearBodies {
  std::vector<BodyId> found;
  std::vector<int> in_box;  // a buffer of the search
};

// A tree over the bounding boxes of the obstacles, in the frame in which they are placed.
// Immutable.
class BodyTree {
 public:
  BodyTree() = default;
  // `bodies`: the object, which is left out, and the obstacles, by BodyId.
  explicit BodyTree(const std::vector<PlacedBody>& bodies);

  // The obstacles that may reach into the region, in ascending order; all that do are among them.
  // `near.found` is replaced.
  void find(const SweptBall& region, NearBodies& near) const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;  // null: no obstacles
};

}  // namespace prehend
