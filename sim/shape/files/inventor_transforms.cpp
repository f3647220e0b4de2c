#include "sim/shape/files/inventor_transforms.h"

#include <array>
#include <utility>

#include "sim/shape/files/inventor_tokens.h"

namespace prehend {
namespace {

// "x y z angle" [rad]; the axis need not be unit.
Eigen::AngleAxisd axis_and_angle(const InventorNode& node, const char* field) {
  const std::vector<double> v = node.numbers(field, 4, {0.0, 0.0, 1.0, 0.0});
  const Vector3 axis(v[0], v[1], v[2]);
  if (axis.isZero(0.0)) {
    if (v[3] != 0.0) fail_in_line(node.line, "an axis of length 0", field);
    return {0.0, Vector3::UnitZ()};
  }
  return {v[3], axis.stableNormalized()};
}

// Inventor Mentor, SoTransform: T C R SO S SO^-1 C^-1, column vectors.
InventorMap whole_transform(const InventorNode& node) {
  const Vector3 center = node.vector3("center", Vector3::Zero());
  const Eigen::AngleAxisd scale_turn = axis_and_angle(node, "scaleOrientation");
  const char* scale_name = node.field("scale") ? "scale" : "scaleFactor";
  InventorMap map = InventorMap::Identity();
  map.translate(node.vector3("translation", Vector3::Zero()));
  map.translate(center);
  map.rotate(axis_and_angle(node, "rotation"));
  map.rotate(scale_turn);
  map.scale(node.vector3(scale_name, Vector3::Ones()));
  map.rotate(scale_turn.inverse());
  map.translate(-center);
  return map;
}

Eigen::AngleAxisd about_named_axis(const InventorNode& node) {
  const std::string_view name = node.word("axis", "X");
  const double angle = node.number("angle", 0.0);
  if (name == "X") return {angle, Vector3::UnitX()};
  if (name == "Y") return {angle, Vector3::UnitY()};
  if (name == "Z") return {angle, Vector3::UnitZ()};
  fail_in_line(node.line, "the axis must be X, Y or Z", name);
}

// Sixteen numbers, for row vectors: the translation is in the last row.
InventorMap from_matrix(const InventorNode& node) {
  const std::vector<double> v =
      node.numbers("matrix", 16, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
  if (v[3] != 0.0 || v[7] != 0.0 || v[11] != 0.0 || v[15] != 1.0) {
    fail_in_line(node.line, "the last column of the matrix must be 0 0 0 1");
  }
  InventorMap map = InventorMap::Identity();
  map.linear() << v[0], v[4], v[8], v[1], v[5], v[9], v[2], v[6], v[10];
  map.translation() = Vector3(v[12], v[13], v[14]);
  return map;
}

}  // namespace

std::optional<InventorMap> inventor_transform(const InventorNode& node) {
  InventorMap map = InventorMap::Identity();
  if (node.type == "Transform") return whole_transform(node);
  if (node.type == "MatrixTransform") return from_matrix(node);
  if (node.type == "Translation") {
    return InventorMap(map.translate(node.vector3("translation", Vector3::Zero())));
  }
  if (node.type == "Rotation") return InventorMap(map.rotate(axis_and_angle(node, "rotation")));
  if (node.type == "RotationXYZ") return InventorMap(map.rotate(about_named_axis(node)));
  if (node.type == "Scale") {
    return InventorMap(map.scale(node.vector3("scaleFactor", Vector3::Ones())));
  }
  return std::nullopt;
}

std::optional<double> inventor_units(const InventorNode& node) {
  if (node.type != "Units") return std::nullopt;
  constexpr std::array<std::pair<std::string_view, double>, 14> kUnits{
      {{"METERS", 1.0},
       {"CENTIMETERS", 1e-2},
       {"MILLIMETERS", 1e-3},
       {"MICROMETERS", 1e-6},
       {"MICRONS", 1e-6},
       {"NANOMETERS", 1e-9},
       {"ANGSTROMS", 1e-10},
       {"KILOMETERS", 1e3},
       {"FEET", 0.3048},
       {"INCHES", 0.0254},
       {"POINTS", 0.0254 / 72.0},
       {"YARDS", 0.9144},
       {"MILES", 1609.344},
       {"NAUTICAL_MILES", 1852.0}}};
  const std::string_view name = node.word("units", "METERS");
  for (const auto& [unit, metres] : kUnits) {
    if (unit == name) return metres;
  }
  fail_in_line(node.line, "no unit is called so", name);
}

}  // namespace prehend
