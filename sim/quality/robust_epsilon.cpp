#include "sim/quality/robust_epsilon.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Geometry>

#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/base/range.h"
#include "sim/base/require_settings.h"
#include "sim/quality/ranges.h"
#include "sim/quality/wrench_space.h"

// Samples are drawn one after the other from one generator, and every number is drawn in a
// statement of its own: the order in which the arguments of one call are evaluated is up to the
// compiler, and would change the samples. This, and a generator of our own (sim/base/random.h),
// makes the result the same on every platform.
namespace prehend {
namespace {

// A vector of three independent normal numbers.
Eigen::Vector3d normal_vector(Random& random, double deviation) {
  const double x = random.normal();
  const double y = random.normal();
  const double z = random.normal();
  return deviation * Eigen::Vector3d(x, y, z);
}

// A rotation about a random axis: the components of its rotation vector (axis times angle) are
// independent and normally distributed.
Eigen::Matrix3d normal_rotation(Random& random, double deviation) {
  const Eigen::Vector3d turn = normal_vector(random, deviation);
  const double angle = turn.norm();
  if (angle == 0.0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
}

// One sample of the contacts: all of them moved and turned together by the error of the pose, then
// each by its own. The logarithm of the friction is disturbed, so that it stays positive. What
// leaves the range of a contact is moved back to its border.
std::vector<Contact> disturbed(std::span<const Contact> contacts, const WrenchFrame& frame,
                               const NoiseOptions& noise, Random& random) {
  const double r = 1.0 / frame.torque_scale;
  const Eigen::Vector3d shift = normal_vector(random, noise.pose_position * r);
  const Eigen::Matrix3d turn = normal_rotation(random, noise.pose_angle);
  std::vector<Contact> moved(contacts.begin(), contacts.end());
  for (Contact& contact : moved) {
    const Eigen::Vector3d own = normal_vector(random, noise.contact_position * r);
    contact.position =
        (frame.torque_origin + shift + own + turn * (contact.position - frame.torque_origin))
            .cwiseMax(-kFarthest)
            .cwiseMin(kFarthest);
    contact.normal =
        normal_rotation(random, noise.normal_angle) * turn * contact.normal.normalized();
    const double deviation = contact.friction_deviation.value_or(noise.friction);
    const double rougher = contact.friction * std::exp(deviation * random.normal());
    contact.friction = std::min(rougher, kLargestFriction);
  }
  return moved;
}

}  // namespace

RobustEpsilon robust_epsilon(std::span<const Contact> contacts, const WrenchFrame& frame,
                             const WrenchSpaceOptions& space, const NoiseOptions& noise,
                             const RunContext& context) {
  require_settings(noise);
  check_contacts(contacts, frame);
  Random random(noise.seed);
  std::vector<double> values;
  RobustEpsilon robust;
  for (int k = 0; k < noise.samples; ++k) {
    context.cancellation.check();
    const std::vector<Contact> moved = disturbed(contacts, frame, noise, random);
    values.push_back(grasp_epsilon(moved, frame, space, epsilon_options(space)).lower);
    robust.mean += values.back() / noise.samples;
    if (values.back() > 0.0) robust.force_closure += 1.0 / noise.samples;
  }
  std::sort(values.begin(), values.end());
  // The percentile by the nearest rank: the smallest value that at least 5 % of the samples do not
  // exceed.
  const auto rank = static_cast<std::size_t>(std::ceil(0.05 * noise.samples));
  robust.percentile_5 = values[rank - 1];
  // Adding 1 / samples many times may exceed 1 by rounding.
  robust.force_closure = std::min(robust.force_closure, 1.0);
  return robust;
}

}  // namespace prehend
