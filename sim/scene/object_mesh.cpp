#include "sim/scene/object_mesh.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <sstream>
#include <string_view>

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

// Whether a CAD program has written the file: STL is their format, and OBJ files name their writer
// in the first comments.
bool of_cad(const std::filesystem::path& file) {
  constexpr std::size_t kHead = 1000;
  constexpr std::array<std::string_view, 14> kPrograms = {
      "freecad",  "solidworks",   "onshape",     "fusion",     "autodesk inventor",
      "openscad", "catia",        "creo",        "solid edge", "siemens nx",
      "cadquery", "open cascade", "opencascade", "rhino"};
  const auto lower = [](std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
  };
  const std::string extension = lower(file.extension().string());
  if (extension == ".stl") return true;
  if (extension != ".obj") return false;
  std::string head(kHead, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(kHead));
  head = lower(head.substr(0, static_cast<std::size_t>(stream.gcount())));
  std::istringstream lines(head);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with('#')) continue;
    const auto names = [&](std::string_view program) { return line.find(program) != line.npos; };
    if (std::any_of(kPrograms.begin(), kPrograms.end(), names)) return true;
  }
  return false;
}

// Reads the file, in metres first where no unit is stated: the size tells whether they are.
LoadedMesh read_in_likely_unit(const std::filesystem::path& file, MeshFileOptions options,
                               ObjectMesh& object) {
  LoadedMesh loaded = load_mesh(file, options);
  const double size = longest_side(loaded.mesh);
  object.unit = states_unit(file) ? "m" : likely_unit(size, of_cad(file));
  if (object.unit == "m") return loaded;
  // Read again, not scaled, so that the same bytes come out as when the unit is stated.
  options.metres_per_unit = metres_per_unit(object.unit);
  loaded = load_mesh(file, options);
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

std::string likely_unit(double longest_side, bool of_cad) {
  constexpr double kLargestPart = 1000.0;  // mm
  constexpr double kLongest = 1.5;         // m
  constexpr std::array<const char*, 3> kUnits = {"mm", "cm", "in"};
  struct Sizes {
    double smallest;
    double largest;
  };
  if (!(longest_side > kLongest)) return "m";
  if (of_cad && longest_side <= kLargestPart) return "mm";
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
  MeshFileOptions options{.part_surfaces = source.part_surfaces, .colors = source.colors};
  if (!source.unit.empty()) options.metres_per_unit = metres_per_unit(source.unit);
  LoadedMesh loaded =
      source.unit.empty() ? read_in_likely_unit(file, options, object) : load_mesh(file, options);
  object.parts = std::move(loaded.parts);
  object.colors = std::move(loaded.colors);
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
