#include "planner/plan/path/plan_transfer.h"

#include <algorithm>
#include <array>
#include <memory>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/require_settings.h"
#include "sim/scene/compiled_arm.h"
#include "sim/scene/reach/motion_check.h"
#include "sim/scene/reach/motion_filter.h"

namespace prehend {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

// Longest edge that a planner adds in one step, as a length in the planner's space: each degree of
// freedom counts with the farthest that it moves any point of the arm [m].
constexpr double kLongestEdge = 0.5;

// Iterations of the first of several searches by rrt_connect, and how many searches there are at
// most.
constexpr int kFirstRound = 200;
constexpr int kMostRounds = 24;

// Motions that keep this distance [m] are found faster, as is proven in fewer steps. Those from and
// to the ends of the path may be closer (MotionCheckOptions::tightest), as the ends often are.
constexpr double kLeastPassage = 4e-3;

// How a corner of a path is cut: from which part of the line before it (1: all of it) to which part
// of the line after it. In the order in which they are tried.
struct CornerCut {
  double before = 0.0;
  double after = 0.0;
};
constexpr std::array<CornerCut, 6> kCuts = {
    {{1.0, 1.0}, {1.0, 0.5}, {0.5, 1.0}, {0.5, 0.5}, {0.25, 0.25}, {0.125, 0.125}}};

// Cuts that shorten a path by a smaller part of its length are not worth their check.
constexpr double kLeastGain = 7e-3;

// How far a joint at its limit may be beyond it by rounding [rad or m].
constexpr double kBeyondLimits = 1e-9;

// OMPL seeds its random generators in the order of their creation, counted over all threads. With
// several searches at a time the result would depend on which of them comes first, so the classes
// below give each generator a seed from the options.
class SeededSampler : public ob::RealVectorStateSampler {
 public:
  SeededSampler(const ob::StateSpace* space, std::uint64_t seed)
      : ob::RealVectorStateSampler(space) {
    rng_.setLocalSeed(static_cast<std::uint_fast32_t>(seed));
  }
};

// OMPL gives every space random projections to the plane, for planners that are not used here.
// Leaving them out saves time and draws no random numbers.
class PlainSpace : public ob::RealVectorStateSpace {
 public:
  using ob::RealVectorStateSpace::RealVectorStateSpace;
  void registerProjections() override {}
};

template <typename Planner>
class Seeded : public Planner {
 public:
  Seeded(const ob::SpaceInformationPtr& information, std::uint64_t seed) : Planner(information) {
    this->rng_.setLocalSeed(static_cast<std::uint_fast32_t>(seed));
  }
};

std::vector<ArmPair> checked_pairs_of(const CompiledArm& arm) {
  std::vector<ArmPair> pairs = arm.arm_pairs;
  pairs.insert(pairs.end(), arm.hand_pairs.begin(), arm.hand_pairs.end());
  return pairs;
}

// The space that OMPL plans in, and its collision checks. Its coordinates are the degrees of
// freedom that carry the hand, each multiplied by the farthest that any point moves per unit of it
// [m/rad or m/m]. In these coordinates a distance says about how far the arm moves, so that a turn
// of the base, which swings the whole arm, counts more than one of the wrist; and radians and
// metres can be mixed.
class TransferSpace {
 public:
  TransferSpace(const CompiledArm& arm, const Transfer& transfer, const TransferOptions& options,
                const RunContext& context)
      : arm_(arm),
        transfer_(transfer),
        options_(options),
        context_(context),
        pairs_(checked_pairs_of(arm)),
        filter_(arm, pairs_),
        blocks_(pairs_.size(), 0) {
    for (const int dof : arm.dofs) scale_.push_back(motion_of(dof));
  }

  std::size_t size() const { return scale_.size(); }
  double lower(std::size_t k) const { return scale_[k] * dof(k).lower; }
  double upper(std::size_t k) const { return scale_[k] * dof(k).upper; }

  DofValues dofs(const ob::State* state) const {
    const double* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
    DofValues result = transfer_.from;
    for (std::size_t k = 0; k < size(); ++k) result[index(arm_.dofs[k])] = values[k] / scale_[k];
    return result;
  }

