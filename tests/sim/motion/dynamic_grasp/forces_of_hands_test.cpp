// What the hands of the library press with.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "sim/motion/dynamic_grasp/hand_drives.h"
#include "sim/motion/dynamic_grasp/scene_world.h"
#include "sim/motion/solids.h"
#include "sim/motion/step_world.h"
#include "sim/robot/files/robot_file.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

// A hand at its first preshape, in front of a block that stands still where its fingers meet.
World hand_around_block(const std::string& name) {
  const Robot robot = find_robot(name);
  const Preshape& preshape = robot.hand->preshapes.front();
  World world;
  world.gravity.setZero();
  const auto model = std::make_shared<const RobotModel>(make_robot_model(robot));
  world.robots.push_back(make_world_robot(name, model, Pose::Identity(), preshape.dofs));
  const double width = std::min(0.04, 0.5 * (preshape.min_width + preshape.max_width));
  WorldBody block{"block", make_collision_body("block", make_box({0.06, width, 0.03}), true)};
  block.is_fixed = true;
  Matrix3 R_HB;
  R_HB.col(1) = robot.hand->closing.normalized();
  R_HB.col(2) = robot.hand->approach.normalized();
  R_HB.col(0) = R_HB.col(1).cross(R_HB.col(2));
  block.motion.X_WB = pose_from(R_HB, robot.hand->origin + preshape.depth * robot.hand->approach);
  world.bodies.push_back(block);
  return world;
}

WorldHand whole_robot(const RobotModel& model) {
  return {.dofs = static_cast<int>(model.dofs()),
          .joints = static_cast<int>(model.robot.joints.size()),
          .links = static_cast<int>(model.robot.links.size())};
}

// What all contacts do to each coordinate of the robot [N m or N].
Eigen::VectorXd loads(const World& world) {
  const RobotModel& model = *world.robots[0].model;
  const RobotState state = state_of(world.robots[0]);
  Eigen::VectorXd of_joints = Eigen::VectorXd::Zero(std::ssize(model.robot.joints));
  const auto add = [&](const SolidId& id, const WorldContact& contact, double sign) {
    if (id.robot != 0) return;
    const Vector3 force = sign / world.last_step * contact.impulse_W;
    const Vector3 spin = sign / world.last_step * contact.spin_impulse * contact.normal_W;
    for (int j = model.robot.links[index(id.index)].joint; j >= 0;
         j = model.robot.joints[index(j)].parent) {
      const Vector3& axis = state.axis_W[index(j)];
      const Vector3 arm = contact.position_W - state.origin_W[index(j)];
      const bool slides = model.robot.joints[index(j)].type == JointType::prismatic;
      of_joints[j] += slides ? axis.dot(force) : axis.dot(arm.cross(force) + spin);
    }
  };
  for (const WorldContact& contact : world.contacts) {
    add(contact.a, contact, 1.0);
    add(contact.b, contact, -1.0);
  }
  return model.joints_of.transpose() * of_joints;
}

double pressed(const World& world) {
  double sum = 0.0;
  for (const WorldContact& contact : world.contacts) {
    sum += contact.impulse_W.norm() / world.last_step;
  }
  return sum;
}

bool is_at_limit(const World& world, int dof) {
  const WorldRobot& robot = world.robots[0];
  const Eigen::VectorXd q = joints_of(robot);
  for (std::size_t j = 0; j < robot.model->robot.joints.size(); ++j) {
    const Joint& joint = robot.model->robot.joints[j];
    const double at = q[static_cast<Eigen::Index>(j)];
    if (joint.dof == dof && std::min(at - joint.lower, joint.upper - at) < 1e-4) return true;
  }
  return false;
}

// Closed on a block for long, every hand presses with what its drives give, and gears behind
// clutches hold, whatever the step; and with the same force at each step once it rests.
TEST(ForcesOfHands, AreThoseOfTheirDrivesAtEveryStep) {
  int hands = 0;
  for (const std::string& name : library_robot_names()) {
    const Robot robot = find_robot(name);
    // Suction cups have no drives.
    if (!robot.hand || robot.hand->preshapes.empty() || !robot.hand->cups.empty()) continue;
    SCOPED_TRACE(name);
    ++hands;
    World closed = hand_around_block(name);
    const RobotModel& model = *closed.robots[0].model;
    closed.robots[0].drives = closing_drives(model, whole_robot(model));
    for (double time = 0.0; time < 2.0;) {
      const StepResult result = step_world(closed);
      ASSERT_GT(result.time, 0.0);
      time += result.time;
    }
    ASSERT_GT(pressed(closed), 1.0);
    double least = pressed(closed);
    double most = least;
    for (const double step : {2.5e-3, 1e-3, 5e-4, 2.5e-4}) {
      World world = closed;
      for (int i = 0; i < 40; ++i) {
        ASSERT_EQ(step_world(world, {.step = step}).outcome, StepOutcome::moved);
      }
      least = std::min(least, pressed(world));
      most = std::max(most, pressed(world));
      const Eigen::VectorXd load = loads(world);
      for (int d = 0; d < static_cast<int>(model.dofs()); ++d) {
        double held = model.effort[d];
        for (std::size_t c = 0; c < model.clutches.size(); ++c) {
          const Clutch& clutch = model.clutches[c];
          if (clutch.dof != d) continue;
          const auto slip = model.dofs() + static_cast<Eigen::Index>(c);
          held += clutch.gear_effort;
          EXPECT_LE(std::abs(load[slip]), 1.02 * (clutch.effort + clutch.gear_effort))
              << "clutch " << c << " at " << step;
        }
        if (is_at_limit(world, d)) continue;
        EXPECT_LE(std::abs(load[d]), 1.02 * held) << "dof " << d << " at " << step;
      }
    }
    if (closed.robots[0].rate.lpNorm<Eigen::Infinity>() < 1e-3) {
      EXPECT_LT(most, 1.05 * least);
    }
  }
  EXPECT_GE(hands, 10);
}

}  // namespace
}  // namespace prehend
