#include "planner/plan/try_shapes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "planner/plan/cut_short.h"
#include "planner/plan/run_trials.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/shape/cloud/unseen_space.h"
#include "sim/trial/candidate.h"

namespace prehend {
namespace {

// The scene with another surface of its object; nothing where that overlaps an obstacle.
std::optional<CompiledScene> with_shape(const CompiledScene& scene, const TriangleMesh& shape,
                                        const RunContext& context) {
  if (shape.empty()) return {};
  Scene changed = scene.scene;
  changed.object.mesh = shape;
  changed.object.completion.reset();
  try {
    return compile(std::move(changed), context);
  } catch (const InputError&) {
    return {};
  }
}

// What a trial adds to the certainty of its grasp: 0 where it does not hold.
double worth_of(const Trial& trial) {
  constexpr double kEnough = 0.02;
  constexpr double kBeyond = 0.2;
  if (trial.outcome != Outcome::stable) return 0.0;
  const double epsilon = trial.epsilon.lower;
  return std::min(epsilon, kEnough) + kBeyond * epsilon;
}

// The worth of each candidate's trial. Throws Cancelled where not all were tried.
std::vector<double> worth_on(const CompiledScene& scene, const std::vector<Candidate>& candidates,
                             const TrialOptions& options, const RunContext& context) {
  std::vector<double> worth;
  for (const std::optional<Trial>& trial : run_trials(scene, candidates, options, context)) {
    if (!trial) throw Cancelled();
    worth.push_back(worth_of(*trial));
  }
  return worth;
}

// The candidates with the hand moved, in the object's frame.
std::vector<Candidate> moved_by(const Vector3& move_O, std::vector<Candidate> candidates) {
  for (Candidate& candidate : candidates) candidate.X_OH = translation(move_O) * candidate.X_OH;
  return candidates;
}

using LinkPoints = std::vector<std::vector<Vector3>>;

// Points of the hand's links, frame of each link: at most kPoints of each, spread over its
// vertices.
LinkPoints points_of_links(const Robot& hand) {
  constexpr std::size_t kPoints = 40;
  LinkPoints points;
  for (const Link& link : hand.links) {
    std::vector<Vector3>& of_link = points.emplace_back();
    const std::vector<Vector3>& vertices = link.mesh.vertices;
    const std::size_t stride = 1 + vertices.size() / kPoints;
    for (std::size_t v = 0; v < vertices.size(); v += stride) of_link.push_back(vertices[v]);
  }
  return points;
}

// How many of the points are in unseen space, and of how many.
struct UnseenCount {
  int unseen = 0;
  int all = 0;

  void add(const CompiledScene& scene, const LinkPoints& points, const Pose& X_OH,
           const std::vector<double>& joints) {
    const GraspableBody& object = scene.scene.object;
    RobotPoses poses;
    robot_poses(scene.scene.hand, joints, poses);
    for (std::size_t l = 0; l < points.size(); ++l) {
      const Pose X_WL = object.X_WO * X_OH * poses.X_BL[l];
      for (const Vector3& p_L : points[l]) {
        unseen += object.completion->unseen->contains(X_WL * p_L) ? 1 : 0;
        ++all;
      }
    }
  }
};

// The part of the hand's way that lies in unseen space: where it starts, halfway and at the grasp.
double unseen_part(const CompiledScene& scene, const LinkPoints& points, const ScoredGrasp& grasp) {
  if (!scene.scene.object.completion->unseen) return 0.0;
  const Trial& trial = grasp.trial;
  std::vector<double> open;
  start_joints(scene.scene.hand, grasp.candidate, open);
  UnseenCount count;
  for (const double back : {1.0, 0.5}) {
    const Vector3 move_O = -back * trial.travel * grasp.candidate.approach_O;
    count.add(scene, points, translation(move_O) * trial.X_OH, open);
  }
  count.add(scene, points, trial.X_OH, trial.joints);
  return count.all > 0 ? static_cast<double>(count.unseen) / count.all : 0.0;
}

}  // namespace

void try_shapes(const CompiledScene& scene, const PlanOptions& options, const RunContext& context,
                PlanResult& result) {
  const std::optional<Completion>& completion = scene.scene.object.completion;
  constexpr double kWrong = 0.003;  // [m]
  constexpr double kCostOfUnseen = 0.3;
  if (!completion || result.grasps.empty()) return;
  const double most = std::round(options.rank.pool * static_cast<double>(options.rank.top));
  const auto count =
      static_cast<std::size_t>(std::min(most, static_cast<double>(result.grasps.size())));
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < count; ++i) candidates.push_back(result.grasps[i].candidate);
  RunContext quiet = context;
  quiet.progress = {};
  std::vector<HeldShapes> shapes(count);
  for (std::size_t i = 0; i < count; ++i) {
    shapes[i].likely = result.grasps[i].trial.outcome == Outcome::stable;
    shapes[i].certainty = worth_of(result.grasps[i].trial);
  }
  try {
    const auto fill = [&](const TriangleMesh& shape, std::optional<bool> HeldShapes::*which) {
      if (is_over(context)) throw Cancelled();
      const std::optional<CompiledScene> other = with_shape(scene, shape, context);
      if (!other) return;
      const std::vector<double> worth = worth_on(*other, candidates, options.trial, quiet);
      for (std::size_t i = 0; i < count; ++i) {
        shapes[i].*which = worth[i] > 0.0;
        shapes[i].certainty += worth[i];
      }
    };
    fill(completion->thin, &HeldShapes::thin);
    fill(completion->thick, &HeldShapes::thick);
    for (int axis = 0; axis < 3; ++axis) {
      for (const double move : {kWrong, -kWrong}) {
        if (is_over(context)) throw Cancelled();
        const std::vector<double> worth =
            worth_on(scene, moved_by(move * Vector3::Unit(axis), candidates), options.trial, quiet);
        for (std::size_t i = 0; i < count; ++i) shapes[i].certainty += worth[i];
      }
    }
  } catch (const Cancelled&) {
    result.status = cut_short(context);
    return;
  }
  const LinkPoints points = points_of_links(scene.scene.hand);
  for (std::size_t i = 0; i < count; ++i) {
    shapes[i].unseen = unseen_part(scene, points, result.grasps[i]);
    shapes[i].certainty *= 1.0 - kCostOfUnseen * shapes[i].unseen;
    result.grasps[i].shapes = shapes[i];
  }
  const auto place = [](const ScoredGrasp& grasp) {
    return std::tuple(grasp.trial.preferred, grasp.shapes->certainty);
  };
  std::stable_sort(result.grasps.begin(),
                   result.grasps.begin() + static_cast<std::ptrdiff_t>(count),
                   [&](const ScoredGrasp& a, const ScoredGrasp& b) { return place(a) > place(b); });
}

}  // namespace prehend
