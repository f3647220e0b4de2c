// One thing in one view: where its surface is, where nothing is, and what the view does not know.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/shape/cloud/seen_surface.h"

namespace prehend {

// What a pixel shows, as far as one thing is concerned.
enum class PixelKind : std::uint8_t {
  beyond,  // nothing, or something that is not in front of the thing
  thing,
  hidden  // something that may be in front of it, or no reading beside it
};

// A view cut out around a thing.
struct ObjectView {
  Eigen::Isometry3f X_CP = Eigen::Isometry3f::Identity();  // P: frame of the support
  DepthCamera camera;
  int left = 0;  // pixel of the first column and row of what follows
  int top = 0;
  int width = 0;
  int height = 0;
  std::vector<PixelKind> kind;
  std::vector<float> depth;         // of a reading; 0: none [m]
  std::vector<LocalPlane> surface;  // of pixels that show the thing
  // To the nearest pixel beyond, of those that show the thing; to the nearest that is not beyond,
  // of the others [pixels].
  std::vector<float> to_edge;

  std::size_t at(int u, int v) const { return index(v - top) * index(width) + index(u - left); }
  bool contains(int u, int v) const {
    return u >= left && v >= top && u < left + width && v < top + height;
  }
};

// Fills `to_edge`, and gives pixels without reading their kind: hidden beside the thing, else
// beyond.
void find_edges(ObjectView& view);

// What a view knows of a point.
struct PointSample {
  // Signed distance from what the view allows the thing to be, an estimate [m]: positive in free
  // space, negative behind the surface or where the view knows nothing.
  float distance = 0.0F;
  const LocalPlane* surface = nullptr;  // that its pixel shows, of the thing
  float width = 0.0F;                   // from its pixel to the edge of the thing [m]
};

// `far` [m]: distances are cut at this.
PointSample sample(const ObjectView& view, const Eigen::Vector3f& p_P, float far);

// The largest distance of all views: that from the body that all of them allow together.
float allowed_distance(const std::vector<ObjectView>& views, const Eigen::Vector3f& p_P, float far);

// A reading of the thing, smoothed.
struct SeenPoint {
  Vector3 p_P = Vector3::Zero();
  Vector3 normal_P = Vector3::UnitZ();  // unit, towards the camera
  double width = 0.0;                   // as in PointSample
  int view = 0;
  std::size_t pixel = 0;  // in that view's cutout
};

std::vector<SeenPoint> seen_points(const std::vector<ObjectView>& views);

}  // namespace prehend
