#include "benchmarks/primitives/primitive_sets.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "benchmarks/support/percentile.h"
#include "primitives/primitive_surface.h"
#include "primitives/surface_sample.h"

namespace prehend::bench {
namespace {

double distance_to(const std::vector<Primitive>& primitives, const Vector3& p_O) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Primitive& one : primitives) {
    nearest = std::min(nearest, std::abs(signed_distance(one, p_O)));
  }
  return nearest;
}

double one_way(const std::vector<Primitive>& from, const std::vector<Primitive>& to) {
  constexpr int kPoints = 600;
  double sum = 0.0;
  double area = 0.0;
  for (const Primitive& one : from) {
    for (const PatchPoint& patch : spread_points(one, kPoints)) {
      sum += patch.area * distance_to(to, patch.p_O);
      area += patch.area;
    }
  }
  return sum / area;
}

}  // namespace

std::map<std::string, int> kinds_of(const std::vector<Primitive>& primitives) {
  std::map<std::string, int> kinds;
  for (const Primitive& one : primitives) ++kinds[std::string(shape_name(one.shape))];
  return kinds;
}

std::string kinds_text(const std::vector<Primitive>& primitives) {
  std::string text;
  for (const auto& [kind, count] : kinds_of(primitives)) {
    text += text.empty() ? "" : " + ";
    text += count > 1 ? std::to_string(count) + " " + kind : kind;
  }
  return text;
}

double distance_between(const std::vector<Primitive>& a, const std::vector<Primitive>& b) {
  return std::max(one_way(a, b), one_way(b, a));
}

std::vector<Primitive> moved_primitives(std::vector<Primitive> primitives, const Pose& X_NO,
                                        double factor) {
  for (Primitive& one : primitives) {
    if (auto* box = std::get_if<Box>(&one.shape)) box->size *= factor;
    if (auto* sphere = std::get_if<Sphere>(&one.shape)) sphere->radius *= factor;
    if (auto* cylinder = std::get_if<Cylinder>(&one.shape)) {
      cylinder->radius *= factor;
      cylinder->height *= factor;
    }
    if (auto* cone = std::get_if<Cone>(&one.shape)) {
      cone->radius_low *= factor;
      cone->radius_high *= factor;
      cone->height *= factor;
    }
    one.X_OP = X_NO * one.X_OP;
    one.X_OP.translation() *= factor;
  }
  return primitives;
}

SurfaceResidual residual_of(const TriangleMesh& mesh, const std::vector<Primitive>& primitives) {
  constexpr int kPoints = 6000;
  constexpr std::uint64_t kSeed = 17;
  std::vector<double> distances;
  for (const SurfacePoint& s : sample_surface(mesh, kPoints, kSeed)) {
    distances.push_back(distance_to(primitives, s.p_O));
  }
  return {benchmark::percentile(distances, 0.5), benchmark::percentile(distances, 0.95)};
}

}  // namespace prehend::bench
