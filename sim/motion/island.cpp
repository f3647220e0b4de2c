#include "sim/motion/island.h"

#include <algorithm>
#include <cmath>

#include "sim/base/disjoint_sets.h"
#include "sim/base/index.h"
#include "sim/motion/joint_conditions.h"
#include "sim/motion/placed_contact.h"
#include "sim/motion/robot_kick.h"
#include "sim/motion/smoothed_contacts.h"
#include "sim/motion/solve_contacts.h"
#include "sim/motion/spatial.h"

namespace prehend {
namespace {

using Eigen::Index;

// Part of the drift of contacts that stick which a step takes back.
constexpr double kReturn = 0.5;

class IslandStep {
 public:
  IslandStep(const World& world, const Solids& solids, const Island& island, double time,
             const StepOptions& options, const EarlierTry& earlier)
      : world_(world),
        solids_(solids),
        island_(island),
        time_(time),
        options_(options),
        earlier_(earlier) {}

  IslandMotion run() {
    build(had_impulses() ? time_ : 0.5 * time_);
    motion_.is_free = kick_ < time_ && asks_for_nothing();
    if (motion_.is_free) {
      motion_.solution.velocity = problem_.free;
      motion_.solution.impulses.assign(problem_.contacts.size(), Eigen::Vector4d::Zero());
    } else {
      if (kick_ < time_) build(time_);
      const bool has_warm = std::any_of(warm_.impulses.begin(), warm_.impulses.end(),
                                        [](const Eigen::Vector4d& w) { return !w.isZero(0.0); });
      if (!has_warm) warm_ = {};
      motion_.solution = solve_contacts(
          problem_, {.tolerance = options_.tolerance, .acceptable = options_.acceptable}, warm_);
    }
    report();
    return std::move(motion_);
  }

 private:
  bool is_body(int mover) const { return index(mover) < world_.bodies.size(); }

  // What acts on the island, forces for a time `kick` before it moves.
  void build(double kick) {
    kick_ = kick;
    problem_ = {};
    warm_ = {};
    places_.clear();
    motion_ = {};
    for (const int mover : island_.movers) add_mover(mover);
    for (const std::size_t p : island_.pairs) add_pair(world_.memory.pairs[p]);
  }

  // Whether contacts or joints acted in the last step, and are expected to do so in this one.
  bool had_impulses() const {
    const bool in_contacts =
        std::any_of(island_.pairs.begin(), island_.pairs.end(), [&](std::size_t p) {
          const std::vector<HeldContact>& contacts = world_.memory.pairs[p].contacts;
          return std::any_of(contacts.begin(), contacts.end(),
                             [](const HeldContact& held) { return !held.impulse.isZero(0.0); });
        });
    return in_contacts || std::any_of(island_.movers.begin(), island_.movers.end(), [&](int mover) {
             if (is_body(mover)) return false;
             const std::vector<double>& impulses = robot_at(mover).joint_impulses;
             return std::any_of(impulses.begin(), impulses.end(),
                                [](double impulse) { return impulse != 0.0; });
           });
  }

  // Whether all conditions hold without an impulse.
  bool asks_for_nothing() const {
    return std::all_of(problem_.contacts.begin(), problem_.contacts.end(),
                       [&](const ContactCondition& condition) {
                         const bool pulls = condition.lower < 0.0;  // friction in joints, drives
                         return !pulls && relative_velocity(condition, problem_.free)[0] >= 0.0;
                       });
  }

  const WorldRobot& robot_at(int mover) const {
    return world_.robots[index(mover) - world_.bodies.size()];
  }

  void add_mover(int mover) {
    const auto first = static_cast<int>(problem_.free.size());
    motion_.first.push_back(first);
    if (is_body(mover)) {
      add_body(mover, first);
    } else {
      add_robot(mover, first);
    }
  }

  void add_velocities(int mover, const Eigen::VectorXd& now, const Eigen::VectorXd& free) {
    const bool is_known =
        !earlier_.velocities.empty() && earlier_.velocities[index(mover)].size() == free.size();
    const Eigen::VectorXd& start = is_known ? earlier_.velocities[index(mover)] : now;
    const Index before = problem_.free.size();
    problem_.free.conservativeResize(before + free.size());
    problem_.free.tail(free.size()) = free;
    warm_.velocity.conservativeResize(before + free.size());
    warm_.velocity.tail(free.size()) = start;
  }

