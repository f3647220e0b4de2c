// Most objects are surfaces of revolution, given by the corners of their profile (distance from the
// axis, height) in metres with a fillet radius each. Dimensions are those of common products or of
// the YCB object set (Calli et al. 2015).
#include "sim/shape/object_generator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "sim/base/input_error.h"
#include "sim/shape/generate_mug.h"
#include "sim/shape/revolve.h"

namespace prehend {
namespace {

// A solid of revolution with edges about `edge` long [m].
TriangleMesh turned(const std::vector<ProfileCorner>& corners, double edge) {
  // Coarser than this, the profiles lose their form.
  edge = std::min(edge, 0.03);
  return revolve(profile_points(corners, edge), edge).mesh;
}

// A vessel from its outer profile: the inner profile is parallel to it at distance `wall`, and the
// lip between them is rounded to a half circle.
TriangleMesh vessel(std::vector<ProfileCorner> outer, double wall, double edge) {
  outer.back().fillet = 0.5 * wall;
  const std::vector<ProfileCorner> inner = inner_side(outer, wall);
  outer.insert(outer.end(), inner.begin(), inner.end());
  return turned(outer, edge);
}

// Number of cells of about `edge` along a length.
int cells(double length, double edge) {
  return std::clamp(static_cast<int>(std::lround(length / edge)), 1, 10000);
}

// A white-wine glass: 71 mm wide, 172 mm high, wall 1.6 mm, foot and stem solid.
TriangleMesh wine_glass(double edge) {
  return turned({{{0.0, 0.0}},
                 {{0.034, 0.0}, 0.0012},
                 {{0.034, 0.002}, 0.0012},
                 {{0.0038, 0.006}, 0.010},
                 {{0.0038, 0.080}, 0.010},
                 {{0.0370, 0.086}, 0.026},
                 {{0.0310, 0.172}, 0.0008},
                 {{0.0294, 0.172}, 0.0008},
                 {{0.0353, 0.088}, 0.0244},
                 {{0.0, 0.0835}}},
                edge);
}

// A conical laboratory flask of one litre: base 136 mm, height 207 mm, neck 36 mm, wall 2.5 mm.
TriangleMesh flask(double edge) {
  return vessel({{{0.0, 0.0}}, {{0.072, 0.0}, 0.010}, {{0.018, 0.145}, 0.020}, {{0.018, 0.207}}},
                0.0025, edge);
}

// A half-litre drinks bottle: 65 mm wide, 205 mm high, with a cap of 30 mm.
TriangleMesh bottle(double edge) {
  return turned({{{0.0, 0.0}},
                 {{0.0325, 0.0}, 0.006},
                 {{0.0325, 0.140}, 0.025},
                 {{0.0135, 0.178}, 0.012},
                 {{0.0135, 0.188}},
                 {{0.015, 0.188}},
                 {{0.015, 0.205}, 0.0015},
                 {{0.0, 0.205}}},
                edge);
}

// A cereal bowl: 161 mm wide, 55 mm high like the one of the YCB set, wall 3.5 mm.
TriangleMesh bowl(double edge) {
  return vessel({{{0.0, 0.0}}, {{0.060, 0.0}, 0.045}, {{0.0811, 0.0544}}}, 0.0035, edge);
}

// A soup can: 68 mm by 102 mm like the one of the YCB set.
TriangleMesh can(double edge) {
  return turned({{{0.0, 0.0}}, {{0.034, 0.0}, 0.001}, {{0.034, 0.102}, 0.001}, {{0.0, 0.102}}},
                edge);
}

TriangleMesh standing(const TriangleMesh& mesh, double half_height) {
  return transformed(mesh, translation({0.0, 0.0, half_height}));
}

// A carton of tea: 60 mm by 100 mm by 160 mm.
TriangleMesh carton(double edge) {
  const Vector3 size(0.060, 0.100, 0.160);
  return standing(
      make_box_grid(size, {cells(size.x(), edge), cells(size.y(), edge), cells(size.z(), edge)}),
      0.5 * size.z());
}

// A tennis ball: 67 mm (ITF rules: 65.4 to 68.6 mm).
TriangleMesh ball(double edge) {
  const double radius = 0.0335;
  // From equal areas: that of the sphere, and that of 20 frequency^2 triangles of about edge^2 / 2.
  const double frequency = std::sqrt(4.0 * std::numbers::pi / 10.0) * radius / edge;
  return standing(
      make_geodesic_sphere(radius, std::clamp(static_cast<int>(std::lround(frequency)), 1, 2000)),
      radius);
}

// Projects a point on the surface of a box to the box of the same size whose edges are rounded with
// `radius`: towards the nearest point of the inner box, which is smaller by `radius` on every side.
Vector3 rounded(const Vector3& p, const Vector3& half, double radius) {
  const Vector3 inner =
      p.cwiseMax(radius * Vector3::Ones() - half).cwiseMin(half - radius * Vector3::Ones());
  return inner + radius * (p - inner).normalized();
}

// A smartphone: 147 mm by 71.5 mm by 7.8 mm, all edges rounded by 3 mm.
TriangleMesh phone(double edge) {
  const Vector3 size(0.147, 0.0715, 0.0078);
  const double radius = 0.003;
  const Vector3 half = 0.5 * size;
  const int arc = cells(0.25 * std::numbers::pi * radius, edge);
  std::array<int, 3> count{};
  std::array<int, 3> flat{};
  for (std::size_t k = 0; k < 3; ++k) {
    flat[k] = cells(size[static_cast<Eigen::Index>(k)] - 2.0 * radius, edge);
    count[k] = flat[k] + 2 * arc;
  }
  const Vector3 lattice(count[0], count[1], count[2]);
  TriangleMesh mesh = make_box_grid(lattice, count);
  for (Vector3& p : mesh.vertices) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      // Lattice steps on the flat part have equal lengths. The `arc` steps beyond it are spaced as
      // the tangent of equal angles up to 45 degrees, so that the projection (rounded) turns them
      // into equal angles of the rounded edge.
      const double step = p[k];
      const double flat_steps = 0.5 * flat[static_cast<std::size_t>(k)];
      const double beyond = std::max(0.0, std::abs(step) - flat_steps) / arc;
      const double offset = (half[k] - radius) * std::min(1.0, std::abs(step) / flat_steps) +
                            radius * std::tan(0.25 * std::numbers::pi * beyond);
      p[k] = std::copysign(offset, step);
    }
    p = rounded(p, half, radius);
  }
  return standing(mesh, half.z());
}

