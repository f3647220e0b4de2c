#include "sim/robot/files/robot_geometry.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "sim/base/range.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/convex_hull.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/loft.h"
#include "sim/shape/polygon.h"
#include "sim/shape/weld.h"

namespace prehend {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr int kCylinderSides = 24;
constexpr int kMostCylinderSides = 360;
constexpr int kCapsuleSides = 12;
constexpr int kSphereSubdivisions = 2;
constexpr int kMostSphereSubdivisions = 5;
constexpr std::size_t kMostHullPoints = 10'000;  // takes a tenth of a second
// How far the products of the rows of a rotation may be from 0 and 1.
constexpr double kRotationRounding = 1e-9;

double positive(const JsonField& field, double unit) { return field.number(kLengthAbove0, unit); }

int integer_or(const JsonField& object, std::string_view key, int otherwise, int low, int high) {
  if (!object.has(key)) return otherwise;
  const JsonField field = object[key];
  const int value = field.integer();
  if (value < low || value > high) {
    field.fail("must be " + std::to_string(low) + " to " + std::to_string(high));
  }
  return value;
}

double angle_unit(const JsonField& field, const std::string& suffix) {
  if (field.text() == "rad" + suffix) return 1.0;
  if (field.text() == "deg" + suffix) return kDegree;
  field.fail("unknown unit, known are rad" + suffix + " and deg" + suffix);
}

double mass_unit(const JsonField& field) {
  if (field.text() == "kg") return 1.0;
  if (field.text() == "g") return 1e-3;
  field.fail("unknown unit, known are kg and g");
}

TriangleMesh box(const JsonField& shape, const FileUnits& units) {
  shape.allow_only({"shape", "size", "pose"});
  const JsonField size = shape["size"];
  const Vector3 metres = size.vector3(kLengthAbove0, units.length);
  return with_field_errors(size, [&] { return make_box(metres); });
}

TriangleMesh cylinder(const JsonField& shape, const FileUnits& units) {
  shape.allow_only({"shape", "radius", "height", "sides", "pose"});
  const double radius = positive(shape["radius"], units.length);
  const double height = positive(shape["height"], units.length);
  const int sides = integer_or(shape, "sides", kCylinderSides, 3, kMostCylinderSides);
  return with_field_errors(shape, [&] { return make_cylinder(radius, height, sides); });
}

TriangleMesh capsule(const JsonField& shape, const FileUnits& units) {
  shape.allow_only({"shape", "radius", "from", "to", "sides", "pose"});
  const double radius = positive(shape["radius"], units.length);
  const Vector3 from = shape["from"].vector3(kCoordinate, units.length);
  const Vector3 to = shape["to"].vector3(kCoordinate, units.length);
  const int sides = integer_or(shape, "sides", kCapsuleSides, 4, kMostCylinderSides);
  return with_field_errors(shape["radius"], [&] { return make_capsule(from, to, radius, sides); });
}

TriangleMesh sphere(const JsonField& shape, const FileUnits& units) {
  shape.allow_only({"shape", "radius", "subdivisions", "pose"});
  const double radius = positive(shape["radius"], units.length);
  const int subdivisions =
      integer_or(shape, "subdivisions", kSphereSubdivisions, 0, kMostSphereSubdivisions);
  return with_field_errors(shape["radius"], [&] { return make_sphere(radius, subdivisions); });
}

// Turns x, y, z into the axes of the named plane and its normal.
Pose plane_pose(const JsonField& shape) {
  const std::string plane = shape.text_or("plane", "xy");
  Matrix3 axes = Matrix3::Identity();
  if (plane == "yz") {
    axes << Vector3::UnitY(), Vector3::UnitZ(), Vector3::UnitX();
  } else if (plane == "zx") {
    axes << Vector3::UnitZ(), Vector3::UnitX(), Vector3::UnitY();
  } else if (plane != "xy") {
    shape["plane"].fail("unknown plane, known are xy, yz and zx");
  }
  return pose_from(axes, Vector3::Zero());
}

std::vector<Eigen::Vector2d> profile_corners(const JsonField& profile, const FileUnits& units) {
  std::vector<Eigen::Vector2d> corners;
  for (const JsonField& corner : profile.items()) {
    const std::vector<double> uv = corner.numbers(2);
    corners.push_back(Eigen::Vector2d(uv[0], uv[1]) * units.length);
  }
  return corners;
}

TriangleMesh prism(const JsonField& shape, const FileUnits& units) {
  shape.allow_only({"shape", "plane", "profile", "sweep", "pose"});
  const JsonField profile = shape["profile"];
  std::vector<Eigen::Vector2d> corners = profile_corners(profile, units);
  // Either sense is fine in a file.
  if (corners.size() >= 3 && doubled_area(corners) < 0.0) {
    std::reverse(corners.begin(), corners.end());
  }
  const JsonField sweep = shape["sweep"];
  const std::vector<double> range = sweep.numbers(2);
  if (range[0] >= range[1]) sweep.fail("must be two numbers, the lower one first");
  const TriangleMesh mesh = with_field_errors(profile, [&] {
    return make_prism(corners, range[0] * units.length, range[1] * units.length);
  });
  return transformed(mesh, plane_pose(shape));
}

// Either sense is fine, but the same for all sections: corners are joined in their order.
TriangleMesh loft(const JsonField& shape, const FileUnits& units) {
  shape.allow_only({"shape", "plane", "sections", "pose"});
  const JsonField list = shape["sections"];
  std::vector<LoftSection> sections;
  double sense = 0.0;
  for (const JsonField& item : list.items()) {
    item.allow_only({"at", "profile"});
    const JsonField profile = item["profile"];
    std::vector<Eigen::Vector2d> corners = profile_corners(profile, units);
    const double area = doubled_area(corners);
    if (sense * area < 0.0) profile.fail("runs the other way round than the first section");
    if (sense == 0.0) sense = area;
    if (sense < 0.0) std::reverse(corners.begin(), corners.end());
    sections.push_back(
        {.at = item["at"].number(kCoordinate, units.length), .corners = std::move(corners)});
  }
  const TriangleMesh mesh = with_field_errors(list, [&] { return make_loft(sections); });
  return transformed(mesh, plane_pose(shape));
}

TriangleMesh hull(const JsonField& shape, const FileUnits& units) {
  shape.allow_only({"shape", "points", "pose"});
  const JsonField list = shape["points"];
  std::vector<Vector3> points;
  for (const JsonField& point : list.items()) {
    points.push_back(point.vector3(kCoordinate, units.length));
    if (points.size() > kMostHullPoints) {
      list.fail("must be at most " + std::to_string(kMostHullPoints) + " points");
    }
  }
  TriangleMesh mesh = convex_hull(points);
  if (mesh.empty()) list.fail("must be at least four points that are not in one plane");
  return mesh;
}

TriangleMesh triangles(const JsonField& shape, const FileUnits& units) {
  shape.allow_only({"shape", "vertices", "triangles", "pose"});
  TriangleMesh mesh;
  for (const JsonField& vertex : shape["vertices"].items()) {
    mesh.vertices.push_back(vertex.vector3(kCoordinate, units.length));
  }
  const int count = static_cast<int>(mesh.vertices.size());
  for (const JsonField& triangle : shape["triangles"].items()) {
    Triangle corners{};
    const std::vector<JsonField> indices = triangle.items();
    if (indices.size() != corners.size()) triangle.fail("must be three numbers of vertices");
    for (std::size_t k = 0; k < corners.size(); ++k) {
      corners[k] = indices[k].integer();
      if (corners[k] < 0 || corners[k] >= count) indices[k].fail("no vertex of this number");
    }
    mesh.triangles.push_back(corners);
  }
  return mesh;
}

TriangleMesh mesh_from_file(const JsonField& part, const FileUnits& units) {
  part.allow_only({"mesh", "unit", "pose"});
  const JsonField name = part["mesh"];
  MeshFileOptions options{.metres_per_unit = units.length};
  if (part.has("unit")) {
    const JsonField unit = part["unit"];
    options.metres_per_unit = with_field_errors(unit, [&] { return metres_per_unit(unit.text()); });
  }
  const std::filesystem::path path = part.file().parent_path() / name.text();
  return with_field_errors(name, [&] { return load_mesh(path, options).mesh; });
}

TriangleMesh read_part(const JsonField& part, const FileUnits& units) {
  if (part.has("mesh")) return mesh_from_file(part, units);
  const JsonField shape = part["shape"];
  const std::string name = shape.text();
  if (name == "box") return box(part, units);
  if (name == "cylinder") return cylinder(part, units);
  if (name == "sphere") return sphere(part, units);
  if (name == "capsule") return capsule(part, units);
  if (name == "prism") return prism(part, units);
  if (name == "loft") return loft(part, units);
  if (name == "hull") return hull(part, units);
  if (name == "triangles") return triangles(part, units);
  shape.fail(
      "unknown shape, known are box, cylinder, sphere, capsule, prism, loft, hull and triangles");
}

// Nine numbers in three rows, taken as they are.
Matrix3 read_rotation(const JsonField& field) {
  const std::vector<JsonField> rows = field.items();
  Matrix3 rotation;
  if (rows.size() != 3) field.fail("must be three rows of three numbers");
  for (Eigen::Index row = 0; row < 3; ++row) {
    rotation.row(row) = rows[static_cast<std::size_t>(row)].vector3().transpose();
  }
  const double off = (rotation * rotation.transpose() - Matrix3::Identity()).cwiseAbs().maxCoeff();
  if (!(off < kRotationRounding && rotation.determinant() > 0.0)) {
    field.fail("is no rotation: its rows must be right-handed, unit and orthogonal");
  }
  return rotation;
}

}  // namespace

