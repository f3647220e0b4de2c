#include "sim/robot/files/graspit_body.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "sim/base/input_file.h"
#include "sim/base/range.h"
#include "sim/base/xml/xml_file.h"
#include "sim/robot/files/graspit_notes.h"
#include "sim/robot/files/graspit_transform.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/mesh_checks.h"
#include "sim/shape/weld.h"

namespace prehend {
namespace {

constexpr double kGram = 1e-3;              // kg
constexpr double kLargestBodyMass = 1e9;    // kg
constexpr double kSquareMillimetre = 1e-6;  // m^2

// What GraspIt! takes for a body that names none.
constexpr Material kGraspitMaterial = Material::wood;

Material material_of(const XmlElement& element, std::vector<std::string>& notes) {
  const std::string name = element.content();
  for (const Material material : kAll<Material>) {
    if (name_of(material) == name) return material;
  }
  const bool slippery = name == "frictionless";
  const Material nearest = slippery ? Material::metal : kGraspitMaterial;
  const std::string why = slippery ? ", which holds less than others but is not without friction"
                          : name == "stone" ? ", whose friction is at most 0.5 lower"
                                            : "";
  notes.push_back(note_of(element, "there is no material " + in_note(name) + " here: taken as " +
                                       std::string(name_of(nearest)) + why));
  return nearest;
}

std::optional<Matrix3> read_unit_inertia(const XmlElement& element,
                                         std::vector<std::string>& notes) {
  const std::vector<double> v = element.content_numbers();
  if (v.size() != 9) element.fail("must be nine numbers", element.content());
  const Matrix3 given = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(v.data());
  const Matrix3 symmetric = 0.5 * (given + given.transpose());
  if (!given.isApprox(given.transpose(), 1e-9)) {
    notes.push_back(note_of(element, "not symmetric: the mean of the two halves is taken"));
  }
  const std::string defect = inertia_defect(symmetric);
  if (!defect.empty()) {
    notes.push_back(note_of(element, defect + ": that of the mesh is taken instead"));
    return std::nullopt;
  }
  return kSquareMillimetre * symmetric;
}

// One factor for all axes, or one for each.
Vector3 read_scaling(const XmlElement& element) {
  const std::vector<double> v = element.content_numbers();
  if (v.size() != 1 && v.size() != 3)
    element.fail("must be one or three numbers", element.content());
  const Vector3 scaling = v.size() == 1 ? Vector3::Constant(v[0]) : Vector3(v[0], v[1], v[2]);
  if (!(scaling.minCoeff() > 1e-9 && scaling.maxCoeff() < 1e9)) {
    element.fail("must be positive", element.content());
  }
  return scaling;
}

// The name of the unit that is `millimetres` long; empty: there is none.
std::string unit_of(double millimetres) {
  for (const char* unit : {"mm", "cm", "m", "in"}) {
    if (metres_per_unit(unit) == millimetres * kGraspitLength) return unit;
  }
  return {};
}

// The mesh file, beside the body's. Where it is missing, files were perhaps renamed together: then
// the mesh file of the body's own name is meant.
std::filesystem::path mesh_file_of(const XmlElement& geometry, std::vector<std::string>& notes) {
  if (geometry.content().empty()) geometry.fail("names no file");
  const std::filesystem::path file = geometry.file().parent_path() / geometry.content();
  std::filesystem::path namesake = geometry.file();
  namesake.replace_extension(file.extension());
  if (is_there(file) || !is_file(namesake) || namesake == geometry.file()) return file;
  notes.push_back(note_of(geometry, "there is no " + in_note(geometry.content()) + ": " +
                                        in_note(namesake.filename().string()) +
                                        " is read instead, which has the name of this file"));
  return namesake;
}

void read_mesh(const XmlElement& root, GraspitBody& body) {
  const XmlElement geometry = root["geometryFile"];
  const std::filesystem::path file = mesh_file_of(geometry, body.notes);
  const auto scaled = root.child("geometryScaling");
  const auto moved = root.child("geometryOffset");
  const Vector3 scaling = scaled ? read_scaling(*scaled) : Vector3::Ones();
  const Vector3 offset = moved ? graspit_vector(*moved, kGraspitLength) : Vector3::Zero();
  const bool even = (scaling.array() == scaling.x()).all();
  body.mesh = with_field_errors(geometry, [&] {
    return load_mesh(file, {.metres_per_unit = kGraspitLength * (even ? scaling.x() : 1.0)}).mesh;
  });
  for (Vector3& p : body.mesh.vertices) {
    if (!even) p = scaling.cwiseProduct(p);
    p += offset;
    if (!(p.cwiseAbs().maxCoeff() <= kFarthest)) geometry.fail("reaches beyond 1e6 m");
  }
  orient_outward(body.mesh);
  if (even && offset.isZero(0.0)) body.unit = unit_of(scaling.x());
  if (!body.unit.empty()) {
    body.mesh_file = std::filesystem::absolute(file).lexically_normal();
  }
}

}  // namespace

GraspitBody load_graspit_body(const std::filesystem::path& file) {
  return read_graspit_body(XmlFile(file));
}

GraspitBody read_graspit_body(const XmlFile& file) {
  const XmlElement root = file.root();
  if (root.name() != "root") root.fail("not a GraspIt! body, whose outermost element is <root>");
  GraspitBody body;
  body.name = file.path().stem().string();
  constexpr std::array<std::string_view, 10> kKnown{"material",
                                                    "mass",
                                                    "cog",
                                                    "inertia_matrix",
                                                    "geometryFile",
                                                    "geometryScaling",
                                                    "geometryOffset",
                                                    "useFlockOfBirds",
                                                    "primitive_data_path",
                                                    "bounding_volume"};
  note_unknown(root, kKnown, body.notes);
  if (const auto material = root.child("material")) {
    body.material = material_of(*material, body.notes);
  } else {
    body.notes.push_back(note_of(root, "no material, taken as wood as GraspIt! does"));
  }
  if (const auto mass = root.child("mass")) {
    body.mass = kGram * mass->content_number();
    if (!(body.mass > 0.0 && body.mass <= kLargestBodyMass)) {
      mass->fail("must be positive, at most 1e12 g", mass->content());
    }
  }
  if (const auto center = root.child("cog")) {
    body.center_of_mass = graspit_vector(*center, kGraspitLength);
    if (!(body.center_of_mass->cwiseAbs().maxCoeff() <= kFarthest)) {
      center->fail("must be within 1e9 mm of 0", center->content());
    }
  }
  if (const auto inertia = root.child("inertia_matrix")) {
    body.unit_inertia = read_unit_inertia(*inertia, body.notes);
  }
  read_mesh(root, body);
  return body;
}

Inertial inertial_of(const GraspitBody& body) {
  if (!(body.mass > 0.0)) return {};
  Inertial inertial = inertial_of_mass(body.mesh, body.mass);
  if (body.center_of_mass) inertial.center_of_mass = *body.center_of_mass;
  if (body.unit_inertia) inertial.inertia = body.mass * *body.unit_inertia;
  return inertial;
}

}  // namespace prehend
