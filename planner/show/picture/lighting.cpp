#include "planner/show/picture/lighting.h"

#include <algorithm>
#include <cmath>

namespace prehend {
namespace {

// Lambert's cosine, shifted so that it reaches 0 at an angle where the cosine is -width, and scaled
// to 1 at normal incidence. A large lamp lights surfaces a little beyond 90 degrees in this way,
// and the border to the shade is soft.
constexpr double softened(double cosine, double width) {
  return std::max(0.0, (cosine + width) * (1.0 / (1.0 + width)));
}

}  // namespace

Lights::Lights(const Lighting& lighting, const Vector3& up_C)
    : lighting_(lighting),
      up_(up_C.normalized()),
      to_key_(Vector3(-0.45, -0.75, -0.70).normalized()),
      to_fill_(Vector3(0.85, 0.15, -0.50).normalized()) {}

Light Lights::reflected(const Light& albedo, const Vector3& normal, const Vector3& to_eye) const {
  constexpr double kKeyWidth = 0.15;
  constexpr double kFillWidth = 0.4;
  // Sky and ground: linear in the vertical component of the normal, as under two half spheres of
  // uniform light.
  const double upward = 0.5 + 0.5 * normal.dot(up_);
  const double diffuse = lighting_.ground + (lighting_.sky - lighting_.ground) * upward +
                         lighting_.key * softened(normal.dot(to_key_), kKeyWidth) +
                         lighting_.fill * softened(normal.dot(to_fill_), kFillWidth);
  // Blinn's highlight: the cosine between the normal and the bisector of light and eye, to the
  // power of 32: its square, by squaring four times.
  const Vector3 between = to_key_ + to_eye;
  const double along = std::max(0.0, normal.dot(between));
  const double length = between.squaredNorm();
  double highlight = length > 0.0 ? along * along / length : 0.0;
  for (int i = 0; i < 4; ++i) highlight *= highlight;
  const double white = lighting_.gloss * highlight;
  Light light{};
  for (std::size_t k = 0; k < 3; ++k) {
    light[k] = static_cast<float>(diffuse * static_cast<double>(albedo[k]) + white);
  }
  return light;
}

}  // namespace prehend
