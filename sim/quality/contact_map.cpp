#include "sim/quality/contact_map.h"

#include <cmath>
#include <sstream>
#include <string>

#include <Eigen/Geometry>

#include "sim/base/input_error.h"
#include "sim/base/range.h"
#include "sim/quality/ranges.h"

// The contact map (Murray, Li and Sastry 1994, section 5.2) has one column for each thing that a
// contact can transmit: the wrench of a unit force along the normal, along each tangent, and of a
// unit torque about the normal. A force f at p exerts the torque (p - origin) x f. The torque scale
// is put into the lever arm, so that all columns are [force; torque * scale].
namespace prehend {
namespace {

// A normal whose length is farther from 1 than this is taken for a mistake of the caller, such as a
// vector that was not normalised. Nearer ones are normalised where they are used.
constexpr double kUnitTolerance = 1e-3;
// The cross product of unit vectors has a rounding error of about 1e-16. At this length its
// direction is still accurate to about 1e-10; where it is much shorter, the direction would be that
// of the rounding error.
constexpr double kParallelSine = 1e-6;

// Vectors in error messages: all coordinates in one line.
const Eigen::IOFormat kInline(Eigen::StreamPrecision, Eigen::DontAlignCols, ", ", ", ");

template <typename Value>
[[noreturn]] void reject(const std::string& field, const std::string& problem, const Value& value) {
  std::ostringstream text;
  text << value;
  throw InputError({.field = field, .problem = problem, .value = text.str()});
}

// The limits as they are in messages.
std::string number_text(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

void check_point(const std::string& field, const Eigen::Vector3d& point) {
  if (!point.allFinite()) reject(field, "not finite", point.transpose().format(kInline));
  if (point.cwiseAbs().maxCoeff() > kFarthest) {
    reject(field, "must be within " + number_text(kFarthest) + " m of 0",
           point.transpose().format(kInline));
  }
}

// The comparison also turns away what is not a number.
void check_range(const std::string& field, double value, double lowest, double highest) {
  if (value >= lowest && value <= highest) return;
  reject(field, "must be from " + number_text(lowest) + " to " + number_text(highest), value);
}

}  // namespace

Tangents contact_tangents(const Eigen::Vector3d& normal) {
  Eigen::Vector3d first = normal.cross(Eigen::Vector3d::UnitX());
  // A normal parallel to X is orthogonal to Z, so this product has length one.
  if (first.norm() < kParallelSine) first = normal.cross(Eigen::Vector3d::UnitZ());
  first.normalize();
  return {first, normal.cross(first)};
}

ContactMap contact_map(const Contact& contact, const WrenchFrame& frame) {
  const Eigen::Vector3d normal = contact.normal.normalized();
  const Tangents tangents = contact_tangents(normal);
  const Eigen::Vector3d arm = frame.torque_scale * (contact.position - frame.torque_origin);
  ContactMap map;
  map.col(0) << normal, arm.cross(normal);
  map.col(1) << tangents.first, arm.cross(tangents.first);
  map.col(2) << tangents.second, arm.cross(tangents.second);
  // A pure torque is the same about every origin: it has no lever arm.
  map.col(3) << Eigen::Vector3d::Zero(), frame.torque_scale * normal;
  return map;
}

void check_contact(const Contact& contact) {
  check_point("position", contact.position);
  if (!contact.normal.allFinite()) {
    reject("normal", "not finite", contact.normal.transpose().format(kInline));
  }
  if (std::abs(contact.normal.norm() - 1.0) > kUnitTolerance) {
    reject("normal", "not unit", contact.normal.transpose().format(kInline));
  }
  check_range("friction", contact.friction, 0.0, kLargestFriction);
  check_range("torsion", contact.torsion, 0.0, kFarthest);
  check_range("moment", contact.moment, 0.0, kFarthest);
  check_range("vacuum", contact.vacuum, 0.0, kLargestLoad);
}

void check_frame(const WrenchFrame& frame) {
  check_point("torque_origin", frame.torque_origin);
  check_range("torque_scale", frame.torque_scale, kSmallestTorqueScale, kLargestTorqueScale);
}

void check_contacts(std::span<const Contact> contacts, const WrenchFrame& frame) {
  check_frame(frame);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    try {
      check_contact(contacts[i]);
    } catch (const InputError& error) {
      throw error.under("contacts[" + std::to_string(i) + "]");
    }
  }
}

}  // namespace prehend
