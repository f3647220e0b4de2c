// The values that a number may have.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <string_view>

namespace prehend {

// An interval of finite numbers, with its upper end and, unless without_lower, its lower end. NaN
// is in none.
struct Range {
  double lower = 0.0;
  double upper = std::numeric_limits<double>::infinity();
  bool without_lower = false;  // above `lower`, not at it
  bool with_infinity = false;  // where there is no upper end

  bool contains(double value) const {
    return (std::isfinite(value) || with_infinity) &&
           (without_lower ? value > lower : value >= lower) && value <= upper;
  }

  // "must be at least 1 and at most 3", "must be above 0", "must be a number".
  std::string words() const;

  // As an interval: "[1, 3]", "(0, 1]", "> 0", ">= 1"; "" for any number.
  std::string interval() const;
};

// Numbers of files and messages are not larger, whatever their unit: sums and products of several
// of them then stay in the range of double.
inline constexpr double kLargestNumber = 1e30;

// Limits by kind of quantity, in SI units and radians, of whatever files, messages and programs
// give. They are far beyond all that can be gripped, and so small that squares of sums of many of
// them are numbers in single precision, which the trees of boxes need.
inline constexpr double kFarthest = 1e6;     // m, rad
inline constexpr double kLargestMass = 1e9;  // kg
inline constexpr double kLargestLoad = 1e9;  // N, N m
inline constexpr double kLargestRate = 1e9;  // velocities, accelerations
inline constexpr double kLargestFriction = 1e6;
// Of a coordinate of a point [m], and of the value of a joint [rad or m].
inline constexpr Range kCoordinate{.lower = -kFarthest, .upper = kFarthest};
inline constexpr Range kDistance{.upper = kFarthest};
inline constexpr Range kLengthAbove0{.upper = kFarthest, .without_lower = true};
inline constexpr Range kDensity{.upper = 1e6, .without_lower = true};  // kg/m^3
inline constexpr Range kMass{.upper = kLargestMass, .without_lower = true};
// With a sign: forces and torques.
inline constexpr Range kLoad{.lower = -kLargestLoad, .upper = kLargestLoad};
inline constexpr Range kEffort{.upper = kLargestLoad};
inline constexpr Range kEffortAbove0{.upper = kLargestLoad, .without_lower = true};
inline constexpr Range kVelocity{.lower = -kLargestRate, .upper = kLargestRate};
inline constexpr Range kRate{.upper = kLargestRate};
// Of springs and controllers, and friction that grows with velocity.
inline constexpr Range kGain{.upper = 1e15};
inline constexpr Range kGainAbove0{.upper = 1e15, .without_lower = true};
inline constexpr Range kRateAbove0{.upper = kLargestRate, .without_lower = true};
inline constexpr Range kAngle{.upper = kFarthest};
inline constexpr Range kAngleAbove0{.upper = kFarthest, .without_lower = true};
inline constexpr Range kTime{.upper = 1e6};  // s
inline constexpr Range kTimeAbove0{.upper = 1e6, .without_lower = true};
// Without a unit: shares, tolerances relative to something, deviations of logarithms.
inline constexpr Range kRatio{.upper = 1e6};
inline constexpr Range kRatioAbove0{.upper = 1e6, .without_lower = true};
// Of steps and tries: more would be more than a machine makes.
inline constexpr double kLargestCount = 1e9;
inline constexpr Range kCount{.upper = kLargestCount};
inline constexpr Range kCountAbove0{.lower = 1.0, .upper = kLargestCount};
// Of what is kept in memory.
inline constexpr Range kSampleCount{.lower = 1.0, .upper = 1e5};
inline constexpr Range kPointCount{.lower = 100.0, .upper = 1e6};
// Numbers that count from 0, or name something.
inline constexpr Range kIndex{.upper = std::numeric_limits<int>::max()};
inline constexpr Range kAnyNumber{.lower = -std::numeric_limits<double>::infinity()};
inline constexpr Range kAtLeast0{};
inline constexpr Range kAtLeast1{.lower = 1.0};
inline constexpr Range kAbove0{.without_lower = true};
inline constexpr Range kFraction{.upper = 1.0};
inline constexpr Range kFractionAbove0{.upper = 1.0, .without_lower = true};
// Edges of a pyramid that stands for a friction cone.
inline constexpr Range kConeEdges{.lower = 3.0, .upper = 1024.0};

// Throws InputError that names `field` when the value is out of the range.
void require_in(const Range& range, double value, std::string_view field);

}  // namespace prehend
