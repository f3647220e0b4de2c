// The links of a robot prepared for collision checks during motions: collision bodies, bounds on
// how far their points move, and the pairs checked for self-collision.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/scene/collision_body.h"
#include "sim/scene/ids.h"
#include "sim/scene/scene.h"
#include "sim/soft/pad_cache.h"

namespace prehend {

// A link with its contact properties against the object and a bound on its motion: when its joints
// move by d_k, no point of it moves farther than the sum of reach[k] * |d_k|.
struct CompiledLink : CollisionBody {
  // Against the object, where neither has regions of other materials (`surface`,
  // CompiledScene::object_surface): coefficient of friction, and indentation of its surface by the
  // object, 0: hard [m].
  double friction = 0.0;
  double compliant_depth = 0.0;
  // Joints between the robot's base and the link, base to tip (none for a link of the base), and
  // for each the farthest that a point of the link moves per unit of the joint's motion: for a
  // revolute joint the largest distance of any point from the axis [m], for a prismatic one 1.
  std::vector<int> joints = {};
  std::vector<double> reach = {};
  std::shared_ptr<const PadCache> pad = {};  // none: the link has no pad
  SurfaceMaterials surface = {};
  std::optional<double> friction_deviation = {};  // of `friction`
};

// How many joints from the base on move both links alike.
std::size_t shared_joints(const CompiledLink& a, const CompiledLink& b);

// A pair of links checked for self-collision.
struct LinkPair {
  LinkId a = {};
  LinkId b = {};
};

// A link that is fixed to a joint of `robot`. Throws InputError for an unknown material and a link
// without triangles.
CompiledLink compile_link(const Scene& scene, const Robot& robot, const Link& link);

// All links of `robot`, with their friction against the object of the scene.
// Throws InputError for an unknown material, a link without triangles or joints that are no tree.
std::vector<CompiledLink> compile_links(const Scene& scene, const Robot& robot);

// All pairs of links that are checked for self-collision. Left out are two links on the same joint,
// which never move against each other, and two that one joint connects, whose meshes overlap there
// by construction: neighbours in a chain, and a chain's first link with the link that carries it;
// also the pairs that the robot exempts. `links` are those of `robot`.
std::vector<LinkPair> collision_pairs(const std::vector<CompiledLink>& links, const Robot& robot);

}  // namespace prehend
