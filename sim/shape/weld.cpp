// Vertices are merged with a hash grid of kept vertices, so that only nearby ones are compared.
//
// Removing duplicate triangles needs care with windings: two triangles on the same three vertices
// that are wound against each other enclose nothing. One of them is kept as a two-sided triangle,
// except where it is a fin.
#include "sim/shape/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

// Edge length of a grid cell. The wider the cell, the rarer a search ball extends into a
// neighbouring cell; the narrower, the fewer points there are to compare. As wide as the vertices
// of a surface are apart, within bounds in tolerances. It does not change what is found.
double cell_size(const TriangleMesh& mesh, double tolerance) {
  const double apart =
      bounds(mesh).diagonal() / std::sqrt(static_cast<double>(mesh.vertices.size()));
  return std::clamp(apart, 4.0 * tolerance, 32.0 * tolerance);
}

using Cell = std::array<std::int64_t, 3>;

// Multiplicative hashing with the 64-bit golden ratio; the shift mixes high bits into low ones.
struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t h = 0;
    for (const std::int64_t k : cell) {
      h = (h ^ static_cast<std::uint64_t>(k)) * 0x9E3779B97F4A7C15ULL;
      h ^= h >> 29;
    }
    return static_cast<std::size_t>(h);
  }
};

// Kept vertices by grid cell.
class PointGrid {
 public:
  PointGrid(const Vector3& origin, double tolerance, double cell_size)
      : origin_(origin), tolerance_(tolerance), cell_size_(cell_size) {}

  // Index of the first kept vertex within the tolerance of p; -1: none. Looks at the cells that the
  // cube of half size `tolerance_` about p touches: one to eight.
  int find(const Vector3& p, const std::vector<Vector3>& kept) const {
    const Cell low = cell(p - Vector3::Constant(tolerance_));
    const Cell high = cell(p + Vector3::Constant(tolerance_));
    int found = -1;
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          const auto place = cells_.find({x, y, z});
          if (place == cells_.end()) continue;
          for (const int i : place->second) {
            const bool near =
                (kept[static_cast<std::size_t>(i)] - p).squaredNorm() <= tolerance_ * tolerance_;
            // The first in the order of vertices, whatever the order of cells.
            if (near && (found < 0 || i < found)) found = i;
          }
        }
      }
    }
    return found;
  }

  void add(const Vector3& p, int index) { cells_[cell(p)].push_back(index); }

 private:
  Cell cell(const Vector3& p) const {
    Cell c;
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Index axis = static_cast<Eigen::Index>(k);
      c[k] = static_cast<std::int64_t>(std::floor((p[axis] - origin_[axis]) / cell_size_));
    }
    return c;
  }

  Vector3 origin_;
  double tolerance_;
  double cell_size_;
  std::unordered_map<Cell, std::vector<int>, CellHash> cells_;
};

// The triangle with its smallest vertex first and the same winding: equal for triangles that differ
// only in which vertex is named first.
Triangle rotated(const Triangle& t) {
  const std::size_t k = static_cast<std::size_t>(std::min_element(t.begin(), t.end()) - t.begin());
  return {t[k], t[(k + 1) % 3], t[(k + 2) % 3]};
}

// A fin is a two-sided triangle that stands out from a surface: one of its sides is on the surface,
// the other two are free, and no other two-sided triangle is attached to it. It bounds nothing and
// makes the edge at its foot non-manifold, so it is removed. Two-sided triangles that form a larger
// sheet (a leaf, a label) are kept.
void mark_fins(const TriangleMesh& mesh, const std::vector<bool>& two_sided,
               std::vector<bool>& removed) {
  struct Uses {
    int plain = 0;
    int two_sided = 0;
  };
  std::map<std::pair<int, int>, Uses> uses;
  const auto side = [&](const Triangle& t, std::size_t k) -> Uses& {
    return uses[std::minmax(t[k], t[(k + 1) % 3])];
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3 && !removed[i]; ++k) {
      Uses& at = side(mesh.triangles[i], k);
      ++(two_sided[i] ? at.two_sided : at.plain);
    }
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!two_sided[i]) continue;
    int free_sides = 0;
    bool alone = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const Uses& at = side(mesh.triangles[i], k);
      free_sides += at.plain == 0 ? 1 : 0;
      alone = alone && at.two_sided == 1;
    }
    removed[i] = alone && free_sides == 2;
  }
}

