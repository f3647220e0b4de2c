#include "sim/quality/suction_cup.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/quality/wrench.h"

namespace prehend {
namespace {

constexpr double kMostLipForce = 2.0;
// Corners of the polygon of tilting torques: more would make too many columns.
constexpr int kMostTiltEdges = 16;

}  // namespace

// A ring of radius r, pressed with l, has the line force l / (2 pi r). Tilted until one side is
// relaxed, the line force is l / (2 pi r) (1 + cos a) at the angle a, with the torque r l / 2.
double largest_tilt(const Contact& cup, double lip_force) {
  return std::min(0.5 * cup.torsion * lip_force, cup.moment);
}

std::array<double, 3> lip_levels(const Contact& cup) {
  const double elastic = cup.torsion > 0.0 ? 2.0 * cup.moment / cup.torsion : 0.0;
  return {0.0, std::min(elastic, kMostLipForce), kMostLipForce};
}

TiltMap tilt_map(const Contact& cup, const WrenchFrame& frame) {
  const Tangents tangents = contact_tangents(cup.normal.normalized());
  TiltMap map = TiltMap::Zero();
  map.col(0).tail<3>() = frame.torque_scale * tangents.first;
  map.col(1).tail<3>() = frame.torque_scale * tangents.second;
  return map;
}

// For a force l on the lip the farthest point is that of a soft finger and of a disc of torques,
// each by itself. Its value is concave and piecewise linear in l, so the largest is at a level.
Wrench cup_support(const Contact& cup, const WrenchFrame& frame, const Wrench& direction) {
  const ContactMap map = contact_map(cup, frame);
  const TiltMap tilts = tilt_map(cup, frame);
  const Eigen::Vector4d along = map.transpose() * direction;
  const Eigen::Vector2d tilting = tilts.transpose() * direction;
  const Eigen::Vector3d grip(along[1], along[2], cup.torsion * along[3]);
  const double grip_length = grip.norm();
  const double tilt_length = tilting.norm();
  double best = -1.0;
  double value = 0.0;
  for (const double lip : lip_levels(cup)) {
    const double reached = along[0] * (lip - 1.0) + cup.friction * lip * grip_length +
                           largest_tilt(cup, lip) * tilt_length;
    if (best >= 0.0 && !(reached > value)) continue;
    best = lip;
    value = reached;
  }
  Eigen::Vector4d force(best - 1.0, 0.0, 0.0, 0.0);
  if (grip_length > 0.0) {
    const Eigen::Vector3d friction = cup.friction * best / grip_length * grip;
    force.tail<3>() << friction[0], friction[1], cup.torsion * friction[2];
  }
  Wrench wrench = map * force;
  if (tilt_length > 0.0) wrench += tilts * (largest_tilt(cup, best) / tilt_length * tilting);
  return wrench;
}

int cup_corner_count(int edges) {
  return 1 +
         2 * std::min(edges, kMostTiltEdges) * pyramid_corners(ContactModel::soft_finger, edges);
}

void cup_corners(const Contact& cup, const WrenchFrame& frame, int edges,
                 const Eigen::Matrix3Xd& friction, Eigen::Ref<Wrenches> corners) {
  const ContactMap map = contact_map(cup, frame);
  const TiltMap tilts = tilt_map(cup, frame);
  const std::array<double, 3> levels = lip_levels(cup);
  corners.col(0) = -map.col(0);
  Eigen::Index column = 1;
  const int tilt_edges = std::min(edges, kMostTiltEdges);
  for (const double lip : {levels[1], levels[2]}) {
    for (int edge = 0; edge < tilt_edges; ++edge) {
      const double angle = 2.0 * std::numbers::pi * edge / tilt_edges;
      const Eigen::Vector2d tilt(std::cos(angle), std::sin(angle));
      auto block = corners.middleCols(column, friction.cols());
      block.noalias() = cup.friction * lip * map.middleCols<2>(1) * friction.topRows<2>();
      block.noalias() += cup.friction * lip * cup.torsion * map.col(3) * friction.row(2);
      block.colwise() += (lip - 1.0) * map.col(0) + tilts * (largest_tilt(cup, lip) * tilt);
      column += friction.cols();
    }
  }
}

// A lip that is tilted by `strain` as an angle moves by strain r cos a along the axis, at the line
// stiffness K / (2 pi r): the torque is the integral of K / (2 pi r) strain r cos a over the lip,
// with the lever arm r cos a, K r^2 strain / 2. In the source this is pi r kappa.
Contact cup_contact(const Eigen::Vector3d& position, const Eigen::Vector3d& normal, double radius,
                    double friction, double vacuum, double lip_stiffness, double strain) {
  Contact contact{position, normal, friction, ContactModel::suction, radius};
  contact.moment = vacuum > 0.0 ? 0.5 * lip_stiffness * strain * radius * radius / vacuum : 0.0;
  contact.vacuum = vacuum;
  return contact;
}

}  // namespace prehend
