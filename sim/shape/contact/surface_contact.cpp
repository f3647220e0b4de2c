#include "sim/shape/contact/surface_contact.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"
#include "sim/shape/contact/contact_copies.h"
#include "sim/shape/contact/triangle_overlap.h"
#include "sim/shape/triangle_distance.h"

// Every pair of triangles within the threshold is asked for contacts in three ways: points of the
// link's triangle over the face of the object's, points of the object's over the face of the
// link's, and the nearest points of the pair. Points found by mistake, because a pair of triangles
// is only a part of the two surfaces, are rejected by `supports`, which looks at the neighbouring
// triangles on both bodies: a contact is real if both surfaces stay on their sides of the tangent
// plane. The same contact is found by many pairs of triangles (all faces around a vertex, for
// example); the copies are merged at the end.
namespace prehend {
namespace {

// Points nearer than this to an edge or a vertex are on it [m]. A guard against rounding, no choice
// of accuracy: coordinates below a metre are known to 1e-16 m, and distances of meshes are far
// above it.
constexpr double kOnFeature = 1e-7;

double distance_to_segment(const Vector3& p, const Vector3& a, const Vector3& b) {
  const Vector3 ab = b - a;
  const double s = std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
  return (p - a - s * ab).norm();
}

// True when the triangle rises, from its point p, above the plane through p with normal n by an
// angle whose sine exceeds `slope`. One without a normal never does. Only directions that stay in
// the triangle count: all from a point inside, half of them from one on an edge, those between two
// edges from a corner.
bool rises(const PlacedTriangle& triangle, const Vector3& p, const Vector3& n, double slope) {
  const Corners& c = triangle.corner;
  const Vector3& face_normal = triangle.normal;
  // If the sine of the angle between the plane and the triangle is at most `slope`, no direction in
  // the triangle rises more. Compared as squares, since this early exit takes no root and is the
  // usual case. A triangle that faces the other way counts as parallel too.
  const double along_normal = n.dot(face_normal);
  const bool nearly_parallel = along_normal * along_normal >= 1.0 - slope * slope;
  if (nearly_parallel || face_normal.isZero(0.0)) return false;
  const Vector3 uphill = n - n.dot(face_normal) * face_normal;
  // `uphill` is the steepest direction in the triangle's plane, its length the sine of the angle by
  // which it rises. If it stays in the triangle from p on, it is the answer; if it leaves across an
  // edge that p is on, the steepest directions that stay are along the edges at p.
  bool leaves = false;
  double along_edges = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3& a = c[k];
    const Vector3& b = c[(k + 1) % 3];
    if (distance_to_segment(p, a, b) > kOnFeature) continue;
    const Vector3 edge = (b - a).normalized();
    if (uphill.dot(face_normal.cross(edge)) < 0.0) leaves = true;
    // Along the edge one can go forward unless p is at its end b, and back unless p is at a.
    const double forward = uphill.dot(edge);
    if ((p - b).norm() > kOnFeature) along_edges = std::max(along_edges, forward);
    if ((p - a).norm() > kOnFeature) along_edges = std::max(along_edges, -forward);
  }
  return !leaves || along_edges > slope;
}

// True when the surface around p, a point of triangle t, lies below the plane with normal n: around
// a point inside a face that is the face, on an edge the faces of that edge, on a vertex all its
// faces. A contact where this fails has a nearer one beside it (figure 7 of the paper).
bool supports(const ProximityMesh& body, int t, const Vector3& p, const Vector3& n, double slope) {
  const TriangleMesh& mesh = body.mesh();
  const std::vector<PlacedTriangle>& triangles = body.triangles();
  const auto is_below = [&](int u) { return !rises(triangles[index(u)], p, n, slope); };
  if (!is_below(t)) return false;
  const Triangle& v = mesh.triangles[index(t)];
  for (int vk : v) {
    if ((p - mesh.vertices[index(vk)]).norm() > kOnFeature) continue;
    const auto around = body.triangles_at(vk);
    return std::all_of(around.begin(), around.end(), is_below);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const int va = v[k];
    const int vb = v[(k + 1) % 3];
    if (distance_to_segment(p, mesh.vertices[index(va)], mesh.vertices[index(vb)]) > kOnFeature) {
      continue;
    }
    for (int u : body.triangles_at(va)) {
      const Triangle& w = mesh.triangles[index(u)];
      const bool shares_edge = std::find(w.begin(), w.end(), vb) != w.end();
      if (shares_edge && !is_below(u)) return false;
    }
  }
  return true;
}

// Whether the segment ab passes through the triangle or its border: where it meets an edge between
// two triangles, rounding must not find it outside of both.
bool passes_through(const Vector3& a, const Vector3& b, const Corners& c) {
  const Vector3 area = (c[1] - c[0]).cross(c[2] - c[0]);
  const double above = (a - c[0]).dot(area);
  const double below = (b - c[0]).dot(area);
  if (above * below >= 0.0) return false;
  const Vector3 p = a + (above / (above - below)) * (b - a);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 edge = c[(k + 1) % 3] - c[k];
    // Twice an area: how far inside of the edge, times its length and the normal's.
    const double inside = area.dot(edge.cross(p - c[k]));
    if (inside < -kOnFeature * edge.norm() * area.norm()) return false;
  }
  return true;
}

