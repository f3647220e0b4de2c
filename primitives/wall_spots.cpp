#include "primitives/wall_spots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "sim/base/index.h"
#include "sim/base/parallel/parallel.h"

namespace prehend {
namespace {

// Directions of rays in the middle of a wall, an eighth of a turn apart: the opposite one is four
// further, those across are two further and two back.
constexpr std::size_t kDirections = 8;

// Of cosines between a ray and the normal of the surface where it ends: the two sides of a wall,
// the face of an edge, and any surface that is not grazed.
constexpr double kOpposite = 0.8;
constexpr double kEdgeFace = 0.5;
constexpr double kNotGrazed = 0.7;

// A wall goes on behind its edge for at least this many times its thickness.
constexpr double kLeastDepth = 2.5;
// A bar is at most so much wider in one direction across than in the other, and at least so much
// longer than wide, where it may be bent.
constexpr double kFlatBar = 2.5;
constexpr double kLongBar = 2.2;

// The end of a ray.
struct Exit {
  double distance = std::numeric_limits<double>::infinity();
  double facing = 0.0;  // cosine between the ray and the outward normal there; 1: leaves straight
  Vector3 normal = Vector3::Zero();
};

class Probe {
 public:
  Probe(const ProximityMesh& mesh, const ThinLimits& limits) : mesh_(mesh), limits_(limits) {
    // Rays start so far from the surface, in order not to meet it there.
    aside_ = 1e-6 * mesh.ball_radius();
  }

  void at(const SurfacePoint& point, std::optional<ThinSpot>& wall, std::optional<ThinSpot>& bar) {
    const double thickest = std::max(limits_.wall, limits_.bar);
    normal_ = normal_of(point.triangle);
    const Exit opposite = ray(point.p_O - aside_ * normal_, -normal_, thickest);
    if (opposite.facing < kOpposite || opposite.distance < aside_) return;
    width_ = opposite.distance + aside_;
    middle_ = point.p_O - 0.5 * width_ * normal_;
    look_around(first_direction(point));
    bar = bar_here();
    if (!bar && width_ <= limits_.wall) wall = edge_near();
  }

 private:
  // That of the mesh, also where a surface as a whole seems to face inward: the volume in a thin
  // wall is too little to tell from sample points.
  Vector3 normal_of(int triangle) const {
    return doubled_area_vector(mesh_.mesh(), index(triangle)).normalized();
  }

  Exit ray(const Vector3& from, const Vector3& direction, double cap) const {
    const RayHit hit = first_hit(mesh_, from, direction, cap);
    if (hit.triangle < 0) return {};
    const Vector3 normal = normal_of(hit.triangle);
    return {hit.distance, normal.dot(direction), normal};
  }

  bool is_free(const Vector3& from, const Vector3& direction, double length) const {
    return first_hit(mesh_, from + 10.0 * aside_ * direction, direction, length).triangle < 0;
  }

  // Along a side of the triangle, so that the rays turn with the mesh.
  Vector3 first_direction(const SurfacePoint& point) const {
    const Triangle& corner = mesh_.mesh().triangles[index(point.triangle)];
    const Vector3 side =
        mesh_.mesh().vertices[index(corner[1])] - mesh_.mesh().vertices[index(corner[0])];
    const Vector3 flat = side - normal_ * normal_.dot(side);
    return flat.norm() > 0.0 ? Vector3(flat.normalized()) : any_orthogonal(normal_);
  }

  void look_around(const Vector3& first) {
    const Vector3 second = normal_.cross(first);
    for (std::size_t k = 0; k < kDirections; ++k) {
      const double angle = 0.25 * std::numbers::pi * static_cast<double>(k);
      direction_[k] = std::cos(angle) * first + std::sin(angle) * second;
      exit_[k] = ray(middle_, direction_[k], limits_.around);
    }
  }

  // From surface to surface along a direction, through the middle.
  double through(std::size_t k) const {
    return exit_[k].distance + exit_[(k + kDirections / 2) % kDirections].distance;
  }

  std::optional<ThinSpot> bar_here() const {
    std::size_t narrow = 0;
    for (std::size_t k = 1; k < kDirections / 2; ++k) {
      if (through(k) < through(narrow)) narrow = k;
    }
    const std::size_t along = (narrow + kDirections / 4) % kDirections;
    const Exit& one = exit_[narrow];
    const Exit& other = exit_[narrow + kDirections / 2];
    const double width = std::max(width_, through(narrow));
    if (width > limits_.bar || through(narrow) > kFlatBar * width_) return std::nullopt;
    if (std::min(one.facing, other.facing) < kNotGrazed) return std::nullopt;
    if (through(along) < kLongBar * width) return std::nullopt;
    const Vector3 center = middle_ + 0.5 * (one.distance - other.distance) * direction_[narrow];
    return ThinSpot{center, direction_[along], Vector3::Zero(), width, 0.0};
  }

  // A place in the middle of a wall.
  struct InWall {
    Vector3 p = Vector3::Zero();
    Vector3 normal = Vector3::Zero();
    double width = 0.0;
  };

