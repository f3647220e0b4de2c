#include "sim/motion/dynamic_grasp/resting.h"

#include "sim/base/index.h"

namespace prehend {
namespace {

constexpr double kSlowest = 1e-4;   // of all points of the object [m/s], ten times that of joints
constexpr double kRestTime = 0.05;  // for how long they have to be slower [s]

}  // namespace

bool Resting::look(const World& world, const WorldHand& hand, double time) {
  const WorldBody& object = world.bodies[index(kObjectBody)];
  const double speed =
      object.motion.linear.norm() + object.motion.angular.norm() * object.shape.mesh.ball_radius();
  const double joints = world.robots[index(hand.robot)].rate.lpNorm<Eigen::Infinity>();
  const bool rests = speed < kSlowest && joints < 10.0 * kSlowest;
  for_ = rests ? for_ + time : 0.0;
  return for_ >= kRestTime;
}

}  // namespace prehend