// Of all triangles with the same three vertices the first is kept. Returns the number of triangles
// removed, fins included. Sorting by sorted vertices brings duplicates together; the index as the
// last key puts the one to keep first.
int remove_duplicates(TriangleMesh& mesh) {
  struct Named {
    Triangle corners;  // sorted
    std::size_t triangle;
  };
  std::vector<Named> named;
  named.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    named.push_back({mesh.triangles[i], i});
    std::sort(named.back().corners.begin(), named.back().corners.end());
  }
  std::sort(named.begin(), named.end(), [](const Named& a, const Named& b) {
    return std::tie(a.corners, a.triangle) < std::tie(b.corners, b.triangle);
  });
  std::vector<bool> removed(mesh.triangles.size(), false);
  std::vector<bool> two_sided(mesh.triangles.size(), false);
  bool any = false;
  for (std::size_t first = 0; first < named.size();) {
    const Triangle kept = rotated(mesh.triangles[named[first].triangle]);
    int net = 1;  // copies wound like the first minus those wound against it
    std::size_t next = first + 1;
    for (; next < named.size() && named[next].corners == named[first].corners; ++next) {
      net += rotated(mesh.triangles[named[next].triangle]) == kept ? 1 : -1;
      removed[named[next].triangle] = true;
      any = true;
    }
    // As many copies one way as the other: the triangle has two sides.
    two_sided[named[first].triangle] = net == 0;
    first = next;
  }
  if (!any) return 0;
  mark_fins(mesh, two_sided, removed);
  std::size_t left = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!removed[i]) mesh.triangles[left++] = mesh.triangles[i];
  }
  const int count = static_cast<int>(mesh.triangles.size() - left);
  mesh.triangles.resize(left);
  return count;
}

}  // namespace

bool is_degenerate(const TriangleMesh& mesh, std::size_t triangle) {
  // Doubled area over squared longest side is the height over the longest side.
  constexpr double kFlattest = 1e-7;
  const Triangle& t = mesh.triangles[triangle];
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
  const Vector3& a = mesh.vertices[static_cast<std::size_t>(t[0])];
  const Vector3& b = mesh.vertices[static_cast<std::size_t>(t[1])];
  const Vector3& c = mesh.vertices[static_cast<std::size_t>(t[2])];
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return !(doubled_area_vector(mesh, triangle).norm() > kFlattest * longest);
}

WeldedMesh weld(const TriangleMesh& mesh, double tolerance) {
  WeldedMesh result;
  PointGrid grid(bounds(mesh).lower, tolerance, cell_size(mesh, tolerance));
  std::vector<int> kept_as;
  kept_as.reserve(mesh.vertices.size());
  for (const Vector3& p : mesh.vertices) {
    // A merged vertex is not added to the grid: vertices are compared with kept ones only, so that
    // chains of close vertices do not collapse into one point.
    int index = grid.find(p, result.mesh.vertices);
    if (index < 0) {
      index = static_cast<int>(result.mesh.vertices.size());
      result.mesh.vertices.push_back(p);
      grid.add(p, index);
    } else {
      ++result.vertices_merged;
    }
    kept_as.push_back(index);
  }
  for (const Triangle& t : mesh.triangles) {
    Triangle renamed;
    for (std::size_t k = 0; k < 3; ++k) renamed[k] = kept_as[static_cast<std::size_t>(t[k])];
    result.mesh.triangles.push_back(renamed);
    if (is_degenerate(result.mesh, result.mesh.triangles.size() - 1)) {
      result.mesh.triangles.pop_back();
      ++result.degenerate_removed;
    }
  }
  result.duplicates_removed = remove_duplicates(result.mesh);
  drop_unused_vertices(result.mesh);
  return result;
}

void drop_unused_vertices(TriangleMesh& mesh) {
  std::vector<int> place(mesh.vertices.size(), -1);
  for (const Triangle& t : mesh.triangles) {
    for (const int v : t) place[static_cast<std::size_t>(v)] = 0;
  }
  std::size_t used = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] < 0) continue;
    place[i] = static_cast<int>(used);
    mesh.vertices[used++] = mesh.vertices[i];
  }
  mesh.vertices.resize(used);
  for (Triangle& t : mesh.triangles) {
    for (int& v : t) v = place[static_cast<std::size_t>(v)];
  }
}

WeldedMesh weld_to_scale(const TriangleMesh& mesh, double fraction) {
  require(fraction > 0.0 && fraction < 0.01, {.field = "weld_fraction",
                                              .problem = "must be above 0 and below 0.01",
                                              .value = std::to_string(fraction)});
  const double diagonal = bounds(mesh).diagonal();
  // weld needs a tolerance above 0.
  if (!(diagonal > 0.0)) throw InputError("all vertices are at one point");
  WeldedMesh welded = weld(mesh, fraction * diagonal);
  if (welded.mesh.empty()) throw InputError("no triangle has an area");
  return welded;
}

}  // namespace prehend