  void add_body(int mover, int first) {
    const WorldBody& body = world_.bodies[index(mover)];
    Eigen::MatrixXd mass = Eigen::MatrixXd::Identity(6, 6) * body.inertial.mass;
    const Matrix3 inertia = inertia_in_world(body.inertial, body.motion.X_WB);
    mass.topLeftCorner<3, 3>() = inertia;
    problem_.masses.push_back({first, std::move(mass)});
    Vector6 free;
    Vector3 momentum = inertia * body.motion.angular;
    if (!body.torque_W.isZero(0.0)) momentum += kick_ * body.torque_W;
    free.head<3>() = free_angular_velocity(body.inertial, body.motion.X_WB, momentum, time_);
    free.tail<3>() =
        body.motion.linear + kick_ * (world_.gravity + body.force_W / body.inertial.mass);
    add_velocities(mover, spatial(body.motion.angular, body.motion.linear), free);
  }

  void add_robot(int mover, int first) {
    const WorldRobot& robot = robot_at(mover);
    RobotKick kick = kicked(robot, world_.gravity, time_, kick_);
    add_velocities(mover, robot.rate, kick.mass.llt().solve(kick.momentum));
    problem_.masses.push_back({first, std::move(kick.mass)});
    const std::size_t r = index(mover) - world_.bodies.size();
    const bool is_again = !earlier_.joint_impulses.empty() && !earlier_.joint_impulses[r].empty();
    const std::vector<double>& guess = is_again ? earlier_.joint_impulses[r] : robot.joint_impulses;
    const bool is_known = guess.size() == joint_places(robot);
    for (JointCondition& joint : joint_conditions(robot, first, time_)) {
      warm_.impulses.push_back(Eigen::Vector4d::Zero());
      if (is_known) warm_.impulses.back()[0] = time_ * guess[joint.place];
      motion_.joints.push_back({mover, joint.place});
      problem_.contacts.push_back(std::move(joint.condition));
    }
  }

  int first_of(int mover) const {
    const auto place = std::lower_bound(island_.movers.begin(), island_.movers.end(), mover);
    return motion_.first[static_cast<std::size_t>(place - island_.movers.begin())];
  }

  // How fast the contact may close, or has to open: an impact of a link gives back a part of its
  // velocity, by Newton's law. Those of bodies are over (impacts.h).
  double approach_of(const Solid& a, const Solid& b, const PlacedContact& at) const {
    const double closing = at.directions[0].dot(b.velocity_at(at.p_W) - a.velocity_at(at.p_W));
    const bool of_robot = a.id.robot >= 0 || b.id.robot >= 0;
    const double restitution = of_robot ? std::max(a.restitution, b.restitution) : 0.0;
    const double room = (at.gap - options_.rest_gap) / time_;
    if (restitution > 0.0 && closing > options_.slowest_bounce && closing > room) {
      return -restitution * closing;
    }
    return std::max(room, 0.0);
  }

  // A gap that has become too small opens slowly: at once, it would throw the bodies apart, and so
  // it would in steps that are shortened.
  double opening_of(const PlacedContact& at, bool crosses) const {
    constexpr double kOpening = 0.1;
    const double gap = crosses ? std::min(at.gap, 0.0) : at.gap;
    const double missing = std::max(options_.rest_gap - gap, 0.0);
    // Nearly closed, it has to open faster than edges that slide and turn close it in each step.
    constexpr double kNearlyClosed = 0.2;  // of the gap at rest
    constexpr double kFastest = 10.0;
    const double hurry =
        gap > 0.0 ? std::clamp(kNearlyClosed * options_.rest_gap / gap, 1.0, kFastest) : kFastest;
    return -std::min(hurry * kOpening / options_.step, 1.0 / time_) * missing;
  }

  // A base that turns carries what its hand holds along an arc, and bodies move straight within a
  // step, which would press them into the fingers outside: what is missing of the velocity at which
  // the place of the body's centre moves from its start on the arc to its end.
  Vector3 turning_of(const Solid& link, const Solid& body) const {
    if (link.id.robot < 0 || body.id.robot >= 0) return Vector3::Zero();
    const WorldBody& held = world_.bodies[index(body.id.index)];
    if (held.is_fixed) return Vector3::Zero();
    const WorldRobot& robot = world_.robots[index(link.id.robot)];
    const Vector3 center = center_in_world(held.inertial, held.motion.X_WB);
    const Vector3& turning = robot.base_angular;
    return 0.5 * time_ * turning.cross(turning.cross(center - robot.X_WB.translation()));
  }

