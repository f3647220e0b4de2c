#include "sim/shape/contact/cup_seal.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "sim/base/index.h"
#include "sim/shape/proximity.h"
#include "sim/shape/ray.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {
namespace {

constexpr int kRays = 2 * kLipSprings;
constexpr double kEdgeCosine = 0.7071067811865476;  // of neighbouring normals, 45 degrees
// A ray through an edge of two triangles may by rounding meet neither, and come to the back of
// others: it is tried again beside it, by this part of the radius.
constexpr double kBesideRay = 1e-5;
// Rays start so many times the travel behind the lip.
constexpr double kStart = 2.0;
// A step between neighbours that is higher than their normals explain, by this part of the radius.
constexpr double kStep = 0.05;

struct Met {
  double depth = 0.0;  // along the axis from the plane of the lip [m]
  Vector3 normal = Vector3::UnitZ();
  bool outer = false;  // side of the surface
};

class Projection {
 public:
  Projection(const ProximityMesh& mesh, const CupLip& cup)
      : mesh_(mesh), cup_(cup), x_(any_orthogonal(cup.axis)), y_(cup.axis.cross(x_)) {}

  Vector3 at(double angle, double radius) const {
    return cup_.center + radius * (std::cos(angle) * x_ + std::sin(angle) * y_);
  }

  std::optional<Met> meet(const Vector3& p) const {
    const std::optional<Met> met = meet_once(p);
    if (met && met->outer) return met;
    const std::optional<Met> beside = meet_once(p + kBesideRay * cup_.radius * (x_ + 0.7 * y_));
    return beside && beside->outer ? beside : met;
  }

 private:
  std::optional<Met> meet_once(const Vector3& p) const {
    const double start = kStart * cup_.travel;
    const double cap = start + cup_.travel + 4.0 * cup_.radius;
    const RayHit hit = first_hit(mesh_, p - start * cup_.axis, cup_.axis, cap);
    if (hit.triangle < 0) return std::nullopt;
    const Vector3 normal =
        doubled_area_vector(mesh_.mesh(), index(hit.triangle)).stableNormalized();
    return Met{hit.distance - start, normal, normal.dot(cup_.axis) < 0.0};
  }

  const ProximityMesh& mesh_;
  const CupLip& cup_;
  Vector3 x_;
  Vector3 y_;
};

// How much deeper a surface with this normal may be at the distance `apart`.
double explained_step(const Met& met, const Vector3& axis, double apart) {
  const double cosine = std::min(1.0, -met.normal.dot(axis));
  if (!(cosine > 0.0)) return std::numeric_limits<double>::infinity();
  return apart * std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) / cosine;
}

// The lip on the surface; the end is `sealed` where nothing spoke against it.
struct Ring {
  SealEnd end = SealEnd::sealed;
  std::vector<Met> met;
};

Ring project_ring(const Projection& projection, const CupLip& cup) {
  Ring ring;
  for (int i = 0; i < kRays; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kRays;
    const std::optional<Met> met = projection.meet(projection.at(angle, cup.radius));
    if (!met || !met->outer) {
      ring.end = met ? SealEnd::gap : SealEnd::off_surface;
      return ring;
    }
    ring.met.push_back(*met);
  }
  return ring;
}

bool crosses_edge(const std::vector<Met>& ring, const CupLip& cup) {
  const double apart = 2.0 * cup.radius * std::sin(std::numbers::pi / kRays);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Met& one = ring[i];
    const Met& next = ring[(i + 1) % ring.size()];
    if (one.normal.dot(next.normal) < kEdgeCosine) return true;
    const double step = std::abs(one.depth - next.depth);
    const double explained =
        std::max(explained_step(one, cup.axis, apart), explained_step(next, cup.axis, apart));
    if (step > explained + kStep * cup.radius) return true;
  }
  return false;
}

double largest_strain(const std::vector<Met>& ring, const CupLip& cup) {
  const double rest = 2.0 * cup.radius * std::sin(std::numbers::pi / kLipSprings);
  double largest = 0.0;
  for (int i = 0; i < kLipSprings; ++i) {
    const Met& one = ring[index(2 * i)];
    const Met& next = ring[index(2 * ((i + 1) % kLipSprings))];
    largest = std::max(largest, std::hypot(rest, one.depth - next.depth) / rest - 1.0);
  }
  return largest;
}

// The least depth of the surface inside of the lip; none where it has a hole.
std::optional<double> least_inside(const Projection& projection, const CupLip& cup) {
  constexpr int kCircles = 4;
  double least = std::numeric_limits<double>::infinity();
  for (int circle = 0; circle < kCircles; ++circle) {
    const int rays = circle == 0 ? 1 : 8 * circle;
    for (int i = 0; i < rays; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / rays;
      const double radius = cup.radius * circle / kCircles;
      const std::optional<Met> met = projection.meet(projection.at(angle, radius));
      if (!met || !met->outer) return std::nullopt;
      least = std::min(least, met->depth);
    }
  }
  return least;
}

bool any_leaks(const std::vector<Met>& ring, const Projection& projection, const CupLip& cup,
               const std::function<bool(const Vector3&)>& leaks) {
  for (std::size_t i = 0; leaks && i < ring.size(); ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / kRays;
    if (leaks(projection.at(angle, cup.radius) + ring[i].depth * cup.axis)) return true;
  }
  const std::optional<Met> middle = projection.meet(cup.center);
  return leaks && middle && leaks(cup.center + middle->depth * cup.axis);
}

}  // namespace

CupSeal cup_seal(const ProximityMesh& mesh, const CupLip& cup,
                 const std::function<bool(const Vector3&)>& leaks) {
  const Projection projection(mesh, cup);
  const Ring ring = project_ring(projection, cup);
  CupSeal seal{.end = ring.end, .center = cup.center};
  if (seal.end != SealEnd::sealed) return seal;
  double sum = 0.0;
  seal.nearest = seal.press = ring.met.front().depth;
  for (const Met& met : ring.met) {
    seal.nearest = std::min(seal.nearest, met.depth);
    seal.press = std::max(seal.press, met.depth);
    sum += met.depth;
  }
  seal.center += sum / kRays * cup.axis;
  seal.strain = largest_strain(ring.met, cup);
  const std::optional<double> inside = least_inside(projection, cup);
  if (crosses_edge(ring.met, cup)) {
    seal.end = SealEnd::edge;
  } else if (!inside) {
    seal.end = SealEnd::gap;
  } else if (seal.strain > cup.strain ||
             seal.press - std::min(seal.nearest, *inside) > cup.travel) {
    seal.end = SealEnd::too_curved;
  } else if (any_leaks(ring.met, projection, cup, leaks)) {
    seal.end = SealEnd::porous;
  }
  return seal;
}

}  // namespace prehend
