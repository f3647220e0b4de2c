// How a protocol's phase moves the base of the hand.
#pragma once

#include "sim/base/pose.h"
#include "sim/manipulation/test_procedure.h"

namespace prehend {

// What a phase's motion needs to know besides the phase.
struct BaseStart {
  Pose X_WH = Pose::Identity();       // where the base is when the phase begins
  Vector3 axis_W = Vector3::UnitZ();  // of an approach, a swing or a turn, unit
  double height = 0.0;                // of a lift [m]
  double distance = 0.0;              // of an approach [m]
};

// The pose of the base `time` [s] after the phase began. Approach and lift follow a quintic from
// rest to rest. The amplitude of circles, swings and turns grows and shrinks by such a quintic
// within the first and the last half period, or a quarter of the phase if that is less, so that
// there is no jolt.
Pose base_pose(const ProcedurePhase& phase, const BaseStart& start, double time);

}  // namespace prehend
