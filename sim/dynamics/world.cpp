#include "sim/dynamics/world.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/dynamics/impacts.h"
#include "sim/dynamics/island.h"
#include "sim/dynamics/joint_conditions.h"
#include "sim/dynamics/joint_springs.h"
#include "sim/dynamics/near_pairs.h"
#include "sim/dynamics/solids.h"

namespace prehend {
namespace {

// What a step changes of bodies and robots, to take it back.
struct Motions {
  std::vector<RigidMotion> bodies;
  struct OfRobot {
    Pose X_WB;
    Eigen::VectorXd x;
    Eigen::VectorXd rate;
  };
  std::vector<OfRobot> robots;
};

Motions motions_of(const World& world) {
  Motions motions;
  for (const WorldBody& body : world.bodies) motions.bodies.push_back(body.motion);
  for (const WorldRobot& robot : world.robots) {
    motions.robots.push_back({robot.X_WB, robot.x, robot.rate});
  }
  return motions;
}

void set_motions(const Motions& motions, World& world) {
  for (std::size_t i = 0; i < world.bodies.size(); ++i) world.bodies[i].motion = motions.bodies[i];
  for (std::size_t r = 0; r < world.robots.size(); ++r) {
    world.robots[r].X_WB = motions.robots[r].X_WB;
    world.robots[r].x = motions.robots[r].x;
    world.robots[r].rate = motions.robots[r].rate;
  }
}

// Moves a body with the velocities at the end of the step. Its angular momentum is what it was and
// what pushed it, so that the velocity after the turn follows from the inertia there.
void move_body(const Eigen::Ref<const Vector6>& velocity, double time, WorldBody& body) {
  const Matrix3 inertia = inertia_in_world(body.inertial, body.motion.X_WB);
  const Vector3 before = inertia * body.motion.angular;
  const Vector3 free = free_angular_velocity(body.inertial, body.motion.X_WB, before, time);
  const Vector3 turning = velocity.head<3>();
  const Vector3 pushed = inertia * (turning - free);
  body.motion.angular = turning;
  body.motion.linear = velocity.tail<3>();
  body.motion.X_WB = carried(body.inertial, body.motion, time);
  const Matrix3 inertia_after = inertia_in_world(body.inertial, body.motion.X_WB);
  body.motion.angular = inertia_after.ldlt().solve(before + pushed);
}

void move_base(double time, WorldRobot& robot) {
  const RigidMotion base{robot.X_WB, robot.base_angular, robot.base_linear};
  robot.X_WB = carried(Inertial{}, base, time);
}

// One step of a world, tried with shorter and shorter times.
class WorldStep {
 public:
  WorldStep(World& world, const StepOptions& options)
      : world_(world),
        options_(options),
        before_(motions_of(world)),
        hit_(before_),
        solids_(world) {}

  StepResult run() {
    result_.time = find_near(solids_, nullptr, world_, options_.step, options_, world_.memory);
    if (result_.time < options_.step) ++result_.shortened;
    if (resolve_impacts(world_, result_.time, options_)) {
      solids_ = Solids(world_);
      for (std::size_t i = 0; i < world_.bodies.size(); ++i)
        hit_.bodies[i] = world_.bodies[i].motion;
    }
    for (bool looked_again = false; result_.time >= options_.shortest * options_.step;) {
      solve();
      if (!all_finite()) return ended(StepOutcome::not_finite);
      move();
      const Solids after(world_);
      const bool met = may_have_met(after, world_.memory);
      if (!met && !crosses(after)) return finished(after);
      if (!met && looked_again && accepts_crossings(after)) return finished(after);
      set_motions(hit_, world_);
      ++result_.shortened;
      // What the step sets in motion may need more room than what moved before: once, contacts are
      // looked for with the new speeds. After that only a shorter step helps.
      const double shorter = 0.5 * result_.time;
      if (!looked_again) {
        result_.time = std::min(result_.time, find_near(solids_, &after, world_, result_.time,
                                                        options_, world_.memory));
        looked_again = true;
      } else {
        result_.time = shorter;
      }
    }
    return ended(StepOutcome::blocked);
  }

 private:
  StepResult ended(StepOutcome outcome) {
    set_motions(before_, world_);
    result_.outcome = outcome;
    result_.time = 0.0;
    return result_;
  }

