#include "sim/manipulation/base_motion.h"

#include <algorithm>
#include <cmath>

namespace prehend {
namespace {

const double kTwoPi = 2.0 * std::acos(-1.0);

// From 0 to 1, with no velocity and acceleration at either end: 10 s^3 - 15 s^4 + 6 s^5.
double quintic(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * s * (10.0 + s * (-15.0 + s * 6.0));
}

// A motion that repeats does not begin with its full velocity: it grows for a quarter of a period.
double grown(const ProtocolPhase& phase, double time) {
  return quintic(4.0 * phase.frequency * time);
}

}  // namespace

Pose base_pose(const ProtocolPhase& phase, const Pose& X_WH_start, double height,
               const Vector3& axis_W, double time) {
  const double angle = kTwoPi * phase.frequency * time;
  const double amplitude = grown(phase, time) * phase.amplitude;
  const auto shifted = [&](const Vector3& way) { return translation(way) * X_WH_start; };
  switch (phase.kind) {
    case PhaseKind::lift:
      return shifted(height * quintic(time / phase.duration) * Vector3::UnitZ());
    case PhaseKind::circle:
      return shifted(amplitude * Vector3(std::cos(angle), std::sin(angle), 0.0));
    case PhaseKind::swing:
      return shifted(amplitude * std::sin(angle) * axis_W);
    case PhaseKind::turn:
      return pose_from(Eigen::AngleAxisd(amplitude * std::sin(angle), axis_W) * X_WH_start.linear(),
                       X_WH_start.translation());
    default:
      return X_WH_start;
  }
}

}  // namespace prehend
