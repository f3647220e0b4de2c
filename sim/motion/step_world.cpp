#include "sim/motion/step_world.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"
#include "sim/motion/contact_search.h"
#include "sim/motion/crossings.h"
#include "sim/motion/impacts.h"
#include "sim/motion/island.h"
#include "sim/motion/joint_conditions.h"
#include "sim/motion/near_pairs.h"
#include "sim/motion/robot_kick.h"
#include "sim/motion/solids.h"
#include "sim/motion/spatial.h"

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
  const Vector3 momentum = before + inertia * (turning - free);
  body.motion.angular = turning;
  body.motion.linear = velocity.tail<3>();
  body.motion.X_WB = carried(body.inertial, body.motion, time);
  const Matrix3 inertia_after = inertia_in_world(body.inertial, body.motion.X_WB);
  body.motion.angular = inertia_after.ldlt().solve(momentum);
}

// What forces and weight do to the velocities of a body within a time.
void push_body(const Vector3& gravity_W, double time, WorldBody& body) {
  body.motion.linear += time * (gravity_W + body.force_W / body.inertial.mass);
  if (body.torque_W.isZero(0.0)) return;
  const Matrix3 inertia = inertia_in_world(body.inertial, body.motion.X_WB);
  body.motion.angular += inertia.ldlt().solve(time * body.torque_W);
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
    bounce();
    while (result_.time >= options_.shortest * options_.step) {
      solve();
      if (!all_finite()) return ended(StepOutcome::not_finite);
      move();
      const Solids after(world_);
      const bool met = may_have_met(after, world_.memory);
      const std::vector<Crossing> crossings =
          met ? std::vector<Crossing>{} : crossings_of(world_.memory, solids_, after, options_);
      if (!met && crossings.empty()) return finished(after);
      if (!met && looked_again_ && accepts(crossings, after)) return finished(after);
      remember();
      const bool accepts_it = !met && are_shallow(crossings, after);
      set_motions(hit_, world_);
      if (!met && keep_apart(crossings)) continue;
      shorten(after, met || accepts_it);
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

  void bounce() {
    if (!resolve_impacts(world_, result_.time, options_)) return;
    solids_ = Solids(world_);
    for (std::size_t i = 0; i < world_.bodies.size(); ++i) hit_.bodies[i] = world_.bodies[i].motion;
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
      motions_.push_back(solve_island(world_, solids_, island, result_.time, options_, earlier_));
      islands_.push_back(std::move(island));
      const ContactSolution& solution = motions_.back().solution;
      result_.newton_steps += solution.newton_steps;
      result_.violation = std::max(result_.violation, solution.violation);
      if (solution.outcome != ContactOutcome::solved) result_.outcome = StepOutcome::not_converged;
    }
  }

  // What this try found, for the next one.
  void remember() {
    const auto movers = static_cast<std::size_t>(solids_.movers());
    earlier_.velocities.resize(movers);
    earlier_.joint_impulses.resize(world_.robots.size());
    for (std::size_t k = 0; k < islands_.size(); ++k) {
      const IslandMotion& motion = motions_[k];
      for (std::size_t m = 0; m < islands_[k].movers.size(); ++m) {
        const std::size_t mover = index(islands_[k].movers[m]);
        const bool is_body = mover < world_.bodies.size();
        const Eigen::Index size =
            is_body ? 6 : world_.robots[mover - world_.bodies.size()].rate.size();
        earlier_.velocities[mover] = motion.solution.velocity.segment(motion.first[m], size);
        if (!is_body) {
          const std::size_t r = mover - world_.bodies.size();
          earlier_.joint_impulses[r] = joint_impulses(motion, islands_[k].movers[m]);
        }
      }
      std::size_t condition = motion.joints.size();
      for (const std::size_t p : islands_[k].pairs) {
        for (HeldContact& held : world_.memory.pairs[p].contacts) {
          held.guess = motion.solution.impulses[condition++] / result_.time;
        }
      }
    }
  }

  // Of a robot, over the time.
  std::vector<double> joint_impulses(const IslandMotion& motion, int mover) const {
    const WorldRobot& robot = world_.robots[index(mover) - world_.bodies.size()];
    std::vector<double> impulses(joint_places(robot), 0.0);
    for (std::size_t i = 0; i < motion.joints.size(); ++i) {
      if (motion.joints[i].mover != mover) continue;
      impulses[motion.joints[i].place] = motion.solution.impulses[i][0] / result_.time;
    }
    return impulses;
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
        const bool is_free = motions_[k].is_free;
        if (mover < world_.bodies.size()) {
          WorldBody& body = world_.bodies[mover];
          move_body(velocity.segment<6>(first), result_.time, body);
          if (is_free) push_body(world_.gravity, 0.5 * result_.time, body);
        } else {
          WorldRobot& robot = world_.robots[mover - world_.bodies.size()];
          robot.rate = velocity.segment(first, robot.rate.size());
          robot.x += result_.time * robot.rate;
          move_base(result_.time, robot);
          if (is_free) robot.rate = rates_after(robot, world_.gravity, result_.time);
        }
      }
    }
  }

  // Where features crossed that no contact stands for, contacts are added that do: whether there
  // are any.
  bool keep_apart(const std::vector<Crossing>& crossings) {
    constexpr int kMostRounds = 8;
    if (rounds_ == kMostRounds) return false;
    bool added = false;
    for (const Crossing& crossing : crossings) {
      PairMemory& pair = world_.memory.pairs[crossing.pair];
      const std::size_t known = pair.contacts.size();
      if (!add_contacts(crossing, solids_, pair)) continue;
      added = true;
      for (std::size_t i = known; i < pair.contacts.size(); ++i) {
        added_.push_back({pair.a, pair.b, pair.contacts[i]});
      }
    }
    if (!added) return false;
    ++rounds_;
    bounce();
    return true;
  }

  // What the step sets in motion may need more room than what moved before: once, contacts are
  // looked for with the new speeds. After that, and where that finds nothing new, only a shorter
  // step helps, unless the same try may succeed the second time (`again`).
  void shorten(const Solids& after, bool again) {
    ++result_.shortened;
    rounds_ = 0;
    if (!looked_again_) {
      looked_again_ = true;
      if (look_again(after) || again) return;
    }
    result_.time *= 0.5;
  }

  // Whether it finds a contact, or that the step has to be shorter. Contacts that keep what crossed
  // apart are kept: nothing has moved since.
  bool look_again(const Solids& after) {
    const std::vector<PairMemory> before = world_.memory.pairs;
    const double time = find_near(solids_, &after, world_, result_.time, options_, world_.memory);
    std::vector<PairMemory>& pairs = world_.memory.pairs;
    for (const AddedContact& one : added_) {
      for (PairMemory& pair : pairs) {
        if (pair.a == one.a && pair.b == one.b) add_unknown(one.contact, pair.contacts);
      }
    }
    const bool same = time >= result_.time && std::equal(before.begin(), before.end(),
                                                         pairs.begin(), pairs.end(), are_alike);
    result_.time = std::min(result_.time, time);
    return !same;
  }

  static bool are_alike(const PairMemory& p, const PairMemory& q) {
    return p.a == q.a && p.b == q.b && p.crosses == q.crosses &&
           std::equal(p.contacts.begin(), p.contacts.end(), q.contacts.begin(), q.contacts.end(),
                      [](const HeldContact& c, const HeldContact& d) {
                        return c.p_A == d.p_A && c.p_B == d.p_B && c.normal_A == d.normal_A;
                      });
  }

  bool are_shallow(const std::vector<Crossing>& crossings, const Solids& after) const {
    return std::all_of(crossings.begin(), crossings.end(), [&](const Crossing& crossing) {
      const PairMemory& pair = world_.memory.pairs[crossing.pair];
      if (pair.crosses) return false;
      const double speed = closing_speed(after.at(pair.a), after.at(pair.b));
      return result_.time * speed <= options_.shallow;
    });
  }

  // Where shorter steps do not help: once surfaces cannot cross by more than `shallow` in the step,
  // they may, and are pushed apart.
  bool accepts(const std::vector<Crossing>& crossings, const Solids& after) {
    if (!are_shallow(crossings, after)) return false;
    for (const Crossing& crossing : crossings) world_.memory.pairs[crossing.pair].crosses = true;
    result_.crossings += static_cast<int>(crossings.size());
    return true;
  }

  StepResult finished(const Solids& after) {
    world_.contacts = resting_contacts();
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

  // The contacts of islands that rest: they press as they did when these fell asleep.
  std::vector<WorldContact> resting_contacts() const {
    std::vector<bool> moved(static_cast<std::size_t>(solids_.movers()), false);
    for (const Island& island : islands_) {
      for (const int mover : island.movers) moved[index(mover)] = true;
    }
    const auto rests = [&](const SolidId& id) {
      const int mover = solids_.at(id).mover;
      return mover < 0 || !moved[index(mover)];
    };
    std::vector<WorldContact> contacts;
    for (const WorldContact& contact : world_.contacts) {
      if (!rests(contact.a) || !rests(contact.b)) continue;
      contacts.push_back(contact);
      contacts.back().impulse_W *= result_.time / world_.last_step;
      contacts.back().spin_impulse *= result_.time / world_.last_step;
    }
    return contacts;
  }

  // The conditions of an island are those of the joints of its robots, then the contacts of its
  // pairs, in order.
  void keep_contacts(const Island& island, const Solids& after, IslandMotion& motion) {
    std::size_t condition = motion.joints.size();
    std::size_t contact = 0;
    for (const std::size_t p : island.pairs) {
      PairMemory& pair = world_.memory.pairs[p];
      pair.stiffness = motion.solution.stiffness;
      const Pose X_AB = after.at(pair.a).X_WS.inverse() * after.at(pair.b).X_WS;
      for (HeldContact& held : pair.contacts) {
        held.impulse = motion.solution.impulses[condition++] / result_.time;
        held.guess = held.impulse;
        held.slides = motion.contacts[contact++].slip > options_.sliding;
        if (held.slides) stick_here(X_AB, held);
      }
    }
    std::move(motion.contacts.begin(), motion.contacts.end(), std::back_inserter(world_.contacts));
  }

  void keep_joints(const Island& island, const IslandMotion& motion) {
    for (const int place : island.movers) {
      const std::size_t mover = index(place);
      if (mover < world_.bodies.size()) continue;
      WorldRobot& robot = world_.robots[mover - world_.bodies.size()];
      // As they were before the step, with which the conditions were made.
      WorldRobot earlier = robot;
      earlier.x = before_.robots[mover - world_.bodies.size()].x;
      earlier.rate = before_.robots[mover - world_.bodies.size()].rate;
      robot.gear_stops = gear_stops(earlier, robot);
      robot.joint_impulses = joint_impulses(motion, place);
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
  bool looked_again_ = false;  // for contacts, with the speeds after a first try
  struct AddedContact {
    SolidId a;
    SolidId b;
    HeldContact contact;
  };
  std::vector<AddedContact> added_;  // in this step
  EarlierTry earlier_;
  int rounds_ = 0;               // in which contacts were added, of this length of the step
  std::vector<Island> islands_;  // those that move
  std::vector<IslandMotion> motions_;
};

}  // namespace

StepResult step_world(World& world, const StepOptions& options) {
  return WorldStep(world, options).run();
}

}  // namespace prehend
