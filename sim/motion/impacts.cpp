#include "sim/motion/impacts.h"

#include <algorithm>

#include "sim/base/index.h"
#include "sim/motion/island.h"
#include "sim/motion/placed_contact.h"
#include "sim/motion/solve_contacts.h"
#include "sim/motion/spatial.h"

namespace prehend {
namespace {

// Rounds after which impacts that go on are left to the step: with a restitution below 1 they die
// out, and each round takes one body farther.
constexpr int kMostPasses = 200;

// The impacts of one island at one instant.
class IslandImpact {
 public:
  IslandImpact(World& world, const Solids& solids, const Island& island, double time,
               const StepOptions& options)
      : world_(world), solids_(solids), island_(island), time_(time), options_(options) {}

  // Whether any contact closed.
  bool run() {
    for (const std::size_t p : island_.pairs) {
      const PairMemory& pair = world_.memory.pairs[p];
      if (pair.a.robot >= 0 || pair.b.robot >= 0) continue;
      for (const HeldContact& held : pair.contacts)
        add(held, solids_.at(pair.a), solids_.at(pair.b));
    }
    if (problem_.contacts.empty()) return false;
    const ContactSolution solution = bounce();
    for (const auto& [mover, first] : first_) set(solution.velocity.segment<6>(first), mover);
    return true;
  }

 private:
  // Where bodies are hit at several places at once, or turn, Newton's law may ask for more energy
  // than there was (Kane and Levinson 1985, Dynamics, section 4.9): then for less of it at all
  // contacts. Without restitution Coulomb's law only takes energy.
  ContactSolution bounce() {
    constexpr int kHalvings = 6;
    ContactSolution solution = solve_contacts(problem_);
    for (int i = 0; i <= kHalvings && gains_energy(solution.velocity); ++i) {
      const double part = i == kHalvings ? 0.0 : 0.5;
      for (ContactCondition& condition : problem_.contacts) condition.offset[0] *= part;
      solution = solve_contacts(problem_);
    }
    return solution;
  }

  bool gains_energy(const Eigen::VectorXd& velocity) const {
    constexpr double kRounding = 1e-9;
    double before = 0.0;
    double after = 0.0;
    for (const ContactProblem::Mass& mass : problem_.masses) {
      const auto energy = [&](const Eigen::VectorXd& v) {
        return v.segment<6>(mass.first).dot(mass.matrix * v.segment<6>(mass.first));
      };
      before += energy(problem_.free);
      after += energy(velocity);
    }
    return after > (1.0 + kRounding) * before;
  }

  void add(const HeldContact& held, const Solid& a, const Solid& b) {
    const double restitution = std::max(a.restitution, b.restitution);
    const PlacedContact at = placed(held, a, b);
    const double closing = at.directions[0].dot(b.velocity_at(at.p_W) - a.velocity_at(at.p_W));
    const double room = std::max(at.gap - options_.rest_gap, 0.0) / time_;
    if (restitution == 0.0 || closing <= options_.slowest_bounce || closing <= room) return;
    ContactCondition condition;
    condition.friction = friction_of(world_.laws, held, a, b);
    const double arm = arm_of(world_.laws, held, a, b, condition.friction);
    condition.rows = arm > 0.0 ? 4 : 3;
    condition.offset[0] = -restitution * closing;
    for (const auto& [solid, sign] : {std::pair{&a, 1.0}, std::pair{&b, -1.0}}) {
      const int first = solid->mover >= 0 ? first_of(solid->mover) : -1;
      solids_.add_rows(*solid, first, at.p_W, at.directions, arm, sign, condition);
    }
    problem_.contacts.push_back(std::move(condition));
  }

  int first_of(int mover) {
    for (const auto& [known, first] : first_) {
      if (known == mover) return first;
    }
    const WorldBody& body = world_.bodies[index(mover)];
    const auto first = static_cast<int>(problem_.free.size());
    Eigen::MatrixXd mass = Eigen::MatrixXd::Identity(6, 6) * body.inertial.mass;
    mass.topLeftCorner<3, 3>() = inertia_in_world(body.inertial, body.motion.X_WB);
    problem_.masses.push_back({first, std::move(mass)});
    problem_.free.conservativeResize(first + 6);
    problem_.free.tail<6>() = spatial(body.motion.angular, body.motion.linear);
    first_.emplace_back(mover, first);
    return first;
  }

  void set(const Vector6& velocity, int mover) {
    WorldBody& body = world_.bodies[index(mover)];
    body.motion.angular = velocity.head<3>();
    body.motion.linear = velocity.tail<3>();
    body.rest_time = 0.0;
    body.asleep = false;
  }

  World& world_;
  const Solids& solids_;
  const Island& island_;
  double time_;
  const StepOptions& options_;
  ContactProblem problem_;
  std::vector<std::pair<int, int>> first_;  // of each mover that is hit: where its velocities are
};

}  // namespace

bool resolve_impacts(World& world, double time, const StepOptions& options) {
  const bool bounces = std::any_of(world.bodies.begin(), world.bodies.end(),
                                   [](const WorldBody& body) { return body.restitution > 0.0; });
  if (!bounces) return false;
  bool any = false;
  for (int round = 0; round < kMostPasses; ++round) {
    const Solids solids(world);
    bool hit = false;
    for (const Island& island : islands_of(solids, world.memory)) {
      hit = IslandImpact(world, solids, island, time, options).run() || hit;
    }
    if (!hit) break;
    any = true;
  }
  return any;
}

}  // namespace prehend
