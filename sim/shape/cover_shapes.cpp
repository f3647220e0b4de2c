#include "sim/shape/cover_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "sim/base/disjoint_sets.h"
#include "sim/base/index.h"
#include "sim/shape/box_tree.h"
#include "sim/shape/nearest_point.h"
#include "sim/shape/proximity.h"

namespace prehend {
namespace {

// Components get a shape each where there are not more of them than this, and the shapes have at
// most this multiple of their volume.
constexpr std::size_t kMostComponents = 24;
constexpr double kLoosest = 2.0;
// A component gets several shapes, up to so many, where one has more than this multiple of its
// volume and where each cut saves this part of the shape's volume. Not one of very many triangles.
constexpr double kTight = 1.05;
constexpr double kSavedByCut = 0.05;
constexpr std::size_t kMostShapes = 6;
constexpr std::size_t kMostCut = 1000;
// A cylinder or a capsule is tried where its surface is this much as wide along one axis as along
// the other, at least.
constexpr double kRoundest = 0.85;
// Boxes around parts of a surface.
constexpr std::size_t kSurfaceBoxes = 16;
// Directions that are tried for the axes of a shape, besides those of the mesh.
constexpr std::size_t kMostDirections = 5;
// Shapes are grown by this part of the size of the mesh, for rounding.
constexpr double kShapeRounding = 1e-9;
// Components of more triangles are not tested for being convex.
constexpr std::size_t kMostPlanes = 500;
// Balls inside: how many are tried and taken, and by which part of the mesh's radius they are grown
// for what counts as filled by them.
constexpr std::size_t kMostPoints = 120;
constexpr std::size_t kMostTried = 12;
constexpr std::size_t kMostInside = 12;
constexpr int kMostAlong = 4;             // balls side by side in a shape
constexpr std::size_t kMostCorners = 24;  // corners
constexpr double kFilledBeside = 0.12;

struct Component {
  std::vector<Vector3> points;
  std::vector<int> triangles;
  double volume = 0.0;  // that it bounds
};

std::vector<Component> components_of(const TriangleMesh& mesh) {
  DisjointSets sets(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles) {
    sets.merge(index(t[0]), index(t[1]));
    sets.merge(index(t[0]), index(t[2]));
  }
  std::map<std::size_t, Component> components;
  std::vector<std::uint8_t> known(mesh.vertices.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Component& component = components[sets.find(index(mesh.triangles[t][0]))];
    component.triangles.push_back(static_cast<int>(t));
    for (const int v : mesh.triangles[t]) {
      if (known[index(v)] == 0) component.points.push_back(mesh.vertices[index(v)]);
      known[index(v)] = 1;
    }
  }
  std::vector<Component> result;
  for (auto& [root, component] : components) {
    for (const int t : component.triangles) {
      const Corners c = corners_of(mesh, t);
      component.volume += (c[0] - component.points[0])
                              .dot((c[1] - component.points[0]).cross(c[2] - component.points[0])) /
                          6.0;
    }
    result.push_back(std::move(component));
  }
  return result;
}

// Directions that may be axes of a shape around the component: those of the mesh, and normals of
// its largest triangles with their cross products (the axis of a cylinder is orthogonal to two
// normals of its side).
std::vector<Vector3> axes_of(const TriangleMesh& mesh, const Component& component) {
  std::vector<Vector3> axes = {Vector3::UnitZ(), Vector3::UnitX(), Vector3::UnitY()};
  const auto add = [&](const Vector3& direction) {
    if (axes.size() >= 3 + kMostDirections || direction.norm() < 1e-3) return;
    const Vector3 axis = direction.normalized();
    for (const Vector3& other : axes) {
      if (std::abs(other.dot(axis)) > 1.0 - 1e-6) return;
    }
    axes.push_back(axis);
  };
  std::vector<std::pair<double, int>> areas;
  for (const int t : component.triangles) {
    areas.emplace_back(-doubled_area_vector(mesh, static_cast<std::size_t>(t)).norm(), t);
  }
  const auto last = areas.begin() + static_cast<std::ptrdiff_t>(
                                        std::min<std::size_t>(areas.size(), kMostDirections));
  std::partial_sort(areas.begin(), last, areas.end());
  std::vector<Vector3> normals;
  for (auto at = areas.begin(); at != last; ++at) {
    const Vector3 normal = doubled_area_vector(mesh, index(at->second));
    if (normal.norm() > 0.0) normals.push_back(normal.normalized());
  }
  for (std::size_t i = 1; i < normals.size(); ++i) add(normals[0].cross(normals[i]));
  for (const Vector3& normal : normals) add(normal);
  return axes;
}

// The smallest shape around points that was found.
class SmallestShape {
 public:
  explicit SmallestShape(const std::vector<Vector3>& points) : points_(points) {}

