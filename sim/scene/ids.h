// Typed indices of links and bodies, which the compiler keeps apart, and pairs of them.
#pragma once

#include <cassert>
#include <compare>
#include <cstddef>
#include <variant>
#include <vector>

#include "sim/base/index.h"

namespace prehend {

// A link, as an index into the links of one robot: into CompiledScene::links where the hand is
// meant, into CompiledArm::links where the whole platform is.
enum class LinkId : int {};

constexpr LinkId link_id(std::size_t i) { return static_cast<LinkId>(i); }
constexpr std::size_t index(LinkId link) { return index(static_cast<int>(link)); }

// A body that does not belong to the robot: the object, or one of the scene's obstacles.
class BodyId {
 public:
  static constexpr BodyId object() { return BodyId(0); }
  // `i`: index into Scene::obstacles.
  static constexpr BodyId obstacle(int i) {
    assert(i >= 0);
    return BodyId(i + 1);
  }

  constexpr bool is_object() const { return place_ == 0; }

  // Place in lists of bodies, which hold the object first and then the obstacles in the order of
  // the scene.
  friend constexpr std::size_t index(BodyId body) { return index(body.place_); }
  static constexpr BodyId at(std::size_t place) { return BodyId(static_cast<int>(place)); }

  friend constexpr auto operator<=>(BodyId, BodyId) = default;

 private:
  explicit constexpr BodyId(int place) : place_(place) {}
  int place_;
};

// Two bodies that can collide: a link of the platform with another link, or with the object or an
// obstacle.
struct ArmPair {
  LinkId link = {};
  std::variant<LinkId, BodyId> other = LinkId{};
  // Joints that move one body relative to the other, and for each the farthest that a point moves
  // per unit of the joint's motion (see CompiledLink).
  std::vector<int> joints = {};
  std::vector<double> reach = {};
};

}  // namespace prehend
