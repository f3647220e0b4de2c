// Pictures as PNG files: the one place that knows libpng.
#include <array>
#include <cstdio>
#include <new>
#include <stdexcept>
#include <string>

#include <png.h>

#include "planner/show/picture/image.h"
#include "sim/base/input_error.h"
#include "sim/base/output_file.h"

namespace prehend {
namespace {

using ErrorText = std::array<char, 200>;

// libpng requires that an error handler does not return. It keeps the message and jumps back to
// setjmp in encode(). An exception instead would have to pass through libpng's C code.
void keep_error(png_structp png, png_const_charp message) {
  auto& text = *static_cast<ErrorText*>(png_get_error_ptr(png));
  std::snprintf(text.data(), text.size(), "%s", message);
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

void append(png_structp png, png_bytep bytes, std::size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(bytes), count);
}

void flush_nothing(png_structp) {}

// False, with the reason in `text`, when libpng fails. The jump leaves this frame only, where
// every local is trivial, so no destructor is skipped.
bool encode(const Image& image, std::string& bytes, ErrorText& text) {
  png_structp png =
      png_create_write_struct(PNG_LIBPNG_VER_STRING, &text, keep_error, ignore_warning);
  // `text` stays empty, unless libpng reported an error.
  if (png == nullptr) return false;
  png_infop info = png_create_info_struct(png);
  // Both ways of failing end here: png_destroy_write_struct accepts a null info.
  if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) {
    png_destroy_write_struct(&png, &info);
    return false;
  }
  png_set_write_fn(png, &bytes, append, flush_nothing);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  // Rows as they are: the pictures have a plain background and flat faces, which filters would only
  // make longer, and which takes most of the time.
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
  // The bytes are sRGB; without this chunk a viewer may interpret them in the colour space of its
  // screen.
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(png, info);
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(image.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    png_write_row(png, image.rgb.data() + y * row_bytes);
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return true;
}

}  // namespace

std::string png_bytes(const Image& image) {
  if (image.width < 1 || image.height < 1 ||
      image.rgb.size() !=
          3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) {
    throw InputError({.problem = "not an image",
                      .value = std::to_string(image.width) + " x " + std::to_string(image.height) +
                               ", " + std::to_string(image.rgb.size()) + " bytes"});
  }
  std::string bytes;
  ErrorText text = {};
  if (encode(image, bytes, text)) return bytes;
  if (text.front() == '\0') throw std::bad_alloc();
  throw std::runtime_error(std::string("libpng: ") + text.data());
}

void write_png(const std::filesystem::path& file, const Image& image) {
  write_file(file, png_bytes(image));
}

}  // namespace prehend