FileUnits read_units(const JsonField& root) {
  FileUnits units;
  if (!root.has("units")) return units;
  const JsonField field = root["units"];
  field.allow_only({"length", "angle", "angular_velocity", "mass"});
  if (field.has("length")) {
    const JsonField length = field["length"];
    units.length = with_field_errors(length, [&] { return metres_per_unit(length.text()); });
  }
  if (field.has("angle")) units.angle = angle_unit(field["angle"], "");
  if (field.has("mass")) units.mass = mass_unit(field["mass"]);
  units.angular_velocity =
      field.has("angular_velocity") ? angle_unit(field["angular_velocity"], "/s") : units.angle;
  return units;
}

Pose read_pose(const JsonField& steps, const FileUnits& units) {
  Pose pose = Pose::Identity();
  for (const JsonField& step : steps.items()) {
    step.allow_only({"translate", "rotate_x", "rotate_y", "rotate_z", "rotation"});
    const std::vector<std::string> keys = step.keys();
    if (keys.size() != 1) step.fail("must be one translation or one rotation");
    const JsonField amount = step[keys.front()];
    if (keys.front() == "translate") {
      pose = pose * translation(amount.vector3(kCoordinate, units.length));
      continue;
    }
    if (keys.front() == "rotation") {
      pose = pose * pose_from(read_rotation(amount), Vector3::Zero());
      continue;
    }
    const Eigen::Index axis = keys.front().back() - 'x';
    pose = pose * Eigen::AngleAxisd(amount.number(kCoordinate, units.angle), Vector3::Unit(axis));
  }
  return pose;
}