  void set(const DofValues& dofs, ob::State* state) const {
    double* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
    for (std::size_t k = 0; k < size(); ++k) values[k] = scale_[k] * dofs[index(arm_.dofs[k])];
  }

  // Cancellation must not be an exception here: OMPL owns states by bare pointers, which an
  // exception thrown through it would leak. Instead every motion counts as blocked once the context
  // is cancelled. The planner then soon asks its termination condition (`after`) and returns, and
  // search() throws Cancelled.
  //
  // States are not checked by themselves. Each that a planner uses is joined by motions to an end
  // of the path, and there the bodies are apart and none is inside another: where no surfaces touch
  // along the motions, that remains so.
  bool is_free(const ob::State* /*state*/) const { return !is_cancelled(); }

  // Whether the arm can be in a posture: within its limits, but for rounding, and free of
  // collision.
  bool is_possible(const DofValues& dofs) const {
    for (std::size_t k = 0; k < size(); ++k) {
      const double value = dofs[index(arm_.dofs[k])];
      if (value < dof(k).lower - kBeyondLimits || value > dof(k).upper + kBeyondLimits)
        return false;
    }
    return !first_meeting(arm_, pairs_, joints(dofs));
  }

  // Whether the lines between postures are proven free of collision by the meshes alone.
  bool is_free(const std::vector<DofValues>& waypoints) const {
    for (std::size_t i = 1; i < waypoints.size(); ++i) {
      if (is_blocked(pairs_, joints(waypoints[i - 1]), joints(waypoints[i]), options_.motion))
        return false;
    }
    return true;
  }

  // Whether no collision on the line between two postures shows at once.
  bool may_be_free(const DofValues& from, const DofValues& to) {
    return filter_.line(joints(from), joints(to), options_.motion.tightest, IfClose::open, open_) !=
           FilterVerdict::blocked;
  }

  // Whether the straight line between two postures is proven free of collision, by the filter where
  // it can tell.
  bool is_free(const ob::State* from, const ob::State* to) {
    const bool at_end = is_end(from) || is_end(to);
    MotionCheckOptions motion = options_.motion;
    if (!at_end) motion.tightest = std::max(motion.tightest, kLeastPassage);
    const IfClose if_close = by_shapes_ && !at_end ? IfClose::blocked : IfClose::open;
    const std::vector<double> first = joints(dofs(from));
    const std::vector<double> last = joints(dofs(to));
    const FilterVerdict verdict = filter_.line(first, last, motion.tightest, if_close, open_);
    if (verdict == FilterVerdict::blocked) ++blocks_[filter_.blocker()];
    if (verdict != FilterVerdict::open) return verdict == FilterVerdict::free;
    const auto posture = [&](double at) {
      std::vector<double> result = first;
      for (std::size_t j = 0; j < result.size(); ++j) result[j] += at * (last[j] - first[j]);
      return result;
    };
    return std::none_of(open_.begin(), open_.end(), [&](const OpenStretch& stretch) {
      std::vector<ArmPair> pairs;
      for (const std::size_t p : stretch.pairs) pairs.push_back(pairs_[p]);
      if (!is_blocked(pairs, posture(stretch.from), posture(stretch.to), motion)) return false;
      for (const std::size_t p : stretch.pairs) ++blocks_[p];
      return true;
    });
  }

  // The pair that blocked, or may have blocked, most motions; none where no motion was blocked.
  std::optional<ArmPair> bottleneck() const {
    const auto most = std::max_element(blocks_.begin(), blocks_.end());
    if (most == blocks_.end() || *most == 0) return std::nullopt;
    return pairs_[static_cast<std::size_t>(most - blocks_.begin())];
  }

  // Whether motions count as blocked where the simple shapes around the meshes overlap: much
  // faster, and no less safe. Motions from and to the ends of the path are seen as they are.
  void set_by_shapes(bool by_shapes) { by_shapes_ = by_shapes; }