  void add_pair(const PairMemory& pair) {
    constexpr double kStiffer = 1.5;  // tried again after softer contacts were needed
    warm_.stiffness = std::min(warm_.stiffness, kStiffer * pair.stiffness);
    const Solid& a = solids_.at(pair.a);
    const Solid& b = solids_.at(pair.b);
    const Vector3 turning = turning_of(a, b) - turning_of(b, a);
    for (const HeldContact& held : pair.contacts) {
      const PlacedContact at = placed(held, a, b);
      ContactCondition condition;
      condition.friction = friction_of(world_.laws, held, a, b);
      const double arm = arm_of(world_.laws, held, a, b, condition.friction);
      condition.rows = arm > 0.0 ? 4 : 3;
      condition.offset[0] = approach_of(a, b, at);
      condition.correction[0] = opening_of(at, pair.crosses);
      // Contacts that stick go back to where they stuck, so that what steps lose on curved ways
      // does not add up.
      if (!held.slides) condition.correction.segment<2>(1) = kReturn / options_.step * at.drift;
      for (const auto& [solid, sign] : {std::pair{&a, 1.0}, std::pair{&b, -1.0}}) {
        const int first = solid->mover >= 0 ? first_of(solid->mover) : -1;
        solids_.add_rows(*solid, first, at.p_W, at.directions, arm, sign, condition);
      }
      for (int k = 0; k < 3; ++k) condition.offset[k] += at.directions[index(k)].dot(turning);
      motion_.contacts.push_back({.a = pair.a,
                                  .b = pair.b,
                                  .position_W = at.p_W,
                                  .normal_W = at.directions[0],
                                  .gap = at.gap});
      places_.push_back({at.directions, arm, problem_.contacts.size()});
      warm_.impulses.push_back(time_ * held.guess);
      problem_.contacts.push_back(std::move(condition));
    }
  }

  void report() {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Place& place = places_[i];
      const Eigen::Vector4d& impulse = motion_.solution.impulses[place.condition];
      WorldContact& contact = motion_.contacts[i];
      contact.impulse_W = impulse[0] * place.directions[0] + impulse[1] * place.directions[1] +
                          impulse[2] * place.directions[2];
      contact.spin_impulse = place.arm * impulse[3];
      const ContactCondition& condition = problem_.contacts[place.condition];
      ConeVector w = relative_velocity(condition, motion_.solution.velocity);
      if (!motion_.solution.corrected) w -= condition.correction;
      contact.slip = w.segment<2>(1).norm();
    }
  }

  struct Place {
    std::array<Vector3, 3> directions;
    double arm = 0.0;
    std::size_t condition = 0;
  };

  const World& world_;
  const Solids& solids_;
  const Island& island_;
  double time_;
  double kick_ = 0.0;  // for how long forces act before it moves [s]
  const StepOptions& options_;
  const EarlierTry& earlier_;
  ContactProblem problem_;
  WarmStart warm_;
  std::vector<Place> places_;  // of each contact
  IslandMotion motion_;
};

}  // namespace

std::vector<Island> islands_of(const Solids& solids, const ContactMemory& memory) {
  const auto movers = static_cast<std::size_t>(solids.movers());
  DisjointSets sets(movers);
  for (const PairMemory& pair : memory.pairs) {
    const int a = solids.at(pair.a).mover;
    const int b = solids.at(pair.b).mover;
    if (!pair.contacts.empty() && a >= 0 && b >= 0) sets.merge(index(a), index(b));
  }
  std::vector<Island> islands;
  std::vector<std::size_t> island_of(movers);
  for (std::size_t m = 0; m < movers; ++m) {
    const std::size_t root = sets.find(m);
    if (root == m) {
      island_of[m] = islands.size();
      islands.emplace_back();
    }
    islands[island_of[root]].movers.push_back(static_cast<int>(m));
  }
  for (std::size_t p = 0; p < memory.pairs.size(); ++p) {
    if (memory.pairs[p].contacts.empty()) continue;
    const int a = solids.at(memory.pairs[p].a).mover;
    const int b = solids.at(memory.pairs[p].b).mover;
    if (a < 0 && b < 0) continue;
    islands[island_of[sets.find(index(a >= 0 ? a : b))]].pairs.push_back(p);
  }
  return islands;
}

IslandMotion solve_island(const World& world, const Solids& solids, const Island& island,
                          double time, const StepOptions& options, const EarlierTry& earlier) {
  return IslandStep(world, solids, island, time, options, earlier).run();
}

}  // namespace prehend
