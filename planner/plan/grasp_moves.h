// The grasps near a grasp: its hand turned, shifted and with another spread of the fingers.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sim/scene/compiled_scene.h"
#include "sim/trial/candidate.h"
#include "sim/trial/trial.h"

namespace prehend {

// How far a grasp may be moved.
struct GraspReach {
  double turn = 0.0;    // of the hand, about each of its axes [rad]
  double shift = 0.0;   // of the hand, along each of its axes [m]
  double spread = 0.0;  // of each degree of freedom that does not close, 0: none [rad or m]
};

// Candidates around the grasp of a stable trial, by variables of -1 .. 1: three turns of the hand
// about the middle of the contacts, three shifts of it, and a change of the starting value for each
// degree of freedom that closing leaves alone (the spread of the Barrett hand). The axes are those
// of the hand: its approach, its closing direction, and the third. The direction in which the hand
// moves to the object turns with the hand.
//
// A hand that went on until it touched may go on by kOverrun beyond where the variables put it, so
// that a palm that rests on the object does so again after a small turn. The pre-grasp is as far
// from the grasp as that of the given trial.
class GraspMoves {
 public:
  static constexpr double kOverrun = 0.01;  // m

  // `trial` is that of `candidate` in `scene`, which must outlive this, and has contacts.
  GraspMoves(const CompiledScene& scene, const Candidate& candidate, const Trial& trial,
             const GraspReach& reach);

  std::size_t variables() const { return 6 + free_dofs_.size(); }

  // For one value per variable. All 0: the hand where it is.
  Candidate at(const std::vector<double>& x) const;

 private:
  const Robot& hand_;
  GraspReach reach_;
  Pose X_OH_ = Pose::Identity();
  Vector3 p_HC_ = Vector3::Zero();         // the middle of the contacts
  Matrix3 R_HA_ = Matrix3::Identity();     // columns: approach, closing, third axis
  Vector3 approach_H_ = Vector3::UnitZ();  // direction in which the hand moves, unit
  double approach_distance_ = 0.0;         // from the pre-grasp to X_OH [m]
  double overrun_ = 0.0;                   // m
  std::optional<int> preshape_;            // of the candidate
  std::vector<double> dofs_;               // at the pre-grasp [rad or m]
  std::vector<double> joints_;             // as Candidate::joints
  std::vector<std::size_t> free_dofs_;     // those that closing leaves alone
};

}  // namespace prehend