  // Tries a box, a cylinder and a capsule with this frame's directions.
  void offer(const Matrix3& axes) {
    Bounds box;
    for (const Vector3& p : points_) {
      const Vector3 q = axes.transpose() * p;
      box.lower = box.lower.cwiseMin(q);
      box.upper = box.upper.cwiseMax(q);
    }
    const Vector3 half = 0.5 * box.size();
    const Pose X_MS = pose_from(axes, axes * box.center());
    take({X_MS, half}, 8.0 * half.prod());
    // What is round about z is as wide along x as along y.
    const double wide = std::max(half.x(), half.y());
    if (std::min(half.x(), half.y()) < kRoundest * wide) return;
    double disc = 0.0;
    for (const Vector3& p : points_) disc = std::max(disc, from_axis(box, axes.transpose() * p));
    const double around = std::numbers::pi * disc * disc;
    take({X_MS, {0.0, 0.0, half.z()}, disc}, around * 2.0 * half.z());
    double length = 0.0;
    for (const Vector3& p : points_) {
      const Vector3 q = axes.transpose() * p;
      const double beside = from_axis(box, q);
      const double height = std::sqrt(std::max(0.0, disc * disc - beside * beside));
      length = std::max(length, std::abs(q.z() - box.center().z()) - height);
    }
    take({X_MS, {0.0, 0.0, length}, 0.0, disc}, around * (2.0 * length + 4.0 / 3.0 * disc));
  }

  const CoverShape& shape() const { return shape_; }
  double volume() const { return volume_; }

 private:
  static double from_axis(const Bounds& box, const Vector3& q) {
    return (q - box.center()).head<2>().norm();
  }
  void take(const CoverShape& shape, double volume) {
    if (volume >= volume_ * (1.0 - 1e-6)) return;
    shape_ = shape;
    volume_ = volume;
  }