  bool rests(const Island& island) const {
    return std::all_of(island.movers.begin(), island.movers.end(), [&](int mover) {
      return index(mover) < world_.bodies.size() &&
             (world_.bodies[index(mover)].asleep || world_.bodies[index(mover)].is_fixed);
    });
  }

  void solve() {
    islands_.clear();
    motions_.clear();
    result_.newton_steps = 0;
    result_.violation = 0.0;
    result_.outcome = StepOutcome::moved;
    for (Island& island : islands_of(solids_, world_.memory)) {
      if (rests(island)) continue;
      motions_.push_back(solve_island(world_, solids_, island, result_.time, options_));
      islands_.push_back(std::move(island));
      const ContactSolution& solution = motions_.back().solution;
      result_.newton_steps += solution.newton_steps;
      result_.violation = std::max(result_.violation, solution.violation);
      if (solution.outcome != ContactOutcome::solved) result_.outcome = StepOutcome::not_converged;
    }
  }

  bool all_finite() const {
    return std::all_of(motions_.begin(), motions_.end(), [](const IslandMotion& motion) {
      return motion.solution.velocity.allFinite();
    });
  }

  void move() {
    for (std::size_t k = 0; k < islands_.size(); ++k) {
      for (std::size_t m = 0; m < islands_[k].movers.size(); ++m) {
        const std::size_t mover = index(islands_[k].movers[m]);
        const Eigen::VectorXd& velocity = motions_[k].solution.velocity;
        const int first = motions_[k].first[m];
        if (mover < world_.bodies.size()) {
          move_body(velocity.segment<6>(first), result_.time, world_.bodies[mover]);
        } else {
          WorldRobot& robot = world_.robots[mover - world_.bodies.size()];
          robot.rate = velocity.segment(first, robot.rate.size());
          robot.x += result_.time * robot.rate;
          move_base(result_.time, robot);
        }
      }
    }
  }

  // Whether the surfaces of a pair that was in contact cross now, which they did not before. While
  // what is known of their contacts still holds and keeps them apart, they do not.
  bool crosses(const PairMemory& pair, const Solids& after) const {
    constexpr double kEnough = 0.2;  // of the gap at rest
    if (pair.contacts.empty() || pair.crosses) return false;
    const Solid& a = after.at(pair.a);
    const Solid& b = after.at(pair.b);
    const bool holds = moved_since(pair, after) <= options_.contacts.refresh;
    if (holds && smallest_gap(pair, a, b) > kEnough * options_.rest_gap) return false;
    return surfaces_cross(a.shape->mesh, b.shape->mesh, a.X_WS.inverse() * b.X_WS);
  }

  bool crosses(const Solids& after) const {
    return std::any_of(world_.memory.pairs.begin(), world_.memory.pairs.end(),
                       [&](const PairMemory& pair) { return crosses(pair, after); });
  }

  // Where a feature is in the way that no contact stands for, shorter steps do not help: once
  // surfaces cannot cross by more than `shallow` in the step, they may, and are pushed apart.
  bool accepts_crossings(const Solids& after) {
    std::vector<PairMemory*> crossing;
    for (PairMemory& pair : world_.memory.pairs) {
      if (!crosses(pair, after)) continue;
      const Solid& a = after.at(pair.a);
      const Solid& b = after.at(pair.b);
      if (result_.time * closing_speed(a, b) > options_.shallow) return false;
      crossing.push_back(&pair);
    }
    for (PairMemory* pair : crossing) pair->crosses = true;
    result_.crossings += static_cast<int>(crossing.size());
    return true;
  }

  static double smallest_gap(const PairMemory& pair, const Solid& a, const Solid& b) {
    double least = std::numeric_limits<double>::infinity();
    for (const HeldContact& contact : pair.contacts) {
      const Vector3 between = a.X_WS * contact.p_A - b.X_WS * contact.p_B;
      least = std::min(least, (a.X_WS.linear() * contact.normal_A).dot(between));
    }
    return least;
  }

  StepResult finished(const Solids& after) {
    world_.contacts.clear();
    for (std::size_t k = 0; k < islands_.size(); ++k)
      keep_contacts(islands_[k], after, motions_[k]);
    for (std::size_t k = 0; k < islands_.size(); ++k) keep_joints(islands_[k], motions_[k]);
    for (const Island& island : islands_) rest(island, after);
    for (WorldRobot& robot : world_.robots) {
      robot.last_base_angular = robot.base_angular;
      robot.last_base_linear = robot.base_linear;
    }
    world_.last_step = result_.time;
    return result_;
  }

