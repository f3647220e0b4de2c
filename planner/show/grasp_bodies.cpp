#include "planner/show/grasp_bodies.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "planner/show/palette.h"
#include "sim/base/index.h"
#include "sim/scene/compiled_scene.h"
#include "sim/shape/weld.h"

namespace prehend {
namespace {

// Diagonal of the bounding box below which a link of the arm only marks a place [m].
constexpr double kMarker = 0.01;

// Sizes of marks as parts of the object's radius.
constexpr double kConeLength = 0.22;
constexpr double kArrowLength = 1.1;
constexpr double kForceRadius = 0.035;
constexpr double kTorqueRadius = 0.015;

// Largest distance of the object from its centre of mass: what marks are sized by.
double object_radius(const CompiledScene& scene) { return 1.0 / scene.wrench_frame.torque_scale; }

std::vector<DrawnBody> joined(std::initializer_list<const std::vector<DrawnBody>*> lists) {
  std::vector<DrawnBody> bodies;
  for (const std::vector<DrawnBody>* list : lists) {
    bodies.insert(bodies.end(), list->begin(), list->end());
  }
  return bodies;
}

DrawnBody link_body(const Link& link, const Pose& X_WL, const Color& color) {
  return {SharedMesh::borrowed(link.mesh), X_WL, color, link.name};
}

std::vector<DrawnBody> hand_bodies(const CompiledScene& scene, const PosedGrasp& grasp) {
  const Robot& hand = scene.scene.hand;
  const Pose X_WH = scene.scene.object.X_WO * grasp.X_OH;
  std::vector<Pose> X_HL;
  link_poses(hand, grasp.joints, X_HL);
  std::vector<DrawnBody> bodies;
  for (std::size_t l = 0; l < hand.links.size(); ++l) {
    const Link& link = hand.links[l];
    const Color& color = link.material == "rubber" ? palette::kRubber : palette::kHard;
    bodies.push_back(link_body(link, X_WH * X_HL[l], color));
  }
  return bodies;
}

// Adds the part of a triangle that is in the region to `skin`: where not all corners are, the
// triangle is halved, down to pieces of a size.
void add_skin(const SurfaceMaterials& materials, int region, const Corners& corners, double size,
              TriangleMesh& skin) {
  int inside = 0;
  for (const Vector3& corner : corners) inside += materials.region_at(corner) == region ? 1 : 0;
  std::size_t longest = 0;
  const auto side = [&](std::size_t i) { return (corners[(i + 1) % 3] - corners[i]).norm(); };
  for (std::size_t i = 1; i < 3; ++i) {
    if (side(i) > side(longest)) longest = i;
  }
  if (inside == 3 || side(longest) <= size) {
    if (inside < 2) return;
    const int first = static_cast<int>(skin.vertices.size());
    skin.vertices.insert(skin.vertices.end(), corners.begin(), corners.end());
    skin.triangles.push_back({first, first + 1, first + 2});
    return;
  }
  const Vector3& a = corners[longest];
  const Vector3& b = corners[(longest + 1) % 3];
  const Vector3& c = corners[(longest + 2) % 3];
  const Vector3 half = 0.5 * (a + b);
  add_skin(materials, region, {a, half, c}, size, skin);
  add_skin(materials, region, {half, b, c}, size, skin);
}

// Moves the vertices outward, so that the surface below does not show through.
void lift(TriangleMesh& skin, double height) {
  std::vector<Vector3> outward(skin.vertices.size(), Vector3::Zero());
  for (std::size_t t = 0; t < skin.triangles.size(); ++t) {
    for (const int v : skin.triangles[t]) outward[index(v)] += doubled_area_vector(skin, t);
  }
  for (std::size_t v = 0; v < outward.size(); ++v) {
    if (outward[v].norm() > 0.0) skin.vertices[v] += height * outward[v].normalized();
  }
}

// The object's parts of other materials. A stripe across a triangle shows where it is wider than a
// piece, a 40th of the object's radius.
std::vector<DrawnBody> surface_bodies(const CompiledScene& scene, const Pose& X_WC) {
  constexpr double kPiece = 0.025;
  constexpr double kHeight = 0.002;
  constexpr double kSame = 1e-6;
  const SurfaceMaterials& materials = scene.object_surface;
  const TriangleMesh& mesh = scene.scene.object.mesh;
  const double radius = object_radius(scene);
  std::vector<DrawnBody> bodies;
  for (int i = 0; i < materials.regions(); ++i) {
    TriangleMesh pieces;
    for (int t = 0; t < std::ssize(mesh.triangles); ++t) {
      add_skin(materials, i, corners_of(mesh, t), kPiece * radius, pieces);
    }
    if (pieces.empty()) continue;
    TriangleMesh skin = weld(pieces, kSame * radius).mesh;
    lift(skin, kHeight * radius);
    const SurfaceMaterial& of = materials.of(i);
    bodies.push_back({std::move(skin), X_WC, palette::of_surface(of.material, !of.name.empty()),
                      surface_name(of)});
  }
  return bodies;
}

std::vector<DrawnBody> arm_bodies(const CompiledScene& scene, const PosedGrasp& grasp) {
  std::vector<DrawnBody> bodies;
  if (grasp.arm_joints.empty()) return bodies;
  const CompiledArm& arm = *scene.arm;
  std::vector<Pose> X_BL;
  arm_link_poses(arm, grasp.arm_joints, X_BL);
  for (std::size_t l = 0; l < X_BL.size(); ++l) {
    // The platform contains the hand, which hand_bodies has drawn already.
    if (arm.is_hand_link(link_id(l))) continue;
    bodies.push_back(link_body(arm.robot().links[l], arm.X_WB * X_BL[l], palette::kArm));
  }
  return bodies;
}

DrawnBody contact_body(const CompiledScene& scene, const Pose& X_WC, const Contact& point,
                       int cone_sides) {
  // The cone of a frictionless contact has no width and would be invisible.
  const double slope = std::max(0.05, point.friction);
  // All cones are equally long along their sides, however wide they are.
  const double length = kConeLength * object_radius(scene) / std::sqrt(1.0 + slope * slope);
  return {cone_mesh(point.position, point.normal, slope, length, cone_sides), X_WC,
          palette::kContact, "contact"};
}

// Two arrows from the torque origin (the centre of mass), for force and torque. Torques of a wrench
// are scaled to forces, so the lengths of both can be compared: they are in proportion to the two
// parts, and the root of the sum of their squares is kArrowLength times the radius.
std::vector<DrawnBody> weakest_bodies(const CompiledScene& scene, const Pose& X_WC,
                                      const Wrench& wrench) {
  if (wrench.isZero(0.0)) return {};
  const double radius = object_radius(scene);
  const Vector3& origin = scene.wrench_frame.torque_origin;
  const Vector3 force = wrench.head<3>() / wrench.norm() * kArrowLength * radius;
  const Vector3 torque = wrench.tail<3>() / wrench.norm() * kArrowLength * radius;
  return {{arrow_mesh(origin, origin + force, kForceRadius * radius), X_WC, palette::kWeakest,
           "weakest force"},
          {arrow_mesh(origin, origin + torque, kTorqueRadius * radius), X_WC, palette::kWeakest,
           "weakest torque"}};
}

}  // namespace

std::vector<DrawnBody> GraspBodies::grasp() const {
  std::vector<DrawnBody> bodies = {object};
  for (const DrawnBody& body : joined({&surfaces, &hand, &contacts, &weakest})) {
    bodies.push_back(body);
  }
  return bodies;
}

std::vector<DrawnBody> GraspBodies::surroundings() const { return joined({&obstacles, &arm}); }

std::vector<DrawnBody> GraspBodies::all() const {
  const std::vector<DrawnBody> first = grasp();
  return joined({&first, &obstacles, &arm});
}

std::vector<DrawnBody> GraspBodies::grasp_and_arm() const {
  std::vector<DrawnBody> bodies = grasp();
  for (const DrawnBody& link : arm) {
    if (bounds(*link.mesh).size().norm() > kMarker) bodies.push_back(link);
  }
  return bodies;
}

GraspBodies grasp_bodies(const CompiledScene& scene, const PosedGrasp& grasp, int cone_sides) {
  const GraspableBody& object = scene.scene.object;
  GraspBodies bodies;
  const Pose X_WC = object.X_WO * grasp.X_OC;
  bodies.object = {SharedMesh::borrowed(object.mesh), X_WC, palette::kObject, object.name};
  bodies.surfaces = surface_bodies(scene, X_WC);
  bodies.hand = hand_bodies(scene, grasp);
  for (const GraspContact& contact : grasp.contacts) {
    bodies.contacts.push_back(contact_body(scene, X_WC, contact.point, cone_sides));
  }
  bodies.weakest = weakest_bodies(scene, X_WC, grasp.weakest);
  for (const StaticBody& body : scene.scene.obstacles) {
    bodies.obstacles.push_back(
        {SharedMesh::borrowed(body.mesh), body.X_WB, palette::kObstacle, body.name});
  }
  bodies.arm = arm_bodies(scene, grasp);
  return bodies;
}

}  // namespace prehend
