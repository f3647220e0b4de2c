// Depth images as PNG files.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace prehend {

struct DepthImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint16_t> counts;  // row by row from the top; 0 and 65535: no reading
};

// Throws InputError for what is damaged, is not 16-bit grey, or has more pixels than kMostReadings.
DepthImage read_depth_png(std::string_view bytes);

}  // namespace prehend
