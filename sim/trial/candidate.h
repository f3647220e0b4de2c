// A grasp to try.
#pragma once

#include <optional>
#include <vector>

#include "sim/base/pose.h"

namespace prehend {

struct ClosingStrategy;
struct Robot;

// A grasp to try: where the hand goes, from which direction, and with which opening it starts.
struct Candidate {
  // Pose of the hand's base at the end of an approach that touches nothing.
  Pose X_OH = Pose::Identity();
  Vector3 approach_O = Vector3::UnitZ();  // direction in which the hand moves, unit, object frame
  double approach_distance = 0.0;         // from the pre-grasp to X_OH; 0: no approach [m]
  std::optional<int> preshape;            // index into Hand::preshapes; none: `dofs` is used
  // Without a preshape, the start values of the hand's degrees of freedom [rad or m].
  std::vector<double> dofs;
  // With `dofs`, the start values of the joints [rad or m]; empty: joint_values of `dofs`.
  std::vector<double> joints;
  // Index into Hand::strategies, by which the hand closes on an object that gives way; none: all at
  // once.
  std::optional<int> strategy = std::nullopt;
};

// The values of all degrees of freedom before closing [rad or m].
const std::vector<double>& start_dofs(const Robot& hand, const Candidate& candidate);

// The values of all joints before closing [rad or m]: those of the candidate's preshape, those
// given for every joint, or those that follow from its degrees of freedom. `joints` is replaced.
void start_joints(const Robot& hand, const Candidate& candidate, std::vector<double>& joints);

// How the hand closes on an object that gives way.
ClosingStrategy strategy_of(const Robot& hand, const Candidate& candidate);

}  // namespace prehend
