#include "sim/trial/uncertainty.h"

#include <array>
#include <cmath>
#include <numbers>

#include "sim/base/random.h"
#include "sim/base/require_settings.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/object_mass.h"

namespace prehend {
namespace {

// Numbers for one disturbance: three errors of position, three of attitude, one of friction, three
// of the centre of mass.
constexpr std::size_t kDimensions = 10;
using Numbers = std::array<double, kDimensions>;

// Points of the unit cube, evenly spread.
class EvenPoints {
 public:
  explicit EvenPoints(std::uint64_t seed) {
    // The only positive root of x^(d + 1) = x + 1.
    double root = 1.0;
    for (int i = 0; i < 64; ++i) root = std::pow(1.0 + root, 1.0 / (kDimensions + 1.0));
    Random random(seed);
    for (std::size_t d = 0; d < kDimensions; ++d) {
      step_[d] = std::pow(root, -static_cast<double>(d + 1));
      at_[d] = random.uniform();
    }
  }

  Numbers next() {
    for (std::size_t d = 0; d < kDimensions; ++d) at_[d] = std::fmod(at_[d] + step_[d], 1.0);
    return at_;
  }

 private:
  Numbers step_{};
  Numbers at_{};
};

// Two neighbours at a time.
Numbers normal(const Numbers& even) {
  Numbers numbers{};
  for (std::size_t d = 0; d < kDimensions; d += 2) {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - even[d]));
    const double angle = 2.0 * std::numbers::pi * even[d + 1];
    numbers[d] = radius * std::cos(angle);
    numbers[d + 1] = radius * std::sin(angle);
  }
  return numbers;
}

// A turn by a rotation vector [rad].
Matrix3 turn_by(const Vector3& vector) {
  const double angle = vector.norm();
  if (angle == 0.0) return Matrix3::Identity();
  return Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

// What numbers of deviation 1 become as a shift of the centre of mass.
Matrix3 center_shift(const CompiledScene& scene, double part_of_radius) {
  const GraspableBody& object = scene.scene.object;
  double shift = part_of_radius / scene.wrench_frame.torque_scale;
  const MassBasis basis = object.mass_basis;
  if (basis == MassBasis::center || basis == MassBasis::parts) shift *= kStatedCenter;
  Matrix3 along = Matrix3::Zero();
  if (const auto found = long_object_of_uniform_mass(object)) {
    along = (kLongCenter - 1.0) * found->axis_O * found->axis_O.transpose();
  }
  return shift * (Matrix3::Identity() + along);
}

}  // namespace

std::vector<Contact> with_friction_of(const Perturbation& perturbation,
                                      std::vector<Contact> contacts) {
  for (Contact& contact : contacts) {
    contact.friction *= contact.friction_deviation
                            ? std::exp(*contact.friction_deviation * perturbation.friction_error)
                            : perturbation.friction;
  }
  return contacts;
}

std::vector<Perturbation> perturbations(const CompiledScene& scene,
                                        const UncertaintyOptions& options, std::uint64_t seed) {
  require_settings(options);
  const Matrix3 R_OW = scene.scene.object.X_WO.linear().transpose();
  const Vector3& center_O = scene.wrench_frame.torque_origin;
  const double across = std::hypot(options.across, options.hand);
  const double along = std::hypot(options.along, options.hand);
  const double angle = std::hypot(options.angle, options.hand_angle);
  const Matrix3 shift = center_shift(scene, options.center_of_mass);
  EvenPoints points(seed);
  std::vector<Perturbation> all;
  for (int i = 0; i < options.samples; ++i) {
    const Numbers n = normal(points.next());
    const Vector3 moved_O = R_OW * Vector3(across * n[0], across * n[1], along * n[2]);
    const Matrix3 turn = turn_by(angle * Vector3(n[4], n[5], n[6]));
    Perturbation perturbation;
    perturbation.X_OC = pose_from(turn, center_O - turn * center_O + moved_O);
    perturbation.friction = std::exp(options.friction * n[3]);
    perturbation.friction_error = n[3];
    perturbation.center_of_mass_O = shift * Vector3(n[7], n[8], n[9]);
    all.push_back(perturbation);
  }
  return all;
}

}  // namespace prehend