  const std::vector<Vector3>& points_;
  CoverShape shape_;
  double volume_ = std::numeric_limits<double>::infinity();
};

// `axes`: directions for its axes.
SmallestShape shape_around(const std::vector<Vector3>& points, const std::vector<Vector3>& axes) {
  SmallestShape smallest(points);
  for (const Vector3& z : axes) {
    int tried = 0;
    for (const Vector3& x : axes) {
      if (tried == 2 || std::abs(x.dot(z)) > 1e-3) continue;
      ++tried;
      const Vector3 across = (x - x.dot(z) * z).normalized();
      Matrix3 frame;
      frame << across, z.cross(across), z;
      smallest.offer(frame);
    }
    if (tried > 0) continue;
    const Vector3 across = any_orthogonal(z);
    Matrix3 frame;
    frame << across, z.cross(across), z;
    smallest.offer(frame);
  }
  return smallest;
}

// Adds the part of a triangle below the plane normal . p = height to `below`, the rest to `above`.
void cut(const Corners& corners, const Vector3& normal, double height, std::vector<Corners>& below,
         std::vector<Corners>& above) {
  std::vector<Vector3> low;
  std::vector<Vector3> high;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3& p = corners[k];
    const Vector3& q = corners[(k + 1) % 3];
    const double over_p = normal.dot(p) - height;
    const double over_q = normal.dot(q) - height;
    (over_p < 0.0 ? low : high).push_back(p);
    if ((over_p < 0.0) == (over_q < 0.0)) continue;
    const Vector3 on = p + over_p / (over_p - over_q) * (q - p);
    low.push_back(on);
    high.push_back(on);
  }
  const auto add = [](const std::vector<Vector3>& polygon, std::vector<Corners>& parts) {
    for (std::size_t k = 2; k < polygon.size(); ++k)
      parts.push_back({polygon[0], polygon[k - 1], polygon[k]});
  };
  add(low, below);
  add(high, above);
}

// A surface and the shape around it.
struct CoveredPart {
  std::vector<Corners> triangles;
  CoverShape shape;
  double volume = 0.0;  // of the shape
};

CoveredPart covered_part(std::vector<Corners> triangles, const std::vector<Vector3>& axes) {
  std::vector<Vector3> points;
  for (const Corners& corners : triangles)
    points.insert(points.end(), corners.begin(), corners.end());
  const SmallestShape smallest = shape_around(points, axes);
  return {std::move(triangles), smallest.shape(), smallest.volume()};
}

// The two halves of a part, cut across an axis of its shape, whose shapes are smallest together;
// none where that saves little.
std::optional<std::array<CoveredPart, 2>> halves_of(const CoveredPart& part) {
  const Matrix3 frame = part.shape.X_MS.linear();
  const std::vector<Vector3> axes = {frame.col(2), frame.col(0), frame.col(1)};
  std::optional<std::array<CoveredPart, 2>> best;
  double least = (1.0 - kSavedByCut) * part.volume;
  for (int k = 0; k < 3; ++k) {
    const Vector3 normal = part.shape.X_MS.linear().col(k);
    std::vector<Corners> below;
    std::vector<Corners> above;
    for (const Corners& corners : part.triangles)
      cut(corners, normal, normal.dot(part.shape.X_MS.translation()), below, above);
    if (below.empty() || above.empty()) continue;
    std::array<CoveredPart, 2> halves{covered_part(std::move(below), axes),
                                      covered_part(std::move(above), axes)};
    if (halves[0].volume + halves[1].volume >= least) continue;
    least = halves[0].volume + halves[1].volume;
    best = std::move(halves);
  }
  return best;
}

// Shapes around a component: one, or several where these are much smaller together.
std::vector<CoveredPart> parts_around(const TriangleMesh& mesh, const Component& component) {
  const std::vector<Vector3> axes = axes_of(mesh, component);
  std::vector<Corners> triangles;
  for (const int t : component.triangles) triangles.push_back(corners_of(mesh, t));
  std::vector<CoveredPart> parts = {covered_part(std::move(triangles), axes)};
  if (component.triangles.size() > kMostCut) return parts;
  double volume = parts.front().volume;
  for (std::size_t i = 0; i < parts.size() && parts.size() < kMostShapes;) {
    if (volume <= kTight * component.volume) break;
    auto halves = halves_of(parts[i]);
    if (!halves) {
      ++i;
      continue;
    }
    volume += (*halves)[0].volume + (*halves)[1].volume - parts[i].volume;
    parts[i] = std::move((*halves)[0]);
    parts.push_back(std::move((*halves)[1]));
  }
  return parts;
}

// By how much a shape may be scaled about its centre to lie in a component, if that is convex: as
// far as it stays below the planes of all triangles. 0 where the component is not convex.
double inner_scale(const TriangleMesh& mesh, const Component& component, const CoverShape& shape) {
  if (component.volume <= 0.0 || component.triangles.size() > kMostPlanes) return 0.0;
  const Vector3 center = shape.X_MS.translation();
  double scale = 1.0;
  for (const int t : component.triangles) {
    const Vector3 area = doubled_area_vector(mesh, index(t));
    if (area.norm() <= 0.0) continue;
    const Vector3 normal = area.normalized();
    const double height = normal.dot(corners_of(mesh, t)[0]);
    for (const Vector3& p : component.points) {
      if (normal.dot(p) > height + 1e-6 * (shape.half.norm() + shape.disc + shape.ball)) return 0.0;
    }
    const double reach = shape.extent(shape.X_MS.linear().transpose() * normal);
    scale = std::min(scale, (height - normal.dot(center)) / reach);
  }
  return std::max(0.0, scale);
}

// Boxes around parts of the surface: the tree's root, of which the largest is opened again and
// again.
std::vector<CoverShape> surface_boxes(const std::vector<BoxNode>& tree) {
  std::vector<std::size_t> open = {0};
  while (open.size() < kSurfaceBoxes) {
    const auto largest = std::max_element(open.begin(), open.end(), [&](auto a, auto b) {
      const auto size = [&](std::size_t n) {
        return tree[n].is_leaf() ? -1.0 : tree[n].half.squaredNorm();
      };
      return size(a) < size(b);
    });
    if (tree[*largest].is_leaf()) break;
    const std::size_t left = index(tree[*largest].left);
    *largest = left;
    open.push_back(left + 1);
  }
  std::vector<CoverShape> shapes;
  for (const std::size_t n : open) shapes.push_back({translation(tree[n].center), tree[n].half});
  return shapes;
}

// A point of the surface and the outward unit normal there.
struct SurfacePoint {
  Vector3 p = Vector3::Zero();
  Vector3 normal = Vector3::Zero();
};

// The centre of a ball that touches the surface from within at `from` and has none of the points in
// it: from a ball that is too large, the one through the nearest point, and so on (shrinking balls:
// Ma, Bae and Choi 2012, "3D medial axis point approximation using nearest neighbors and the normal
// field").
std::optional<Vector3> touching_ball(const std::vector<SurfacePoint>& points,
                                     const SurfacePoint& from, double largest) {
  double radius = largest;
  for (int k = 0; k < 30; ++k) {
    const Vector3 center = from.p - radius * from.normal;
    double nearest = std::numeric_limits<double>::infinity();
    Vector3 to = Vector3::Zero();
    for (const SurfacePoint& point : points) {
      const double squared = (point.p - center).squaredNorm();
      if (squared >= nearest) continue;
      nearest = squared;
      to = from.p - point.p;
    }
    if (std::sqrt(nearest) >= radius * (1.0 - 1e-6)) return center;
    const double along = from.normal.dot(to);
    if (along <= 0.0) return std::nullopt;
    radius = to.squaredNorm() / (2.0 * along);
  }
  return std::nullopt;
}

double distance_from_surface(const TriangleMesh& mesh, const Vector3& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3 q = nearest_point_on(corners_of(mesh, static_cast<int>(t)), p);
    nearest = std::min(nearest, (q - p).squaredNorm());
  }
  return std::sqrt(nearest);
}

