#include "planner/show/contact_sheet.h"

#include <algorithm>
#include <cstddef>

#include "planner/show/best_viewpoint.h"
#include "planner/show/grasp_picture.h"
#include "planner/show/palette.h"
#include "planner/show/picture/label.h"
#include "planner/show/posed_grasp.h"
#include "sim/base/parallel/parallel.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {
namespace {

constexpr int kTextScale = 2;
constexpr int kMargin = 10;  // around a cell, and between picture and title [pixels]

// The picture in a white cell, with `text` under it in a strip of the given height.
Image cell(const Image& picture, const std::string& text, int strip) {
  Image whole{picture.width + 2 * kMargin, picture.height + strip + 3 * kMargin, {}};
  whole.rgb.assign(
      3 * static_cast<std::size_t>(whole.width) * static_cast<std::size_t>(whole.height), 255);
  const auto row_bytes = 3 * static_cast<std::ptrdiff_t>(picture.width);
  for (int y = 0; y < picture.height; ++y) {
    const auto row = picture.rgb.begin() + y * row_bytes;
    const auto place =
        3 * (static_cast<std::ptrdiff_t>(y + kMargin) * whole.width + std::ptrdiff_t{kMargin});
    std::copy(row, row + row_bytes, whole.rgb.begin() + place);
  }
  label(whole, kMargin, picture.height + 2 * kMargin, text, palette::kText, kTextScale);
  return whole;
}

}  // namespace

Image contact_sheet(const CompiledScene& scene, const std::vector<PosedGrasp>& grasps, int columns,
                    const PictureSize& size, const RunContext& context) {
  // All cells have the strip of the tallest title, so that pictures and titles of a row are
  // aligned.
  int strip = 0;
  for (const PosedGrasp& grasp : grasps) {
    strip = std::max(strip, text_size(grasp.title, kTextScale).height);
  }
  const ViewpointSearch search(scene);
  std::vector<Image> cells(grasps.size());
  // Drawing and the search for the side use one thread each, so the grasps are distributed.
  for_each_in_parallel(grasps.size(), context.threads, [&](std::size_t i) {
    context.cancellation.check();
    // The title goes below the picture instead of into it.
    PosedGrasp untitled = grasps[i];
    untitled.title.clear();
    const Image picture =
        grasp_picture(scene, untitled, search.best(untitled, context), size, context);
    cells[i] = cell(picture, grasps[i].title, strip);
  });
  return grid(cells, columns);
}

}  // namespace prehend
