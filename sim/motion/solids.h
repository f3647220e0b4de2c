// All bodies and links of a world as one list: where they are, how they move, and how a velocity of
// one of their points follows from the velocities of the world.
#pragma once

#include <vector>

#include "sim/motion/contact_problem.h"
#include "sim/motion/world.h"

namespace prehend {

// A body, or a link of a robot.
struct Solid {
  SolidId id = {};
  const CollisionBody* shape = nullptr;
  Material material = Material::plastic;
  const SurfaceMaterials* surface = nullptr;  // where it is not of the material all over
  double restitution = 0.0;
  int mover = -1;  // what moves it, in Movers: -1: nothing does
  Pose X_WS = Pose::Identity();
  Vector3 angular = Vector3::Zero();          // world axes [rad/s]
  Vector3 origin_velocity = Vector3::Zero();  // of the origin of S [m/s]
  bool moves = false;                         // or is moved, with a base

  Vector3 velocity_at(const Vector3& p_W) const {
    return origin_velocity + angular.cross(p_W - X_WS.translation());
  }
};

// A robot at its present posture.
struct RobotState {
  std::vector<Pose> X_WA;         // of the frames after each joint
  std::vector<Vector3> axis_W;    // of each joint
  std::vector<Vector3> origin_W;  // a point on it
  std::vector<Vector3> angular;   // of the frames after each joint
  std::vector<Vector3> linear;    // of their origins
};
RobotState state_of(const WorldRobot& robot);

// The solids in the order of bodies, then of robots and their links. Movers are counted in the same
// order: body i is mover i, robot r the one after all bodies and r others.
class Solids {
 public:
  explicit Solids(const World& world);

  const std::vector<Solid>& all() const { return solids_; }
  const Solid& at(const SolidId& id) const;
  int place(const SolidId& id) const;
  int movers() const { return movers_; }

  // Rows of the velocities along `directions` and the spin about the first, times `arm`, of the
  // point p_W fixed to the solid, times `sign`: blocks on the velocities of its mover from `first`
  // on. What the base of its robot contributes is added to `offset`. Rows: 3, or 4 with an arm.
  void add_rows(const Solid& solid, int first, const Vector3& p_W,
                const std::array<Vector3, 3>& directions, double arm, double sign,
                ContactCondition& condition) const;

 private:
  const World* world_;
  std::vector<Solid> solids_;
  std::vector<RobotState> robots_;
  std::vector<int> first_link_;  // of each robot in the list
  int movers_ = 0;
};

// A bound on how fast the surfaces of two solids can approach each other [m/s].
double closing_speed(const Solid& a, const Solid& b);

}  // namespace prehend
