// Triangles projected to the picture plane, ready for rasterisation.
#pragma once

#include <array>
#include <vector>

#include "planner/show/picture/camera.h"
#include "planner/show/picture/color.h"

namespace prehend {

// Everything is given at the three corners. 1 / depth is what varies linearly across the picture.
// The corners run clockwise on the screen (positive area with y down).
struct ScreenTriangle {
  std::array<Eigen::Vector2d, 3> corners;
  std::array<double, 3> inverse_depths;
  std::array<Vector3, 3> normals;  // camera frame, unit, on the viewer's side
  Light albedo{};
  float opacity = 1.0F;
  bool lit = true;  // otherwise the albedo is shown as it is

  bool solid() const { return opacity >= 1.0F; }
};

// A vertex in the camera frame.
struct CameraVertex {
  Vector3 p_C = Vector3::Zero();
  Vector3 normal_C = Vector3::Zero();  // outward
};

// What all triangles of a body have in common.
struct SurfaceLook {
  Light albedo{};
  float front_opacity = 1.0F;
  float back_opacity = 1.0F;
};

// Projects a triangle (counter-clockwise from outside) and appends the result: it is clipped at the
// near plane, and its normals are turned to the viewer. Nothing when it has no area on the screen.
void append_triangle(const std::array<CameraVertex, 3>& triangle, const SurfaceLook& look,
                     const Projection& projection, std::vector<ScreenTriangle>& out);

// How a line is drawn.
struct LineLook {
  Light color{};
  float opacity = 1.0F;
  double width = 1.0;  // pixels
};

// Appends the line between two points as a flat strip, a little nearer than they are so that it
// shows on the surface that they belong to.
void append_line(const Vector3& from_C, const Vector3& to_C, const LineLook& look,
                 const Projection& projection, std::vector<ScreenTriangle>& out);

}  // namespace prehend
