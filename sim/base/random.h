// Pseudorandom numbers that are the same on every machine and with every standard library, and the
// seeds of a run, which all derive from one.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>

#include "sim/base/pose.h"

namespace prehend {

// A seeded generator: std::mt19937_64, whose output the C++ standard prescribes, with its own
// mappings to distributions, because those of the standard (std::uniform_real_distribution and
// others) differ between libraries.
//
// The numbers come in the order of the calls, and compilers evaluate the arguments of a function
// and the operands of an operator in different orders. An expression therefore draws once, save
// within braces, which are evaluated from left to right.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  // Uniform in [0, 1), with the 53 bits of precision of a double.
  double uniform() { return static_cast<double>(engine_() >> 11U) * 0x1.0p-53; }

  // Uniform in [lower, upper).
  double uniform(double lower, double upper) { return lower + (upper - lower) * uniform(); }

  // Uniform in 0 .. count - 1 (count > 0). Taking the remainder favours small values by a relative
  // error below count / 2^64, which is negligible here.
  std::size_t index(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }

  // Uniform in low .. high, both included.
  int integer(int low, int high) {
    return low + static_cast<int>(index(static_cast<std::size_t>(high - low + 1)));
  }

  // Standard normal distribution (Box and Muller 1958). 1 - uniform() is never 0, so that the
  // logarithm is finite.
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }

  // A unit vector, uniform over the sphere: its z coordinate is uniform (Archimedes), and so is its
  // angle about z.
  Vector3 direction() {
    const double z = uniform(-1.0, 1.0);
    const double angle = uniform(0.0, 2.0 * std::numbers::pi);
    const double ring = std::sqrt(1.0 - z * z);
    return Vector3(ring * std::cos(angle), ring * std::sin(angle), z).normalized();
  }

  // A rotation by a uniform angle about a uniform axis. This is not the uniform distribution over
  // all rotations (the Haar measure).
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

  // Uniform in the box from `lower` to `upper`.
  Vector3 in_box(const Vector3& lower, const Vector3& upper) {
    Vector3 p;
    for (Vector3::Index k = 0; k < 3; ++k) p[k] = uniform(lower[k], upper[k]);
    return p;
  }

  // A vector in a direction() of a length that is uniform in [shortest, longest).
  Vector3 vector(double shortest, double longest) {
    const double length = uniform(shortest, longest);
    return length * direction();
  }

  // A pose with a rotation() and a position in_box(half).
  Pose pose(double half) {
    const Matrix3 turn = rotation();
    return pose_from(turn, in_box(half));
  }

 private:
  std::mt19937_64 engine_;
};

// The seed of one of a run's random generators, from the run's seed `run`. It depends on nothing
// else, so that a run gives the same result on any number of threads. `item` distinguishes
// generators that serve the same purpose, such as the path planners of different grasps; item 0
// has the seed of the run. Generators of different purposes may share a seed: they use the stream
// for different quantities. The bits of the item are mixed, so that the items of one run have other
// seeds than those of runs with neighbouring seeds. Source: the last step of SplitMix64 (Steele,
// Lea and Flood 2014, figure 16, with the constants of Stafford's variant 13).
constexpr std::uint64_t derived_seed(std::uint64_t run, std::uint64_t item = 0) {
  std::uint64_t mixed = item;
  mixed = (mixed ^ mixed >> 30U) * 0xBF58476D1CE4E5B9U;
  mixed = (mixed ^ mixed >> 27U) * 0x94D049BB133111EBU;
  return run + (mixed ^ mixed >> 31U);
}

}  // namespace prehend
