#include "sim/motion/placed_contact.h"

#include <algorithm>
#include <cmath>

namespace prehend {
namespace {

// A round value of the radius of fingertips, with which the depth of a compliant material was
// stated (friction_table.h) [m].
constexpr double kPadRadius = 0.03;
// Contacts with more friction count as having this: they hold within three degrees of the surface.
// The lift mu |w_t| of the law (contact_problem.h) hides a normal velocity behind a slip of 1/mu of
// it, until rounding leaves nothing of either.
constexpr double kMostFriction = 20.0;

bool is_uniform(const Solid& a, const Solid& b) {
  return a.surface == nullptr && b.surface == nullptr;
}

// What the solid is made of at a point of its surface, in its frame.
SurfaceMaterial surface_at(const Solid& solid, const Vector3& p_S) {
  return solid.surface != nullptr ? solid.surface->at(p_S) : SurfaceMaterial{solid.material};
}

}  // namespace

double soft_arm(double depth) {
  return 3.0 * std::acos(-1.0) / 16.0 * std::sqrt(kPadRadius * depth);
}

PlacedContact placed(const HeldContact& contact, const Solid& a, const Solid& b) {
  const Vector3 on_a = a.X_WS * contact.p_A;
  const Vector3 on_b = b.X_WS * contact.p_B;
  const Matrix3& R = a.X_WS.linear();
  const Vector3 tangent = any_orthogonal(contact.normal_A);
  const std::array<Vector3, 3> directions = {R * contact.normal_A, R * tangent,
                                             R * contact.normal_A.cross(tangent)};
  const Vector3 between = on_a - on_b;
  return {0.5 * (on_a + on_b),
          directions,
          directions[0].dot(between),
          {directions[1].dot(between), directions[2].dot(between)}};
}

double friction_of(const ContactLaws& laws, const HeldContact& contact, const Solid& a,
                   const Solid& b) {
  const FrictionTable& table = contact.slides && laws.kinetic ? *laws.kinetic : laws.friction;
  const double friction = is_uniform(a, b) ? table.between(a.material, b.material)
                                           : friction_between(table, surface_at(a, contact.p_A),
                                                              surface_at(b, contact.p_B));
  return std::min(friction, kMostFriction);
}

double arm_of(const ContactLaws& laws, const HeldContact& contact, const Solid& a, const Solid& b,
              double friction) {
  const bool of_robot = a.id.robot >= 0 || b.id.robot >= 0;
  if (of_robot && laws.torsion) return friction > 0.0 ? *laws.torsion / friction : 0.0;
  if (is_uniform(a, b)) return soft_arm(laws.compliant_depths.between(a.material, b.material));
  return soft_arm(
      depth_between(laws.compliant_depths, surface_at(a, contact.p_A), surface_at(b, contact.p_B)));
}

}  // namespace prehend
