#include "sim/soft/hex_mesh.h"

#include <cstddef>
#include <string>
#include <string_view>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

void require_ascending(std::span<const double> values, std::string_view field) {
  bool ascending = values.size() >= 2;
  for (std::size_t i = 1; i < values.size(); ++i) ascending &= values[i] > values[i - 1];
  require(ascending, {.field = std::string(field), .problem = "must ascend, two values or more"});
}

}  // namespace

HexMesh block_mesh(std::span<const double> x, std::span<const double> y,
                   std::span<const double> z) {
  require_ascending(x, "x");
  require_ascending(y, "y");
  require_ascending(z, "z");
  HexMesh mesh;
  mesh.nodes.reserve(x.size() * y.size() * z.size());
  for (const double zk : z) {
    for (const double yj : y) {
      for (const double xi : x) mesh.nodes.emplace_back(xi, yj, zk);
    }
  }
  const auto node = [&](std::size_t i, std::size_t j, std::size_t k) {
    return static_cast<int>((k * y.size() + j) * x.size() + i);
  };
  for (std::size_t k = 0; k + 1 < z.size(); ++k) {
    for (std::size_t j = 0; j + 1 < y.size(); ++j) {
      for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        mesh.elements.push_back({node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k),
                                 node(i, j + 1, k), node(i, j, k + 1), node(i + 1, j, k + 1),
                                 node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)});
      }
    }
  }
  return mesh;
}

}  // namespace prehend
