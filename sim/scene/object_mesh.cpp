#include "sim/scene/object_mesh.h"

#include <array>

#include "sim/base/formatted.h"
#include "sim/base/joined.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/mass_properties.h"
#include "sim/shape/mesh_repair.h"

namespace prehend {
namespace {

constexpr double kMillimetres = 1000.0;

double longest_side(const TriangleMesh& mesh) { return bounds(mesh).size().maxCoeff(); }

std::string counted_repeats(int count) {
  return count == 1 ? "1 triangle that repeats another"
                    : std::to_string(count) + " triangles that repeat others";
}

bool is_stl(const std::filesystem::path& file) {
  const std::filesystem::path extension = file.extension();
  return extension == ".stl" || extension == ".STL";
}

// Reads the file, in metres first where no unit is stated: the size tells whether they are.
LoadedMesh read_in_likely_unit(const std::filesystem::path& file, bool part_surfaces,
                               ObjectMesh& object) {
  LoadedMesh loaded = load_mesh(file, {.part_surfaces = part_surfaces});
  const double size = longest_side(loaded.mesh);
  object.unit = states_unit(file) ? "m" : likely_unit(size, is_stl(file));
  if (object.unit == "m") return loaded;
  // Read again, not scaled, so that the same bytes come out as when the unit is stated.
  loaded = load_mesh(
      file, {.metres_per_unit = metres_per_unit(object.unit), .part_surfaces = part_surfaces});
  object.notes.push_back(formatted(
      "%.4g long in the file, whose unit nobody says: read in %s, which makes it %.4g mm; --unit m "
      "reads it in metres",
      size, object.unit.c_str(), kMillimetres * longest_side(loaded.mesh)));
  return loaded;
}

// What was repaired and what is still missing; nothing for a mesh that is a solid as it is.
void note_repair(const LoadedMesh& loaded, const MeshRepair& repair, ObjectMesh& object) {
  const MassSource source = mass_properties(repair.mesh).source;
  std::string words = repair_text(repair);
  if (loaded.duplicates_removed > 0) {
    add_part(words, counted_repeats(loaded.duplicates_removed) + " left out");
  }
  const std::string missing = missing_text(repair.after);
  if (words.empty() && missing.empty()) return;
  if (!missing.empty()) words += (words.empty() ? "" : "; still ") + missing;
  words += "; " + trust_text(repair.after, source);
  if (repair.changed()) words += "; --no-repair keeps the surface as it is in the file";
  object.notes.push_back(words);
}

}  // namespace

std::string likely_unit(double longest_side, bool is_stl) {
  constexpr double kLeastPart = 3.0;  // mm
  constexpr double kLargestPart = 1000.0;
  constexpr double kLongest = 1.5;  // m
  constexpr std::array<const char*, 3> kUnits = {"mm", "cm", "in"};
  struct Sizes {
    double smallest;
    double largest;
  };
  if (!(longest_side > kLongest)) return "m";
  if (is_stl && longest_side > kLeastPart && longest_side <= kLargestPart) return "mm";
  for (const Sizes& sizes : {Sizes{0.03, 0.5}, Sizes{0.01, 1.0}}) {
    for (const char* unit : kUnits) {
      const double size = longest_side * metres_per_unit(unit);
      if (size >= sizes.smallest && size <= sizes.largest) return unit;
    }
  }
  return "m";
}

ObjectMesh load_object_mesh(const std::filesystem::path& file, const ObjectMeshSource& source) {
  ObjectMesh object;
  object.unit = source.unit;
  LoadedMesh loaded = source.unit.empty()
                          ? read_in_likely_unit(file, source.part_surfaces, object)
                          : load_mesh(file, {.metres_per_unit = metres_per_unit(source.unit),
                                             .part_surfaces = source.part_surfaces});
  object.parts = std::move(loaded.parts);
  if (!source.repair) {
    orient_outward(loaded.mesh);
    object.mesh = std::move(loaded.mesh);
    return object;
  }
  MeshRepair repair = repair_mesh(loaded.mesh);
  note_repair(loaded, repair, object);
  object.mesh = std::move(repair.mesh);
  return object;
}

}  // namespace prehend
