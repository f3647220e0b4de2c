// Random numbers that are the same on every machine: the standard's generator, our own mappings.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "sim/geometry/pose.h"

namespace prehend::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}

  // Uniform in [lower, upper).
  double uniform(double lower, double upper) {
    constexpr double kUnit = 1.0 / 9007199254740992.0;  // 2^-53
    return lower + (upper - lower) * (static_cast<double>(generator_() >> 11U) * kUnit);
  }

  // 0 .. count - 1.
  std::size_t index(std::size_t count) { return static_cast<std::size_t>(generator_() % count); }

  Vector3 in_box(double half) {
    const double x = uniform(-half, half);
    const double y = uniform(-half, half);
    const double z = uniform(-half, half);
    return {x, y, z};
  }

  Vector3 direction() {
    const double z = uniform(-1.0, 1.0);
    const double angle = uniform(0.0, 2.0 * std::numbers::pi);
    const double ring = std::sqrt(1.0 - z * z);
    return {ring * std::cos(angle), ring * std::sin(angle), z};
  }

  // A turn by any angle about any axis (not uniform over rotations, which no test needs).
  Matrix3 rotation() {
    const Vector3 axis = direction();
    return Eigen::AngleAxisd(uniform(0.0, 2.0 * std::numbers::pi), axis).toRotationMatrix();
  }

  Pose pose(double half) {
    const Matrix3 turn = rotation();
    return pose_from(turn, in_box(half));
  }

 private:
  std::mt19937_64 generator_;
};

}  // namespace prehend::test
