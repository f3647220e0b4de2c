#include "benchmarks/views/view_cases.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "benchmarks/support/percentile.h"
#include "benchmarks/views/place_on_table.h"
#include "benchmarks/views/render_depth.h"
#include "planner/plan/accuracy.h"
#include "planner/plan/plan.h"
#include "sim/base/input_error.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/convex_hull.h"
#include "sim/trial/perturbed_trials.h"
#include "sim/trial/run_trial.h"
#include "tests/support/depth_camera.h"

namespace prehend::bench {
namespace {

constexpr double kDistance = 0.65;  // of cameras [m]
constexpr double kTable = 0.6;      // to each side [m]
constexpr double kWrong = 0.003;    // by which a surface may be elsewhere [m]
constexpr double kEnough = 0.02;    // epsilon
constexpr double kGap = 0.001;      // between the table of the plans and what stands on it [m]

CompiledScene scene_of(const TriangleMesh& mesh_W, const std::string& hand) {
  Scene scene = make_scene(make_graspable("object", mesh_W, Material::plastic), hand);
  add_obstacle(scene, "table", make_box({2.0 * kTable, 2.0 * kTable, 0.02}),
               translation({0.0, 0.0, -0.01 - kGap}));
  return compile(std::move(scene));
}

// Of a body that reaches below z = 0 by its roughness: only what does not touch the table.
TriangleMesh above_table(TriangleMesh mesh) {
  for (Vector3& p : mesh.vertices) p.z() = std::max(p.z(), -0.5 * kGap);
  return mesh;
}

// The candidate that leads to the grasp again: the hand comes the same way until it touches, or to
// where it stopped in the plan, for a robot that feels nothing.
Candidate again(const ScoredGrasp& grasp, bool until_touch) {
  Candidate candidate = replayed_approach(grasp.candidate, grasp.trial, Pose::Identity());
  if (until_touch) return candidate;
  candidate.X_OH = grasp.trial.X_OH;
  candidate.approach_distance = grasp.trial.travel;
  return candidate;
}

std::vector<ScoredGrasp> best_grasps(const CompiledScene& scene, int threads) {
  PlanOptions options = plan_options(Accuracy::draft);
  options.rank.top = 16;
  return plan(scene, options, {.threads = threads}).grasps;
}

ViewResult tried_on(const CompiledScene& scene, const ScoredGrasp& grasp) {
  const Trial trial = run_trial(scene, again(grasp, true));
  ViewResult result{.found = true, .outcome = std::string(name_of(trial.outcome))};
  result.holds = trial.outcome == Outcome::stable;
  result.holds_as_planned = run_trial(scene, again(grasp, false)).outcome == Outcome::stable;
  return result;
}

// The grasp that holds best on all scenes, and in the first of them with the hand moved by what a
// surface may be wrong: the largest sum of epsilon, of which what exceeds kEnough counts a fifth,
// so that to hold each time is worth more than to hold well sometimes.
const ScoredGrasp& surest(const std::vector<ScoredGrasp>& grasps,
                          const std::vector<CompiledScene>& scenes) {
  const ScoredGrasp* best = &grasps.front();
  double most = -1.0;
  if (scenes.empty()) return *best;
  for (const ScoredGrasp& grasp : grasps) {
    double sum = 0.0;
    const auto add = [&](const CompiledScene& scene, const Vector3& move) {
      Candidate candidate = again(grasp, true);
      candidate.X_OH = translation(move) * candidate.X_OH;
      const Trial trial = run_trial(scene, candidate);
      if (trial.outcome != Outcome::stable) return;
      const double epsilon = trial.epsilon.lower;
      sum += std::min(epsilon, kEnough) + 0.2 * epsilon;
    };
    for (const CompiledScene& scene : scenes) add(scene, Vector3::Zero());
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {1.0, -1.0}) {
        add(scenes.front(), sign * kWrong * Vector3::Unit(axis));
      }
    }
    if (sum > most) {
      most = sum;
      best = &grasp;
    }
  }
  return *best;
}

}  // namespace

TableCase table_case(const std::string& file) {
  const Scene scene = load_scene(file);
  const std::size_t from = file.find_last_of('/') + 1;
  return {file.substr(from, file.find_last_of('.') - from),
          transformed(scene.object.mesh, pose_on_table(scene.object.mesh))};
}

std::vector<DepthView> views_of(const TableCase& object, double angle, int count) {
  const ProximityMesh tree(object.mesh_W);
  const Vector3 middle = bounds(object.mesh_W).center();
  std::vector<DepthView> views;
  for (int k = 0; k < count; ++k) {
    const double turn = angle + 2.0 * std::numbers::pi * k / count;
    const double down = std::numbers::pi / 180.0 * (37.5 + 7.5 * std::sin(5.0 * turn));
    const Vector3 way(std::cos(turn) * std::cos(down), std::sin(turn) * std::cos(down),
                      std::sin(down));
    Random random(derived_seed(1, static_cast<std::uint64_t>(1000.0 * turn)));
    views.push_back(render_depth(test::camera_at(middle + kDistance * way, middle), {{&tree}},
                                 kTable, {}, random));
  }
  return views;
}

TriangleMesh hull_of_seen(const SeenObject& object) {
  if (object.mesh.empty()) return {};
  std::vector<Vector3> points;
  for (std::size_t t = 0; t < object.seen.size(); ++t) {
    if (object.seen[t] == 0) continue;
    for (const Vector3& p : corners_of(object.mesh, static_cast<int>(t))) points.push_back(p);
  }
  return convex_hull(points);
}

Grasping::Grasping(const TableCase& object, std::string hand, int threads)
    : hand_(std::move(hand)), true_W_(object.mesh_W), threads_(threads) {}

ViewResult Grasping::plan_and_try(const TriangleMesh& mesh_W,
                                  const std::vector<TriangleMesh>& others) const {
  if (mesh_W.empty()) return {.outcome = "no mesh"};
  const std::vector<ScoredGrasp> grasps =
      best_grasps(scene_of(above_table(mesh_W), hand_), threads_);
  if (grasps.empty()) return {.outcome = "no grasp"};
  std::vector<CompiledScene> scenes;
  for (const TriangleMesh& other : others) scenes.push_back(scene_of(above_table(other), hand_));
  return tried_on(scene_of(true_W_, hand_), surest(grasps, scenes));
}

std::array<ViewResult, 2> Grasping::plan_and_try_both(const SeenObject& object) const {
  const benchmark::Clock::time_point start = benchmark::Clock::now();
  const CompiledScene likely = scene_of(above_table(object.mesh), hand_);
  const std::vector<ScoredGrasp> grasps = best_grasps(likely, threads_);
  const double planned = benchmark::milliseconds_since(start);
  if (grasps.empty()) {
    const ViewResult none{.outcome = "no grasp", .milliseconds = planned};
    return {none, none};
  }
  std::vector<CompiledScene> scenes;
  for (const TriangleMesh* other : {&object.mesh, &object.thin, &object.thick}) {
    if (!other->empty()) scenes.push_back(scene_of(above_table(*other), hand_));
  }
  const CompiledScene truth = scene_of(true_W_, hand_);
  const ScoredGrasp& sure = surest(grasps, scenes);
  const double judged = benchmark::milliseconds_since(start);
  std::array<ViewResult, 2> results{tried_on(truth, grasps.front()), tried_on(truth, sure)};
  results[0].milliseconds = planned;
  results[1].milliseconds = judged;
  return results;
}

}  // namespace prehend::bench
