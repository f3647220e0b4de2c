// Friction between materials, and how far they yield to pressure.
#pragma once

#include <array>
#include <optional>

#include "sim/base/material.h"
#include "sim/base/range.h"

namespace prehend {

// A friction coefficient, which must be from 0 to 1e6 (kLargestFriction, sim/quality/ranges.h).
// Throws InputError otherwise.
double checked_friction(double friction);

// Symmetric table of static friction coefficients. Values: the table of GraspIt!'s default
// materials (Miller and Allen 2004, section "Contacts and Friction"; docs/reference/scene-file.md).
class FrictionTable {
 public:
  FrictionTable();

  double between(Material a, Material b) const;
  // Throws as checked_friction.
  void set(Material a, Material b, double friction);

 private:
  std::array<std::array<double, 5>, 5> values_;
};

// Friction coefficients of surfaces that slide, of those pairs of materials that have one of their
// own; others slide as they stick.
class KineticFriction {
 public:
  std::optional<double> between(Material a, Material b) const;
  // Throws as checked_friction. Without a number the pair has none of its own from then on.
  void set(Material a, Material b, std::optional<double> friction);
  // Whether no pair has one.
  bool empty() const;

 private:
  std::array<std::array<std::optional<double>, 5>, 5> values_;
};

// The friction of surfaces that slide: the kinetic coefficients, else the static ones.
FrictionTable sliding_friction(const FrictionTable& statics, const KineticFriction& kinetic);

// How uncertain the friction of a pair is: the standard deviation of the logarithm of its
// coefficient. Pairs without one have that of the options that ask for errors.
class FrictionDeviations {
 public:
  std::optional<double> between(Material a, Material b) const;
  // Throws InputError unless the deviation is from 0 to 10. Without a number the pair has none.
  void set(Material a, Material b, std::optional<double> deviation);

 private:
  std::array<std::array<std::optional<double>, 5>, 5> values_;
};

// How far the surface of a material gives way where a finger presses, 0 for hard materials, which
// touch at points. Rubber: 1 mm, the Hertzian indentation of a pad of 2 MPa that is pressed with 20
// N against a surface of radius 30 mm (Johnson, "Contact Mechanics", 1985, eq. 4.23).
class CompliantDepths {
 public:
  double of(Material material) const;  // m
  // Throws InputError unless `depth` is finite and >= 0.
  void set(Material material, double depth);

  // Of two bodies the softer one gives way.
  double between(Material a, Material b) const;

 private:
  std::array<double, 5> values_ = {0.0, 0.0, 0.0, 0.0, 1e-3};
};

}  // namespace prehend
