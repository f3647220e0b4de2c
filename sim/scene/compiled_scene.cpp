#include "sim/scene/compiled_scene.h"

#include <cassert>
#include <cmath>
#include <string>
#include <utility>

#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/robot/one_finger.h"
#include "sim/scene/sunk_object.h"
#include "sim/shape/mesh_checks.h"
#include "sim/shape/proximity.h"

namespace prehend {
namespace {

// The gap of each self pair at a preshape [m], a lower bound that saves the closing hand queries.
// Throws InputError where links collide.
std::vector<double> gaps_at(const CompiledScene& scene, const Preshape& preshape) {
  const Robot& hand = scene.scene.hand;
  std::vector<Pose> X_HL;
  link_poses(hand, joint_values(hand, preshape.dofs), X_HL);
  std::vector<double> gaps;
  for (const LinkPair& pair : scene.self_pairs) {
    const CompiledLink& a = scene.links[index(pair.a)];
    const CompiledLink& b = scene.links[index(pair.b)];
    const Pose X_AB = X_HL[index(pair.a)].inverse() * X_HL[index(pair.b)];
    gaps.push_back(find_gap(a.mesh, b.mesh, X_AB).lower);
    if (gaps.back() <= 0.0) {
      throw InputError({hand.name, "preshape " + preshape.name,
                        "links " + a.name + " and " + b.name + " collide"});
    }
  }
  return gaps;
}

void check_object_is_free(const CompiledScene& scene) {
  constexpr double kFarUp = 1.0;  // m
  for (const PlacedBody& obstacle : scene.obstacles()) {
    if (!bodies_overlap(scene.object(), obstacle, obstacle.X_RB)) continue;
    std::string problem = scene.scene.object.name + " overlaps the obstacle " + obstacle.name;
    const Vector3 up_O = scene.scene.object.X_WO.linear().transpose() * Vector3::UnitZ();
    if (const auto rise = rise_to_be_free(scene.object(), {obstacle}, up_O, kFarUp)) {
      problem += formatted(", and would be free of it %.3g mm higher", 1000.0 * *rise);
    }
    throw InputError({scene.scene.name, "object", problem});
  }
}

// A lip covers a disc, and a disc has its diameter as width in some direction of each plane: also
// of that of the two shortest edges of the box around the object, which is no wider than their
// diagonal.
void check_cups_fit(const Scene& scene) {
  const Vector3 size = bounds(scene.object.mesh).size();
  const double widest = std::sqrt(size.squaredNorm() - size.maxCoeff() * size.maxCoeff());
  for (const SuctionCup& cup : scene.hand.hand->cups) {
    if (2.0 * cup.radius <= widest) continue;
    throw InputError({scene.hand.name, "cups",
                      formatted("%.3g mm wide, more than the object %s (%.3g mm)%s: take a smaller "
                                "cup",
                                2000.0 * cup.radius, scene.object.name.c_str(), 1000.0 * widest,
                                unit_hint(scene.object).c_str())});
  }
}

// The object and the obstacles, in the object's frame.
std::vector<PlacedBody> placed_bodies(const Scene& scene, const RunContext& context) {
  const auto placed = [&context](const std::string& name, const TriangleMesh& mesh,
                                 const Pose& X_OB) {
    context.cancellation.check();
    return PlacedBody{make_collision_body(name, mesh, check_mesh(mesh).solid(), context), X_OB};
  };
  std::vector<PlacedBody> bodies = {placed(scene.object.name, scene.object.mesh, Pose::Identity())};
  const Pose X_OW = scene.object.X_WO.inverse();
  for (const StaticBody& body : scene.obstacles) {
    bodies.push_back(placed(body.name, body.mesh, X_OW * body.X_WB));
  }
  return bodies;
}

// The same bodies in the base frame of the platform that carries the hand.
std::vector<PlacedBody> bodies_in_base(const CompiledScene& scene) {
  const Pose X_BO = scene.scene.carrier->X_WB.inverse() * scene.scene.object.X_WO;
  std::vector<PlacedBody> bodies = scene.bodies;
  for (PlacedBody& body : bodies) body.X_RB = X_BO * body.X_RB;
  return bodies;
}

}  // namespace

// Links and bodies come first: preshape gaps, the test of the object and the arm need their search
// trees. The arm comes last, since it takes over the bodies in the frame of its own base.
CompiledScene compile(Scene scene, const RunContext& context) {
  if (!scene.hand.hand) throw InputError({scene.hand.name, "hand", "the robot is not a hand"});
  const double radius = max_distance(scene.object.mesh, scene.object.center_of_mass);
  if (!(radius > 0.0) || !std::isfinite(radius)) {
    throw InputError({scene.name, "object", "has no extent", scene.object.name});
  }
  const double size = bounds(scene.object.mesh).size().maxCoeff();
  if (size < kSmallestObject) {
    throw InputError({scene.name, "object",
                      formatted("%.3g mm large%s: too small to find contacts on", 1000.0 * size,
                                unit_hint(scene.object).c_str()),
                      scene.object.name});
  }
  check_cups_fit(scene);
  CompiledScene compiled{.scene = scene};
  compiled.links = compile_links(scene, scene.hand);
  compiled.bodies = placed_bodies(scene, context);
  compiled.near_obstacles = BodyTree(compiled.bodies);
  compiled.keep_out = SurfaceRegions(scene.keep_out);
  compiled.preferred = SurfaceRegions(scene.preferred);
  compiled.porous = SurfaceRegions(scene.porous);
  compiled.object_surface =
      SurfaceMaterials(scene.object.material, scene.object.surfaces, compiled.object().mesh);
  compiled.self_pairs = collision_pairs(compiled.links, scene.hand);
  for (const Preshape& preshape : scene.hand.hand->preshapes) {
    context.cancellation.check();
    compiled.preshape_gaps.push_back(gaps_at(compiled, preshape));
  }
  compiled.pushing_H = pushing_direction(scene.hand);
  // Torques are taken about the centre of mass and divided by the largest distance of the object
  // from it (WrenchFrame).
  compiled.wrench_frame = {scene.object.center_of_mass, 1.0 / radius};
  context.cancellation.check();
  check_object_is_free(compiled);
  context.cancellation.check();
  if (scene.carrier) compiled.arm = compile_arm(scene, bodies_in_base(compiled));
  return compiled;
}

BodyPlaces places_of(const Scene& scene) {
  BodyPlaces places{scene.object.X_WO, {}};
  for (const StaticBody& body : scene.obstacles) places.X_WB.push_back(body.X_WB);
  return places;
}

void set_places(Scene& scene, const BodyPlaces& places) {
  assert(places.X_WB.size() == scene.obstacles.size());
  scene.object.X_WO = places.X_WO;
  for (std::size_t i = 0; i < places.X_WB.size(); ++i) scene.obstacles[i].X_WB = places.X_WB[i];
}

CompiledScene with_bodies_at(const CompiledScene& scene, const BodyPlaces& places) {
  const BodyPlaces before = places_of(scene.scene);
  std::vector<bool> moved = {before.X_WO.matrix() != places.X_WO.matrix()};
  for (std::size_t i = 0; i < places.X_WB.size(); ++i) {
    moved.push_back(before.X_WB[i].matrix() != places.X_WB[i].matrix());
  }
  CompiledScene placed = scene;
  set_places(placed.scene, places);
  const Pose X_OW = places.X_WO.inverse();
  for (std::size_t i = 0; i < places.X_WB.size(); ++i) {
    placed.bodies[i + 1].X_RB = X_OW * places.X_WB[i];
  }
  placed.near_obstacles = BodyTree(placed.bodies);
  check_object_is_free(placed);
  if (scene.arm) move_bodies(placed.scene, bodies_in_base(placed), moved, *placed.arm);
  return placed;
}

}  // namespace prehend
