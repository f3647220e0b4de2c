#include "sim/base/material.h"
#include "sim/base/range.h"
#include "sim/robot/files/robot_file_parts.h"

namespace prehend {
namespace {

constexpr const char* kFromMesh = "mesh";
constexpr const char* kUnknown = "unknown";

// Density of the link [kg/m^3]: its own, or its material's.
double read_density(const JsonField& field) {
  if (field.has("density")) return field["density"].number(kDensity);
  const JsonField material = field["material"];
  return with_field_errors(material, [&] { return density_of(material_named(material.text())); });
}

// Nine numbers in three rows, or ixx, iyy, izz, ixy, ixz, iyz; about the centre of mass.
Matrix3 read_inertia(const JsonField& field, double unit) {
  Matrix3 inertia;
  const std::vector<JsonField> items = field.items();
  if (items.size() == 3) {
    for (Eigen::Index row = 0; row < 3; ++row) {
      inertia.row(row) = items[static_cast<std::size_t>(row)].vector3().transpose();
    }
  } else if (items.size() == 6) {
    const std::vector<double> i = field.numbers(6);
    inertia << i[0], i[3], i[4],  //
        i[3], i[1], i[5],         //
        i[4], i[5], i[2];
  } else {
    field.fail("must be three rows of three numbers, or six numbers");
  }
  const std::string defect = inertia_defect(inertia);
  if (!defect.empty()) field.fail(defect);
  return unit * 0.5 * (inertia + inertia.transpose());
}

Inertial from_mesh(const JsonField& field, const TriangleMesh& mesh) {
  const double density = read_density(field);
  const Inertial inertial =
      with_field_errors(field["geometry"], [&] { return inertial_of_density(mesh, density); });
  const bool asked = field.has("mass") || field.has("density");
  if (asked && !(inertial.mass > 0.0)) {
    field["geometry"].fail("flat, it has no mass that could be found from the mesh");
  }
  return inertial;
}

Inertial stated(const JsonField& field, const FileUnits& units, const TriangleMesh& mesh) {
  const JsonField mass = field["mass"];
  if (field.has("density")) field["density"].fail("a link has a mass or a density, not both");
  const double kilograms = mass.number(kMass, units.mass);
  Inertial inertial =
      with_field_errors(field["geometry"], [&] { return inertial_of_mass(mesh, kilograms); });
  if (field.has("center_of_mass")) {
    inertial.center_of_mass = field["center_of_mass"].vector3(kCoordinate, units.length);
  }
  if (field.has("inertia")) {
    if (!field.has("center_of_mass")) field["inertia"].fail("needs \"center_of_mass\" with it");
    inertial.inertia = read_inertia(field["inertia"], units.mass * units.length * units.length);
  }
  return inertial;
}

Inertial read_inertial(const JsonField& field, const FileUnits& units, const TriangleMesh& mesh) {
  const bool is_stated = field.has("mass") && !field["mass"].is_text();
  if (is_stated) return stated(field, units, mesh);
  const std::string source = field.text_or("mass", kFromMesh);
  if (source != kFromMesh && source != kUnknown) {
    field["mass"].fail(R"(must be a number, "mesh" or "unknown")");
  }
  for (const char* key : {"center_of_mass", "inertia"}) {
    if (field.has(key)) field[key].fail("needs \"mass\" as a number with it");
  }
  if (source == kUnknown) {
    if (field.has("density")) field["density"].fail("not beside an unknown mass");
    return {};
  }
  return from_mesh(field, mesh);
}

PadShape read_pad(const JsonField& field, const FileUnits& units) {
  field.allow_only({"outward", "thickness", "youngs_modulus", "poissons_ratio"});
  PadShape pad;
  pad.outward_L = field["outward"].direction();
  pad.thickness = field["thickness"].number(kLengthAbove0, units.length);
  pad.material.youngs_modulus = field["youngs_modulus"].number(kYoungsModulus);
  pad.material.poissons_ratio = field["poissons_ratio"].number(kPoissonsRatio);
  return pad;
}

}  // namespace

Link read_link(const JsonField& field, const FileUnits& units, const NamedGeometry& named,
               ShapeBudget& budget, int joint) {
  Link link{.name = field["name"].text(),
            .material = field["material"].text(),
            .joint = joint,
            .mesh = read_geometry(field["geometry"], units, named, budget)};
  link.inertial = read_inertial(field, units, link.mesh);
  link.driver_name = field.text_or("driver_name", "");
  if (field.has("pad")) link.pad = read_pad(field["pad"], units);
  return link;
}

}  // namespace prehend
