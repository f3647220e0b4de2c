#include "sim/shape/mass_parts.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include <Eigen/Eigenvalues>

#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/range.h"
#include "sim/shape/parted_solid.h"

// All is computed in the frame and at the scale of MassSolid, where the diagonal of the mesh is 1.
namespace prehend {
namespace {

// The part of the solid's volume up to which an overlap is taken for none.
constexpr double kTouching = 1e-6;

std::string part_field(std::size_t i) { return "parts[" + std::to_string(i) + "]"; }

std::string number(double value) { return formatted("%.6g", value); }

void check_density(const std::string& field, double density) {
  if (!(density >= 0.0)) refuse(field, "must be at least 0", number(density));
  if (!(density <= kDensity.upper)) refuse(field, "must be at most 1e6 kg/m^3", number(density));
}

void check_mass(const std::string& field, double mass) {
  if (!(mass > 0.0 && std::isfinite(mass))) refuse(field, "must be positive", number(mass));
}

void check_values(const StatedMass& stated) {
  if (stated.mass) check_mass("mass", *stated.mass);
  if (stated.density) check_density("density", *stated.density);
  if (stated.parts.size() > static_cast<std::size_t>(kMostMassParts)) {
    refuse("parts", "must be at most " + std::to_string(kMostMassParts),
           std::to_string(stated.parts.size()));
  }
  for (std::size_t i = 0; i < stated.parts.size(); ++i) {
    const MassPart& part = stated.parts[i];
    const bool at_point = std::holds_alternative<AtPoint>(part.where);
    if (at_point && !part.mass) refuse(part_field(i), "a part at a point needs mass");
    if (part.mass.has_value() == part.density.has_value()) {
      refuse(part_field(i), "needs exactly one of density, mass");
    }
    if (part.density) check_density(part_field(i) + ".density", *part.density);
    if (part.mass) check_mass(part_field(i) + ".mass", *part.mass);
  }
}

// The moments of a point of mass 1. Far outside the object, which is of size 1, nothing could hold
// it, and it would leave no digits to the moments of the rest.
Moments point_moments(const MassSolid& solid, const Vector3& p_O, const std::string& field) {
  const Vector3 p = solid.to_unit(p_O);
  if (!(p.norm() <= 1.0)) {
    refuse(field + ".at", "must be at most the object's diagonal from its middle",
           formatted("[%.6g, %.6g, %.6g]", p_O.x(), p_O.y(), p_O.z()));
  }
  return {1.0, p, p * p.transpose()};
}

// A part with its integrals at unit size; the mass [kg] per unit of its zeroth moment.
struct WeighedPart {
  Moments moments;
  double weight = 0.0;
  bool has_volume = true;

