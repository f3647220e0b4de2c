// The scene and the hand of a session in motion: the object is free, obstacles are fixed, the base
// of the hand is held in place, and drives move its degrees of freedom.
#pragma once

#include <optional>
#include <vector>

#include "planner/live/hand_posture.h"
#include "sim/base/range.h"
#include "sim/motion/dynamic_grasp/scene_world.h"
#include "sim/motion/step_world.h"

namespace prehend {

struct TimeOptions {
  bool gravity = true;
  // Longest step of the simulation, in kLiveStep [s].
  double step = StepOptions{}.step;
};

// Within these a person can wait for an answer, and sees the hand move [s].
inline constexpr Range kLiveStep{.lower = 5e-4, .upper = 2e-2};
// That one call may go on for, so that it ends soon [s].
inline constexpr Range kLiveAdvance{.upper = 1.0, .without_lower = true};

// What moves a degree of freedom; with neither it is held where it is, with up to its largest
// effort. Not both.
struct DofDrive {
  // Goes there and holds it [rad or m]. Its speed is that with which the hand closes, or what it
  // may have at most where it does not close.
  std::optional<double> target = {};
  std::optional<double> effort = {};  // acts on it whatever happens [N m or N]
};

// A spring of no length from a point of the object to a point of the world, critically damped for
// the mass that the point moves.
struct ObjectPull {
  Vector3 point_O = Vector3::Zero();
  Vector3 to_W = Vector3::Zero();
  double stiffness = 0.0;  // >= 0 [N/m]
};

// A value: a copy goes on by itself. The same calls give the same bytes.
class MovingWorld {
 public:
  // At rest, with all degrees of freedom held. Throws InputError for options out of range, an
  // object without a mass, and bodies that overlap.
  MovingWorld(const CompiledScene& scene, const Pose& X_WH, const HandPosture& posture,
              const TimeOptions& options);

  const TimeOptions& options() const { return options_; }
  const World& world() const { return world_; }
  const WorldHand& hand() const { return hand_; }
  double time() const { return time_; }  // since the start [s]

  // Moves on by `seconds`, in kLiveAdvance, in equal steps of at most
  // options().step, that become shorter where bodies meet. Ends early where a step is blocked or
  // not finite, or after twenty times as many steps. Returns the worst that happened to a step.
  StepOutcome advance(double seconds);
  // Of the last step; `moved` before the first.
  StepOutcome last() const { return last_; }

  // The drive of one degree of freedom of the hand from now on: targets beyond its limits are taken
  // as the limits, efforts beyond its largest as that.
  void drive(std::size_t dof, const DofDrive& drive);
  const std::vector<DofDrive>& drives() const { return drives_; }
  // Throws InputError of the field "stiffness" for one that steps of this length cannot follow.
  void pull(const std::optional<ObjectPull>& pull);
  const std::optional<ObjectPull>& pulling() const { return pull_; }

  const RigidMotion& object() const { return world_.bodies[0].motion; }
  // The hand relative to the object, and its values.
  HandPosture posture() const;

 private:
  void set_drives(double step);
  void set_pull();
  StepOutcome step(double longest, double& taken);
  void wake();

  TimeOptions options_;
  World world_;
  WorldHand hand_;
  std::vector<DofDrive> drives_;
  std::optional<ObjectPull> pull_;
  double time_ = 0.0;
  StepOutcome last_ = StepOutcome::moved;
};

}  // namespace prehend