// Points of a component's triangles: their middles and one near each corner. Of many triangles,
// only some.
std::vector<SurfacePoint> points_on(const TriangleMesh& mesh, const std::vector<int>& triangles) {
  std::vector<SurfacePoint> points;
  const bool many = triangles.size() > kMostPoints / 4;
  for (std::size_t i = 0; i < triangles.size(); i += 1 + triangles.size() / kMostPoints) {
    const Vector3 area = doubled_area_vector(mesh, index(triangles[i]));
    if (area.norm() <= 0.0) continue;
    const Vector3 normal = area.normalized();
    const Corners c = corners_of(mesh, triangles[i]);
    const Vector3 middle = (c[0] + c[1] + c[2]) / 3.0;
    points.push_back({middle, normal});
    if (many) continue;
    for (const Vector3& corner : c) points.push_back({0.3 * middle + 0.7 * corner, normal});
  }
  return points;
}

// How large a ball around `center` is inside of a component: as far as the centre is below the
// planes of all of its triangles. (What is below all planes of a closed surface is inside of it.)
// Else, where the component is not convex, as far as the centre is from the whole surface.
double radius_inside(const ProximityMesh& of, const std::vector<int>& triangles,
                     const Vector3& center) {
  double below = std::numeric_limits<double>::infinity();
  for (const int t : triangles) {
    const Vector3 area = doubled_area_vector(of.mesh(), index(t));
    if (area.norm() <= 0.0) continue;
    below = std::min(below, area.normalized().dot(corners_of(of.mesh(), t)[0] - center));
  }
  if (below <= 0.0 && is_inside(of, center)) below = distance_from_surface(of.mesh(), center);
  return below * (1.0 - kShapeRounding);
}

// Balls in the part of a shape that lies in the solid, side by side along its longer axes.
void fill_shape(const CoverShape& shape, std::vector<InnerBall>& balls) {
  const Vector3 size = shape.inside * (shape.half + Vector3(shape.disc, shape.disc, 0.0) +
                                       Vector3::Constant(shape.ball));
  const double radius = size.minCoeff();
  // A grid about the centre that stays within the disc, where there is one.
  std::array<int, 3> count{};
  for (int k = 0; k < 3; ++k) {
    const bool in_disc = shape.disc > 0.0 && k < 2;
    count[index(k)] =
        in_disc ? 1
                : std::min(kMostAlong, 1 + static_cast<int>(std::lround(size[k] / radius - 1.0)));
  }
  for (int i = 0; i < count[0]; ++i) {
    for (int j = 0; j < count[1]; ++j) {
      for (int k = 0; k < count[2]; ++k) {
        const Vector3 at(i, j, k);
        Vector3 p_S = Vector3::Zero();
        for (int d = 0; d < 3; ++d) {
          if (count[index(d)] == 1) continue;
          p_S[d] = (size[d] - radius) * (2.0 * at[d] / (count[index(d)] - 1) - 1.0);
        }
        balls.push_back({shape.X_MS * p_S, radius * (1.0 - kShapeRounding)});
      }
    }
  }
}

