#include "sim/manipulation/base_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/motion/control/quintic_step.h"

namespace prehend {
namespace {

// The part of the amplitude at a time.
double swell(const ProcedurePhase& phase, double time) {
  const double ramp = std::min(0.25 * phase.duration, 0.5 / std::max(phase.frequency, 1e-9));
  return std::min(quintic_step(time / ramp), quintic_step((phase.duration - time) / ramp));
}

}  // namespace

Pose base_pose(const ProcedurePhase& phase, const BaseStart& start, double time) {
  Pose X_WH = start.X_WH;
  const double angle = 2.0 * std::numbers::pi * phase.frequency * time;
  switch (phase.kind) {
    case PhaseKind::approach:
      X_WH.translation() += start.distance * quintic_step(time / phase.duration) * start.axis_W;
      break;
    case PhaseKind::lift:
      X_WH.translation().z() += start.height * quintic_step(time / phase.duration);
      break;
    case PhaseKind::circle:
      X_WH.translation() +=
          phase.amplitude * swell(phase, time) * Vector3(std::cos(angle), std::sin(angle), 0.0);
      break;
    case PhaseKind::swing:
      X_WH.translation() += phase.amplitude * swell(phase, time) * std::sin(angle) * start.axis_W;
      break;
    case PhaseKind::turn:
      X_WH.linear() =
          Eigen::AngleAxisd(phase.amplitude * swell(phase, time) * std::sin(angle), start.axis_W) *
          start.X_WH.linear();
      break;
    case PhaseKind::settle:
    case PhaseKind::close:
    case PhaseKind::hold:
    case PhaseKind::open:
      break;
  }
  return X_WH;
}

}  // namespace prehend
