// A small part of a picture, sample by sample: depth test, translucent layers, average.
#pragma once

#include <cstdint>
#include <vector>

#include "planner/show/picture/camera.h"
#include "planner/show/picture/image.h"
#include "planner/show/picture/lighting.h"
#include "planner/show/picture/screen_triangle.h"

namespace prehend {

// A square of pixels that moves over the picture, so that the memory for samples and their
// translucent layers is bounded whatever the scene. The samples of a pixel are on a sheared grid:
// no two in a row or column, which makes edges near the axes as smooth as slanted ones.
class Tile {
 public:
  static constexpr int kSize = 32;        // pixels
  static constexpr int kMostLayers = 24;  // translucent layers kept in a sample

  // Keeps references to `projection` and `lights`.
  Tile(const Projection& projection, const Lights& lights, int samples, const Light& background);

  // Forgets what was drawn and moves the upper left corner to this pixel.
  void move_to(int left, int top);

  // Solid triangles come first, then translucent ones; within each, the order does not matter.
  void add(const ScreenTriangle& triangle);

  // Writes the pixels into the picture, as far as they lie in it.
  void write_to(Image& image) const;

 private:
  struct Surface {
    float inverse_depth = 0.0F;  // 0 is infinitely far: the background
    Light light{};
  };
  struct Layer {
    Surface surface;
    float opacity = 0.0F;
  };
  struct Look {
    Light light{};
    float opacity = 1.0F;
  };

  static bool before(const Surface& a, const Surface& b);
  Look look_at(const ScreenTriangle& triangle, const Vector3& weights) const;
  bool visible(const ScreenTriangle& triangle, std::size_t sample, float inverse_depth) const;
  void put(const ScreenTriangle& triangle, const Look& look, std::size_t sample,
           float inverse_depth);
  void note_farthest(std::size_t pixel);
  void insert(const Layer& layer, std::size_t sample);
  Light seen(std::size_t sample) const;

  const Projection& projection_;
  const Lights& lights_;
  Light background_;
  int left_ = 0;
  int top_ = 0;
  std::vector<Eigen::Vector2d> offsets_;  // of the samples in a pixel
  std::vector<Surface> surfaces_;         // by sample; the samples of a pixel are together
  std::vector<Layer> layers_;             // kMostLayers a sample, nearest first
  std::vector<std::uint8_t> layer_counts_;
  std::vector<float> farthest_;  // by pixel: the smallest inverse depth of its surfaces
};

}  // namespace prehend
