// Checks that a hand and the object between its fingers can turn and slide relative to each other
// without either touching an obstacle.
#pragma once

#include <vector>

#include "sim/scene/collision_body.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/trial.h"
#include "sim/trial/trial_options.h"

namespace prehend {

// One step of settling: the hand opens a little, turns about a point of the object and slides,
// closes again and is centred.
struct HandTurn {
  Vector3 middle_O = Vector3::Zero();  // a point of the axis, object frame [m]
  double angle = 0.0;                  // >= 0 [rad]
  double slide = 0.0;                  // distance by which that point moves, >= 0 [m]
  std::vector<double> opened;          // joint values during the turn [rad or m]
  std::vector<double> closed;          // joint values at the end [rad or m]
  double shift = 0.0;                  // distance by which centring moves the hand [m]
};

// A turn changes the pose of the hand relative to the object. Which of them moves in the world
// depends on who holds them, and nothing says that. So both must be free: the hand, turned about
// the object at rest, and the object, turned the other way in the hand at rest. A body is free when
// its gap to every obstacle is larger than the farthest that any of its points moves, with
// `contact.threshold` left over; an object that stands on something, leans on it or is within the
// threshold of it can therefore not turn at all.
//
// Fingers of the hand at rest need no test of their own: how far they open is part of the test of
// the first turn, when the turned hand is still at rest, and after it they are closer together.
class ClearanceBudget {
 public:
  // To be called before anything else, and for each grasp anew; keeps the memory that it has.
  // `start`: as the hand has closed, before any turn. The scene must outlive the room.
  void start(const CompiledScene& scene, const Trial& start, const TrialOptions& options);

  // Whether the turn from `now` is free. `now` is `start` after the turns that were spent.
  bool allows(const Trial& now, const HandTurn& turn);
  // Carries the turn out: lowers the known gaps by the motion that it takes.
  void consume(const Trial& now, const HandTurn& turn);

 private:
  // Farthest that any point moves in a turn [m].
  double object_motion(const HandTurn& turn) const;
  double hand_motion(const Trial& now, const HandTurn& turn);
  // Lower bounds of the smallest gap to an obstacle, exact where it is not above `enough` [m].
  double object_gap(const Trial& now, double enough);
  double hand_gap(const Trial& now, double enough);
  double smallest_gap(const CollisionBody& body, const Pose& X_OB, double enough);

  const CompiledScene* scene_ = nullptr;
  Pose X_OH_start_ = Pose::Identity();
  double least_gap_ = 0.0;
  // Known lower bounds of the gaps at the present pose [m].
  double object_gap_ = 0.0;
  double hand_gap_ = 0.0;
  RobotPoses poses_;
  NearBodies near_;
};

}  // namespace prehend
