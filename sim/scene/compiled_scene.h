// A scene prepared for trials: collision bodies, bounds on motions, friction, and the pairs checked
// for self-collision.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/quality/contact_map.h"
#include "sim/scene/body_tree.h"
#include "sim/scene/compiled_arm.h"
#include "sim/scene/compiled_link.h"
#include "sim/scene/scene.h"

namespace prehend {

// Immutable after compile, shared by threads.
struct CompiledScene {
  Scene scene;
  // The object, at the identity, then the obstacles as in scene.obstacles; in the object's frame O.
  std::vector<PlacedBody> bodies = {};
  BodyTree near_obstacles = {};           // over the obstacles among `bodies`
  std::vector<CompiledLink> links = {};   // of the hand, as scene.hand.links
  std::vector<LinkPair> self_pairs = {};  // link pairs of the hand checked for self-collision
  // Per preshape of the hand and self pair, the gap at that preshape [m].
  std::vector<std::vector<double>> preshape_gaps = {};
  // Of a hand with one finger that closes onto a part of its base: the direction in which it pushes
  // (pushing_direction), in the hand's base frame.
  std::optional<Vector3> pushing_H = {};
  // Torques about the object's centre of mass, times 1 / largest distance of a vertex from it.
  WrenchFrame wrench_frame = {};
  SurfaceRegions keep_out = {};  // as scene.keep_out and scene.preferred
  SurfaceRegions preferred = {};
  SurfaceRegions porous = {};
  SurfaceMaterials object_surface = {};
  std::optional<CompiledArm> arm = {};  // the platform that carries the hand, where there is one

  const PlacedBody& object() const { return bodies.front(); }
  // Whether friction and compliance are the same wherever a link touches the object.
  bool is_uniform(const CompiledLink& link) const {
    return object_surface.uniform() && link.surface.uniform();
  }
  std::span<const PlacedBody> obstacles() const { return std::span(bodies).subspan(1); }
  bool has_obstacles() const { return bodies.size() > 1; }
  const PlacedBody& body(BodyId id) const { return bodies[index(id)]; }
  // X_BX in the frame B of the body, of a pose X_OX given in the object's frame.
  Pose pose_in(BodyId id, const Pose& X_OX) const {
    return id.is_object() ? X_OX : body(id).X_RB.inverse() * X_OX;
  }
};

// Contacts are found where surfaces are within about 0.1 mm of each other. On an object that is not
// much larger than that they would touch all of it at once, and no quality would mean anything [m].
inline constexpr double kSmallestObject = 0.002;

// Prepares a scene for trials: builds the search trees of all meshes, finds the pairs to check for
// self-collision and, with an arm, those that can never collide.
//
// Throws InputError when the robot is not a hand, has an unknown material or an empty link, a
// preshape in which links collide, the object is smaller than kSmallestObject or overlaps an
// obstacle, or the arm's start posture collides or is outside limits.
//
// Throws Cancelled. The checks of one mesh (is it closed, of how many pieces is it) and its convex
// hull are not interrupted: above 50 000 triangles they can take longer than 50 ms.
CompiledScene compile(Scene scene, const RunContext& context = {});

// Where the bodies of a scene are in the world.
struct BodyPlaces {
  Pose X_WO = Pose::Identity();  // of the object
  std::vector<Pose> X_WB = {};   // of the obstacles, as Scene::obstacles
};

BodyPlaces places_of(const Scene& scene);
void set_places(Scene& scene, const BodyPlaces& places);

// The scene with its bodies at other places. The same as compile() of it there, but for rounding of
// where obstacles are relative to the object, in a small part of the time: all search trees are
// shared with `scene`, and of an arm only what depends on bodies that moved is proven anew. Throws
// InputError where the object overlaps an obstacle there, or the arm's start posture collides.
CompiledScene with_bodies_at(const CompiledScene& scene, const BodyPlaces& places);

}  // namespace prehend
