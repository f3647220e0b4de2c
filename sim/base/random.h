// Random numbers that are the same on every machine.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>

#include "sim/base/pose.h"

namespace prehend {

// A seeded generator: the standard's mersenne twister, whose output the standard fixes, with
// mappings of our own, because the standard's distributions differ between libraries.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  // Uniform in [0, 1): the 53 bits that a double holds.
  double uniform() { return static_cast<double>(engine_() >> 11U) * 0x1.0p-53; }

  // Uniform in [lower, upper).
  double uniform(double lower, double upper) { return lower + (upper - lower) * uniform(); }

  // 0 .. count - 1 (count > 0). The remainder favours small values by less than count / 2^64.
  std::size_t index(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }

  // low .. high, both included.
  int integer(int low, int high) {
    return low + static_cast<int>(index(static_cast<std::size_t>(high - low + 1)));
  }

  // Standard normal (Box and Muller 1958).
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }

  // A unit vector, uniform over the sphere.
  Vector3 direction() {
    const double z = uniform(-1.0, 1.0);
    const double angle = uniform(0.0, 2.0 * std::numbers::pi);
    const double ring = std::sqrt(1.0 - z * z);
    return Vector3(ring * std::cos(angle), ring * std::sin(angle), z).normalized();
  }

  // A rotation by a uniform angle about a uniform axis; this is not uniform over all rotations.
  Matrix3 rotation() {
    const Vector3 axis = direction();
    return Eigen::AngleAxisd(uniform(0.0, 2.0 * std::numbers::pi), axis).toRotationMatrix();
  }

  // Uniform in the cube |x|, |y|, |z| <= half.
  Vector3 in_box(double half) {
    const double x = uniform(-half, half);
    const double y = uniform(-half, half);
    const double z = uniform(-half, half);
    return {x, y, z};
  }

  // rotation() at in_box(half).
  Pose pose(double half) {
    const Matrix3 turn = rotation();
    return pose_from(turn, in_box(half));
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace prehend
