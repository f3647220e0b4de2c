#include "sim/quality/wrench.h"

#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace prehend {
namespace {

constexpr double kUnitTolerance = 1e-3;
constexpr double kParallelSine = 1e-6;

std::string describe(const Eigen::Vector3d& vector) {
  std::ostringstream text;
  text << vector.x() << ", " << vector.y() << ", " << vector.z();
  return text.str();
}

[[noreturn]] void reject(std::size_t contact, const std::string& what) {
  throw std::invalid_argument("contact " + std::to_string(contact) + ": " + what);
}

void check_frame(const WrenchFrame& frame, int edges) {
  if (!frame.torque_origin.allFinite()) {
    throw std::invalid_argument("torque_origin: not finite (" + describe(frame.torque_origin) +
                                ")");
  }
  if (!std::isfinite(frame.torque_scale) || frame.torque_scale <= 0.0) {
    throw std::invalid_argument("torque_scale: must be positive and finite (" +
                                std::to_string(frame.torque_scale) + ")");
  }
  if (edges < 3) {
    throw std::invalid_argument("edges: a friction pyramid needs at least 3 (" +
                                std::to_string(edges) + ")");
  }
}

void check_contact(const PointContact& contact, std::size_t index) {
  if (!contact.position.allFinite()) {
    reject(index, "position: not finite (" + describe(contact.position) + ")");
  }
  if (!contact.normal.allFinite()) {
    reject(index, "normal: not finite (" + describe(contact.normal) + ")");
  }
  if (std::abs(contact.normal.norm() - 1.0) > kUnitTolerance) {
    reject(index, "normal: not unit (" + describe(contact.normal) + ")");
  }
  if (!std::isfinite(contact.friction) || contact.friction < 0.0) {
    reject(index,
           "friction: must be finite and not negative (" + std::to_string(contact.friction) + ")");
  }
}

}  // namespace

Tangents contact_tangents(const Eigen::Vector3d& normal) {
  Eigen::Vector3d first = normal.cross(Eigen::Vector3d::UnitX());
  if (first.norm() < kParallelSine) first = normal.cross(Eigen::Vector3d::UnitZ());
  first.normalize();
  return {first, normal.cross(first)};
}

Wrenches contact_wrenches(std::span<const PointContact> contacts, const WrenchFrame& frame,
                          int edges) {
  check_frame(frame, edges);
  std::vector<Eigen::Vector2d> circle;
  for (int edge = 0; edge < edges; ++edge) {
    const double angle = 2.0 * std::numbers::pi * edge / edges;
    circle.emplace_back(std::cos(angle), std::sin(angle));
  }
  Wrenches wrenches(6, static_cast<Eigen::Index>(contacts.size()) * edges);
  Eigen::Index column = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    check_contact(contacts[i], i);
    const Eigen::Vector3d normal = contacts[i].normal.normalized();
    const Tangents tangents = contact_tangents(normal);
    const Eigen::Vector3d arm = frame.torque_scale * (contacts[i].position - frame.torque_origin);
    for (const Eigen::Vector2d& edge : circle) {
      const Eigen::Vector3d tangential = edge.x() * tangents.first + edge.y() * tangents.second;
      const Eigen::Vector3d force = normal + contacts[i].friction * tangential;
      wrenches.col(column++) << force, arm.cross(force);
    }
  }
  return wrenches;
}

}  // namespace prehend
