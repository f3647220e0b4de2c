#include "planner/plan/together/hold_together.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "planner/plan/together/posed_links.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/parallel/parallel.h"
#include "sim/base/require_settings.h"
#include "sim/quality/wrench_space.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/grasp_contacts.h"

namespace prehend {
namespace {

void require_one_object(const GraspableBody& a, const GraspableBody& b) {
  const bool same = a.mesh.vertices == b.mesh.vertices && a.mesh.triangles == b.mesh.triangles &&
                    a.X_WO.isApprox(b.X_WO, 1e-9) && a.mass == b.mass &&
                    a.center_of_mass.isApprox(b.center_of_mass, 1e-9);
  require(same, {.field = "object",
                 .problem = "must be the same in both scenes, at the same place and with the same "
                            "mass; it is " +
                            a.name + " and",
                 .value = b.name});
}

Vector3 middle_of(const Trial& trial) {
  Vector3 sum = Vector3::Zero();
  for (const GraspContact& contact : trial.contacts) sum += contact.point.position;
  return sum / std::max<double>(1.0, static_cast<double>(trial.contacts.size()));
}

// The best grasp, then again and again the one whose contacts are farthest from those of all
// before: the best ones of a hand often touch at one place, and the other hand needs another.
std::vector<std::size_t> spread_out(const PlanResult& result, std::size_t most) {
  std::vector<std::size_t> chosen;
  std::vector<double> away(result.grasps.size(), std::numeric_limits<double>::infinity());
  std::vector<Vector3> middles;
  for (const ScoredGrasp& grasp : result.grasps) middles.push_back(middle_of(grasp.trial));
  while (chosen.size() < std::min(most, middles.size())) {
    const auto next = static_cast<std::size_t>(
        std::distance(away.begin(), std::max_element(away.begin(), away.end())));
    chosen.push_back(next);
    for (std::size_t i = 0; i < away.size(); ++i) {
      away[i] = std::min(away[i], (middles[i] - middles[next]).norm());
    }
    away[next] = -1.0;
  }
  return chosen;
}

class Pairing {
 public:
  Pairing(const std::array<HandPlan, 2>& plans, const TogetherOptions& options,
          const RunContext& context)
      : plans_(plans), options_(options), context_(context) {}

  TogetherResult run() {
    find_pairs();
    try_best();
    return std::move(result_);
  }

 private:
  // What is known of a pair that was looked at.
  struct Looked {
    bool apart = false;
    std::optional<SharedGrasp> pair;  // that bears the weight
  };

  const ScoredGrasp& grasp_of(std::size_t side, std::size_t i) const {
    return plans_[side].result.grasps[i];
  }

  std::array<HoldingHand, 2> hands_of(const SharedGrasp& pair) const {
    return {{{plans_[0].scene, grasp_of(0, pair.grasps[0]).trial},
             {plans_[1].scene, grasp_of(1, pair.grasps[1]).trial}}};
  }

  void find_pairs() {
    std::array<std::vector<std::size_t>, 2> pool;
    std::array<std::vector<std::vector<PosedLink>>, 2> links;
    for (std::size_t side = 0; side < 2; ++side) {
      pool[side] = spread_out(plans_[side].result, index(options_.pool));
      for (const std::size_t i : pool[side]) {
        links[side].push_back(links_in_grasp(plans_[side].scene, grasp_of(side, i).trial));
        alone_[side].push_back(weight_strength(plans_[side].scene, grasp_of(side, i).trial));
      }
    }
    const std::size_t others = pool[1].size();
    std::vector<Looked> looked(pool[0].size() * others);
    for_each_in_parallel(looked.size(), context_.threads, [&](std::size_t k) {
      context_.cancellation.check();
      const std::size_t a = k / others;
      const std::size_t b = k % others;
      looked[k].apart = are_apart(links[0][a], links[1][b], options_.apart);
      if (!looked[k].apart) return;
      SharedGrasp pair;
      pair.grasps = {pool[0][a], pool[1][b]};
      pair.alone = {alone_[0][a], alone_[1][b]};
      pair.strength = weight_strength(hands_of(pair));
      if (pair.strength < 1.0) return;
      pair.epsilon = epsilon_of(pair);
      looked[k].pair = pair;
    });
    result_.pairs = static_cast<int>(looked.size());
    for (Looked& one : looked) {
      if (one.apart) ++result_.apart;
      if (one.pair) bearing_.push_back(std::move(*one.pair));
    }
    result_.bear = static_cast<int>(bearing_.size());
    std::stable_sort(bearing_.begin(), bearing_.end(),
                     [](const SharedGrasp& a, const SharedGrasp& b) {
                       return a.epsilon.lower > b.epsilon.lower;
                     });
  }

