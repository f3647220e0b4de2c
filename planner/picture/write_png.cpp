// write_png of image.h: the one place that knows libpng.
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <system_error>
#include <unistd.h>

#include <png.h>

#include "planner/picture/image.h"
#include "sim/geometry/input_error.h"

namespace prehend {
namespace {

using ErrorText = std::array<char, 200>;

// libpng must not return from an error: keep its words, then jump back into encode().
void keep_error(png_structp png, png_const_charp message) {
  auto& text = *static_cast<ErrorText*>(png_get_error_ptr(png));
  std::snprintf(text.data(), text.size(), "%s", message);
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

// False, with the reason in `text`, when libpng fails. The jump leaves this frame only, where
// every local is trivial, so no destructor is skipped.
bool encode(std::FILE* stream, const Image& image, ErrorText& text) {
  png_structp png =
      png_create_write_struct(PNG_LIBPNG_VER_STRING, &text, keep_error, ignore_warning);
  if (png == nullptr) return false;
  png_infop info = png_create_info_struct(png);
  if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) {
    png_destroy_write_struct(&png, &info);
    return false;
  }
  png_init_io(png, stream);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
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

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& why) {
  throw InputError(file.string() + ": cannot write the picture: " + why);
}

// Writes all of the image to `file`; an empty string, or why it could not.
std::string write_to(const std::filesystem::path& file, const Image& image) {
  std::FILE* const stream = std::fopen(file.c_str(), "wb");
  if (stream == nullptr) return std::strerror(errno);
  ErrorText text = {"out of memory"};
  const bool encoded = encode(stream, image, text);
  // A full disk may show only when the last bytes leave the buffer.
  const bool closed = std::fclose(stream) == 0;
  if (!encoded) return text.data();
  return closed ? "" : std::strerror(errno);
}

}  // namespace

void write_png(const std::filesystem::path& file, const Image& image) {
  if (image.width < 1 || image.height < 1 ||
      image.rgb.size() !=
          3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) {
    fail(file, "not an image (" + std::to_string(image.width) + " x " +
                   std::to_string(image.height) + ", " + std::to_string(image.rgb.size()) +
                   " bytes)");
  }
  // Beside the target, because a rename is atomic only within one file system.
  std::filesystem::path partial = file;
  partial += ".partial-" + std::to_string(getpid());
  std::string why = write_to(partial, image);
  std::error_code error;
  if (why.empty()) {
    std::filesystem::rename(partial, file, error);
    if (!error) return;
    why = error.message();
  }
  std::filesystem::remove(partial, error);
  fail(file, why);
}

}  // namespace prehend
