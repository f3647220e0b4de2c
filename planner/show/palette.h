// The colours of pictures, 3-D files and reports, all defined here.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/show/picture/color.h"
#include "sim/base/material.h"
#include "sim/trial/outcome.h"

namespace prehend::palette {

// 0xRRGGBB, as web pages write colours.
constexpr Color from_hex(std::uint32_t rgb, double opacity = 1.0) {
  const auto part = [&](unsigned shift) {
    return static_cast<double>(rgb >> shift & 0xFFU) / 255.0;
  };
  return {part(16), part(8), part(0), opacity};
}

// Bodies.
inline constexpr Color kObject{0.80, 0.78, 0.70, 0.22};
inline constexpr Color kHard{0.45, 0.53, 0.63, 1.0};    // links of a hand that do not give way
inline constexpr Color kRubber{0.27, 0.31, 0.37, 1.0};  // links that do
inline constexpr Color kArm{0.87, 0.70, 0.36, 1.0};
inline constexpr Color kObstacle{0.72, 0.72, 0.72, 0.25};

// Axes of a hand.
inline constexpr Color kApproach{0.10, 0.30, 0.85, 1.0};
inline constexpr Color kClosing{0.80, 0.15, 0.10, 1.0};

// Parts of the object's surface of another material; one with a name of its own is `own`.
constexpr Color of_surface(Material material, bool own) {
  if (own) return {0.10, 0.45, 0.80, 0.45};
  switch (material) {
    case Material::glass:
      return {0.55, 0.78, 0.85, 0.45};
    case Material::metal:
      return {0.45, 0.53, 0.63, 0.45};
    case Material::plastic:
      return {0.80, 0.66, 0.30, 0.45};
    case Material::wood:
      return {0.55, 0.36, 0.20, 0.45};
    case Material::rubber:
      return {0.27, 0.31, 0.37, 0.45};
  }
  return kObject;  // not reached: all materials stand above
}

// Marks of a grasp.
inline constexpr Color kPrimitive{0.16, 0.55, 0.55, 0.30};
inline constexpr Color kContact{0.88, 0.13, 0.12, 1.0};
inline constexpr Color kWeakest{0.50, 0.16, 0.75, 1.0};
inline constexpr Color kForce = from_hex(0x1f8a70);      // of a contact in a simulation
inline constexpr Color kPointedAt = from_hex(0xffb300);  // the contact that a reader points at
inline constexpr Color kCenterOfMass = from_hex(0x111111);
inline constexpr std::array<Color, 3> kAxes = {from_hex(0xc62828), from_hex(0x2e7d32),
                                               from_hex(0x1f4fb0)};  // x, y, z of a frame

// Where the tips of a robot get, one colour a tip; also of solids (of_solid).
inline constexpr std::array<Color, 5> kTips = {from_hex(0xc62828), from_hex(0x1f4fb0),
                                               from_hex(0x2e7d32), from_hex(0xe8952b),
                                               from_hex(0x803fbf)};

// Solids that describe an object together, one colour each.
constexpr Color of_solid(std::size_t k) {
  Color color = kTips[k % kTips.size()];
  color.opacity = 0.35;
  return color;
}

// The space of wrenches.
inline constexpr Color kWrenchSpace = from_hex(0x6f8fb8, 0.30);
inline constexpr Color kEpsilonBall = from_hex(0x2e9e4f, 0.55);
inline constexpr Color kContribution{0.88, 0.13, 0.12, 0.75};  // of one contact

inline constexpr Color kText{0.15, 0.15, 0.18, 1.0};

// How a candidate ended: green for what holds, warm colours and grey where the hand fails,
// blue and teal where the arm does, purple where the object gets away.
constexpr Color of(Outcome outcome) {
  switch (outcome) {
    case Outcome::stable:
      return from_hex(0x2e9e4f);
    case Outcome::not_force_closure:
      return from_hex(0xe8952b);
    case Outcome::no_contact:
      return from_hex(0x8d939b);
    case Outcome::hand_blocked:
      return from_hex(0xd23b2f);
    case Outcome::approach_blocked:
      return from_hex(0x8a5a2b);
    case Outcome::unreachable:
      return from_hex(0x3f7fd6);
    case Outcome::arm_blocked:
      return from_hex(0x1d3f80);
    case Outcome::pushed_away:
      return from_hex(0xb5548c);
    case Outcome::toppled:
      return from_hex(0x9a4fb0);
    case Outcome::squeezed_out:
      return from_hex(0xd6336c);
    case Outcome::dropped:
      return from_hex(0x7a2f57);
    case Outcome::not_simulated:
      return from_hex(0x555555);
    case Outcome::no_path:
      return from_hex(0x14909c);
    case Outcome::keep_out:
      return from_hex(0xb8a500);
    case Outcome::no_seal:
      return from_hex(0x2bb3b3);
  }
  return kText;  // not reached: all outcomes stand above
}

}  // namespace prehend::palette
