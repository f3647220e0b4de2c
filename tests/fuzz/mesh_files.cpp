#include <algorithm>
#include <vector>

#include "sim/base/range.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/mass_properties.h"
#include "sim/shape/mesh_checks.h"
#include "sim/shape/weld.h"
#include "tests/fuzz/mesh_promises.h"
#include "tests/fuzz/untrusted_files.h"

namespace prehend::fuzz {
namespace {

// What a mesh file promises beyond that (mesh_file.h).
void check_clean(const LoadedMesh& loaded) {
  const TriangleMesh& mesh = loaded.mesh;
  promised(loaded.degenerate_removed >= 0 && loaded.duplicates_removed >= 0,
           "counts of removed triangles are not negative");
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const Triangle& triangle : mesh.triangles) {
    for (const int vertex : triangle) used[static_cast<std::size_t>(vertex)] = true;
  }
  promised(std::find(used.begin(), used.end(), false) == used.end(), "every vertex is used");
  for (const Vector3& vertex : mesh.vertices) {
    promised(vertex.cwiseAbs().maxCoeff() <= kFarthest, "no vertex is beyond 1e30 m");
  }
  promised(check_mesh(mesh).degenerate_triangles == 0, "no triangle is degenerate");
}

void check_colors(const ColoredMesh& mesh) {
  promised(mesh.colors.size() == mesh.surface.triangles.size(), "each triangle has an entry");
  for (const SurfaceColor& color : mesh.colors) {
    if (!color) continue;
    promised(color->minCoeff() >= 0.0F && color->maxCoeff() <= 1.0F, "colours are from 0 to 1");
  }
  double whole = 0.0;
  for (const ColorShare& one : frequent_colors(mesh)) {
    promised(one.share > 0.0, "a colour that is listed is there");
    promised(color_in_text(color_text(one.color)).has_value(), "its text is a colour");
    whole += one.share;
  }
  promised(whole <= 1.0 + 1e-9, "colours cover at most the whole");
}

void check_mass(const TriangleMesh& mesh) {
  const MassProperties mass = mass_properties(mesh);
  promised(mass.volume >= 0.0 && std::isfinite(mass.volume), "the volume is a finite number");
  promised(mass.center_of_mass.allFinite(), "the centre of mass is finite");
  promised(mass.unit_inertia.allFinite(), "the inertia is finite");
  promised((mass.unit_inertia.diagonal().array() >= 0.0).all(), "moments are not negative");
}

}  // namespace

void check_usable(const TriangleMesh& mesh) {
  promised(!mesh.empty(), "a mesh has triangles");
  const int count = static_cast<int>(mesh.vertices.size());
  for (const Triangle& triangle : mesh.triangles) {
    for (const int vertex : triangle) {
      promised(vertex >= 0 && vertex < count, "every corner is a vertex of the mesh");
    }
  }
  for (const Vector3& vertex : mesh.vertices) {
    promised(vertex.allFinite(), "every vertex is finite");
  }
}

bool finite(const Pose& pose) { return pose.matrix().allFinite(); }

// Reads the mesh and does with it what every plan does with the mesh of its object.
void read_mesh_file(std::string_view extension, const std::string& bytes) {
  LoadedMesh loaded = read_mesh(bytes, pretended_path(extension, extension),
                                {.part_surfaces = true, .colors = true});
  check_usable(loaded.mesh);
  check_clean(loaded);
  check_colors(loaded.colors);
  orient_outward(loaded.mesh);
  check_usable(loaded.mesh);
  promised(orient_outward(loaded.mesh) == 0, "what faces outward is not turned again");
  check_mass(loaded.mesh);
}

}  // namespace prehend::fuzz
