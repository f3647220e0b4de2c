// Quickhull in three dimensions (Barber, Dobkin and Huhdanpaa 1996).
//
// The hull starts as a tetrahedron of points far from each other. Every face keeps the list of
// points above its plane that no earlier face has taken; a point in no list is inside. One step
// takes the point of a list that is farthest above its face, finds all faces that this point sees,
// and replaces them by a cone of triangles from the border of the visible region (the horizon) to
// the point. The lists of the removed faces are distributed over the new faces. The hull is
// complete when all lists are empty.
//
// Distances below the tolerance count as 0, so that nearly coplanar points do not produce faces
// whose orientation is decided by rounding. A point that would still break the topology is left
// out: the hull is then too small by about the tolerance, but always closed.
#include "sim/shape/convex_hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace prehend {
namespace {

// A triangle of the hull, counter-clockwise seen from outside. Replaced faces are marked dead and
// stay in the list, so that indices remain valid.
struct Face {
  Triangle corner{};
  Triangle neighbour{};  // across the side from corner k to corner k + 1
  Vector3 normal = Vector3::Zero();
  // Plane: normal . p = offset.
  double offset = 0.0;
  std::vector<int> outside;  // points above this face and no earlier one
  bool alive = true;
};

class Quickhull {
 public:
  explicit Quickhull(const std::vector<Vector3>& points) : points_(points) {}

  TriangleMesh run() {
    std::array<int, 4> simplex{};
    if (!find_simplex(simplex)) return {};
    start(simplex);
    // New faces come at the end, so one pass sees every face that ever has points above it.
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      while (faces_[f].alive && !faces_[f].outside.empty()) grow(static_cast<int>(f));
    }
    TriangleMesh mesh;
    std::vector<int> place(points_.size(), -1);
    for (const Face& face : faces_) {
      if (!face.alive) continue;
      Triangle t = face.corner;
      for (int& v : t) {
        int& at = place[static_cast<std::size_t>(v)];
        if (at < 0) {
          at = static_cast<int>(mesh.vertices.size());
          mesh.vertices.push_back(point(v));
        }
        v = at;
      }
      mesh.triangles.push_back(t);
    }
    return mesh;
  }

 private:
  const Vector3& point(int i) const { return points_[static_cast<std::size_t>(i)]; }
  Face& face(int f) { return faces_[static_cast<std::size_t>(f)]; }

  template <typename Measure>
  int farthest(Measure measure) const {
    int best = 0;
    for (int i = 1; i < static_cast<int>(points_.size()); ++i) {
      if (measure(point(i)) > measure(point(best))) best = i;
    }
    return best;
  }

  // The corners of the first tetrahedron: two points far apart, the point farthest from their line,
  // and the point farthest from the plane of these three. False when the points are (nearly)
  // coplanar or not finite.
  bool find_simplex(std::array<int, 4>& s) {
    if (points_.size() < 4) return false;
    for (const Vector3& p : points_) {
      if (!p.allFinite()) return false;
    }
    s[0] = farthest([](const Vector3& p) { return p.x(); });
    s[1] = farthest([&](const Vector3& p) { return (p - point(s[0])).squaredNorm(); });
    s[0] = farthest([&](const Vector3& p) { return (p - point(s[1])).squaredNorm(); });
    const double extent = (point(s[1]) - point(s[0])).norm();
    if (!(extent > 0.0)) return false;
    // Both thresholds are relative to the size of the points. A first tetrahedron thinner than
    // `flat` would have faces with unreliable normals.
    tolerance_ = 1e-9 * extent;
    const double flat = 1e-6 * extent;
    const Vector3 along = (point(s[1]) - point(s[0])) / extent;
    s[2] = farthest([&](const Vector3& p) { return (p - point(s[0])).cross(along).squaredNorm(); });
    const Vector3 across = (point(s[2]) - point(s[0])).cross(along);
    if (!(across.norm() > flat)) return false;
    const Vector3 up = across.normalized();
    s[3] = farthest([&](const Vector3& p) { return std::abs((p - point(s[0])).dot(up)); });
    const double height = (point(s[3]) - point(s[0])).dot(up);
    if (!(std::abs(height) > flat)) return false;
    const double volume =
        (point(s[1]) - point(s[0])).cross(point(s[2]) - point(s[0])).dot(point(s[3]) - point(s[0]));
    // Negative volume: face s[0], s[1], s[2] has its normal away from s[3], as start() needs it.
    if (volume > 0.0) std::swap(s[0], s[1]);
    return true;
  }

  // Computes the plane of a face from its corners. False when they are collinear.
  bool set_plane(Face& made) const {
    const Vector3& a = point(made.corner[0]);
    const Vector3 normal = (point(made.corner[1]) - a).cross(point(made.corner[2]) - a);
    const double length = normal.norm();
    if (!(length > tolerance_ * tolerance_)) return false;
    made.normal = normal / length;
    made.offset = made.normal.dot(a);
    return true;
  }

  // Signed distance of point i from the plane of a face, positive outside.
  double height(const Face& over, int i) const { return over.normal.dot(point(i)) - over.offset; }

