// A contact between a finger and an object: all that the measures of grasp quality know of it.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include <Eigen/Core>

#include "sim/base/named_enum.h"

namespace prehend {

// The forces and torques that a contact can transmit with a normal force f_n >= 0.
enum class ContactModel {
  frictionless,  // the normal force alone
  point,         // Coulomb friction: tangential force |f_t| <= friction f_n
  soft_finger,   // and a torque t about the normal: |f_t|^2 + (t / torsion)^2 <= (friction f_n)^2,
                 // the ellipsoidal limit surface (Howe and Cutkosky 1996)
  suction,       // a sealed suction cup, which also pulls and resists tilting (suction_cup.h)
};

// The enumerator's name, as it is written in files.
constexpr auto enum_names(ContactModel /*of*/) {
  return std::to_array<std::string_view>({"frictionless", "point", "soft_finger", "suction"});
}

// A point contact. `position` and `normal` are given in one frame, usually the object's. Contact
// over an area is described by several contacts, at the corners of the area.
struct Contact {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();   // unit, from the finger into the object
  double friction = 0.0;  // Coulomb coefficient, >= 0; a frictionless contact ignores it
  ContactModel model = ContactModel::point;
  double torsion = 0.0;  // soft finger: largest torque over largest friction force, >= 0; suction:
                         // radius of the lip, > 0 [m]
  double moment = 0.0;   // suction: largest torque about a tangent that the lip bears elastically,
                         // over the vacuum's force, >= 0 [m]
  double vacuum = 0.0;   // suction: force with which the vacuum presses the lip onto the object,
                         // >= 0 [N]
  // Standard deviation of the logarithm of the coefficient, >= 0, in place of what is asked of all
  // contacts (NoiseOptions); measures without errors ignore it.
  std::optional<double> friction_deviation = {};
};

}  // namespace prehend