  double mass() const { return weight * moments.zeroth; }
};

std::vector<WeighedPart> weigh_parts(const MassSolid& solid, const StatedMass& stated) {
  const PartedSolid parted(solid);
  const double cube = solid.size * solid.size * solid.size;
  std::vector<WeighedPart> weighed;
  for (std::size_t i = 0; i < stated.parts.size(); ++i) {
    const MassPart& part = stated.parts[i];
    if (const auto* at = std::get_if<AtPoint>(&part.where)) {
      weighed.push_back({point_moments(solid, at->p_O, part_field(i)), *part.mass, false});
      continue;
    }
    const Moments moments = parted.moments(part, part_field(i));
    for (std::size_t j = 0; j < i; ++j) {
      if (!weighed[j].has_volume) continue;
      const double common = parted.common_volume(stated.parts[j], part, part_field(i));
      if (common > kTouching * solid.moments.zeroth) {
        refuse(part_field(i), "must not overlap " + part_field(j),
               formatted("by %.3g %% of the object", 100.0 * common / solid.moments.zeroth));
      }
    }
    const double weight = part.density ? *part.density * cube : *part.mass / moments.zeroth;
    weighed.push_back({moments, weight, true});
  }
  return weighed;
}

// What no part covers, without its weight. Of a mesh without volume it is the surface.
std::optional<WeighedPart> rest_of(const MassSolid& solid, const std::vector<WeighedPart>& parts) {
  WeighedPart rest{solid.moments, 0.0, solid.is_solid()};
  bool covered = false;
  for (const WeighedPart& part : parts) {
    if (!part.has_volume) continue;
    rest.moments.add(-1.0, part.moments);
    covered = true;
  }
  if (covered && !(rest.moments.zeroth > kNoVolume * solid.moments.zeroth)) return std::nullopt;
  return rest;
}

// Sets the weight of the rest, and returns what all masses are to be multiplied with.
double weigh_rest(const MassSolid& solid, const StatedMass& stated, double of_parts,
                  std::optional<WeighedPart>& rest) {
  if (rest && stated.density) {
    if (!rest->has_volume) refuse("density", "the mesh encloses nothing", number(*stated.density));
    rest->weight = *stated.density * solid.size * solid.size * solid.size;
  } else if (rest && stated.mass) {
    const double left = *stated.mass - of_parts;
    if (!(left > 0.0)) {
      refuse("mass", "must be more than what the parts weigh, " + number(of_parts) + " kg",
             number(*stated.mass));
    }
    rest->weight = left / rest->moments.zeroth;
    return 1.0;
  } else if (rest) {
    refuse("mass", "needed, or density of what no part covers");
  }
  const double all = of_parts + (rest ? rest->mass() : 0.0);
  if (!(all > 0.0)) refuse("density", "nothing of the object weighs anything");
  return stated.mass ? *stated.mass / all : 1.0;
}

MassShare share_of(const MassSolid& solid, const std::string& name, const WeighedPart& part,
                   double scale) {
  const double cube = solid.size * solid.size * solid.size;
  return {name, part.has_volume ? part.moments.zeroth * cube : 0.0, scale * part.mass(),
          solid.from_unit(part.moments.center())};
}

void need_spread(const Moments& mass) {
  // Rounding of points on a line leaves less.
  constexpr double kThinnest = 1e-12;
  const Vector3 spread = Eigen::SelfAdjointEigenSolver<Matrix3>(mass.spread()).eigenvalues();
  if (!(spread[1] > kThinnest))
    refuse("parts", "the mass must not be all in one point or along a line");
}

}  // namespace

MassOfParts mass_of_parts(const TriangleMesh& mesh, const StatedMass& stated) {
  check_values(stated);
  const MassSolid solid = mass_solid(mesh);
  const std::vector<WeighedPart> parts = weigh_parts(solid, stated);
  std::optional<WeighedPart> rest = rest_of(solid, parts);
  Moments mass;
  for (const WeighedPart& part : parts) mass.add(part.weight, part.moments);
  MassOfParts result;
  result.source = solid.source;
  result.scale = weigh_rest(solid, stated, mass.zeroth, rest);
  if (rest) mass.add(rest->weight, rest->moments);
  need_spread(mass);
  result.mass = stated.mass.value_or(mass.zeroth);
  result.center_of_mass = solid.from_unit(mass.center());
  result.inertia = result.mass * solid.size * solid.size * mass.unit_inertia();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    result.parts.push_back(share_of(solid, stated.parts[i].name, parts[i], result.scale));
  }
  if (rest) result.rest = share_of(solid, "rest", *rest, result.scale);
  return result;
}

std::vector<ComponentVolume> component_volumes(const TriangleMesh& mesh) {
  const MassSolid solid = mass_solid(mesh);
  if (!solid.has_components()) return {};
  std::vector<ComponentVolume> volumes;
  for (const SolidComponent& component : solid_components(solid)) {
    volumes.push_back({component.moments.zeroth * solid.size * solid.size * solid.size,
                       solid.from_unit(component.moments.center())});
  }
  return volumes;
}

}  // namespace prehend