struct NamedObject {
  std::string_view name;
  TriangleMesh (*make)(double edge);
};

constexpr std::array<NamedObject, 9> kObjects{{{"mug", generate_mug},
                                               {"wine_glass", wine_glass},
                                               {"phone", phone},
                                               {"flask", flask},
                                               {"bottle", bottle},
                                               {"bowl", bowl},
                                               {"box", carton},
                                               {"ball", ball},
                                               {"cylinder", can}}};

// The number of triangles is about proportional to 1 / edge^2. A few corrections of the edge length
// by the square root of the ratio of counts come close; counts change in jumps, so the best attempt
// is kept.
TriangleMesh with_count(TriangleMesh (*make)(double), int triangles) {
  // 3 % (logarithm of the ratio) is close enough.
  constexpr double kClose = 0.03;
  double edge = 0.01;
  double best_error = std::numeric_limits<double>::infinity();
  TriangleMesh best;
  for (int attempt = 0; attempt < 6 && best_error > kClose; ++attempt) {
    TriangleMesh mesh = make(edge);
    const double ratio = static_cast<double>(mesh.triangles.size()) / triangles;
    const double error = std::abs(std::log(ratio));
    if (error < best_error) {
      best_error = error;
      best = std::move(mesh);
    }
    edge = std::clamp(edge * std::sqrt(ratio), 1e-5, 0.5);
  }
  return best;
}

}  // namespace

std::vector<std::string> generated_object_names() {
  std::vector<std::string> names;
  for (const NamedObject& object : kObjects) names.emplace_back(object.name);
  return names;
}

TriangleMesh generate_object(std::string_view name, int triangles) {
  constexpr int kMost = 2'000'000;
  require(triangles >= 1 && triangles <= kMost, {.field = "triangles",
                                                 .problem = "must be 1 to 2000000",
                                                 .value = std::to_string(triangles)});
  const auto found = std::find_if(kObjects.begin(), kObjects.end(),
                                  [&](const NamedObject& object) { return object.name == name; });
  if (found == kObjects.end()) {
    std::string known;
    for (const NamedObject& object : kObjects) known.append(" ").append(object.name);
    throw InputError({.field = "object",
                      .problem = "must be a known generator:" + known,
                      .value = std::string(name)});
  }
  return with_count(found->make, triangles);
}

}  // namespace prehend
