// Lengths are in metres inside; they are printed in millimetres, areas in square centimetres,
// volumes in litres.
#pragma once

namespace prehend {

inline constexpr double kMillimetres = 1000.0;     // in a metre
inline constexpr double kSquareCentimetres = 1e4;  // in a square metre
inline constexpr double kLitres = 1000.0;          // in a cubic metre

}  // namespace prehend
