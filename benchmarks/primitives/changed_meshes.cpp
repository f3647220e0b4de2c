#include "benchmarks/primitives/changed_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "sim/base/index.h"
#include "sim/shape/weld.h"

namespace prehend::bench {
namespace {

using Edge = std::pair<int, int>;  // the lower index first

Edge edge_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

Vector3 middle_of(const TriangleMesh& mesh, std::size_t t) {
  const Corners corners = corners_of(mesh, static_cast<int>(t));
  return (corners[0] + corners[1] + corners[2]) / 3.0;
}

TriangleMesh with_triangles(const TriangleMesh& mesh, const std::vector<bool>& kept) {
  TriangleMesh part{mesh.vertices, {}};
  for (std::size_t t = 0; t < kept.size(); ++t) {
    if (kept[t]) part.triangles.push_back(mesh.triangles[t]);
  }
  drop_unused_vertices(part);
  return part;
}

// The longest edge of each triangle that is too long is divided in its middle, and so are the
// neighbours that share it. False where nothing was too long.
bool divide_once(TriangleMesh& mesh, double longest) {
  const auto length = [&](int a, int b) {
    return (mesh.vertices[index(a)] - mesh.vertices[index(b)]).norm();
  };
  std::map<Edge, int> middles;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = t[k];
      const int b = t[(k + 1) % 3];
      const int c = t[(k + 2) % 3];
      const double own = length(a, b);
      if (own <= longest || own < length(b, c) || own < length(c, a)) continue;
      const auto [place, is_new] =
          middles.try_emplace(edge_of(a, b), static_cast<int>(mesh.vertices.size()));
      if (!is_new) continue;
      mesh.vertices.push_back(0.5 * (mesh.vertices[index(a)] + mesh.vertices[index(b)]));
    }
  }
  std::vector<Triangle> triangles;
  for (const Triangle& t : mesh.triangles) {
    std::vector<Triangle> pieces = {t};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto found = middles.find(edge_of(t[k], t[(k + 1) % 3]));
      if (found == middles.end()) continue;
      std::vector<Triangle> finer;
      for (const Triangle& piece : pieces) {
        std::size_t at = 3;
        for (std::size_t j = 0; j < 3; ++j) {
          if (piece[j] == t[k] && piece[(j + 1) % 3] == t[(k + 1) % 3]) at = j;
        }
        if (at == 3) {
          finer.push_back(piece);
          continue;
        }
        const int apex = piece[(at + 2) % 3];
        finer.push_back({piece[at], found->second, apex});
        finer.push_back({found->second, piece[(at + 1) % 3], apex});
      }
      pieces = std::move(finer);
    }
    triangles.insert(triangles.end(), pieces.begin(), pieces.end());
  }
  mesh.triangles = std::move(triangles);
  return !middles.empty();
}

// How far along a direction each cell of a picture sees.
class DepthPicture {
 public:
  static constexpr int kCells = 300;

  DepthPicture(const TriangleMesh& mesh, const Vector3& towards) : mesh_(mesh), towards_(towards) {
    right_ = any_orthogonal(towards);
    up_ = towards.cross(right_);
    middle_ = bounds(mesh).center();
    cell_ = bounds(mesh).diagonal() / kCells;
    nearest_.assign(kCells * kCells, -std::numeric_limits<double>::infinity());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) draw(t);
  }

  bool sees(std::size_t t) const {
    constexpr double kSlack = 2.0;  // cells
    const Vector3 p = place(middle_of(mesh_, t));
    return p.z() >
           nearest_[cell(static_cast<int>(p.x()), static_cast<int>(p.y()))] - kSlack * cell_;
  }

 private:
  // By cells, and towards the eye in metres.
  Vector3 place(const Vector3& p_O) const {
    const Vector3 d = p_O - middle_;
    return {d.dot(right_) / cell_ + 0.5 * kCells, d.dot(up_) / cell_ + 0.5 * kCells,
            d.dot(towards_)};
  }
  static std::size_t cell(int x, int y) {
    return index(std::clamp(y, 0, kCells - 1) * kCells + std::clamp(x, 0, kCells - 1));
  }

  void draw(std::size_t t) {
    std::array<Vector3, 3> p = corners_of(mesh_, static_cast<int>(t));
    for (Vector3& corner : p) corner = place(corner);
    const auto cross = [](const Vector3& a, const Vector3& b, double x, double y) {
      return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
    };
    const double area = cross(p[0], p[1], p[2].x(), p[2].y());
    if (area == 0.0) return;
    const auto [x_low, x_high] = std::minmax({p[0].x(), p[1].x(), p[2].x()});
    const auto [y_low, y_high] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
    for (int y = static_cast<int>(y_low); y <= static_cast<int>(y_high); ++y) {
      for (int x = static_cast<int>(x_low); x <= static_cast<int>(x_high); ++x) {
        const double a = cross(p[1], p[2], x + 0.5, y + 0.5) / area;
        const double b = cross(p[2], p[0], x + 0.5, y + 0.5) / area;
        if (a < 0.0 || b < 0.0 || a + b > 1.0) continue;
        double& nearest = nearest_[cell(x, y)];
        nearest = std::max(nearest, a * p[0].z() + b * p[1].z() + (1.0 - a - b) * p[2].z());
      }
    }
  }

  const TriangleMesh& mesh_;
  Vector3 towards_;
  Vector3 right_;
  Vector3 up_;
  Vector3 middle_;
  double cell_ = 0.0;
  std::vector<double> nearest_;
};

}  // namespace