  EpsilonBracket epsilon_of(const SharedGrasp& pair) const {
    std::vector<Contact> contacts;
    for (const HoldingHand& hand : hands_of(pair)) {
      for (const Contact& contact : contacts_of(hand.trial.contacts)) contacts.push_back(contact);
    }
    return grasp_epsilon(contacts, plans_[0].scene.wrench_frame);
  }

  // In groups of as many as are still wanted, so that the same pairs are lifted on any number of
  // threads.
  void try_best() {
    const std::size_t most = std::min(bearing_.size(), index(options_.lifts));
    std::size_t next = 0;
    while (next < most && result_.grasps.size() < index(options_.top)) {
      const std::size_t count = std::min(index(options_.top) - result_.grasps.size(), most - next);
      for_each_in_parallel(count, context_.threads,
                           [&](std::size_t i) { try_one(bearing_[next + i]); });
      for (std::size_t i = next; i < next + count; ++i) {
        if (bearing_[i].lift.end != SharedLiftEnd::lifted) continue;
        ++result_.lifted;
        if (!options_.paths || bearing_[i].paths) result_.grasps.push_back(bearing_[i]);
      }
      next += count;
    }
    result_.tried = static_cast<int>(next);
  }

  // Lifts the object, and plans the paths of a pair that keeps it.
  void try_one(SharedGrasp& pair) const {
    pair.lift = lift_together(hands_of(pair), options_.lift, context_);
    if (!options_.paths || pair.lift.end != SharedLiftEnd::lifted) return;
    GraspPathOptions paths = *options_.paths;
    paths.lift.height = options_.lift.height;
    const std::array<SharedHold, 2> holds = {{{plans_[0].scene, grasp_of(0, pair.grasps[0])},
                                              {plans_[1].scene, grasp_of(1, pair.grasps[1])}}};
    pair.paths = plan_shared_paths(holds, paths, context_);
  }

  const std::array<HandPlan, 2>& plans_;
  const TogetherOptions& options_;
  const RunContext& context_;
  std::array<std::vector<double>, 2> alone_;  // of the pool: how many times the weight one holds
  std::vector<SharedGrasp> bearing_;
  TogetherResult result_;
};

}  // namespace

void require_pair(const CompiledScene& first, const CompiledScene& second, bool paths) {
  require_one_object(first.scene.object, second.scene.object);
  for (const CompiledScene* scene : {&first, &second}) {
    require(!paths || scene->arm.has_value(),
            {.field = scene->scene.name, .problem = "paths need an arm, and it has none"});
    require(scene->scene.hand.hand->cups.empty(),
            {.field = scene->scene.hand.name,
             .problem = "suction cups do not hold together with another hand yet"});
  }
}

TogetherResult hold_together(const std::array<HandPlan, 2>& plans, const TogetherOptions& options,
                             const RunContext& context) {
  require_settings(options);
  require_pair(plans[0].scene, plans[1].scene, options.paths.has_value());
  return Pairing(plans, options, context).run();
}

}  // namespace prehend
