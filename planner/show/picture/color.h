// Colors in sRGB, and as linear light for computing with.
#pragma once

#include <array>
#include <cstdint>

namespace prehend {

// sRGB parts in [0, 1], as a color picker shows them; values outside are clamped.
struct Color {
  double red = 0.5;
  double green = 0.5;
  double blue = 0.5;
  double opacity = 1.0;  // 0 invisible, 1 solid
};

// Red, green and blue in proportion to the amount of light: the space to add and average in.
using Light = std::array<float, 3>;

Light light_of(const Color& color);

// The sRGB byte for an amount of light, rounded to nearest; clamped to [0, 1], NaN is 0.
std::uint8_t display_byte(float light);

}  // namespace prehend