  // The conditions of an island are those of the joints of its robots, then the contacts of its
  // pairs, in order.
  void keep_contacts(const Island& island, const Solids& after, IslandMotion& motion) {
    std::size_t condition = motion.solution.impulses.size() - motion.contacts.size();
    std::size_t contact = 0;
    for (const std::size_t p : island.pairs) {
      PairMemory& pair = world_.memory.pairs[p];
      const Pose X_AB = after.at(pair.a).X_WS.inverse() * after.at(pair.b).X_WS;
      for (HeldContact& held : pair.contacts) {
        held.impulse = motion.solution.impulses[condition++] / result_.time;
        held.slides = motion.contacts[contact++].slip > options_.sliding;
        if (held.slides) stick_here(X_AB, held);
      }
    }
    std::move(motion.contacts.begin(), motion.contacts.end(), std::back_inserter(world_.contacts));
  }

  void keep_joints(const Island& island, const IslandMotion& motion) {
    std::size_t condition = 0;
    for (std::size_t m = 0; m < island.movers.size(); ++m) {
      const std::size_t mover = index(island.movers[m]);
      if (mover < world_.bodies.size()) continue;
      WorldRobot& robot = world_.robots[mover - world_.bodies.size()];
      // As they were before the step, with which the conditions were made.
      WorldRobot earlier = robot;
      earlier.x = before_.robots[mover - world_.bodies.size()].x;
      earlier.rate = before_.robots[mover - world_.bodies.size()].rate;
      robot.joint_impulses.assign(joint_places(robot), 0.0);
      for (const JointCondition& joint : joint_conditions(earlier, motion.first[m], result_.time)) {
        robot.joint_impulses[joint.place] = motion.solution.impulses[condition++][0] / result_.time;
      }
    }
  }

  // Bodies of an island that has no robot fall asleep together.
  void rest(const Island& island, const Solids& after) {
    bool all = true;
    for (const int mover : island.movers) {
      if (index(mover) >= world_.bodies.size()) {
        all = false;
        continue;
      }
      WorldBody& body = world_.bodies[index(mover)];
      body.asleep = false;
      if (body.is_fixed) continue;
      const Solid& solid = after.all()[index(mover)];
      const double speed =
          body.motion.linear.norm() + solid.angular.norm() * body.shape.mesh.ball_radius();
      body.rest_time = speed <= options_.still ? body.rest_time + result_.time : 0.0;
      all = all && body.rest_time > options_.sleep_after;
    }
    if (!all) return;
    for (const int mover : island.movers) {
      WorldBody& body = world_.bodies[index(mover)];
      body.asleep = true;
      body.motion.linear.setZero();
      body.motion.angular.setZero();
    }
  }

  World& world_;
  const StepOptions& options_;
  const Motions before_;
  Motions hit_;    // with the velocities after impacts
  Solids solids_;  // before the step, after impacts
  StepResult result_;
  std::vector<Island> islands_;  // those that move
  std::vector<IslandMotion> motions_;
};

}  // namespace

WorldRobot make_world_robot(std::string name, std::shared_ptr<const RobotModel> model,
                            const Pose& X_WB, const std::vector<double>& dofs,
                            const std::vector<double>& joints) {
  WorldRobot robot{.name = std::move(name), .model = std::move(model), .X_WB = X_WB};
  robot.x = coordinates_at(*robot.model, dofs, joints);
  robot.rate = Eigen::VectorXd::Zero(robot.x.size());
  return robot;
}

Eigen::VectorXd joints_of(const WorldRobot& robot) {
  return robot.model->joints_of * robot.x + robot.model->offset;
}

StepResult step_world(World& world, const StepOptions& options) {
  return WorldStep(world, options).run();
}

double energy_of(const World& world) {
  double sum = 0.0;
  for (const WorldBody& body : world.bodies) {
    if (body.is_fixed) continue;
    sum += kinetic_energy(body.inertial, body.motion) -
           body.inertial.mass * world.gravity.dot(center_in_world(body.inertial, body.motion.X_WB));
  }
  for (const WorldRobot& robot : world.robots) {
    const RobotModel& model = *robot.model;
    sum += model.dynamics.kinetic_energy(joints_of(robot), model.joints_of * robot.rate) +
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
