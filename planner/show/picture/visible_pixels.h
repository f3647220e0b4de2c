// Visibility: how many pixels of each body a camera sees.
#pragma once

#include <cstddef>
#include <vector>

#include "planner/show/picture/camera.h"
#include "planner/show/picture/drawn_body.h"

namespace prehend {

// Counts pixels in a picture to which bodies are added one after the other: one sample at the
// center of each pixel, no shading. It is quick enough to look from many directions.
class VisiblePixels {
 public:
  // Throws InputError when the camera sees nothing.
  VisiblePixels(const Camera& camera, int width, int height);

  // Adds a body; of its color only the opacity matters. A solid one is seen where nothing that was
  // added before is as near. A translucent one dims what was added before and is behind it, its
  // back half as much as its front, and has no pixels itself. Returns how many pixels the body
  // covers, whatever is before it.
  double add(const DrawnBody& body);

  // For each body, in the order in which they were added, how many pixels show it; a dimmed pixel
  // counts as the part that is not covered.
  std::vector<double> counts() const;

 private:
  // A corner of a triangle: pixel coordinates and 1 / depth, which is 0 before the near plane.
  using Corner = Vector3;

  struct Pixel {
    float inverse_depth = 0.0F;  // of the nearest solid body
    float uncovered = 1.0F;      // the part of that which no translucent body covers
    int nearest = -1;            // that body; -1: none
    int last = -1;               // the body that was last added here
  };

  void add_clipped(const DrawnBody& body, const Triangle& triangle, const Pose& X_CB);
  void fill(const Corner& a, const Corner& b, const Corner& c, float opacity);
  void touch(float inverse_depth, float opacity, Pixel& pixel);

  Projection projection_;
  int width_;
  int height_;
  int body_ = -1;                // the one that is added
  int covered_ = 0;              // pixels of it
  std::vector<Corner> corners_;  // its vertices
  std::vector<Pixel> pixels_;    // by row, top row first
};

}  // namespace prehend
