#include "planner/show/picture/color.h"

#include <cmath>
#include <cstddef>

namespace prehend {
namespace {

// Written so that NaN becomes 0.
double clamped(double part) { return part > 0.0 ? (part < 1.0 ? part : 1.0) : 0.0; }

// The sRGB transfer function (IEC 61966-2-1) and its inverse.
double encoded(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
}
double decoded(double part) {
  return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
}

// A call of pow for each pixel would be slow, so bytes are looked up. Byte i gives way to the next
// one where the encoding passes (i + 1/2) / 255. Where the curve is steepest, a byte spans about
// 1/3300 of the range of light, so a cell of 2^-14 contains at most one such border: the byte at
// the lower end of a cell needs one comparison to be corrected.
constexpr std::size_t kCells = 1U << 14U;

struct ByteTable {
  std::array<std::uint8_t, kCells> first_byte;  // byte at the lower end of each cell
  std::array<float, 256> upper_border;          // light at which byte i gives way to i + 1

  ByteTable() {
    for (std::size_t i = 0; i < 256; ++i) {
      upper_border[i] = static_cast<float>(decoded((static_cast<double>(i) + 0.5) / 255.0));
    }
    for (std::size_t i = 0; i < kCells; ++i) {
      const double light = static_cast<double>(i) / static_cast<double>(kCells);
      first_byte[i] = static_cast<std::uint8_t>(std::lround(255.0 * encoded(light)));
    }
  }
};

}  // namespace

Light light_of(const Color& color) {
  return {static_cast<float>(decoded(clamped(color.red))),
          static_cast<float>(decoded(clamped(color.green))),
          static_cast<float>(decoded(clamped(color.blue)))};
}

std::uint8_t display_byte(float light) {
  static const ByteTable table;
  if (!(light > 0.0F)) return 0;
  if (light >= 1.0F) return 255;
  const auto cell = static_cast<std::size_t>(light * static_cast<float>(kCells));
  const std::uint8_t byte = table.first_byte[cell];
  return light > table.upper_border[byte] ? static_cast<std::uint8_t>(byte + 1) : byte;
}

}  // namespace prehend
