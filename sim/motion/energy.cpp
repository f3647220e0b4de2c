#include "sim/motion/energy.h"

#include "sim/base/index.h"
#include "sim/motion/joint_springs.h"
#include "sim/motion/robot_dynamics.h"
#include "sim/motion/solids.h"

namespace prehend {

double energy_of(const World& world) {
  double sum = 0.0;
  for (const WorldBody& body : world.bodies) {
    if (body.is_fixed) continue;
    sum += kinetic_energy(body.inertial, body.motion) -
           body.inertial.mass * world.gravity.dot(center_in_world(body.inertial, body.motion.X_WB));
  }
  for (const WorldRobot& robot : world.robots) {
    const RobotModel& model = *robot.model;
    sum += model.dynamics->kinetic_energy(joints_of(robot), model.joints_of * robot.rate) +
           0.5 * robot.rate.dot(model.drive_inertia.cwiseProduct(robot.rate)) +
           spring_energy(model.robot, joints_of(robot));
    const RobotState state = state_of(robot);
    for (const Link& link : model.robot.links) {
      if (link.joint < 0) continue;
      const Vector3 center = state.X_WA[index(link.joint)] * link.inertial.center_of_mass;
      sum -= link.inertial.mass * world.gravity.dot(center);
    }
  }
  return sum;
}

}  // namespace prehend
