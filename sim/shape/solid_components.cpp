#include "sim/shape/solid_components.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "sim/shape/shells.h"

namespace prehend {
namespace {

bool bounds_hold(const Bounds& outer, const Bounds& inner) {
  return (outer.lower.array() <= inner.lower.array()).all() &&
         (outer.upper.array() >= inner.upper.array()).all();
}

struct ComponentPiece {
  SolidComponent component;
  Bounds box;
};

// The smallest of the pieces that may hold a cavity with these bounds; null: none.
ComponentPiece* holder_of(std::vector<ComponentPiece>& pieces, const Bounds& cavity) {
  ComponentPiece* found = nullptr;
  for (ComponentPiece& piece : pieces) {
    if (!bounds_hold(piece.box, cavity)) continue;
    const bool smaller =
        found == nullptr || piece.component.moments.zeroth < found->component.moments.zeroth;
    if (smaller) found = &piece;
  }
  return found;
}

// Vertices belong to one shell each.
std::vector<ComponentPiece> pieces_of(const TriangleMesh& surface) {
  const Shells shells = find_shells(surface);
  std::vector<ComponentPiece> pieces(shells.shells.size());
  std::vector<int> place(surface.vertices.size(), -1);  // of each vertex, in its piece
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    TriangleMesh& own = pieces[static_cast<std::size_t>(shells.of_triangle[t])].component.surface;
    Triangle& triangle = own.triangles.emplace_back(surface.triangles[t]);
    for (int& v : triangle) {
      int& at = place[static_cast<std::size_t>(v)];
      if (at < 0) {
        at = static_cast<int>(own.vertices.size());
        own.vertices.push_back(surface.vertices[static_cast<std::size_t>(v)]);
      }
      v = at;
    }
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    pieces[i].component.moments = solid_moments(pieces[i].component.surface);
    pieces[i].box = shells.shells[i].box;
  }
  return pieces;
}

}  // namespace

std::vector<SolidComponent> solid_components(const MassSolid& solid) {
  std::vector<ComponentPiece> pieces;
  std::vector<ComponentPiece> cavities;
  for (ComponentPiece& piece : pieces_of(solid.surface)) {
    (piece.component.moments.zeroth < 0.0 ? cavities : pieces).push_back(std::move(piece));
  }
  std::vector<SolidComponent> components;
  for (ComponentPiece& cavity : cavities) {
    ComponentPiece* holder = holder_of(pieces, cavity.box);
    if (holder == nullptr) {
      components.push_back(std::move(cavity.component));
      continue;
    }
    append(holder->component.surface, cavity.component.surface);
    holder->component.moments.add(1.0, cavity.component.moments);
  }
  for (ComponentPiece& piece : pieces) components.push_back(std::move(piece.component));
  std::stable_sort(components.begin(), components.end(), [](const auto& a, const auto& b) {
    return a.moments.zeroth > b.moments.zeroth;
  });
  return components;
}

}  // namespace prehend
