// The three steps of orient_outward (mesh_checks.h): make neighbours agree within each sheet, turn
// sheets by the sign of their volume, and find cavities. All decisions are collected in flip_; the
// triangles are changed at the end.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "sim/shape/edge_table.h"
#include "sim/shape/mesh_checks.h"

namespace prehend {
namespace {

// Triangles connected over edges of exactly two triangles. Edges of three and more triangles end a
// sheet, because they do not tell which of the triangles continue each other.
struct Sheet {
  std::vector<int> triangles;
  bool as_wound = true;  // no triangle was turned in step 1
  bool closed = true;
  double volume = 0.0;  // signed, after step 1
  Bounds box;
  bool cavity = false;
};

// The triangle across one side of a triangle; `agrees` when both traverse the common edge in
// opposite directions, as the triangles of a consistently wound surface do.
struct Neighbour {
  int triangle = -1;
  bool agrees = true;
};

// The neighbours of one triangle, at most one for each side.
struct Neighbours {
  std::array<Neighbour, 3> across;
  std::size_t count = 0;

  void add(int triangle, bool agrees) { across[count++] = {triangle, agrees}; }
};

class Orienter {
 public:
  explicit Orienter(TriangleMesh& mesh) : mesh_(mesh), uses_(edge_uses(mesh)) {}

  int orient() {
    find_neighbours();
    find_sheets();
    find_open_sheets();
    for (Sheet& sheet : sheets_) measure(sheet);
    find_cavities();
    for (const Sheet& sheet : sheets_) turn_outward(sheet);
    return turn();
  }

  // Step 1 alone, by turning the fewer triangles of each sheet.
  int agree() {
    find_neighbours();
    find_sheets();
    for (const Sheet& sheet : sheets_) turn_fewer(sheet);
    return turn();
  }

 private:
  int turn() {
    int turned = 0;
    for (std::size_t t = 0; t < flip_.size(); ++t) {
      if (!flip_[t]) continue;
      std::swap(mesh_.triangles[t][1], mesh_.triangles[t][2]);
      ++turned;
    }
    return turned;
  }

  void turn_fewer(const Sheet& sheet) {
    std::size_t turned = 0;
    for (const int t : sheet.triangles) turned += flip_[static_cast<std::size_t>(t)] ? 1 : 0;
    if (2 * turned <= sheet.triangles.size()) return;
    for (const int t : sheet.triangles) {
      const std::size_t i = static_cast<std::size_t>(t);
      flip_[i] = !flip_[i];
    }
  }

  // Neighbours across all edges of exactly two triangles.
  void find_neighbours() {
    neighbours_.resize(mesh_.triangles.size());
    for_each_edge(uses_, [&](std::span<const EdgeUse> edge) {
      if (edge.size() != 2) return;
      const bool agrees = edge[0].forward != edge[1].forward;
      neighbours_[static_cast<std::size_t>(edge[0].triangle)].add(edge[1].triangle, agrees);
      neighbours_[static_cast<std::size_t>(edge[1].triangle)].add(edge[0].triangle, agrees);
    });
  }

  // Step 1: a breadth-first search from each triangle that has no sheet yet. A triangle is turned
  // relative to the one it was reached from unless the two agree.
  void find_sheets() {
    const std::size_t n = mesh_.triangles.size();
    flip_.assign(n, false);
    sheet_of_.assign(n, -1);
    for (std::size_t seed = 0; seed < n; ++seed) {
      if (sheet_of_[seed] >= 0) continue;
      const int name = static_cast<int>(sheets_.size());
      Sheet sheet;
      sheet.triangles.push_back(static_cast<int>(seed));
      sheet_of_[seed] = name;
      for (std::size_t i = 0; i < sheet.triangles.size(); ++i) {
        const std::size_t t = static_cast<std::size_t>(sheet.triangles[i]);
        for (std::size_t k = 0; k < neighbours_[t].count; ++k) {
          const Neighbour& next = neighbours_[t].across[k];
          const std::size_t other = static_cast<std::size_t>(next.triangle);
          if (sheet_of_[other] >= 0) continue;
          sheet_of_[other] = name;
          flip_[other] = next.agrees ? flip_[t] : !flip_[t];
          if (flip_[other]) sheet.as_wound = false;
          sheet.triangles.push_back(next.triangle);
        }
      }
      sheets_.push_back(std::move(sheet));
    }
  }

  // A sheet is closed when its triangles traverse every edge as often forward as backward.
  void find_open_sheets() {
    for_each_edge(uses_, [&](std::span<const EdgeUse> edge) {
      const auto direction_of = [&](const EdgeUse& use) {
        return use.forward != flip_[static_cast<std::size_t>(use.triangle)] ? 1 : -1;
      };
      const auto sheet_of = [&](const EdgeUse& use) {
        return sheet_of_[static_cast<std::size_t>(use.triangle)];
      };
      // Nearly all edges join two triangles of one sheet.
      if (edge.size() == 2 && direction_of(edge[0]) + direction_of(edge[1]) == 0) return;
      // Edges of other numbers of triangles, and those where a one-sided sheet disagrees with
      // itself: count for each sheet.
      std::map<int, int> net;
      for (const EdgeUse& use : edge) net[sheet_of(use)] += direction_of(use);
      for (const auto& [name, direction] : net) {
        if (direction != 0) sheets_[static_cast<std::size_t>(name)].closed = false;
      }
    });
  }