  // The middle of the wall below a point of its surface.
  std::optional<InWall> below(const Vector3& p, const Vector3& normal) const {
    const Exit opposite = ray(p - aside_ * normal, -normal, limits_.wall);
    if (opposite.facing < kOpposite || opposite.distance < aside_) return std::nullopt;
    const double width = opposite.distance + aside_;
    return InWall{p - 0.5 * width * normal, normal, width};
  }

  // Where a way through the wall that began with a ray along `direction` leaves it over its edge.
  struct Way {
    InWall last;  // the ray that leaves begins here
    Vector3 direction = Vector3::Zero();
    Exit exit;
    double length = std::numeric_limits<double>::infinity();
  };

  // A straight ray leaves a bent wall over its side: from there the way goes on in the middle of
  // the wall.
  std::optional<Way> way_to_edge(std::size_t k) const {
    constexpr int kMostBends = 8;
    Way way{{middle_, normal_, width_}, direction_[k], exit_[k], exit_[k].distance};
    for (int bend = 0; bend < kMostBends && way.length <= limits_.reach; ++bend) {
      if (way.exit.facing >= kEdgeFace) return way;
      const Vector3 at = way.last.p + way.exit.distance * way.direction;
      const auto inside = below(at, way.exit.normal);
      if (!inside) return std::nullopt;
      way.last = *inside;
      const Vector3 flat = way.direction - inside->normal * inside->normal.dot(way.direction);
      if (!(flat.norm() > 0.0)) return std::nullopt;
      way.direction = flat.normalized();
      way.exit = ray(way.last.p, way.direction, limits_.reach);
      way.length += way.exit.distance;
    }
    return std::nullopt;
  }

  // The nearest edge: a face across the wall that closes it.
  std::optional<ThinSpot> edge_near() const {
    std::optional<Way> nearest;
    double behind = 0.0;  // how far the wall goes on the other way
    for (std::size_t k = 0; k < kDirections; ++k) {
      const auto way = way_to_edge(k);
      if (!way || (nearest && way->length >= nearest->length)) continue;
      nearest = way;
      behind = exit_[(k + kDirections / 2) % kDirections].distance;
    }
    if (!nearest) return std::nullopt;
    const InWall& wall = nearest->last;
    const Vector3& normal = nearest->exit.normal;
    const Vector3 flat = normal - wall.normal * wall.normal.dot(normal);
    if (!(flat.norm() > 0.0)) return std::nullopt;
    const Vector3 out = flat.normalized();
    const Exit edge = ray(wall.p, out, limits_.reach);
    if (edge.facing < kEdgeFace) return std::nullopt;
    const double depth = std::min(nearest->length + behind, limits_.around);
    if (depth < kLeastDepth * wall.width) return std::nullopt;
    const ThinSpot spot{wall.p + edge.distance * out, -out, wall.normal, wall.width, depth};
    return has_room(spot, wall) ? std::optional(spot) : std::nullopt;
  }

  // For a hand ahead of the edge, and for fingers on both sides of the wall, which come from there:
  // the edge of the bottom of a cup has none, because its wall is in the way.
  bool has_room(const ThinSpot& spot, const InWall& wall) const {
    const Vector3 half = 0.5 * wall.width * wall.normal;
    const Vector3 beside = half + 0.75 * limits_.free_beside * wall.normal;
    const double length = limits_.free_ahead + (spot.p - wall.p).norm();
    return is_free(spot.p, -spot.into, limits_.free_ahead) &&
           is_free(wall.p + half, wall.normal, limits_.free_beside) &&
           is_free(wall.p - half, -wall.normal, limits_.free_beside) &&
           is_free(wall.p + beside, -spot.into, length) &&
           is_free(wall.p - beside, -spot.into, length);
  }

  const ProximityMesh& mesh_;
  const ThinLimits& limits_;
  double aside_ = 0.0;
  double width_ = 0.0;
  Vector3 normal_ = Vector3::Zero();
  Vector3 middle_ = Vector3::Zero();
  std::array<Vector3, kDirections> direction_;
  std::array<Exit, kDirections> exit_;
};

}  // namespace

ThinSpots find_thin_spots(const ProximityMesh& mesh, const std::vector<SurfacePoint>& points,
                          const ThinLimits& limits, const RunContext& context) {
  constexpr std::size_t kTogether = 32;
  std::vector<std::optional<ThinSpot>> walls(points.size());
  std::vector<std::optional<ThinSpot>> bars(points.size());
  for_each_in_parallel((points.size() + kTogether - 1) / kTogether, context.threads,
                       [&](std::size_t group) {
                         context.cancellation.check();
                         Probe probe(mesh, limits);
                         const std::size_t end = std::min(points.size(), (group + 1) * kTogether);
                         for (std::size_t i = group * kTogether; i < end; ++i) {
                           probe.at(points[i], walls[i], bars[i]);
                         }
                       });
  ThinSpots spots;
  for (const auto& wall : walls) {
    if (wall) spots.walls.push_back(*wall);
  }
  for (const auto& bar : bars) {
    if (bar) spots.bars.push_back(*bar);
  }
  return spots;
}

}  // namespace prehend
