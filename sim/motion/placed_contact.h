// A contact of the world where its bodies are now, and the friction that holds there.
#pragma once

#include <array>

#include "sim/motion/solids.h"

namespace prehend {

// A contact of the step in world axes.
struct PlacedContact {
  Vector3 p_W;
  std::array<Vector3, 3> directions;  // normal and tangents
  double gap = 0.0;
  Eigen::Vector2d drift = Eigen::Vector2d::Zero();  // of a's point against b's, along the tangents
};

PlacedContact placed(const HeldContact& contact, const Solid& a, const Solid& b);

// The coefficient of friction of a contact, static or of one that slides.
double friction_of(const ContactLaws& laws, const HeldContact& contact, const Solid& a,
                   const Solid& b);

// The lever arm with which friction resists spin on a surface that yields so far: of the pressure
// of a contact of Hertz over a disc of radius sqrt(R d), 3 pi / 16 of that (Johnson 1985, Contact
// Mechanics, sections 4.2 and 7.4) [m].
double soft_arm(double depth);

// The lever arm with which friction resists spin at a contact [m]; 0: it does not.
double arm_of(const ContactLaws& laws, const HeldContact& contact, const Solid& a, const Solid& b,
              double friction);

}  // namespace prehend
