// A raster picture and its PNG file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace prehend {

// Width and height of a picture [pixels].
struct PictureSize {
  int width;
  int height;
};

// Row-major 8-bit sRGB, top row first: 3 * width * height bytes.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

// The images side by side, `columns` to a row, in reading order. Every cell is as large as the
// largest image; images are centered in their cells and what is left over is white.
// Throws InputError when `columns` < 1.
Image grid(const std::vector<Image>& images, int columns);

// The image as the bytes of a PNG file. Throws InputError when it has no pixels.
std::string png_bytes(const Image& image);

// Writes the file whole or not at all: a failure leaves what was there before.
// Throws InputError when the file cannot be written or the image has no pixels.
void write_png(const std::filesystem::path& file, const Image& image);

}  // namespace prehend
