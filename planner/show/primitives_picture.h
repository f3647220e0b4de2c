// A picture of an object and the primitives that describe it.
#pragma once

#include <vector>

#include "planner/show/grasp_picture.h"
#include "sim/shape/primitive.h"

namespace prehend {

struct Decomposition;
struct TriangleMesh;

// Two views, from opposite sides: the object, and around it the solids, translucent, a colour each.
// Below stands how far the surface is from all of them and from each [mm]. Throws Cancelled.
Image primitives_picture(const TriangleMesh& mesh, const Decomposition& parts,
                         const PictureSize& size = {.width = 1200, .height = 600},
                         const RunContext& context = {});

}  // namespace prehend
