#include <algorithm>
#include <memory>

#include "benchmarks/report/names.h"
#include "benchmarks/suite/google_runs.h"
#include "benchmarks/suite/parts.h"
#include "benchmarks/suite/planning.h"
#include "benchmarks/suite/sample_grasps.h"
#include "benchmarks/suite/sample_robots.h"
#include "sim/base/formatted.h"
#include "sim/quality/epsilon.h"
#include "sim/quality/wrench_hull.h"
#include "sim/robot/files/platform_file.h"
#include "sim/robot/files/robot_file.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"
#include "sim/shape/contact/contact_region.h"
#include "sim/trial/grasp_contacts.h"

namespace prehend::bench {
namespace {

// A call for each of the inputs, of which there is at least one.
template <typename Input, typename Call>
Kernel kernel_over(std::string name, std::vector<Input> inputs, Call call) {
  const int calls = static_cast<int>(inputs.size());
  return {std::move(name), calls, [inputs = std::move(inputs), call] {
            double sum = 0.0;
            for (const Input& input : inputs) sum += call(input);
            return sum;
          }};
}

// Poses of b, turned at random, at which its gap to a is `gap` [m] within a hundredth: b comes from
// afar towards the middle of a.
std::vector<Pose> poses_at_gap(const ProximityMesh& a, const ProximityMesh& b, double gap) {
  constexpr std::size_t kPoses = 32;
  constexpr int kSteps = 200;
  Random random(1);
  std::vector<Pose> poses;
  while (poses.size() < kPoses) {
    const Matrix3 turn = random.rotation();
    const Vector3 from = random.direction();
    double distance = 2.0 * (a.ball_radius() + b.ball_radius()) + gap;
    for (int step = 0; step < kSteps; ++step) {
      const Pose X_AB = pose_from(turn, a.ball_center() + distance * from - turn * b.ball_center());
      const double now = find_gap(a, b, X_AB).lower;
      if (now <= 1.01 * gap) {
        poses.push_back(X_AB);
        break;
      }
      distance -= now - gap;
    }
  }
  return poses;
}

void add_distances(const CompiledScene& scene, std::vector<Kernel>& kernels) {
  const ProximityMesh object = scene.object().mesh;
  const ProximityMesh palm = scene.links.front().mesh;
  for (const double millimetres : {0.1, 10.0, 200.0}) {
    kernels.push_back(kernel_over(
        formatted("mesh distance, %.3g mm apart", millimetres),
        poses_at_gap(object, palm, 1e-3 * millimetres),
        [object, palm](const Pose& X_OL) { return find_gap(object, palm, X_OL).lower; }));
  }
  const Bounds box = bounds(object.mesh());
  Random random(1);
  std::vector<Vector3> points;
  for (int i = 0; i < 512; ++i) {
    points.push_back(random.in_box(box.lower, box.upper));
  }
  kernels.push_back(kernel_over("inside test", points, [object](const Vector3& p) {
    return is_inside(object, p) ? 1.0 : 0.0;
  }));
}

// The link with the most contacts of a grasp.
LinkId busiest_link(const Trial& trial) {
  LinkId busiest = trial.contacts.front().link;
  const auto count = [&](LinkId link) {
    return std::count_if(trial.contacts.begin(), trial.contacts.end(),
                         [link](const GraspContact& contact) { return contact.link == link; });
  };
  for (const GraspContact& contact : trial.contacts) {
    if (count(contact.link) > count(busiest)) busiest = contact.link;
  }
  return busiest;
}

void add_contacts(const CompiledScene& scene, std::vector<Kernel>& kernels) {
  const std::vector<ScoredGrasp> grasps = best_grasps(scene, 40, 10);
  if (grasps.empty()) return;
  std::vector<Trial> trials;
  for (const ScoredGrasp& grasp : grasps) trials.push_back(grasp.trial);
  const auto shared = std::make_shared<const CompiledScene>(scene);
  const auto workspace = std::make_shared<RegionWorkspace>();
  kernels.push_back(
      kernel_over("contact regions of one link", trials, [shared, workspace](const Trial& trial) {
        std::vector<Pose> X_HL;
        link_poses(shared->scene.hand, trial.joints, X_HL);
        const std::size_t link = index(busiest_link(trial));
        std::vector<SurfaceContact> contacts;
        find_contacts(shared->object().mesh, shared->links[link].mesh, trial.X_OH * X_HL[link], {},
                      *workspace, contacts);
        return static_cast<double>(contacts.size());
      }));
  kernels.push_back(
      kernel_over("contacts of a hand, soft patches too", trials, [shared](const Trial& trial) {
        return static_cast<double>(
            grasp_contacts(*shared, trial.X_OH, trial.joints, TrialOptions{}).size());
      }));
}

void add_quality(std::vector<Kernel>& kernels) {
  constexpr int kGrasps = 16;
  for (const int contacts : {4, 8, 16}) {
    std::vector<Wrenches> wrenches;
    for (const auto& grasp : holding_grasps(contacts, kGrasps)) {
      wrenches.push_back(contact_wrenches(grasp, {}));
    }
    kernels.push_back(kernel_over(formatted("ε, %d contacts", contacts), wrenches,
                                  [](const Wrenches& w) { return epsilon_l1(w).lower; }));
    if (contacts > 8) continue;  // seconds
    kernels.push_back(kernel_over(formatted("hull of wrenches by qhull, %d contacts", contacts),
                                  wrenches,
                                  [](const Wrenches& w) { return wrench_hull(w).volume; }));
  }
}

Kernel kinematics(const std::string& name, const Robot& robot, int joint, const Pose& X_JT) {
  constexpr int kTargets = 64;
  return kernel_over(
      "inverse kinematics, " + name, reachable_targets(robot, joint, X_JT, kTargets),
      [robot](const IkTarget& target) {
        IkOptions options;
        options.max_solutions = 1;
        return static_cast<double>(solve_all(robot, {target}, initial_dofs(robot), options).size());
      });
}

void add_kinematics(std::vector<Kernel>& kernels) {
  for (const std::string& name : library_robot_names()) {
    const Robot robot = find_robot(name);
    if (robot.hand || robot.chains.empty()) continue;
    const int last = robot.chains[0].joint_count - 1;
    if (robot.chains[0].closed_form != ClosedForm::none) {
      kernels.push_back(kinematics(name + ", closed form", robot, last, Pose::Identity()));
    }
    kernels.push_back(kinematics(name + ", one posture by least squares",
                                 without_closed_form(robot), last, Pose::Identity()));
  }
  for (const std::string& name : library_platform_names()) {
    const Platform platform = find_platform(name);
    const AssembledPlatform whole = assemble(platform);
    const PlatformPart& hand = whole.parts[static_cast<std::size_t>(hand_of(platform))];
    kernels.push_back(kinematics(name + ", one posture", whole.robot, hand.joint, hand.X_JR));
  }
}

void add_path(const Sizes& sizes, std::vector<Kernel>& kernels) {
  const std::string& name = sizes.arm_scenes.front();
  const auto scene = std::make_shared<const CompiledScene>(compile(load_scene(find_scene(name))));
  const std::vector<ScoredGrasp> grasps = best_grasps(*scene, sizes.path_trials, 1);
  if (grasps.empty()) return;
  kernels.push_back(kernel_over("one path, " + name, grasps, [scene](const ScoredGrasp& grasp) {
    const auto path = plan_grasp_path(*scene, grasp.candidate, grasp.trial);
    return path ? path->motion.times.back() : 0.0;
  }));
}

}  // namespace

void measure_kernels(const Sizes& sizes, std::vector<Entry>& entries) {
  Record record(kKernels, entries);
  record.say("mug and Barrett hand, ε, inverse kinematics, one path");
  const CompiledScene scene = object_scene("mug", 5000, "barrett");
  std::vector<Kernel> kernels;
  add_distances(scene, kernels);
  add_contacts(scene, kernels);
  add_quality(kernels);
  add_kinematics(kernels);
  add_path(sizes, kernels);
  run_kernels(kernels, sizes, record);
}

}  // namespace prehend::bench