  // The ends of the path, near which the arm may be as close to something as it is there.
  void set_ends(const ob::State* from, const ob::State* to) { ends_ = {from, to}; }

  bool is_cancelled() const { return context_.cancellation.requested(); }
  void check_cancellation() const { context_.cancellation.check(); }

 private:
  bool is_end(const ob::State* state) const {
    const auto values = [](const ob::State* of) {
      return of->as<ob::RealVectorStateSpace::StateType>()->values;
    };
    return std::any_of(ends_.begin(), ends_.end(), [&](const ob::State* end) {
      return std::equal(values(end), values(end) + size(), values(state));
    });
  }

  bool is_blocked(const std::vector<ArmPair>& pairs, const std::vector<double>& from,
                  const std::vector<double>& to, const MotionCheckOptions& motion) const {
    try {
      return first_blocked(arm_, pairs, {from, to}, motion, context_).has_value();
    } catch (const Cancelled&) {
      return true;
    }
  }

  const DegreeOfFreedom& dof(std::size_t k) const { return arm_.robot().dofs[index(arm_.dofs[k])]; }

  std::vector<double> joints(const DofValues& dofs) const {
    return arm_joints(arm_, dofs, transfer_.hand_joints);
  }

  // The farthest that any point of a link moves for a unit of the degree of freedom: the largest
  // distance of a point of a link behind the joint (CompiledLink::reach) times the joint's ratio.
  double motion_of(int dof) const {
    double most = 1e-3;  // for one that moves nothing, so that its coordinate does not vanish
    for (const CompiledLink& link : arm_.links) {
      for (std::size_t k = 0; k < link.joints.size(); ++k) {
        const Joint& joint = arm_.robot().joints[index(link.joints[k])];
        if (joint.dof == dof) most = std::max(most, std::abs(joint.ratio) * link.reach[k]);
      }
    }
    return most;
  }

  const CompiledArm& arm_;
  const Transfer& transfer_;
  const TransferOptions& options_;
  const RunContext& context_;
  const std::vector<ArmPair> pairs_;
  std::vector<double> scale_;
  MotionFilter filter_;
  std::vector<OpenStretch> open_;
  std::vector<int> blocks_;  // motions that were blocked, by pair
  std::vector<const ob::State*> ends_;
  bool by_shapes_ = false;
};

// Edges of the planner's graph are checked by the proof of motion_check.h instead of OMPL's
// sampling at a fixed resolution, which can miss a thin obstacle.
class FreeMotion : public ob::MotionValidator {
 public:
  FreeMotion(const ob::SpaceInformationPtr& information, TransferSpace& space)
      : ob::MotionValidator(information), space_(space) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return space_.is_free(from, to);
  }
  // OMPL also asks how far the motion is free. The proof does not tell, so the answer is the start.
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (checkMotion(from, to)) return true;
    if (last_valid.first != nullptr) si_->copyState(last_valid.first, from);
    last_valid.second = 0.0;
    return false;
  }

 private:
  TransferSpace& space_;
};

// OMPL's description of the space: bounds, sampler, and both collision checks.
ob::SpaceInformationPtr information_of(TransferSpace& space, std::uint64_t seed) {
  auto vectors = std::make_shared<PlainSpace>(static_cast<unsigned>(space.size()));
  ob::RealVectorBounds bounds(static_cast<unsigned>(space.size()));
  for (std::size_t k = 0; k < space.size(); ++k) {
    bounds.low[k] = space.lower(k);
    bounds.high[k] = space.upper(k);
  }
  vectors->setBounds(bounds);
  vectors->setStateSamplerAllocator(
      [seed](const ob::StateSpace* of) { return std::make_shared<SeededSampler>(of, seed); });
  auto information = std::make_shared<ob::SpaceInformation>(vectors);
  information->setStateValidityChecker(
      [&space](const ob::State* state) { return space.is_free(state); });
  information->setMotionValidator(std::make_shared<FreeMotion>(information, space));
  information->setup();
  return information;
}

