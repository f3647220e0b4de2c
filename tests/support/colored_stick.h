// A stick in two colours, as PLY.
#pragma once

#include <array>
#include <sstream>
#include <string>

namespace prehend::test {

inline constexpr const char* kLowerColor = "#cc3311";  // below z = 0
inline constexpr const char* kUpperColor = "#2266aa";  // above

// 30 x 40 x 150 mm about the origin, along z, of polygons with colours; without the one at the top
// where `open`.
inline std::string colored_stick(bool open = false) {
  std::ostringstream ply;
  ply << "ply\nformat ascii 1.0\nelement vertex 12\nproperty float x\nproperty float y\n"
         "property float z\nelement face "
      << (open ? 9 : 10)
      << "\nproperty list uchar int vertex_indices\nproperty uchar red\n"
         "property uchar green\nproperty uchar blue\nend_header\n";
  constexpr std::array<const char*, 4> kAround = {"-0.015 -0.02 ", "0.015 -0.02 ", "0.015 0.02 ",
                                                  "-0.015 0.02 "};
  for (const char* z : {"-0.075", "0", "0.075"}) {
    for (const char* xy : kAround) ply << xy << z << "\n";
  }
  const std::string lower = " 204 51 17\n";
  const std::string upper = " 34 102 170\n";
  ply << "4 3 2 1 0" << lower;
  for (const int ring : {0, 4}) {
    for (int k = 0; k < 4; ++k) {
      const int a = ring + k;
      const int b = ring + (k + 1) % 4;
      ply << "4 " << a << " " << b << " " << b + 4 << " " << a + 4 << (ring == 0 ? lower : upper);
    }
  }
  if (!open) ply << "4 8 9 10 11" << upper;
  return ply.str();
}

}  // namespace prehend::test
