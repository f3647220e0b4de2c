#include "sim/motion/dynamic_grasp/resting.h"

#include "sim/base/index.h"

namespace prehend {
bool Resting::look(const World& world, const WorldHand& hand, double time) {
  const WorldBody& object = world.bodies[index(kObjectBody)];
  const double speed =
      object.motion.linear.norm() + object.motion.angular.norm() * object.shape.mesh.ball_radius();
  const double joints = world.robots[index(hand.robot)].rate.lpNorm<Eigen::Infinity>();
  const bool rests = speed < limits_.slowest && joints < 10.0 * limits_.slowest;
  if (for_ == 0.0) first_ = speed;
  for_ = rests ? for_ + time : 0.0;
  return for_ >= limits_.time && (!limits_.slows_down || speed <= first_);
}

}  // namespace prehend