// Mixes a number into a hash: a multiplication by the golden ratio (Knuth, The Art of Computer
// Programming 3, section 6.4) spreads it, and the upper half is folded down.
std::uint64_t mixed(std::uint64_t hash, std::int64_t number) {
  hash = (hash ^ static_cast<std::uint64_t>(number)) * 0x9E3779B97F4A7C15U;
  return hash ^ (hash >> 29);
}

// As std::llround, up to rounding of halves, without a call.
std::int64_t rounded(double number) {
  return static_cast<std::int64_t>(number + std::copysign(0.5, number));
}

// Collects the contacts of pairs of triangles, one of the object and one of the link.
class PairContacts {
 public:
  PairContacts(const ProximityMesh& object, const ProximityMesh& link, const Pose& X_OL,
               const ContactOptions& options, ContactWorkspace& workspace)
      : object_(object),
        link_(link),
        X_OL_(X_OL),
        X_LO_(X_OL.inverse()),
        options_(options),
        points_(workspace.points),
        tried_(workspace.tried) {}

  void add(const ClosePair& close) {
    const PlacedTriangle& of_object = object_.triangles()[index(close.pair.a)];
    const PlacedTriangle& of_link = link_.triangles()[index(close.pair.b)];
    const Corners on_link = moved(of_link.corner, X_OL_);
    // A triangle without area has no normal; its edges still have nearest points.
    if (!of_object.normal.isZero(0.0)) {
      add_face_points(close.pair, of_object.corner, of_object.normal, on_link, true);
    }
    if (!of_link.normal.isZero(0.0)) {
      add_face_points(close.pair, on_link, X_OL_.linear() * of_link.normal, of_object.corner,
                      false);
    }
    add_nearest_point(close);
  }

 private:
  // Contacts with the normal of `face`, which belongs to the object or to the link.
  void add_face_points(TrianglePair pair, const Corners& face, const Vector3& face_normal,
                       const Corners& other, bool face_is_objects) {
    // The part of the other triangle above the face is a polygon, and its distance from the face is
    // linear, so that the nearest points are among its corners.
    const Polygon polygon = over_face(face, face_normal, other);
    double lowest = options_.threshold;
    for (std::size_t i = 0; i < polygon.size; ++i) {
      lowest = std::min(lowest, (polygon.corner[i] - face[0]).dot(face_normal));
    }
    if (lowest < 0.0) return;  // the other triangle reaches behind the face
    // All corners that are as low as the lowest, up to the evenness: a face lying flat on the other
    // has several.
    const double limit = std::min(options_.threshold, lowest + options_.evenness);
    for (std::size_t i = 0; i < polygon.size; ++i) {
      const Vector3& p = polygon.corner[i];
      const double height = (p - face[0]).dot(face_normal);
      if (height > limit) continue;
      const Vector3 foot = p - height * face_normal;
      if (face_is_objects) {
        add_if_supported(pair, foot, p, -face_normal, height);
      } else {
        add_if_supported(pair, p, foot, face_normal, height);
      }
    }
  }

  // Edge and vertex contacts: the nearest points and the direction between them.
  void add_nearest_point(const ClosePair& close) {
    if (close.distance <= kOnFeature) return;  // too near for a reliable direction
    const Vector3 normal = (close.on_a_A - close.on_b_A) / close.distance;
    add_if_supported(close.pair, close.on_a_A, close.on_b_A, normal, close.distance);
  }

