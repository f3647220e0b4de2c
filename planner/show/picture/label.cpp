#include "planner/show/picture/label.h"

#include <algorithm>
#include <string_view>

namespace prehend {
namespace {

constexpr int kGlyphWidth = 5;
constexpr int kGlyphHeight = 8;   // the last row is for descenders
constexpr int kAdvance = 6;       // from one letter to the next
constexpr int kLineAdvance = 11;  // from one line to the next
constexpr int kGlyphsPerBand = 16;
constexpr int kFirstGlyph = 32;
constexpr int kLastGlyph = 127;  // stands for every byte without a glyph

// Glyphs 32 to 127 in reading order: six bands of sixteen glyphs, eight rows each.
constexpr std::string_view kFont =
    R"(
..... ..#.. .#.#. .#.#. ..#.. ##... .##.. ..#.. ...#. .#... ..... ..... ..... ..... ..... .....
..... ..#.. .#.#. .#.#. .#### ##..# #..#. ..#.. ..#.. ..#.. ..#.. ..#.. ..... ..... ..... ....#
..... ..#.. ..... ##### #.#.. ...#. #.#.. ..... .#... ...#. #.#.# ..#.. ..... ..... ..... ...#.
..... ..#.. ..... .#.#. .###. ..#.. .#... ..... .#... ...#. .###. ##### ..... ##### ..... ..#..
..... ..#.. ..... ##### ..#.# .#... #.#.# ..... .#... ...#. #.#.# ..#.. ..... ..... ..... .#...
..... ..... ..... .#.#. ####. #..## #..#. ..... ..#.. ..#.. ..#.. ..#.. .##.. ..... .##.. #....
..... ..#.. ..... .#.#. ..#.. ...## .##.# ..... ...#. .#... ..... ..... ..#.. ..... .##.. .....
..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .#... ..... ..... .....
.###. ..#.. .###. .###. ...#. ##### ..##. ##### .###. .###. ..... ..... ...#. ..... .#... .###.
#...# .##.. #...# #...# ..##. #.... .#... ....# #...# #...# .##.. .##.. ..#.. ..... ..#.. #...#
#..## ..#.. ....# ....# .#.#. ####. #.... ...#. #...# #...# .##.. .##.. .#... ##### ...#. ....#
#.#.# ..#.. ...#. ..##. #..#. ....# ####. ..#.. .###. .#### ..... ..... #.... ..... ....# ...#.
##..# ..#.. ..#.. ....# ##### ....# #...# ..#.. #...# ....# .##.. .##.. .#... ##### ...#. ..#..
#...# ..#.. .#... #...# ...#. #...# #...# .#... #...# ...#. .##.. ..#.. ..#.. ..... ..#.. .....
.###. .###. ##### .###. ...#. .###. .###. .#... .###. .##.. ..... .#... ...#. ..... .#... ..#..
..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .....
.###. .###. ####. .###. ####. ##### ##### .###. #...# .###. ..### #...# #.... #...# #...# .###.
#...# #...# #...# #...# #...# #.... #.... #...# #...# ..#.. ...#. #..#. #.... ##.## ##..# #...#
#.### #...# #...# #.... #...# #.... #.... #.... #...# ..#.. ...#. #.#.. #.... #.#.# #.#.# #...#
#.#.# ##### ####. #.... #...# ####. ####. #.### ##### ..#.. ...#. ##... #.... #.#.# #..## #...#
#.### #...# #...# #.... #...# #.... #.... #...# #...# ..#.. ...#. #.#.. #.... #...# #...# #...#
#.... #...# #...# #...# #...# #.... #.... #...# #...# ..#.. #..#. #..#. #.... #...# #...# #...#
.#### #...# ####. .###. ####. ##### #.... .###. #...# .###. .##.. #...# ##### #...# #...# .###.
..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .....
####. .###. ####. .#### ##### #...# #...# #...# #...# #...# ##### .###. ..... .###. ..#.. .....
#...# #...# #...# #.... ..#.. #...# #...# #...# #...# #...# ....# .#... #.... ...#. .#.#. .....
#...# #...# #...# #.... ..#.. #...# #...# #...# .#.#. .#.#. ...#. .#... .#... ...#. #...# .....
####. #...# ####. .###. ..#.. #...# #...# #.#.# ..#.. ..#.. ..#.. .#... ..#.. ...#. ..... .....
#.... #.#.# #.#.. ....# ..#.. #...# #...# #.#.# .#.#. ..#.. .#... .#... ...#. ...#. ..... .....
#.... #..#. #..#. ....# ..#.. #...# .#.#. ##.## #...# ..#.. #.... .#... ....# ...#. ..... .....
#.... .##.# #...# ####. ..#.. .###. ..#.. #...# #...# ..#.. ##### .###. ..... .###. ..... #####
..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .....
.#... ..... #.... ..... ....# ..... ..##. ..... #.... ..#.. ...#. #.... .##.. ..... ..... .....
..#.. ..... #.... ..... ....# ..... .#... ..... #.... ..... ..... #.... ..#.. ..... ..... .....
..... .###. ####. .###. .#### .###. ####. .#### ####. .##.. ..##. #..#. ..#.. ##.#. ####. .###.
..... ....# #...# #.... #...# #...# .#... #...# #...# ..#.. ...#. #.#.. ..#.. #.#.# #...# #...#
..... .#### #...# #.... #...# ##### .#... #...# #...# ..#.. ...#. ##... ..#.. #.#.# #...# #...#
..... #...# #...# #.... #...# #.... .#... .#### #...# ..#.. ...#. #.#.. ..#.. #.#.# #...# #...#
..... .#### ####. .###. .#### .###. .#... ....# #...# .###. ...#. #..#. .###. #.#.# #...# .###.
..... ..... ..... ..... ..... ..... ..... .###. ..... ..... .##.. ..... ..... ..... ..... .....
..... ..... ..... ..... .#... ..... ..... ..... ..... ..... ..... ..##. ..#.. .##.. ..... #####
..... ..... ..... ..... .#... ..... ..... ..... ..... ..... ..... .#... ..#.. ...#. ..... #...#
####. .#### #.##. .#### ####. #...# #...# #...# #...# #...# ##### .#... ..#.. ...#. .#..# #...#
#...# #...# ##... #.... .#... #...# #...# #.#.# .#.#. #...# ...#. ##... ..#.. ...## #.##. #...#
#...# #...# #.... .###. .#... #...# #...# #.#.# ..#.. #...# ..#.. .#... ..#.. ...#. ..... #...#
####. .#### #.... ....# .#... #...# .#.#. #.#.# .#.#. .#### .#... .#... ..#.. ...#. ..... #...#
#.... ....# #.... ####. ..##. .#### ..#.. .#.#. #...# ....# ##### ..##. ..#.. .##.. ..... #####
#.... ....# ..... ..... ..... ..... ..... ..... ..... .###. ..... ..... ..... ..... ..... .....
)";

bool has_dot(unsigned char letter, int column, int row) {
  const int glyph =
      (letter < kFirstGlyph || letter > kLastGlyph ? kLastGlyph : int{letter}) - kFirstGlyph;
  const int line = (glyph / kGlyphsPerBand) * kGlyphHeight + row;
  // A line is sixteen glyphs, each followed by a blank or the line's end; one break comes first.
  const int at =
      1 + line * kGlyphsPerBand * kAdvance + (glyph % kGlyphsPerBand) * kAdvance + column;
  return kFont[static_cast<std::size_t>(at)] == '#';
}

// Blends `ink` over a square of `size` pixels, as far as it lies in the image. Blending is done in
// linear light, as everywhere in pictures: averages of sRGB bytes are too dark.
void fill_square(Image& image, int left, int top, int size, const Light& ink, double opacity) {
  for (int y = std::max(top, 0); y < std::min(top + size, image.height); ++y) {
    for (int x = std::max(left, 0); x < std::min(left + size, image.width); ++x) {
      const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(x));
      const Light under =
          light_of({image.rgb[at] / 255.0, image.rgb[at + 1] / 255.0, image.rgb[at + 2] / 255.0});
      for (std::size_t k = 0; k < 3; ++k) {
        const auto alpha = static_cast<float>(opacity);
        image.rgb[at + k] = display_byte(under[k] + alpha * (ink[k] - under[k]));
      }
    }
  }
}

}  // namespace

