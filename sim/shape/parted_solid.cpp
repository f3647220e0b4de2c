#include "sim/shape/parted_solid.h"

#include <cstddef>
#include <variant>

#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/shape/moments_inside.h"

namespace prehend {
namespace {

std::string numbers(const Vector3& v) {
  return formatted("[%.6g, %.6g, %.6g]", v.x(), v.y(), v.z());
}

}  // namespace

void refuse(const std::string& field, const std::string& problem, const std::string& value) {
  throw InputError({.field = field, .problem = problem, .value = value});
}

PartedSolid::PartedSolid(const MassSolid& solid) : solid_(solid) {
  if (solid.has_components()) components_ = solid_components(solid);
}

Moments PartedSolid::moments(const MassPart& part, const std::string& field) const {
  if (!solid_.is_solid()) refuse(field, "the mesh encloses nothing that could have parts");
  if (const auto* component = std::get_if<MeshComponent>(&part.where)) {
    return component_at(*component, field).moments;
  }
  const Moments inside = moments_inside(solid_.surface, region(part, field));
  if (inside.zeroth > kNoVolume * solid_.moments.zeroth) return inside;
  const std::string problem = "must meet the object";
  if (const auto* shape = std::get_if<InsideShape>(&part.where)) {
    refuse(field + ".inside", problem,
           std::string(shape_name(shape->shape.shape)) + " about " +
               numbers(shape->shape.X_OP.translation()));
  }
  const auto& beyond = std::get<BeyondPlane>(part.where);
  refuse(field + ".beyond", problem,
         "from " + numbers(beyond.point_O) + " towards " + numbers(beyond.normal_O));
}

double PartedSolid::common_volume(const MassPart& a, const MassPart& b,
                                  const std::string& field) const {
  const auto* component_a = std::get_if<MeshComponent>(&a.where);
  const auto* component_b = std::get_if<MeshComponent>(&b.where);
  if (component_a != nullptr && component_b != nullptr) {
    return component_a->index == component_b->index ? solid_.moments.zeroth : 0.0;
  }
  if (component_a != nullptr) {
    return moments_inside(component_at(*component_a, field).surface, region(b, field)).zeroth;
  }
  if (component_b != nullptr) return common_volume(b, a, field);
  ConvexRegion both = region(a, field);
  const ConvexRegion other = region(b, field);
  both.insert(both.end(), other.begin(), other.end());
  return moments_inside(solid_.surface, both).zeroth;
}

const SolidComponent& PartedSolid::component_at(const MeshComponent& component,
                                                const std::string& field) const {
  const std::string name = field + ".component";
  const std::string value = std::to_string(component.index);
  if (!solid_.has_components()) {
    refuse(name, "the mesh is not closed, so that its components have no volume", value);
  }
  const auto count = static_cast<int>(components_.size());
  if (component.index < 0 || component.index >= count) {
    refuse(
        name,
        count == 1 ? "the mesh has only one, 0" : "must be from 0 to " + std::to_string(count - 1),
        value);
  }
  const SolidComponent& found = components_[static_cast<std::size_t>(component.index)];
  if (!(found.moments.zeroth > 0.0)) refuse(name, "encloses nothing", value);
  return found;
}

// At the scale of the solid.
ConvexRegion PartedSolid::region(const MassPart& part, const std::string& field) const {
  ConvexRegion region;
  if (const auto* inside = std::get_if<InsideShape>(&part.where)) {
    try {
      region = region_of(inside->shape);
    } catch (const InputError& error) {
      throw error.under(field + ".inside");
    }
  } else {
    const auto& beyond = std::get<BeyondPlane>(part.where);
    region = {{-beyond.normal_O, -beyond.normal_O.dot(beyond.point_O)}};
  }
  for (HalfSpace& half : region) {
    half.offset = (half.offset - half.normal.dot(solid_.center)) / solid_.size;
  }
  return region;
}

}  // namespace prehend