  // Both points in O; `normal` from the link into the object.
  void add_if_supported(TrianglePair pair, const Vector3& on_object, const Vector3& on_link,
                        const Vector3& normal, double gap) {
    if (!tried_.insert(on_object, normal, gap)) return;
    const double slope = options_.angular_tolerance;
    if (!supports(object_, pair.a, on_object, -normal, slope)) return;
    if (!supports(link_, pair.b, X_LO_ * on_link, X_LO_.linear() * normal, slope)) return;
    points_.push_back({on_object, normal, gap, pair});
  }

  const ProximityMesh& object_;
  const ProximityMesh& link_;
  const Pose X_OL_;
  const Pose X_LO_;
  const ContactOptions& options_;
  std::vector<SurfaceContact>& points_;
  TriedPoints& tried_;
};

// Nearest first. Ties are decided by position, not by the order of the pairs.
bool nearer(const SurfaceContact& a, const SurfaceContact& b) {
  if (a.gap != b.gap) return a.gap < b.gap;
  return std::lexicographical_compare(a.position.data(), a.position.data() + 3, b.position.data(),
                                      b.position.data() + 3);
}

// Behind a wall that is thinner than the threshold, its far side is within the threshold, too, and
// so may be another wall. Nothing of the object lies between the link and a real contact.
bool is_behind_a_wall(const ProximityMesh& object, const SurfaceContact& contact,
                      std::vector<int>& walls) {
  if (contact.gap <= 3.0 * kOnFeature) return false;
  const Vector3 on_link = contact.position - contact.gap * contact.normal;
  // So far before the contact that the triangles around it, whose borders are widened by
  // kOnFeature, are not taken for a wall.
  const Vector3 before = contact.position - 3.0 * kOnFeature * contact.normal;
  const Vector3 border = Vector3::Constant(10.0 * kOnFeature);
  find_triangles_in(object, {on_link.cwiseMin(before) - border, on_link.cwiseMax(before) + border},
                    walls);
  return std::any_of(walls.begin(), walls.end(), [&](int wall) {
    return passes_through(on_link, before, corners_of(object.mesh(), wall));
  });
}

}  // namespace

void TriedPoints::clear() {
  points_.clear();
  std::fill(places_.begin(), places_.end(), -1);
}

bool TriedPoints::insert(const Vector3& position, const Vector3& normal, double gap) {
  // Points that differ by rounding only are one: lengths count in nanometres, normals in microns
  // of a metre. Those on two sides of a border of this grid are both tried, which costs time only.
  Point point;
  for (int i = 0; i < 3; ++i) {
    point.key[index(i)] = rounded(1e9 * position[i]);
    point.key[index(3 + i)] = rounded(1e6 * normal[i]);
  }
  point.key[6] = rounded(1e9 * gap);
  for (const std::int64_t number : point.key) point.hash = mixed(point.hash, number);
  if (2 * points_.size() >= places_.size()) grow();
  int& place = place_of(point);
  if (place >= 0) return false;
  place = static_cast<int>(points_.size());
  points_.push_back(point);
  return true;
}

int& TriedPoints::place_of(const Point& point) {
  const std::size_t mask = places_.size() - 1;
  std::size_t at = point.hash & mask;
  while (places_[at] >= 0 && points_[index(places_[at])].key != point.key) at = (at + 1) & mask;
  return places_[at];
}

void TriedPoints::grow() {
  places_.assign(std::max<std::size_t>(64, 4 * places_.size()), -1);
  for (std::size_t i = 0; i < points_.size(); ++i) place_of(points_[i]) = static_cast<int>(i);
}

void find_contact_points(const ProximityMesh& object, const ProximityMesh& link, const Pose& X_OL,
                         const ContactOptions& options, ContactWorkspace& workspace,
                         std::vector<SurfaceContact>& points) {
  find_pairs_within(object, link, X_OL, options.threshold, workspace.pairs);
  workspace.points.clear();
  workspace.tried.clear();
  PairContacts contacts(object, link, X_OL, options, workspace);
  for (const ClosePair& close : workspace.pairs) contacts.add(close);
  // The nearest of several copies comes first and is the one that stays.
  std::sort(workspace.points.begin(), workspace.points.end(), nearer);
  first_copies(workspace.points, options, workspace.copies, points);
  std::erase_if(points, [&](const SurfaceContact& contact) {
    return is_behind_a_wall(object, contact, workspace.walls);
  });
}

}  // namespace prehend
