#include "sim/motion/energy.h"

#include "sim/base/index.h"
#include "sim/motion/joint_springs.h"
#include "sim/motion/robot_dynamics.h"
#include "sim/motion/solids.h"

namespace prehend {

namespace {

// Of gears that are pushed back, until they slip.
double gear_energy(const WorldRobot& robot) {
  if (robot.gear_stops.empty()) return 0.0;
  const Eigen::VectorXd q = joints_of(robot);
  double sum = 0.0;
  for (std::size_t c = 0; c < robot.model->clutches.size(); ++c) {
    const Clutch& clutch = robot.model->clutches[c];
    const double back = clutch.locks * (robot.gear_stops[c] - q[clutch.joints.front()]);
    sum += 0.5 * clutch.gear_stiffness * back * back;
  }
  return sum;
}

}  // namespace

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
           spring_energy(model.robot, joints_of(robot)) + gear_energy(robot);
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
