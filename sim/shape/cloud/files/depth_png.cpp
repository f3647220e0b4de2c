#include "sim/shape/cloud/files/depth_png.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <cstring>
#include <new>
#include <string>

#include <png.h>

#include "sim/base/input_error.h"
#include "sim/shape/cloud/files/point_cloud.h"

namespace prehend {
namespace {

// What libpng is given: the bytes that are left, and where to put its message.
struct PngSource {
  std::string_view bytes;
  std::array<char, 200> message = {};
};

// libpng requires that an error handler does not return. It keeps the message and jumps back to
// setjmp. An exception instead would have to pass through libpng's C code.
void keep_message(png_structp png, png_const_charp message) {
  auto& text = static_cast<PngSource*>(png_get_error_ptr(png))->message;
  std::snprintf(text.data(), text.size(), "%s", message);
  png_longjmp(png, 1);
}

void ignore(png_structp, png_const_charp) {}

void read_bytes(png_structp png, png_bytep to, std::size_t count) {
  auto* source = static_cast<PngSource*>(png_get_io_ptr(png));
  if (source->bytes.size() < count) png_error(png, "the file ends too early");
  std::memcpy(to, source->bytes.data(), count);
  source->bytes.remove_prefix(count);
}

struct PngHeader {
  png_uint_32 width = 0;
  png_uint_32 height = 0;
  int depth = 0;
  int color = 0;
};

// Calls of libpng, each false, with the message in the source, where libpng fails. The jump leaves
// frames only in which every local is trivial, so no destructor is skipped.
class PngReader {
 public:
  explicit PngReader(PngSource& source)
      : png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, keep_message, ignore)) {
    if (png_ == nullptr) throw std::bad_alloc();
    info_ = png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
    png_set_read_fn(png_, &source, read_bytes);
    png_set_user_limits(png_, kMostReadings, kMostReadings);
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
    png_set_crc_action(png_, PNG_CRC_QUIET_USE, PNG_CRC_QUIET_USE);
#endif
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  bool read_header(PngHeader& header) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_info(png_, info_);
    png_get_IHDR(png_, info_, &header.width, &header.height, &header.depth, &header.color, nullptr,
                 nullptr, nullptr);
    return true;
  }

  // Of a 16-bit grey image.
  bool read_rows(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    if (std::endian::native == std::endian::little) png_set_swap(png_);
    png_read_image(png_, rows);
    return true;
  }

 private:
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

[[noreturn]] void fail(const PngSource& source) {
  throw InputError("no PNG image, or damaged: " + on_one_line(source.message.data()));
}

void require_depth(const PngHeader& header) {
  if (header.depth == 16 && header.color == PNG_COLOR_TYPE_GRAY) return;
  const bool is_grey = (header.color & PNG_COLOR_MASK_COLOR) == 0;
  throw InputError(
      {.problem = "must be a 16-bit grey image, whose counts are depths",
       .value = std::to_string(header.depth) + "-bit " + (is_grey ? "grey" : "colour")});
}

}  // namespace

DepthImage read_depth_png(std::string_view bytes) {
  PngSource source{bytes};
  PngReader reader(source);
  PngHeader header;
  if (!reader.read_header(header)) fail(source);
  require_depth(header);
  require_few(std::size_t{header.width} * header.height, "pixels");
  DepthImage image{static_cast<int>(header.width), static_cast<int>(header.height), {}};
  image.counts.resize(std::size_t{header.width} * header.height);
  std::vector<png_bytep> rows;
  for (std::size_t y = 0; y < header.height; ++y) {
    rows.push_back(reinterpret_cast<png_bytep>(image.counts.data() + y * header.width));
  }
  if (!reader.read_rows(rows.data())) fail(source);
  std::replace(image.counts.begin(), image.counts.end(), std::uint16_t{65535}, std::uint16_t{0});
  return image;
}

}  // namespace prehend
