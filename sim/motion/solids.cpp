#include "sim/motion/solids.h"

#include <algorithm>
#include <array>

#include "sim/base/index.h"

namespace prehend {
namespace {

const SurfaceMaterials* surface_of(const SurfaceMaterials& surface) {
  return surface.uniform() ? nullptr : &surface;
}

Solid solid_of(const WorldBody& body, int i) {
  Solid solid{.id = {-1, i},
              .shape = &body.shape,
              .material = body.material,
              .surface = surface_of(body.surface),
              .restitution = body.restitution,
              .X_WS = body.motion.X_WB};
  if (body.is_fixed) return solid;
  solid.mover = i;
  solid.moves = true;
  solid.angular = body.motion.angular;
  const Vector3 center = center_in_world(body.inertial, body.motion.X_WB);
  solid.origin_velocity =
      body.motion.linear + solid.angular.cross(solid.X_WS.translation() - center);
  return solid;
}

Solid solid_of(const WorldRobot& robot, const RobotState& state, int r, int link, int mover) {
  const int joint = robot.model->robot.links[index(link)].joint;
  Solid solid{.id = {r, link},
              .shape = &robot.model->shapes[index(link)],
              .material = robot.model->materials[index(link)]};
  if (!robot.model->surfaces.empty()) {
    solid.surface = surface_of(robot.model->surfaces[index(link)]);
  }
  solid.moves = true;
  if (joint < 0) {
    solid.X_WS = robot.X_WB;
    solid.angular = robot.base_angular;
    solid.origin_velocity = robot.base_linear;
    return solid;
  }
  solid.mover = mover;
  solid.X_WS = state.X_WA[index(joint)];
  solid.angular = state.angular[index(joint)];
  solid.origin_velocity = state.linear[index(joint)];
  return solid;
}

// The velocity of p_W along the directions, and the spin about the first.
ConeVector rows_of(const std::array<Vector3, 3>& directions, double arm, const Vector3& linear,
                   const Vector3& angular) {
  return {directions[0].dot(linear), directions[1].dot(linear), directions[2].dot(linear),
          arm * directions[0].dot(angular)};
}

}  // namespace

RobotState state_of(const WorldRobot& robot) {
  const Robot& model = robot.model->robot;
  const Eigen::VectorXd q = joints_of(robot);
  const Eigen::VectorXd v = robot.model->joints_of * robot.rate;
  RobotState state;
  const std::size_t n = model.joints.size();
  state.X_WA.resize(n);
  state.axis_W.resize(n);
  state.origin_W.resize(n);
  state.angular.resize(n);
  state.linear.resize(n);
  for (std::size_t j = 0; j < n; ++j) {
    const Joint& joint = model.joints[j];
    const auto at = static_cast<Eigen::Index>(j);
    const bool on_base = joint.parent < 0;
    const Pose& X_WP = on_base ? robot.X_WB : state.X_WA[index(joint.parent)];
    const Vector3 w = on_base ? robot.base_angular : state.angular[index(joint.parent)];
    const Vector3 p = on_base ? robot.base_linear : state.linear[index(joint.parent)];
    const Pose X_WJ = X_WP * joint.X_PJ;
    state.X_WA[j] = X_WJ * across(joint, q[at]);
    state.axis_W[j] = X_WJ.linear() * joint.axis;
    state.origin_W[j] = X_WJ.translation();
    const Vector3 way = state.X_WA[j].translation() - X_WP.translation();
    state.angular[j] = w;
    state.linear[j] = p + w.cross(way);
    if (joint.type == JointType::revolute) {
      state.angular[j] += v[at] * state.axis_W[j];
      state.linear[j] +=
          v[at] * state.axis_W[j].cross(state.X_WA[j].translation() - state.origin_W[j]);
    } else {
      state.linear[j] += v[at] * state.axis_W[j];
    }
  }
  return state;
}

Solids::Solids(const World& world) : world_(&world) {
  std::size_t count = world.bodies.size();
  for (const WorldRobot& robot : world.robots) count += robot.model->shapes.size();
  solids_.reserve(count);
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    solids_.push_back(solid_of(world.bodies[i], static_cast<int>(i)));
  }
  movers_ = static_cast<int>(world.bodies.size());
  for (std::size_t r = 0; r < world.robots.size(); ++r) {
    const WorldRobot& robot = world.robots[r];
    robots_.push_back(state_of(robot));
    first_link_.push_back(static_cast<int>(solids_.size()));
    for (std::size_t l = 0; l < robot.model->shapes.size(); ++l) {
      solids_.push_back(
          solid_of(robot, robots_.back(), static_cast<int>(r), static_cast<int>(l), movers_));
    }
    ++movers_;
  }
}