// LazyPRM needs no seed: unlike the other two it has no generator of its own and draws from the
// sampler of the space only.
ob::PlannerPtr planner_of(const ob::SpaceInformationPtr& information,
                          const TransferOptions& options) {
  const auto with_range = [](auto planner) -> ob::PlannerPtr {
    planner->setRange(kLongestEdge);
    return planner;
  };
  switch (options.planner) {
    case PathPlanner::roadmap:
      return with_range(std::make_shared<og::LazyPRM>(information));
    case PathPlanner::rrt_star:
      return with_range(std::make_shared<Seeded<og::RRTstar>>(information, options.seed));
    case PathPlanner::rrt_connect:
      break;
  }
  return with_range(std::make_shared<Seeded<og::RRTConnect>>(information, options.seed));
}

// Ends the planner when it has asked `iterations` times whether to end, about once for each sample
// that it draws. A count gives the same path on every machine, a time limit does not.
ob::PlannerTerminationCondition after(int iterations, const TransferSpace& space) {
  auto left = std::make_shared<int>(iterations);
  return ob::PlannerTerminationCondition(
      [left, &space] { return --*left < 0 || space.is_cancelled(); });
}

// A path that the planner found, and the same shortened.
struct FoundPath {
  std::vector<DofValues> whole;
  std::vector<DofValues> shortened;
};

// The ends are as they were given, to the bit: scaling into the planner's coordinates and back
// rounds.
std::vector<DofValues> waypoints_of(og::PathGeometric& path, const TransferSpace& space,
                                    const Transfer& transfer) {
  std::vector<DofValues> waypoints;
  for (const ob::State* state : path.getStates()) waypoints.push_back(space.dofs(state));
  waypoints.front() = transfer.from;
  waypoints.back() = transfer.to;
  return waypoints;
}

// Goes from each vertex that is kept to the last one that a straight line reaches.
void drop_vertices(const ob::SpaceInformation& information, og::PathGeometric& path) {
  std::vector<ob::State*>& states = path.getStates();
  std::vector<ob::State*> kept = {states.front()};
  for (std::size_t from = 0; from + 1 < states.size();) {
    std::size_t to = states.size() - 1;
    while (to > from + 1 && !information.checkMotion(states[from], states[to])) --to;
    for (std::size_t k = from + 1; k < to; ++k) information.freeState(states[k]);
    kept.push_back(states[to]);
    from = to;
  }
  states = std::move(kept);
}

// Cuts one corner of the path, the first way of kCuts that gains enough and is free. Whether there
// was one. Counts `attempts` down, and ends at 0.
bool cut_corner(const ob::SpaceInformation& information, std::size_t corner, int& attempts,
                og::PathGeometric& path) {
  std::vector<ob::State*>& states = path.getStates();
  const ob::StateSpacePtr& space = information.getStateSpace();
  const double least = kLeastGain * path.length();
  const auto part_of = [&](std::size_t neighbour, double part) {
    ob::State* at = information.cloneState(states[neighbour]);
    // Interpolation rounds, and the ends of the path are known by their exact values.
    if (part < 1.0) space->interpolate(states[corner], states[neighbour], part, at);
    return at;
  };
  for (const CornerCut& cut : kCuts) {
    ob::State* from = part_of(corner - 1, cut.before);
    ob::State* to = part_of(corner + 1, cut.after);
    const double gain = space->distance(from, states[corner]) +
                        space->distance(states[corner], to) - space->distance(from, to);
    const bool is_cut = gain >= least && attempts-- > 0 && information.checkMotion(from, to);
    std::vector<ob::State*> unused;
    if (is_cut) {
      unused.push_back(states[corner]);
      auto at = states.erase(states.begin() + static_cast<std::ptrdiff_t>(corner));
      if (cut.after < 1.0) at = states.insert(at, to);
      if (cut.before < 1.0) states.insert(at, from);
    }
    if (!is_cut || cut.before == 1.0) unused.push_back(from);
    if (!is_cut || cut.after == 1.0) unused.push_back(to);
    for (ob::State* state : unused) information.freeState(state);
    if (is_cut) return true;
  }
  return false;
}

