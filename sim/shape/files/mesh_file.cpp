#include "sim/shape/files/mesh_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>

#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/base/range.h"
#include "sim/shape/files/mesh_readers.h"
#include "sim/shape/files/text_scan.h"
#include "sim/shape/weld.h"

// A mesh file is read in steps: the bytes as a whole, their validation and parsing by format, then,
// in the same way for all formats, units and welding. Errors are thrown without the file's name,
// which load_mesh adds to all of them.
namespace prehend {
namespace {

constexpr std::array<std::string_view, 9> kExtensions{"obj", "stl", "ply", "off", "gltf",
                                                      "glb", "dae", "iv",  "wrl"};

// In lower case, without the dot.
std::string extension_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

bool is_known(const std::string& extension) {
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

std::string known_extension_of(const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  if (extension == "xacro") {
    throw InputError("a robot, not a mesh: name it after --hand");
  }
  if (!is_known(extension)) {
    throw InputError(
        {.problem = "unknown mesh format, known: .obj .stl .ply .off .gltf .glb .dae .iv .wrl",
         .value = "." + extension});
  }
  return extension;
}

void scale_to_metres(TriangleMesh& mesh, double metres_per_unit) {
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    Vector3& p = mesh.vertices[i];
    if (!p.allFinite()) throw InputError("vertex " + std::to_string(i) + " is not finite");
    p *= metres_per_unit;
    if (p.cwiseAbs().maxCoeff() > kFarthest) {
      throw InputError("vertex " + std::to_string(i) + " is farther out than 1e6 m");
    }
  }
}

NamedMesh read_raw(const std::string& bytes, const std::filesystem::path& file,
                   const std::string& extension, bool colors) {
  if (extension == "obj") return read_obj(bytes, colors);
  if (extension == "stl") return {read_stl(bytes)};
  if (extension == "ply") return read_ply(bytes, colors);
  if (extension == "off") {
    need_text(bytes);
    return {read_off(bytes)};
  }
  if (extension == "iv" || extension == "wrl") {
    need_text(bytes);
    return {read_inventor(bytes)};
  }
  if (extension == "gltf") return read_gltf(bytes, file.parent_path(), colors);
  if (extension == "glb") return read_glb(bytes, file.parent_path(), colors);
  return read_collada(bytes, file, colors);
}

// Adds triangle `t` of the mesh, with vertices of its own.
void add_corners(const TriangleMesh& mesh, std::size_t t, TriangleMesh& surface) {
  const auto first = static_cast<int>(surface.vertices.size());
  for (const int v : mesh.triangles[t]) {
    surface.vertices.push_back(mesh.vertices[static_cast<std::size_t>(v)]);
  }
  surface.triangles.push_back({first, first + 1, first + 2});
}

std::vector<MeshPart> parts_of(const NamedMesh& named, bool with_surfaces) {
  std::vector<MeshPart> parts;
  if (named.names.size() > kMostNames) return parts;
  std::size_t t = 0;
  for (const NamedTriangles& of : named.names) {
    MeshPart part{of.name, {}};
    for (const std::size_t end = t + of.count; t < end; ++t) {
      if (with_surfaces) add_corners(named.mesh, t, part.surface);
      for (const int v : named.mesh.triangles[t]) {
        const Vector3& p = named.mesh.vertices[static_cast<std::size_t>(v)];
        part.bounds.lower = part.bounds.lower.cwiseMin(p);
        part.bounds.upper = part.bounds.upper.cwiseMax(p);
      }
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

// `bytes` is called for the content of the file, after everything else was checked.
LoadedMesh load(const auto& bytes, const std::filesystem::path& file,
                const MeshFileOptions& options) {
  require(options.metres_per_unit > 0.0 && std::isfinite(options.metres_per_unit),
          {.field = "metres_per_unit",
           .problem = "must be positive and finite",
           .value = std::to_string(options.metres_per_unit)});
  const std::string extension = known_extension_of(file);
  NamedMesh named = read_raw(bytes(), file, extension, options.colors);
  TriangleMesh& raw = named.mesh;
  if (raw.empty()) throw InputError("no triangles");
  // Unused vertices are removed first: they may be invalid, and they must not enlarge the bounding
  // box that sets the weld tolerance.
  drop_unused_vertices(raw);
  scale_to_metres(raw, options.metres_per_unit);
  WeldedMesh welded = weld_to_scale(raw, options.weld_fraction);
  LoadedMesh loaded{std::move(welded.mesh), welded.degenerate_removed, welded.duplicates_removed,
                    parts_of(named, options.part_surfaces)};
  const bool colored = std::any_of(named.colors.begin(), named.colors.end(),
                                   [](const SurfaceColor& color) { return color.has_value(); });
  if (colored) loaded.colors = {std::move(named.mesh), std::move(named.colors)};
  return loaded;
}

}  // namespace

void NamedMesh::add_name(std::string_view name, std::size_t count) {
  name = name.substr(0, 2 * kLongestName);
  const bool more = names.size() <= kMostNames;
  if (names.empty() || (more && names.back().name != name)) names.push_back({std::string(name), 0});
  names.back().count += count;
  named += count;
}

void NamedMesh::color_rest_by_vertices(const std::vector<SurfaceColor>& of_vertices,
                                       std::size_t first) {
  for (std::size_t t = colors.size(); t < mesh.triangles.size(); ++t) {
    colors.push_back(mean_color(of_vertices, mesh.triangles[t], first));
  }
}

double metres_per_unit(std::string_view unit) {
  if (unit == "m") return 1.0;
  if (unit == "cm") return 0.01;
  if (unit == "mm") return 0.001;
  if (unit == "in") return 0.0254;
  double metres = 0.0;
  const auto [end, error] = std::from_chars(unit.data(), unit.data() + unit.size(), metres);
  const bool is_number = error == std::errc() && end == unit.data() + unit.size();
  require(is_number && kLengthAbove0.contains(metres),
          {.field = "unit",
           .problem = "must be m, cm, mm, in or a number of metres, such as 0.0254",
           .value = std::string(unit)});
  return metres;
}

bool has_mesh_format(const std::filesystem::path& file) { return is_known(extension_of(file)); }

bool states_unit(const std::filesystem::path& file) {
  const std::string extension = known_extension_of(file);
  return extension == "gltf" || extension == "glb" || extension == "dae";
}

LoadedMesh load_mesh(const std::filesystem::path& file, const MeshFileOptions& options) {
  try {
    return load([&] { return read_file(file); }, file, options);
  } catch (const InputError& error) {
    throw error.in_file(file.string());
  }
}

LoadedMesh read_mesh(const std::string& bytes, const std::filesystem::path& file,
                     const MeshFileOptions& options) {
  try {
    return load([&]() -> const std::string& { return bytes; }, file, options);
  } catch (const InputError& error) {
    throw error.in_file(file.string());
  }
}

}  // namespace prehend