int Solids::place(const SolidId& id) const {
  return id.robot < 0 ? id.index : first_link_[index(id.robot)] + id.index;
}

const Solid& Solids::at(const SolidId& id) const { return solids_[index(place(id))]; }

void Solids::add_rows(const Solid& solid, int first, const Vector3& p_W,
                      const std::array<Vector3, 3>& directions, double arm, double sign,
                      ContactCondition& condition) const {
  if (solid.id.robot >= 0) {
    const WorldRobot& robot = world_->robots[index(solid.id.robot)];
    const Vector3 base_velocity =
        robot.base_linear + robot.base_angular.cross(p_W - robot.X_WB.translation());
    condition.offset += sign * rows_of(directions, arm, base_velocity, robot.base_angular);
  }
  if (solid.mover < 0) return;
  if (solid.id.robot < 0) {
    const WorldBody& body = world_->bodies[index(solid.id.index)];
    const Vector3 lever = p_W - center_in_world(body.inertial, body.motion.X_WB);
    JacobianBlock block{first, Eigen::MatrixX4d::Zero(6, 4)};
    for (int k = 0; k < 3; ++k) {
      const Vector3& direction = directions[static_cast<std::size_t>(k)];
      block.transposed.col(k) << sign * lever.cross(direction), sign * direction;
    }
    block.transposed.col(3).head<3>() = sign * arm * directions[0];
    condition.blocks.push_back(std::move(block));
    return;
  }
  const RobotModel& model = *world_->robots[index(solid.id.robot)].model;
  const RobotState& state = robots_[index(solid.id.robot)];
  JacobianBlock block{first, Eigen::MatrixX4d::Zero(model.coordinates(), 4)};
  for (int j = model.robot.links[index(solid.id.index)].joint; j >= 0;
       j = model.robot.joints[index(j)].parent) {
    const Vector3& axis = state.axis_W[index(j)];
    const bool turns = model.robot.joints[index(j)].type == JointType::revolute;
    const Vector3 linear = turns ? Vector3(axis.cross(p_W - state.origin_W[index(j)])) : axis;
    const Vector3 angular = turns ? axis : Vector3::Zero();
    const ConeVector rows = sign * rows_of(directions, arm, linear, angular);
    for (Eigen::Index c = 0; c < model.coordinates(); ++c) {
      const double part = model.joints_of(j, c);
      if (part != 0.0) block.transposed.row(c) += part * rows.transpose();
    }
  }
  // Two links of one robot that touch each other share its velocities.
  if (!condition.blocks.empty() && condition.blocks.back().first == first) {
    condition.blocks.back().transposed += block.transposed;
  } else {
    condition.blocks.push_back(std::move(block));
  }
}

double closing_speed(const Solid& a, const Solid& b) {
  // Seen from the larger one, the ball about the smaller moves and turns.
  const bool a_is_small = a.shape->mesh.ball_radius() < b.shape->mesh.ball_radius();
  const Solid& small = a_is_small ? a : b;
  const Solid& large = a_is_small ? b : a;
  const Vector3 center = small.X_WS * small.shape->mesh.ball_center();
  return (small.velocity_at(center) - large.velocity_at(center)).norm() +
         (small.angular - large.angular).norm() * small.shape->mesh.ball_radius();
}

}  // namespace prehend