TextSize text_size(const std::string& text, int scale) {
  int columns = 0;
  int widest = 0;
  int lines = text.empty() ? 0 : 1;
  for (const char letter : text) {
    columns = letter == '\n' ? 0 : columns + 1;
    widest = std::max(widest, columns);
    if (letter == '\n') ++lines;
  }
  const int gap = kAdvance - kGlyphWidth;
  return {std::max(widest * kAdvance - gap, 0) * scale,
          lines == 0 ? 0 : ((lines - 1) * kLineAdvance + kGlyphHeight) * scale};
}

void label(Image& image, int x, int y, const std::string& text, const Color& color, int scale) {
  const Light ink = light_of(color);
  const double opacity = std::clamp(color.opacity, 0.0, 1.0);
  int left = x;
  for (const char letter : text) {
    if (letter == '\n') {
      left = x;
      y += kLineAdvance * scale;
      continue;
    }
    for (int row = 0; row < kGlyphHeight; ++row) {
      for (int column = 0; column < kGlyphWidth; ++column) {
        // char may be signed: bytes from 128 on must not become negative numbers of glyphs.
        if (!has_dot(static_cast<unsigned char>(letter), column, row)) continue;
        fill_square(image, left + column * scale, y + row * scale, scale, ink, opacity);
      }
    }
    left += kAdvance * scale;
  }
}

}  // namespace prehend