  const Vector3& corner(int triangle, std::size_t k) const {
    const Triangle& t = mesh_.triangles[static_cast<std::size_t>(triangle)];
    return mesh_.vertices[static_cast<std::size_t>(t[k])];
  }

  // Bounds and signed volume of a sheet. For an open sheet the volume about its own centroid
  // (weighted by area) is positive when most of its area faces away from the centroid.
  void measure(Sheet& sheet) const {
    Vector3 weighted = Vector3::Zero();
    double area = 0.0;
    for (const int t : sheet.triangles) {
      const double part = doubled_area_vector(mesh_, static_cast<std::size_t>(t)).norm();
      for (std::size_t k = 0; k < 3; ++k) {
        weighted += part / 3.0 * corner(t, k);
        sheet.box.lower = sheet.box.lower.cwiseMin(corner(t, k));
        sheet.box.upper = sheet.box.upper.cwiseMax(corner(t, k));
      }
      area += part;
    }
    if (!(area > 0.0)) return;
    const Vector3 center = weighted / area;
    for (const int t : sheet.triangles) {
      const std::size_t i = static_cast<std::size_t>(t);
      const double part = (corner(t, 0) - center).dot(doubled_area_vector(mesh_, i)) / 6.0;
      sheet.volume += flip_[i] ? -part : part;
    }
    // A flat sheet has a volume of about zero, whose sign is rounding error.
    if (std::abs(sheet.volume) < 1e-9 * area * sheet.box.diagonal()) sheet.volume = 0.0;
  }

  // Whether point p is inside a closed sheet: a ray from p along +z crosses it an odd number of
  // times. Whether the ray meets a triangle is decided in the xy plane, by the sides that a ray
  // along +x from p crosses. Each side is evaluated from its lower to its higher vertex index, so
  // that two triangles with a common side come to the same decision and no crossing is lost or
  // counted twice.
  bool contains(const Sheet& sheet, const Vector3& p) const {
    bool odd = false;
    for (const int t : sheet.triangles) {
      const Triangle& v = mesh_.triangles[static_cast<std::size_t>(t)];
      bool inside = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const int low = std::min(v[k], v[(k + 1) % 3]);
        const int high = std::max(v[k], v[(k + 1) % 3]);
        const Vector3& a = mesh_.vertices[static_cast<std::size_t>(low)];
        const Vector3& b = mesh_.vertices[static_cast<std::size_t>(high)];
        if ((a.y() > p.y()) == (b.y() > p.y())) continue;
        const double x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        if (p.x() < x) inside = !inside;
      }
      if (!inside) continue;
      const Vector3 normal = doubled_area_vector(mesh_, static_cast<std::size_t>(t));
      if (normal.z() == 0.0) continue;
      // The quotient is the height of the crossing above p.
      if (normal.dot(corner(t, 0) - p) / normal.z() > 0.0) odd = !odd;
    }
    return odd;
  }

  // Step 3. Only closed sheets count whose winding the file made consistent: where the winding is
  // unreliable it cannot tell a cavity from a solid part. When all of them have volumes of one
  // sign, there is no cavity.
  void find_cavities() {
    std::vector<std::size_t> solids;
    bool positive = false;
    bool negative = false;
    for (std::size_t i = 0; i < sheets_.size(); ++i) {
      const Sheet& sheet = sheets_[i];
      if (!sheet.closed || !sheet.as_wound || sheet.volume == 0.0) continue;
      solids.push_back(i);
      (sheet.volume > 0.0 ? positive : negative) = true;
    }
    if (!positive || !negative) return;
    // Largest volume first, so that a sheet comes after every sheet that contains it.
    std::stable_sort(solids.begin(), solids.end(), [&](std::size_t a, std::size_t b) {
      return std::abs(sheets_[a].volume) > std::abs(sheets_[b].volume);
    });
    for (std::size_t i = 1; i < solids.size(); ++i) {
      Sheet& inner = sheets_[solids[i]];
      // From the smallest larger sheet on: the first that contains it is the one around it.
      for (std::size_t j = i; j-- > 0;) {
        const Sheet& outer = sheets_[solids[j]];
        const bool boxed = (outer.box.lower.array() <= inner.box.lower.array()).all() &&
                           (outer.box.upper.array() >= inner.box.upper.array()).all();
        if (!boxed || !contains(outer, corner(inner.triangles.front(), 0))) continue;
        inner.cavity = !outer.cavity && (outer.volume > 0.0) != (inner.volume > 0.0);
        break;
      }
    }
  }

  // Step 2: outward for solids, inward for cavities.
  void turn_outward(const Sheet& sheet) {
    const bool wrong = sheet.cavity ? sheet.volume > 0.0 : sheet.volume < 0.0;
    if (!wrong) return;
    for (const int t : sheet.triangles) {
      const std::size_t i = static_cast<std::size_t>(t);
      flip_[i] = !flip_[i];
    }
  }

  TriangleMesh& mesh_;
  std::vector<EdgeUse> uses_;
  std::vector<Neighbours> neighbours_;
  std::vector<int> sheet_of_;
  std::vector<bool> flip_;
  std::vector<Sheet> sheets_;
};

}  // namespace

int orient_outward(TriangleMesh& mesh) { return Orienter(mesh).orient(); }

int make_consistent(TriangleMesh& mesh) { return Orienter(mesh).agree(); }

}  // namespace prehend
