// A small software renderer: triangles with opacity, a perspective camera, no display.
#pragma once

#include <vector>

#include "planner/show/picture/camera.h"
#include "planner/show/picture/drawn_body.h"
#include "planner/show/picture/image.h"
#include "planner/show/picture/lighting.h"
#include "sim/base/run_context.h"

namespace prehend {

// Size and style of a picture.
struct DrawOptions {
  int width = 900;   // pixels, 1 to 16384
  int height = 700;  // pixels, 1 to 16384
  int samples = 2;   // samples x samples a pixel, 1 to 8
  Color background = {1.0, 1.0, 1.0, 1.0};
  Lighting lighting = {};
  // Edges at which faces meet at less than this angle [rad] are shaded smoothly, as on a round
  // surface.
  double crease_angle = 0.7;
  // Width of the dark lines along creases, borders and silhouettes [pixels]; 0 draws none.
  double line_width = 1.2;
};

// Draws the bodies as `camera` sees them. Solid bodies are depth-tested; translucent ones are
// blended in depth order for each sample, so that the picture does not depend on the order of
// `bodies`: surfaces at the very same depth are ordered by how they look. Of the translucent
// surfaces behind one another in one sample, only the nearest 24 are kept. Triangles without area
// are skipped; those nearer than Projection::near_depth() are cut off there. Throws InputError for
// options out of range, a camera that sees nothing, and meshes with vertices that are not finite or
// indices out of range; and Cancelled.
Image draw(const std::vector<DrawnBody>& bodies, const Camera& camera,
           const DrawOptions& options = {}, const RunContext& context = {});

// camera_around of camera.h for a picture of the size in `options`: about the vertices of the
// bodies that are not invisible, or about a box. The vertices fill the picture better than their
// box does.
Camera camera_around(const std::vector<DrawnBody>& bodies, const Vector3& direction,
                     const DrawOptions& options = {});
Camera camera_around(const Bounds& box, const Vector3& direction, const DrawOptions& options = {});

}  // namespace prehend
