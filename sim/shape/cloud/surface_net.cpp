#include "sim/shape/cloud/surface_net.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace prehend {
namespace {

// Values are at least so far from 0, in edges: vertices of neighbouring cells would coincide.
constexpr float kLeastValue = 0.05F;

// Corner c of a cell: bit k of c is its coordinate along axis k.
std::array<std::size_t, 8> cell_corners(const DistanceGrid& grid) {
  std::array<std::size_t, 8> offsets{};
  for (unsigned c = 0; c < 8; ++c) {
    offsets[c] = grid.at(static_cast<int>(c & 1U), static_cast<int>(c >> 1U & 1U),
                         static_cast<int>(c >> 2U));
  }
  return offsets;
}

unsigned inside_mask(const DistanceGrid& grid, const std::array<std::size_t, 8>& offsets,
                     std::size_t first) {
  unsigned mask = 0;
  for (unsigned c = 0; c < 8; ++c) {
    if (grid.value[first + offsets[c]] < 0.0F) mask |= 1U << c;
  }
  return mask;
}

// The corners that make a cell's inside and outside each connected over edges, face by face, if
// they are added: 0 where nothing is wrong.
unsigned to_add(unsigned mask) {
  // A face with two corners inside on one diagonal.
  for (unsigned axis = 0; axis < 3; ++axis) {
    const unsigned a = 1U << (axis + 1) % 3;
    const unsigned b = 1U << (axis + 2) % 3;
    for (unsigned side = 0; side < 2; ++side) {
      const unsigned base = side << axis;
      const auto in = [&](unsigned c) { return (mask >> c & 1U) != 0; };
      const bool p00 = in(base);
      const bool p10 = in(base + a);
      const bool p01 = in(base + b);
      const bool p11 = in(base + a + b);
      if (p00 && p11 && !p10 && !p01) return 1U << (base + a);
      if (p10 && p01 && !p00 && !p11) return 1U << base;
    }
  }
  // Two opposite corners alone, inside or outside.
  for (unsigned c = 0; c < 4; ++c) {
    const unsigned pair = 1U << c | 1U << (7U - c);
    if (mask == pair) return 1U << (c ^ 1U) | 1U << (c ^ 3U);
    if ((~mask & 0xFFU) == pair) return 1U << c;
  }
  return 0;
}

}  // namespace

void make_well_composed(DistanceGrid& grid) {
  const auto [nx, ny, nz] = grid.size;
  const auto outside = static_cast<float>(grid.edge);
  const auto at_border = [](int i, int count) { return i < 2 || i >= count - 2; };
  for (int z = 0; z < nz; ++z) {
    for (int y = 0; y < ny; ++y) {
      const bool border = at_border(z, nz) || at_border(y, ny);
      for (int x = 0; x < nx; ++x) {
        if (!border && !at_border(x, nx)) continue;
        float& value = grid.value[grid.at(x, y, z)];
        value = std::max(value, outside);
      }
    }
  }
  const std::array<std::size_t, 8> offsets = cell_corners(grid);
  const float inside = -kLeastValue * outside;
  for (float& value : grid.value) {
    value = value < 0.0F ? std::min(value, inside) : std::max(value, -inside);
  }
  // Inside only grows, so this ends; each round looks at what the last one changed around.
  for (bool changed = true; changed;) {
    changed = false;
    for (int z = 1; z + 2 < nz; ++z) {
      for (int y = 1; y + 2 < ny; ++y) {
        for (int x = 1; x + 2 < nx; ++x) {
          const std::size_t first = grid.at(x, y, z);
          const unsigned mask = inside_mask(grid, offsets, first);
          if (mask == 0 || mask == 0xFFU) continue;
          const unsigned added = to_add(mask);
          for (unsigned c = 0; c < 8; ++c) {
            if ((added >> c & 1U) != 0) grid.value[first + offsets[c]] = inside;
          }
          changed = changed || added != 0;
        }
      }
    }
  }
}

namespace {

// Where the surface crosses the edges of the cell at (x, y, z), in the mean.
Vector3 net_vertex(const DistanceGrid& grid, const std::array<std::size_t, 8>& offsets, int x,
                   int y, int z) {
  const std::size_t first = grid.at(x, y, z);
  Vector3 sum = Vector3::Zero();
  double count = 0.0;
  for (unsigned c = 0; c < 8; ++c) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      if ((c >> axis & 1U) != 0) continue;
      const double from = grid.value[first + offsets[c]];
      const double to = grid.value[first + offsets[c | 1U << axis]];
      if ((from < 0.0) == (to < 0.0)) continue;
      Vector3 p(c & 1U, c >> 1U & 1U, c >> 2U);
      p[static_cast<Eigen::Index>(axis)] = from / (from - to);
      sum += p;
      count += 1.0;
    }
  }
  return grid.corner(x, y, z) + grid.edge / count * sum;
}

}  // namespace

TriangleMesh surface_net(const DistanceGrid& grid) {
  const auto [nx, ny, nz] = grid.size;
  const std::array<std::size_t, 8> offsets = cell_corners(grid);
  TriangleMesh mesh;
  std::vector<int> vertex(grid.value.size(), -1);
  for (int z = 0; z + 1 < nz; ++z) {
    for (int y = 0; y + 1 < ny; ++y) {
      for (int x = 0; x + 1 < nx; ++x) {
        const unsigned mask = inside_mask(grid, offsets, grid.at(x, y, z));
        if (mask == 0 || mask == 0xFFU) continue;
        vertex[grid.at(x, y, z)] = static_cast<int>(mesh.vertices.size());
        mesh.vertices.push_back(net_vertex(grid, offsets, x, y, z));
      }
    }
  }
  // Around each edge of the grid that the surface crosses, the vertices of the four cells there.
  const auto add_quad = [&](int a, int b, int c, int d) {
    const auto at = [&](int i) { return mesh.vertices[index(i)]; };
    // The shorter diagonal makes the better triangles.
    if ((at(a) - at(c)).squaredNorm() <= (at(b) - at(d)).squaredNorm()) {
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    } else {
      mesh.triangles.push_back({b, c, d});
      mesh.triangles.push_back({b, d, a});
    }
  };
  const std::array<std::size_t, 3> step = {1, grid.at(0, 1, 0), grid.at(0, 0, 1)};
  for (int z = 1; z + 1 < nz; ++z) {
    for (int y = 1; y + 1 < ny; ++y) {
      for (int x = 1; x + 1 < nx; ++x) {
        const std::size_t here = grid.at(x, y, z);
        const bool inside = grid.value[here] < 0.0F;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          if ((grid.value[here + step[axis]] < 0.0F) == inside) continue;
          const std::size_t s = step[(axis + 1) % 3];
          const std::size_t t = step[(axis + 2) % 3];
          const int p00 = vertex[here - s - t];
          const int p10 = vertex[here - t];
          const int p11 = vertex[here];
          const int p01 = vertex[here - s];
          if (inside) {
            add_quad(p00, p10, p11, p01);
          } else {
            add_quad(p00, p01, p11, p10);
          }
        }
      }
    }
  }
  return mesh;
}

}  // namespace prehend