// Cuts corners until no cut helps, but tries no more than `attempts`.
void cut_corners(const ob::SpaceInformation& information, int attempts, og::PathGeometric& path) {
  for (bool any = true; any;) {
    any = false;
    for (std::size_t i = 1; i + 1 < path.getStateCount() && attempts > 0; ++i)
      any = cut_corner(information, i, attempts, path) || any;
  }
}

// One run of the planner, and shortening of the path that it finds. Both check
// states and motions through TransferSpace, so every edge of the path is proven free. Empty when
// the iterations were used up.
FoundPath search(TransferSpace& space, const Transfer& transfer, const TransferOptions& options) {
  const ob::SpaceInformationPtr information = information_of(space, options.seed);
  auto problem = std::make_shared<ob::ProblemDefinition>(information);
  ob::ScopedState<> from(information);
  ob::ScopedState<> to(information);
  space.set(transfer.from, from.get());
  space.set(transfer.to, to.get());
  space.set_ends(from.get(), to.get());
  problem->setStartAndGoalStates(from, to);
  problem->setOptimizationObjective(
      std::make_shared<ob::PathLengthOptimizationObjective>(information));
  const ob::PlannerPtr planner = planner_of(information, options);
  planner->setProblemDefinition(problem);
  planner->setup();
  planner->solve(after(options.max_iterations, space));
  space.check_cancellation();
  // Planners also report approximate solutions, which end near the goal but not at it.
  if (!problem->hasExactSolution()) return {};
  auto path = std::static_pointer_cast<og::PathGeometric>(problem->getSolutionPath());
  FoundPath result{.whole = waypoints_of(*path, space, transfer), .shortened = {}};
  drop_vertices(*information, *path);
  cut_corners(*information, options.simplify_steps, *path);
  result.shortened = waypoints_of(*path, space, transfer);
  return result;
}

// Searches by rrt_connect with one seed after the other, each twice as long as the one before it
// but none longer than max_iterations: where a search takes long, a new one is often faster (Wedge
// and Branicky 2008, "On heavy-tailed runtimes and restarts in rapidly-exploring random trees").
// Every second one sees shapes in place of meshes, and misses only the narrowest passages. The
// other planners improve on what they have, and search once.
FoundPath search_in_rounds(TransferSpace& space, const Transfer& transfer,
                           const TransferOptions& options) {
  if (options.planner != PathPlanner::rrt_connect) return search(space, transfer, options);
  FoundPath found;
  TransferOptions round = options;
  for (int k = 0; k < kMostRounds && found.whole.empty(); ++k) {
    round.max_iterations = std::min(options.max_iterations, kFirstRound << k);
    space.set_by_shapes(k % 2 == 0);
    found = search(space, transfer, round);
    ++round.seed;
  }
  return found;
}

}  // namespace

TransferPath plan_transfer(const CompiledArm& arm, const Transfer& transfer,
                           const TransferOptions& options, const RunContext& context) {
  require_settings(options);
  ompl::msg::noOutputHandler();  // stdout and stderr are the program's own
  context.cancellation.check();
  TransferSpace space(arm, transfer, options, context);
  // OMPL waits for other starts and goals where these are not valid.
  if (!space.is_possible(transfer.from) || !space.is_possible(transfer.to)) return {};
  // Often the straight line is free, which saves the search and is the shortest path.
  if (space.may_be_free(transfer.from, transfer.to) && space.is_free({transfer.from, transfer.to}))
    return {{transfer.from, transfer.to}, std::nullopt};
  FoundPath found = search_in_rounds(space, transfer, options);
  // Rounding in and out of the planner's coordinates moves the waypoints a little, so the proof is
  // repeated for the lines that are returned. Shortening ends at what just passes it, which the
  // rounding can undo; the path before it has more room.
  const bool shortened = space.is_free(found.shortened);
  const bool whole = shortened || space.is_free(found.whole);
  context.cancellation.check();
  if (!whole) return {{}, space.bottleneck()};
  return {shortened ? std::move(found.shortened) : std::move(found.whole), space.bottleneck()};
}

}  // namespace prehend
