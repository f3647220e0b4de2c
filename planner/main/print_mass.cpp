#include "planner/main/print_mass.h"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include "planner/main/printed_units.h"
#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/scene/object_mass.h"
#include "sim/shape/mass_parts.h"

namespace prehend {
namespace {

std::string place(const Vector3& p_O) {
  // As printed, and without a sign before 0.
  const auto rounded = [&](int k) { return 0.1 * std::round(10.0 * kMillimetres * p_O[k]) + 0.0; };
  return formatted("(%.1f, %.1f, %.1f) mm", rounded(0), rounded(1), rounded(2));
}

void print_components(const TriangleMesh& mesh) {
  // A list of scraps would help nobody.
  constexpr std::size_t kMostShown = 10;
  const std::vector<ComponentVolume> components = component_volumes(mesh);
  if (components.size() < 2 || components.size() > kMostShown) return;
  for (std::size_t i = 0; i < components.size(); ++i) {
    std::printf("  component %zu: %.4f litres about %s\n", i, kLitres * components[i].volume,
                place(components[i].center_O).c_str());
  }
}

std::string where_of(const MassPart& part) {
  struct Words {
    std::string operator()(const MeshComponent& component) const {
      return "component " + std::to_string(component.index);
    }
    std::string operator()(const InsideShape& inside) const {
      return "inside a " + std::string(shape_name(inside.shape.shape));
    }
    std::string operator()(const BeyondPlane& /*plane*/) const { return "beyond a plane"; }
    std::string operator()(const AtPoint& /*point*/) const { return "at a point"; }
  };
  return std::visit(Words{}, part.where);
}

void print_share(const std::string& name, const MassShare& share) {
  std::printf("    %s: %.3f kg about %s", name.c_str(), share.mass, place(share.center_O).c_str());
  if (share.volume > 0.0) {
    std::printf(", %.4f litres of %.0f kg/m^3", kLitres * share.volume, share.mass / share.volume);
  }
  std::printf("\n");
}

void print_shares(const GraspableBody& object) {
  const StatedMass& stated = *object.stated_mass;
  const MassOfParts found = mass_of_parts(object.mesh, stated);
  for (std::size_t i = 0; i < found.parts.size(); ++i) {
    const MassPart& part = stated.parts[i];
    const std::string name = part.name.empty() ? "part " + std::to_string(i) : part.name;
    print_share(on_one_line(name) + " (" + where_of(part) + ")", found.parts[i]);
  }
  if (found.rest) print_share("all else", *found.rest);
  constexpr double kRounding = 1e-9;
  if (std::abs(found.scale - 1.0) > kRounding) {
    std::printf("    all of them times %.4g, for the stated mass\n", found.scale);
  }
}

}  // namespace

void print_mass(const GraspableBody& object) {
  print_components(object.mesh);
  if (object.mass_basis == MassBasis::uniform) return;
  std::printf("  mass %.3f kg, centre of mass %s, from the %s\n", object.mass,
              place(object.center_of_mass).c_str(),
              std::string(mass_basis_text(object.mass_basis)).c_str());
  if (object.stated_mass) print_shares(object);
}

}  // namespace prehend
