// The equation of motion of a robot in the coordinates of its joints:
//
//   tau = M(q) a + h(q, v)
//
// with the mass matrix M and the bias h (Coriolis, centrifugal, gyroscopic and gravity terms).
// Efforts tau are torques of revolute joints [N m] and forces of prismatic ones [N]. Source:
// Featherstone 2008, Rigid Body Dynamics Algorithms, chapters 5 to 7.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/motion/spatial.h"
#include "sim/robot/robot.h"

namespace prehend {

// Values, velocities and so on, one number for each joint of the robot, in its order.
using JointVector = Eigen::VectorXd;

// What acts on a robot besides the efforts of its joints.
struct RobotSurroundings {
  // Acceleration of a body that falls freely, in the robot's base frame B [m/s^2].
  Vector3 gravity_B = Vector3::Zero();
  // Velocity and acceleration of the base, in B: of a robot that another one carries.
  Vector6 base_velocity = Vector6::Zero();
  Vector6 base_acceleration = Vector6::Zero();
  // A force on the links that follow each joint, in the frame A after that joint: its moment about
  // A's origin, then the force. Empty: none.
  std::vector<Vector6> forces_A;
};

// A robot made ready for dynamics: for each joint the mass that it carries. The links of the base
// do not matter. All functions take one number a joint, and may be called from several threads.
class RobotDynamics {
 public:
  // Throws InputError that names the joint for a robot that is no tree (require_sound), and for a
  // joint that moves no mass: it would accelerate without bound.
  explicit RobotDynamics(const Robot& robot);

  Eigen::Index joints() const { return static_cast<Eigen::Index>(bodies_.size()); }

  // The efforts that give the joints the accelerations a: recursive Newton-Euler. O(joints).
  JointVector inverse(const JointVector& q, const JointVector& v, const JointVector& a,
                      const RobotSurroundings& around = {}) const;

  // inverse() without accelerations: what the efforts have to balance.
  JointVector bias(const JointVector& q, const JointVector& v,
                   const RobotSurroundings& around = {}) const;

  // M(q), symmetric and positive definite: composite rigid bodies.
  Eigen::MatrixXd mass_matrix(const JointVector& q) const;

  // The accelerations that the efforts cause: articulated bodies. O(joints).
  JointVector forward(const JointVector& q, const JointVector& v, const JointVector& effort,
                      const RobotSurroundings& around = {}) const;

  // Kinetic energy of all links that joints move, the base at rest [J].
  double kinetic_energy(const JointVector& q, const JointVector& v) const;

 private:
  // A joint with all links that follow it, in the frame A after it.
  struct Body {
    Joint joint;
    Vector6 S_A = Vector6::Zero();  // motion of A for a unit velocity of the joint
    Matrix6 inertia_A = Matrix6::Zero();
  };

  std::vector<Pose> poses(const JointVector& q) const;

  std::vector<Body> bodies_;
};

// How the joints follow the degrees of freedom: joint velocities = matrix * velocities of the
// degrees of freedom, as long as no clutch is open. One row a joint.
Eigen::MatrixXd coupling_matrix(const Robot& robot);

}  // namespace prehend