  // Makes the four faces of the tetrahedron and distributes all points over them.
  void start(const std::array<int, 4>& s) {
    const std::array<Triangle, 4> corners{
        {{s[0], s[1], s[2]}, {s[0], s[3], s[1]}, {s[1], s[3], s[2]}, {s[2], s[3], s[0]}}};
    const std::array<Triangle, 4> neighbours{{{1, 2, 3}, {3, 2, 0}, {1, 3, 0}, {2, 1, 0}}};
    for (std::size_t f = 0; f < 4; ++f) {
      Face made;
      made.corner = corners[f];
      made.neighbour = neighbours[f];
      set_plane(made);
      faces_.push_back(std::move(made));
    }
    std::vector<int> all(points_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
    assign(all, 0);
  }

  // Adds each candidate to the list of the first face, from index `first` on, that it lies above.
  // Candidates above none of them are inside the hull and are dropped.
  void assign(const std::vector<int>& candidates, std::size_t first) {
    for (const int i : candidates) {
      for (std::size_t f = first; f < faces_.size(); ++f) {
        if (height(faces_[f], i) <= tolerance_) continue;
        faces_[f].outside.push_back(i);
        break;
      }
    }
  }

  // A directed edge of the horizon, in the direction of the visible face.
  struct Side {
    int from = 0;
    int to = 0;
    int beyond = 0;  // the face across it, which is not visible
  };

  // Finds the faces that point `eye` sees by a search across neighbours that starts at face `seed`,
  // and the horizon: the edges between visible and hidden faces, by their first corner. The visible
  // region of a convex polyhedron is a disc, so the horizon is one closed loop; returns false when
  // rounding makes it anything else.
  bool look(int eye, int seed, std::vector<int>& visible, std::map<int, Side>& ring) {
    std::map<int, bool> sees{{seed, true}};
    visible = {seed};
    std::size_t sides = 0;
    for (std::size_t i = 0; i < visible.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const int next = face(visible[i]).neighbour[k];
        const auto [place, fresh] = sees.try_emplace(next, false);
        if (fresh && height(face(next), eye) > tolerance_) {
          place->second = true;
          visible.push_back(next);
        }
        if (place->second) continue;
        const int from = face(visible[i]).corner[k];
        ring[from] = {from, face(visible[i]).corner[(k + 1) % 3], next};
        ++sides;
      }
    }
    // Follow the loop from corner to corner. It has to return to its start after all edges, and no
    // corner may start two edges (then `ring` holds fewer entries than there are sides).
    std::size_t walked = 0;
    const int first = ring.begin()->first;
    int at = first;
    do {
      const auto side = ring.find(at);
      if (side == ring.end()) return false;
      at = side->second.to;
      ++walked;
    } while (at != first && walked <= sides);
    return walked == sides && sides == ring.size();
  }

  // One step: takes the farthest point above face `seed` into the hull and replaces the faces it
  // sees by a cone. When that fails, the point is left out and the hull is unchanged.
  void grow(int seed) {
    std::vector<int>& above = face(seed).outside;
    const auto top = std::max_element(above.begin(), above.end(), [&](int a, int b) {
      return height(face(seed), a) < height(face(seed), b);
    });
    const int eye = *top;
    above.erase(top);

    std::vector<int> visible;
    std::map<int, Side> ring;
    if (!look(eye, seed, visible, ring)) return;
    std::vector<Face> cone;
    std::map<int, int> face_from;  // the new face whose side starts at a ring corner
    const int first = static_cast<int>(faces_.size());
    int at = ring.begin()->first;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Side& side = ring.at(at);
      Face made;
      made.corner = {side.from, side.to, eye};
      made.neighbour = {side.beyond, -1, -1};
      // Collinear with an edge of the horizon: the face would have no area and no normal, and the
      // point adds next to nothing to the hull.
      if (!set_plane(made)) return;
      face_from[at] = first + static_cast<int>(k);
      cone.push_back(std::move(made));
      at = side.to;
    }
    // Side 1 of a cone face (to, eye) borders on the next face around the loop, side 2 (eye, from)
    // on the one before.
    const int n = static_cast<int>(cone.size());
    for (int k = 0; k < n; ++k) {
      cone[static_cast<std::size_t>(k)].neighbour[1] = first + (k + 1) % n;
      cone[static_cast<std::size_t>(k)].neighbour[2] = first + (k + n - 1) % n;
    }
    // Points above the removed faces are either inside the grown hull or above a face of the cone.
    std::vector<int> orphans;
    for (const int f : visible) {
      face(f).alive = false;
      orphans.insert(orphans.end(), face(f).outside.begin(), face(f).outside.end());
      face(f).outside = {};
    }
    // The hidden faces along the horizon get the faces of the cone as neighbours. They run along
    // the common edge in the opposite direction.
    for (const auto& [from, side] : ring) {
      for (std::size_t k = 0; k < 3; ++k) {
        Face& hidden = face(side.beyond);
        if (hidden.corner[k] == side.to && hidden.corner[(k + 1) % 3] == from) {
          hidden.neighbour[k] = face_from.at(from);
        }
      }
    }
    for (Face& made : cone) faces_.push_back(std::move(made));
    assign(orphans, static_cast<std::size_t>(first));
  }

  const std::vector<Vector3>& points_;
  std::vector<Face> faces_;
  double tolerance_ = 0.0;
};

}  // namespace

TriangleMesh convex_hull(const std::vector<Vector3>& points) { return Quickhull(points).run(); }

}  // namespace prehend
