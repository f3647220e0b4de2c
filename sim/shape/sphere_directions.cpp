#include "sim/shape/sphere_directions.h"

#include <cmath>
#include <numbers>

namespace prehend {
namespace {

Vector3 at_height(double z, double angle) {
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

}  // namespace

Vector3 sphere_direction(int i, int n) {
  return at_height(1.0 - (2.0 * i + 1.0) / n, i * std::numbers::pi * (3.0 - std::sqrt(5.0)));
}

std::vector<Vector3> half_sphere_directions(int n) {
  std::vector<Vector3> directions;
  for (int i = 0; i < n; ++i) {
    directions.push_back(at_height((i + 0.5) / n, 2.0 * std::numbers::pi * std::numbers::phi * i));
  }
  return directions;
}

}  // namespace prehend