// Balls inside that fill much of the mesh: of many, each time the one that comes near most points
// of the surface that no other came near.
std::vector<InnerBall> balls_inside(const ProximityMesh& of,
                                    const std::vector<Component>& components) {
  std::vector<SurfacePoint> left;
  std::vector<InnerBall> balls;
  for (const Component& component : components) {
    const std::vector<SurfacePoint> points = points_on(of.mesh(), component.triangles);
    left.insert(left.end(), points.begin(), points.end());
    if (component.volume <= 0.0) continue;
    for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / kMostTried) {
      const auto center = touching_ball(points, points[i], 2.0 * of.ball_radius());
      if (!center) continue;
      const double radius = radius_inside(of, component.triangles, *center);
      if (radius > 0.0) balls.push_back({*center, radius});
    }
  }
  const double reach = kFilledBeside * of.ball_radius();
  std::vector<InnerBall> taken;
  while (taken.size() < kMostInside) {
    const auto is_near = [&](const InnerBall& ball, const SurfacePoint& point) {
      return (point.p - ball.center).norm() <= ball.radius + reach;
    };
    std::ptrdiff_t most = 0;
    std::size_t best = 0;
    for (std::size_t b = 0; b < balls.size(); ++b) {
      const auto near = std::count_if(left.begin(), left.end(),
                                      [&](const auto& point) { return is_near(balls[b], point); });
      if (near <= most) continue;
      most = near;
      best = b;
    }
    if (most == 0) break;
    taken.push_back(balls[best]);
    std::erase_if(left, [&](const auto& point) { return is_near(taken.back(), point); });
  }
  return taken;
}

// Corners that are far from each other: each the farthest from those before it.
std::vector<InnerBall> spread_corners(const std::vector<Component>& components) {
  std::vector<Vector3> points;
  for (const Component& component : components)
    points.insert(points.end(), component.points.begin(), component.points.end());
  std::vector<double> distance(points.size(), std::numeric_limits<double>::infinity());
  std::vector<InnerBall> corners;
  std::size_t next = 0;
  while (corners.size() < std::min(kMostCorners, points.size())) {
    corners.push_back({points[next], 0.0});
    for (std::size_t i = 0; i < points.size(); ++i)
      distance[i] = std::min(distance[i], (points[i] - points[next]).squaredNorm());
    next = static_cast<std::size_t>(std::max_element(distance.begin(), distance.end()) -
                                    distance.begin());
  }
  return corners;
}

}  // namespace

double CoverShape::extent(const Vector3& n_S) const {
  return n_S.cwiseAbs().dot(half) + disc * std::hypot(n_S.x(), n_S.y()) + ball;
}

ShapeCover make_cover(const ProximityMesh& mesh, const std::vector<BoxNode>& tree) {
  ShapeCover cover;
  const std::vector<Component> components = components_of(mesh.mesh());
  double filled = 0.0;
  double volume = 0.0;
  std::vector<std::uint8_t> is_filled;  // by component: whether a part of a shape is solid
  if (components.size() <= kMostComponents) {
    for (const Component& component : components) {
      filled += component.volume;
      is_filled.push_back(0);
      for (const CoveredPart& part : parts_around(mesh.mesh(), component)) {
        cover.shapes.push_back(part.shape);
        cover.shapes.back().inside = inner_scale(mesh.mesh(), component, part.shape);
        volume += part.volume;
        if (cover.shapes.back().inside > 0.0) is_filled.back() = 1;
      }
    }
  }
  if (components.size() > kMostComponents || volume > kLoosest * filled) {
    cover.shapes = surface_boxes(tree);
    is_filled.assign(components.size(), 0);
  }
  for (CoverShape& shape : cover.shapes) {
    const double rounding = kShapeRounding * mesh.ball_radius();
    if (shape.ball > 0.0) {
      shape.ball += rounding;
    } else if (shape.disc > 0.0) {
      shape.disc += rounding;
      shape.half.z() += rounding;
    } else {
      shape.half += Vector3::Constant(rounding);
    }
  }
  std::vector<Component> unfilled;
  for (std::size_t c = 0; c < components.size(); ++c) {
    if (is_filled[c] == 0) unfilled.push_back(components[c]);
  }
  cover.inside = balls_inside(mesh, unfilled);
  for (const CoverShape& shape : cover.shapes) {
    if (shape.inside > 0.0) fill_shape(shape, cover.inside);
  }
  const std::vector<InnerBall> corners = spread_corners(components);
  cover.inside.insert(cover.inside.end(), corners.begin(), corners.end());
  return cover;
}

}  // namespace prehend