void ShapeBudget::spend_on_shape(const JsonField& field, std::size_t triangles) {
  constexpr std::size_t kFree = 12;  // a box
  made_ += triangles;
  spend(field, triangles - std::min(triangles, kFree));
}

void ShapeBudget::spend(const JsonField& field, std::size_t triangles) {
  constexpr std::size_t kMost = 50'000;
  spent_ += triangles;
  if (spent_ > kMost) {
    field.fail("the shapes of the file must have at most " + std::to_string(kMost) + " triangles");
  }
}

TriangleMesh read_geometry(const JsonField& field, const FileUnits& units,
                           const NamedGeometry& named, ShapeBudget& budget) {
  if (field.is_text()) {
    const auto found = named.find(field.text());
    if (found == named.end()) field.fail("no geometry of this name in \"geometries\"");
    budget.spend(field, found->second.of_shapes);
    return found->second.mesh;
  }
  TriangleMesh mesh;
  for (const JsonField& part : field.items()) {
    TriangleMesh piece = read_part(part, units);
    if (!part.has("mesh") && !part.has("triangles")) {
      budget.spend_on_shape(part, piece.triangles.size());
    }
    if (part.has("pose")) piece = transformed(piece, read_pose(part["pose"], units));
    append(mesh, piece);
  }
  if (mesh.empty()) field.fail("a link needs at least one triangle");
  for (const Vector3& p : mesh.vertices) {
    if (!(p.cwiseAbs().maxCoeff() <= kFarthest)) field.fail("reaches beyond 1e6 m");
  }
  return mesh;
}

}  // namespace prehend
