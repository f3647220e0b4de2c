// A raster picture and its PNG file.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace prehend {

// Row-major 8-bit RGB, top row first.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

// Writes the file whole or not at all. Throws InputError when it cannot be written.
void write_png(const std::filesystem::path& file, const Image& image);

}  // namespace prehend
