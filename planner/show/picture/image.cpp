#include "planner/show/picture/image.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

// The part must lie within the whole. Rows are contiguous, so each is copied at once.
void paste(const Image& part, int left, int top, Image& whole) {
  const auto row_bytes = 3 * static_cast<std::ptrdiff_t>(part.width);
  for (int y = 0; y < part.height; ++y) {
    const auto row = part.rgb.begin() + y * row_bytes;
    const auto place = 3 * (static_cast<std::ptrdiff_t>(top + y) * whole.width + left);
    std::copy(row, row + row_bytes, whole.rgb.begin() + place);
  }
}

}  // namespace

Image grid(const std::vector<Image>& images, int columns) {
  require(columns >= 1,
          {.field = "columns", .problem = "must be positive", .value = std::to_string(columns)});
  const int count = static_cast<int>(images.size());
  // Fewer images than columns make a narrower picture, not one with empty cells.
  columns = std::min(columns, std::max(count, 1));
  const int rows = (count + columns - 1) / columns;
  int cell_width = 0;
  int cell_height = 0;
  for (const Image& image : images) {
    cell_width = std::max(cell_width, image.width);
    cell_height = std::max(cell_height, image.height);
  }
  Image whole{columns * cell_width, rows * cell_height, {}};
  whole.rgb.assign(
      3 * static_cast<std::size_t>(whole.width) * static_cast<std::size_t>(whole.height), 255);
  for (int i = 0; i < count; ++i) {
    const Image& part = images[static_cast<std::size_t>(i)];
    paste(part, (i % columns) * cell_width + (cell_width - part.width) / 2,
          (i / columns) * cell_height + (cell_height - part.height) / 2, whole);
  }
  return whole;
}

}  // namespace prehend
