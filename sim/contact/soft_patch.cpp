#include "sim/contact/soft_patch.h"

#include <algorithm>
#include <limits>
#include <map>

#include "sim/contact/triangle_overlap.h"
#include "sim/geometry/disjoint_sets.h"
#include "sim/geometry/weld.h"

namespace prehend {
namespace {

// Patches weaker than this part of the strongest are left out.
constexpr double kWeakest = 0.1;

// A little of the pressure.
struct Pressure {
  Vector3 position;
  Vector3 normal;  // into the object
  double force = 0.0;
  double gap = 0.0;
  int triangle = 0;  // of the object
};

// The springs of one triangle of the link that one triangle of the object presses.
void add_pressure(const Corners& on_object, const Corners& on_link, int triangle, double depth,
                  std::vector<Pressure>& pressures) {
  const Vector3 up = unit_normal(on_link);
  const Vector3 outward = unit_normal(on_object);
  const double facing = -outward.dot(up);
  if (facing <= 0.0) return;
  Polygon pressed = cut(over_face(on_link, up, on_object), on_link[0], up);
  pressed = cut(pressed, on_link[0] + depth * up, -up);
  for (std::size_t k = 2; k < pressed.size; ++k) {
    const Corners part = {pressed.corner[0], pressed.corner[k - 1], pressed.corner[k]};
    const double area = 0.5 * facing * (part[1] - part[0]).cross(part[2] - part[0]).norm();
    // The midpoints of the edges integrate a linear pressure, and its moments, exactly.
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 middle = 0.5 * (part[i] + part[(i + 1) % 3]);
      const double height = (middle - on_link[0]).dot(up);
      pressures.push_back({middle, -outward, area / 3.0 * (depth - height), height, triangle});
    }
  }
}

// For each pressure, the smallest vertex of the object that its patch is connected to.
std::vector<std::size_t> patch_of_each(const TriangleMesh& object,
                                       const std::vector<Pressure>& pressures) {
  std::map<int, std::size_t> number;  // of the vertices met
  for (const Pressure& p : pressures) {
    for (const int v : object.triangles[static_cast<std::size_t>(p.triangle)]) {
      number.emplace(v, 0);
    }
  }
  std::size_t next = 0;
  for (auto& [vertex, at] : number) at = next++;
  DisjointSets sets(number.size());
  for (const Pressure& p : pressures) {
    const Triangle& t = object.triangles[static_cast<std::size_t>(p.triangle)];
    sets.merge(number[t[0]], number[t[1]]);
    sets.merge(number[t[0]], number[t[2]]);
  }
  std::vector<std::size_t> patches;
  for (const Pressure& p : pressures) {
    const Triangle& t = object.triangles[static_cast<std::size_t>(p.triangle)];
    patches.push_back(sets.find(number[t[0]]));
  }
  return patches;
}

SoftPatch resultant(const std::vector<Pressure>& pressures) {
  SoftPatch patch;
  Vector3 normal = Vector3::Zero();
  patch.gap = std::numeric_limits<double>::infinity();
  for (const Pressure& p : pressures) {
    patch.force += p.force;
    patch.position += p.force * p.position;
    normal += p.force * p.normal;
    patch.gap = std::min(patch.gap, p.gap);
  }
  patch.position /= patch.force;
  patch.normal = normal.normalized();
  for (const Pressure& p : pressures) {
    const Vector3 arm = p.position - patch.position;
    patch.torsion += p.force * arm.cross(patch.normal).norm() / patch.force;
  }
  return patch;
}

}  // namespace

std::vector<SoftPatch> soft_patches(const ProximityMesh& object, const ProximityMesh& link,
                                    const Pose& X_OL, double depth, ContactWorkspace& workspace) {
  find_pairs_within(object, link, X_OL, depth, workspace.pairs);
  std::vector<Pressure> pressures;
  for (const TrianglePair& pair : workspace.pairs) {
    if (is_degenerate(object.mesh(), static_cast<std::size_t>(pair.a)) ||
        is_degenerate(link.mesh(), static_cast<std::size_t>(pair.b))) {
      continue;
    }
    add_pressure(corners_of(object.mesh(), pair.a), moved(corners_of(link.mesh(), pair.b), X_OL),
                 pair.a, depth, pressures);
  }
  std::map<std::size_t, std::vector<Pressure>> by_patch;
  const std::vector<std::size_t> patch_of = patch_of_each(object.mesh(), pressures);
  for (std::size_t i = 0; i < pressures.size(); ++i) by_patch[patch_of[i]].push_back(pressures[i]);
  std::vector<SoftPatch> patches;
  for (const auto& [vertex, those] : by_patch) {
    const SoftPatch patch = resultant(those);
    if (patch.force > 0.0) patches.push_back(patch);
  }
  std::stable_sort(patches.begin(), patches.end(),
                   [](const SoftPatch& a, const SoftPatch& b) { return a.force > b.force; });
  std::erase_if(patches, [&](const SoftPatch& patch) {
    return patch.force < kWeakest * patches.front().force;
  });
  return patches;
}

}  // namespace prehend