TriangleMesh scaled_mesh(TriangleMesh mesh, double factor) {
  for (Vector3& p : mesh.vertices) p *= factor;
  return mesh;
}

TriangleMesh with_short_edges(TriangleMesh mesh, double longest) {
  while (divide_once(mesh, longest)) {
  }
  return mesh;
}

TriangleMesh clustered(const TriangleMesh& mesh, double cell) {
  struct Cluster {
    Vector3 sum = Vector3::Zero();
    int count = 0;
    int number = 0;
  };
  const auto cell_of = [&](const Vector3& p) {
    const Eigen::Array3i at = (p.array() / cell).floor().cast<int>();
    return std::tuple(at.x(), at.y(), at.z());
  };
  std::map<std::tuple<int, int, int>, Cluster> clusters;
  for (const Vector3& p : mesh.vertices) {
    Cluster& cluster = clusters[cell_of(p)];
    cluster.sum += p;
    ++cluster.count;
  }
  TriangleMesh coarse;
  for (auto& [place, cluster] : clusters) {
    cluster.number = static_cast<int>(coarse.vertices.size());
    coarse.vertices.push_back(cluster.sum / cluster.count);
  }
  for (const Triangle& t : mesh.triangles) {
    Triangle c{};
    for (std::size_t k = 0; k < 3; ++k) c[k] = clusters[cell_of(mesh.vertices[index(t[k])])].number;
    if (c[0] != c[1] && c[1] != c[2] && c[2] != c[0]) coarse.triangles.push_back(c);
  }
  return coarse;
}

TriangleMesh with_noise(TriangleMesh mesh, double deviation, Random& random) {
  std::vector<Vector3> normals(mesh.vertices.size(), Vector3::Zero());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const int v : mesh.triangles[t]) normals[index(v)] += doubled_area_vector(mesh, t);
  }
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const double length = deviation * random.normal();
    if (normals[v].norm() > 0.0) mesh.vertices[v] += length * normals[v].normalized();
  }
  return mesh;
}

TriangleMesh with_holes(const TriangleMesh& mesh, int count, double share, Random& random) {
  std::vector<bool> kept(mesh.triangles.size(), true);
  const double each = share * surface_area(mesh) / count;
  for (int hole = 0; hole < count; ++hole) {
    const Vector3 place = middle_of(mesh, random.index(mesh.triangles.size()));
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t t = 0; t < kept.size(); ++t) {
      if (kept[t]) near.emplace_back((middle_of(mesh, t) - place).norm(), t);
    }
    std::sort(near.begin(), near.end());
    double area = 0.0;
    for (const auto& [distance, t] : near) {
      if (area >= each) break;
      area += 0.5 * doubled_area_vector(mesh, t).norm();
      kept[t] = false;
    }
  }
  return with_triangles(mesh, kept);
}

TriangleMesh seen_from(const TriangleMesh& mesh, const Vector3& towards) {
  const DepthPicture picture(mesh, towards);
  std::vector<bool> kept(mesh.triangles.size(), false);
  for (std::size_t t = 0; t < kept.size(); ++t) {
    kept[t] = doubled_area_vector(mesh, t).dot(towards) > 0.0 && picture.sees(t);
  }
  return with_triangles(mesh, kept);
}

}  // namespace prehend::bench
