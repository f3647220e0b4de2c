// How a surface looks under the lights of a picture.
#pragma once

#include "planner/show/picture/color.h"
#include "sim/base/pose.h"

namespace prehend {

// Amounts of light; a surface that faces an amount of 1 shows its own color. The key light comes
// from above the viewer's left shoulder and the fill light from the lower right, so that every view
// of a scene is lit alike; sky and ground are the light from above and below in the world.
struct Lighting {
  double sky = 0.40;
  double ground = 0.14;
  double key = 0.72;
  double fill = 0.16;
  double gloss = 0.10;  // of the highlight of the key light, added in white
};

// The lights of one picture, in the camera frame (x right, y down, z into the scene).
class Lights {
 public:
  Lights(const Lighting& lighting, const Vector3& up_C);

  // Light from a surface with unit normal `normal` on the viewer's side; `to_eye` is unit.
  Light reflected(const Light& albedo, const Vector3& normal, const Vector3& to_eye) const;

 private:
  Lighting lighting_;
  Vector3 up_;
  Vector3 to_key_;
  Vector3 to_fill_;
};

}  // namespace prehend
