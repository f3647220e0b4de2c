// Text on a picture, in a built-in 5 x 8 bitmap font.
#pragma once

#include <string>

#include "planner/show/picture/color.h"
#include "planner/show/picture/image.h"

namespace prehend {

struct TextSize {
  int width = 0;   // pixels
  int height = 0;  // pixels
};

// Room that `text` takes at `scale` (pixels of the picture per dot of the font).
TextSize text_size(const std::string& text, int scale);

// Draws printable ASCII with the upper left corner of the first letter at (x, y); '\n' starts a new
// line, other bytes show as a box. What falls outside the image is cut off.
void label(Image& image, int x, int y, const std::string& text, const Color& color, int scale = 2);

}  // namespace prehend
