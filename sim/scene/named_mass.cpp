#include "sim/scene/named_mass.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <utility>

#include "sim/base/formatted.h"
#include "sim/scene/object_mass.h"
#include "sim/shape/mass_parts.h"
#include "sim/shape/solid_components.h"

namespace prehend {
namespace {

constexpr std::array kMaterials = std::to_array<NamedMaterial>({
    {"steel", 7850.0},       {"iron", 7870.0},         {"brass", 8500.0},
    {"bronze", 8800.0},      {"copper", 8960.0},       {"lead", 11340.0},
    {"zinc", 7130.0},        {"tin", 7290.0},          {"titanium", 4510.0},
    {"tungsten", 19300.0},   {"silver", 10490.0},      {"gold", 19300.0},
    {"aluminium", 2700.0},   {"aluminum", 2700.0},     {"magnesium", 1740.0},
    {"metal", 7850.0},       {"glass", 2500.0},        {"ceramic", 2400.0},
    {"porcelain", 2400.0},   {"stone", 2600.0},        {"marble", 2700.0},
    {"granite", 2700.0},     {"concrete", 2300.0},     {"clay", 2000.0},
    {"wood", 700.0},         {"oak", 740.0},           {"beech", 720.0},
    {"ash", 700.0},          {"pine", 500.0},          {"hickory", 800.0},
    {"bamboo", 400.0},       {"cork", 240.0},          {"rubber", 1150.0},
    {"leather", 900.0},      {"paper", 900.0},         {"cardboard", 700.0},
    {"plastic", 1100.0},     {"nylon", 1140.0},        {"abs", 1050.0},
    {"pvc", 1400.0},         {"acrylic", 1190.0},      {"polycarbonate", 1200.0},
    {"polyethylene", 950.0}, {"polypropylene", 910.0}, {"foam", 40.0},
});

// Words of letters in lower case; a capital after a small letter begins another.
std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words(1);
  bool small = false;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool letter = std::isalpha(byte) != 0;
    if (!letter || (small && std::isupper(byte) != 0)) words.emplace_back();
    small = letter && std::islower(byte) != 0;
    if (letter) words.back() += static_cast<char>(std::tolower(byte));
  }
  return words;
}

bool contains(const Bounds& outer, const Bounds& inner, double margin) {
  return (inner.lower.array() >= outer.lower.array() - margin).all() &&
         (inner.upper.array() <= outer.upper.array() + margin).all();
}

const MeshPart* smallest_around(const Bounds& piece, const std::vector<MeshPart>& parts,
                                double margin) {
  const MeshPart* smallest = nullptr;
  for (const MeshPart& part : parts) {
    if (!contains(part.bounds, piece, margin)) continue;
    if (!smallest || part.bounds.diagonal() < smallest->bounds.diagonal()) smallest = &part;
  }
  return smallest;
}

// Of each piece, in their order; empty unless all are known.
std::vector<MassPart> named_parts(const TriangleMesh& mesh, const std::vector<MeshPart>& parts) {
  constexpr double kMargin = 1e-5;  // of the size
  const MassSolid solid = mass_solid(mesh);
  if (!solid.has_components()) return {};
  std::vector<MassPart> named;
  for (const SolidComponent& piece : solid_components(solid)) {
    Bounds around = bounds(piece.surface);
    around.lower = solid.from_unit(around.lower);
    around.upper = solid.from_unit(around.upper);
    const MeshPart* part = smallest_around(around, parts, kMargin * solid.size);
    const std::optional<NamedMaterial> material = part ? material_in(part->name) : std::nullopt;
    const int index = static_cast<int>(named.size());
    if (!material || index == kMostMassParts) return {};
    named.push_back({.name = std::string(material->name),
                     .where = MeshComponent{index},
                     .density = material->density});
  }
  return named;
}

// Whether these can be of more than one material. Most files name none, and finding the pieces of a
// large mesh takes long.
bool are_of_several(const std::vector<MeshPart>& parts) {
  std::optional<double> first;
  for (const MeshPart& part : parts) {
    const std::optional<NamedMaterial> material = material_in(part.name);
    if (!material) continue;
    if (first && material->density != *first) return true;
    first = material->density;
  }
  return false;
}

bool is_even(const std::vector<MassPart>& parts) {
  return std::all_of(parts.begin(), parts.end(),
                     [&](const MassPart& part) { return part.density == parts.front().density; });
}

}  // namespace

std::optional<NamedMaterial> material_in(std::string_view name) {
  for (const std::string& word : words_of(name)) {
    for (const NamedMaterial& material : kMaterials) {
      if (word == material.name) return material;
    }
  }
  return std::nullopt;
}

std::vector<MeshPart> scaled(std::vector<MeshPart> parts, double factor) {
  for (MeshPart& part : parts) {
    part.bounds.lower *= factor;
    part.bounds.upper *= factor;
    for (Vector3& vertex : part.surface.vertices) vertex *= factor;
  }
  return parts;
}

void spread_named_mass(GraspableBody& object, const std::vector<MeshPart>& parts,
                       std::optional<double> mass, std::vector<std::string>& notes) {
  if (!are_of_several(parts)) return;
  std::vector<MassPart> named = named_parts(object.mesh, parts);
  if (named.empty() || is_even(named)) return;
  state_mass(object, {.mass = mass, .density = std::nullopt, .parts = std::move(named)});
  object.mass_basis = MassBasis::materials;
  notes.push_back(formatted("%.3g kg", object.mass) +
                  ", spread by the materials that the file names: state center_of_mass or parts if "
                  "they are others");
}

}  // namespace prehend
