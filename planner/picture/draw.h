// A small software renderer: triangles with opacity, a perspective camera, no display.
#pragma once

#include <vector>

#include "planner/picture/image.h"
#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// Linear parts in [0, 1].
struct Color {
  double red = 0.5;
  double green = 0.5;
  double blue = 0.5;
  double opacity = 1.0;  // 0 invisible, 1 solid
};

struct DrawnBody {
  TriangleMesh mesh;
  Pose X_WB = Pose::Identity();
  Color color;
};

// Looks from `eye` at `target`; `up` need not be orthogonal to the view. World frame, metres.
struct Camera {
  Vector3 eye = Vector3(1, -1, 1);
  Vector3 target = Vector3::Zero();
  Vector3 up = Vector3::UnitZ();
  double vertical_field_of_view = 0.6;  // radians
};

struct DrawOptions {
  int width = 900;
  int height = 700;
  int samples = 2;  // samples x samples per pixel
  Color background = {1.0, 1.0, 1.0, 1.0};
};

// Solid bodies are depth-tested; translucent ones are blended in depth order for each pixel, so
// that the picture does not depend on the order of `bodies`.
Image draw(const std::vector<DrawnBody>& bodies, const Camera& camera,
           const DrawOptions& options = {});

// A camera that sees the whole of `box` from `direction` (from the target to the eye).
Camera camera_around(const Bounds& box, const Vector3& direction, const DrawOptions& options = {});

// Marks as meshes, in the frame of their arguments. `axis` need not be unit.
TriangleMesh arrow_mesh(const Vector3& from, const Vector3& to, double radius);
// Cone with its apex at `apex`, opening along `axis`, half angle atan(slope), `length` high.
TriangleMesh cone_mesh(const Vector3& apex, const Vector3& axis, double slope, double length);

}  // namespace prehend
