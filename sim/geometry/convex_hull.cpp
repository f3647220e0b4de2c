#include "sim/geometry/convex_hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace prehend {
namespace {

struct Face {
  Triangle corner{};
  Triangle neighbour{};  // across the side from corner k to corner k + 1
  Vector3 normal = Vector3::Zero();
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

  // Four points far from each other, from a line from a plane; false when there are none.
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
    if (volume > 0.0) std::swap(s[0], s[1]);
    return true;
  }

  // Adds a face; false when its corners are in a line.
  bool set_plane(Face& made) const {
    const Vector3& a = point(made.corner[0]);
    const Vector3 normal = (point(made.corner[1]) - a).cross(point(made.corner[2]) - a);
    const double length = normal.norm();
    if (!(length > tolerance_ * tolerance_)) return false;
    made.normal = normal / length;
    made.offset = made.normal.dot(a);
    return true;
  }

  double height(const Face& over, int i) const { return over.normal.dot(point(i)) - over.offset; }

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

  // Gives each point to the first face from `first` on that it is above; drops points inside.
  void assign(const std::vector<int>& candidates, std::size_t first) {
    for (const int i : candidates) {
      for (std::size_t f = first; f < faces_.size(); ++f) {
        if (height(faces_[f], i) <= tolerance_) continue;
        faces_[f].outside.push_back(i);
        break;
      }
    }
  }

  struct Side {
    int from = 0;
    int to = 0;
    int beyond = 0;  // the hidden face across it
  };

  // Faces that `eye` sees, from face `seed` on, and the sides where they end, by first corner.
  // False when these sides do not form one ring (rounding).
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

  // Replaces what the farthest point above a face sees by a cone of new faces to that point.
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
      // A point in line with a side adds next to nothing: leave it out.
      if (!set_plane(made)) return;
      face_from[at] = first + static_cast<int>(k);
      cone.push_back(std::move(made));
      at = side.to;
    }
    const int n = static_cast<int>(cone.size());
    for (int k = 0; k < n; ++k) {
      cone[static_cast<std::size_t>(k)].neighbour[1] = first + (k + 1) % n;
      cone[static_cast<std::size_t>(k)].neighbour[2] = first + (k + n - 1) % n;
    }
    std::vector<int> orphans;
    for (const int f : visible) {
      face(f).alive = false;
      orphans.insert(orphans.end(), face(f).outside.begin(), face(f).outside.end());
      face(f).outside = {};
    }
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
