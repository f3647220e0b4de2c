// The links of a robot made ready for motions: bodies, bounds of how far they move, pairs that can
// collide.
#pragma once

#include <string>
#include <vector>

#include "sim/scene/collision_body.h"
#include "sim/scene/ids.h"
#include "sim/scene/scene.h"

namespace prehend {

// A link with its surface against the object and what bounds its motion.
struct CompiledLink : CollisionBody {
  double friction = 0.0;         // coefficient of friction against the object
  double compliant_depth = 0.0;  // by which its surface gives way to the object, 0: hard [m]
  // Joints between the robot's base and the link, base to tip (none for a link of the base), and
  // for each the farthest that a point of the link moves for a unit of the joint's motion: the
  // largest distance from the axis in metres for a revolute joint, 1 for a prismatic one.
  std::vector<int> joints = {};
  std::vector<double> reach = {};
};

// A pair of links checked for self-collision.
struct LinkPair {
  LinkId a = {};
  LinkId b = {};
};

// All links of `robot`, with their friction against the object of the scene.
// Throws InputError for an unknown material, a link without triangles or joints that are no tree.
std::vector<CompiledLink> compile_links(const Scene& scene, const Robot& robot);

// All pairs of links that are checked for self-collision. Left out are two links on the same joint,
// which never move against each other, and two that one joint connects, whose meshes overlap there
// by construction: neighbours in a chain, and a chain's first link with the link that carries it.
std::vector<LinkPair> separate_pairs(const std::vector<CompiledLink>& links);

}  // namespace prehend
