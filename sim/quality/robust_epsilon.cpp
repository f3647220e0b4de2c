#include "sim/quality/robust_epsilon.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

#include <Eigen/Geometry>

namespace prehend {
namespace {

// Standard normal numbers, with mappings of our own: those of the standard library differ between
// platforms.
class Normal {
 public:
  explicit Normal(std::uint64_t seed) : engine_(seed) {}

  double draw() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }

  Eigen::Vector3d vector(double deviation) {
    const double x = draw();
    const double y = draw();
    const double z = draw();
    return deviation * Eigen::Vector3d(x, y, z);
  }

  Eigen::Matrix3d rotation(double deviation) {
    const Eigen::Vector3d turn = vector(deviation);
    const double angle = turn.norm();
    if (angle == 0.0) return Eigen::Matrix3d::Identity();
    return Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
  }

 private:
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }

  std::mt19937_64 engine_;
};

void check(const char* name, double deviation) {
  if (!std::isfinite(deviation) || deviation < 0.0) {
    throw std::invalid_argument(std::string(name) + ": must be finite and not negative (" +
                                std::to_string(deviation) + ")");
  }
}

void check(const NoiseOptions& noise) {
  check("pose_position", noise.pose_position);
  check("pose_angle", noise.pose_angle);
  check("contact_position", noise.contact_position);
  check("normal_angle", noise.normal_angle);
  check("friction", noise.friction);
  if (noise.samples < 1) throw std::invalid_argument("samples: at least one is needed");
}

std::vector<Contact> disturbed(std::span<const Contact> contacts, const WrenchFrame& frame,
                               const NoiseOptions& noise, Normal& normal) {
  const double r = 1.0 / frame.torque_scale;
  const Eigen::Vector3d shift = normal.vector(noise.pose_position * r);
  const Eigen::Matrix3d turn = normal.rotation(noise.pose_angle);
  std::vector<Contact> moved(contacts.begin(), contacts.end());
  for (Contact& contact : moved) {
    const Eigen::Vector3d own = normal.vector(noise.contact_position * r);
    contact.position =
        frame.torque_origin + shift + own + turn * (contact.position - frame.torque_origin);
    contact.normal = normal.rotation(noise.normal_angle) * turn * contact.normal.normalized();
    contact.friction *= std::exp(noise.friction * normal.draw());
  }
  return moved;
}

}  // namespace

RobustEpsilon robust_epsilon(std::span<const Contact> contacts, const WrenchFrame& frame,
                             const WrenchSpaceOptions& space, const NoiseOptions& noise) {
  check(noise);
  check_contacts(contacts, frame);
  Normal normal(noise.seed);
  std::vector<double> values;
  RobustEpsilon robust;
  for (int k = 0; k < noise.samples; ++k) {
    const std::vector<Contact> moved = disturbed(contacts, frame, noise, normal);
    values.push_back(grasp_epsilon(moved, frame, space, epsilon_options(space)).lower);
    robust.mean += values.back() / noise.samples;
    if (values.back() > 0.0) robust.force_closure += 1.0 / noise.samples;
  }
  std::sort(values.begin(), values.end());
  const auto rank = static_cast<std::size_t>(std::ceil(0.05 * noise.samples));
  robust.percentile_5 = values[rank - 1];
  robust.force_closure = std::min(robust.force_closure, 1.0);
  return robust;
}

}  // namespace prehend
