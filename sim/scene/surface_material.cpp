#include "sim/scene/surface_material.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "sim/base/index.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/nearest_triangle.h"

namespace prehend {
namespace {

constexpr double kMargin = SurfaceRegions::kMargin;
constexpr double kSame = 1e-6;  // a triangle is one of a part that is so near to its middle [m]

Vector3 middle_of(const Corners& corners) { return (corners[0] + corners[1] + corners[2]) / 3.0; }

// How far the point is from a region that is no part, at least; at most 0 in it [m].
double distance_to(const SurfaceRegion& region, const Vector3& p) {
  if (region.beyond) return -region.beyond->normal_O.dot(p - region.beyond->point_O);
  return signed_distance(region.inside, p);
}

// The least value of a convex function on [0, most], by golden sections.
template <typename Function>
double least_on(double most, const Function& value) {
  constexpr double kPart = 0.6180339887498949;  // (sqrt(5) - 1) / 2
  constexpr int kSections = 48;                 // to 1e-10 of the interval
  double lower = 0.0;
  double upper = most;
  double x = upper - kPart * (upper - lower);
  double y = lower + kPart * (upper - lower);
  double at_x = value(x);
  double at_y = value(y);
  for (int i = 0; i < kSections; ++i) {
    if (at_x <= at_y) {
      upper = y;
      y = x;
      at_y = at_x;
      x = upper - kPart * (upper - lower);
      at_x = value(x);
    } else {
      lower = x;
      x = y;
      at_x = at_y;
      y = lower + kPart * (upper - lower);
      at_y = value(y);
    }
  }
  return std::min(at_x, at_y);
}

// Whether the triangle has a point in the region, which is no part. The signed distance from a
// convex solid or a plane is a convex function, and so is its least value across the triangle.
bool meets(const SurfaceRegion& region, const Corners& corners) {
  const Vector3 middle = middle_of(corners);
  double radius = 0.0;
  for (const Vector3& corner : corners) {
    if (distance_to(region, corner) <= kMargin) return true;
    radius = std::max(radius, (corner - middle).norm());
  }
  if (distance_to(region, middle) > radius + kMargin) return false;
  const Vector3 to_b = corners[1] - corners[0];
  const Vector3 to_c = corners[2] - corners[0];
  const double least = least_on(1.0, [&](double s) {
    return least_on(
        1.0 - s, [&](double t) { return distance_to(region, corners[0] + s * to_b + t * to_c); });
  });
  return least <= kMargin;
}

std::optional<double> least_of(const std::optional<double>& a, const std::optional<double>& b) {
  if (a && b) return std::min(*a, *b);
  return a ? a : b;
}

}  // namespace

std::string surface_name(const SurfaceMaterial& surface) {
  return surface.name.empty() ? std::string(name_of(surface.material)) : surface.name;
}

double friction_between(const FrictionTable& table, const SurfaceMaterial& a,
                        const SurfaceMaterial& b) {
  const std::optional<double> own = least_of(a.friction[b.material], b.friction[a.material]);
  return own.value_or(table.between(a.material, b.material));
}

double depth_between(const CompliantDepths& depths, const SurfaceMaterial& a,
                     const SurfaceMaterial& b) {
  return std::max(a.compliant_depth.value_or(depths.of(a.material)),
                  b.compliant_depth.value_or(depths.of(b.material)));
}

bool has_surface_of(const SurfaceRegion& region, const TriangleMesh& mesh) {
  if (region.is_of_file()) return !region.surface.empty();
  for (int t = 0; t < std::ssize(mesh.triangles); ++t) {
    if (meets(region, corners_of(mesh, t))) return true;
  }
  return false;
}

TriangleMesh part_of_mesh(const SurfaceRegion& region, const FileSurfaces& file,
                          const TriangleMesh& mesh) {
  SurfaceRegion in_file = region;
  find_file_surface(file, in_file);  // throws where there is none
  TriangleMesh all;
  std::vector<bool> is_meant;
  if (region.color) {
    all = file.colors.surface;
    for (const SurfaceColor& color : file.colors.colors) {
      is_meant.push_back(is_within(*region.color, color));
    }
  } else {
    for (const MeshPart& part : file.parts) {
      append(all, part.surface);
      is_meant.resize(all.triangles.size(), is_part_called(part, region.part));
    }
  }
  const ProximityMesh near(std::move(all));
  TriangleMesh surface{mesh.vertices, {}};
  std::vector<int> nearest;
  for (int t = 0; t < std::ssize(mesh.triangles); ++t) {
    nearest_triangles(near, middle_of(corners_of(mesh, t)), kSame, nearest);
    if (is_meant[index(nearest.front())]) surface.triangles.push_back(mesh.triangles[index(t)]);
  }
  return surface;
}

SurfaceMaterials::SurfaceMaterials(Material body, const std::vector<MaterialRegion>& regions,
                                   const ProximityMesh& surface)
    : body_{.material = body}, regions_(regions) {
  const TriangleMesh& mesh = surface.mesh();
  std::vector<int> nearest;
  for (int i = 0; i < std::ssize(regions_); ++i) {
    const SurfaceRegion& where = regions_[index(i)].where;
    if (!where.is_of_file() || where.surface.empty()) continue;
    surface_ = surface;
    part_of_.resize(mesh.triangles.size(), -1);
    const SurfaceRegions part({where});
    for (int t = 0; t < std::ssize(mesh.triangles); ++t) {
      if (part.contain(middle_of(corners_of(mesh, t)), kSame)) part_of_[index(t)] = i;
    }
  }
}

int SurfaceMaterials::region_at(const Vector3& p_B) const {
  int last = -1;
  for (int i = 0; i < std::ssize(regions_); ++i) {
    const SurfaceRegion& where = regions_[index(i)].where;
    if (!where.is_of_file() && distance_to(where, p_B) <= kMargin) last = i;
  }
  if (!surface_) return last;
  std::vector<int> nearest;
  nearest_triangles(*surface_, p_B, kMargin, nearest);
  for (const int t : nearest) last = std::max(last, part_of_[index(t)]);
  return last;
}

const SurfaceMaterial& SurfaceMaterials::of(int i) const {
  return i < 0 ? body_ : regions_[index(i)].of;
}

void SurfaceMaterials::set_friction(Material other, double friction) {
  body_.friction[other] = friction;
  for (MaterialRegion& region : regions_) region.of.friction[other] = friction;
}

}  // namespace prehend
