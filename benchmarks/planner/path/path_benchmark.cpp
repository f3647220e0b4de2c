// What arms cost: inverse kinematics of every arm and platform of the library, the reach of a
// trial, and the planning of a path, for each scene that has an arm.
//   path_benchmark [SCENE ...]
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "benchmarks/support/percentile.h"
#include "planner/path/check_path.h"
#include "planner/search/plan.h"
#include "sim/base/random.h"
#include "sim/robot/platform_file.h"
#include "sim/robot/robot_file.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"

namespace {

using namespace prehend;  // NOLINT(google-build-using-namespace): a program of its own
using benchmark::Clock;
using benchmark::milliseconds_since;
using benchmark::percentile;

void print(const std::string& what, const std::vector<double>& values, const char* unit) {
  std::printf("  %-28s %5zu   p50 %9.3f   p90 %9.3f   p99 %9.3f %s\n", what.c_str(), values.size(),
              percentile(values, 0.5), percentile(values, 0.9), percentile(values, 0.99), unit);
}

DofValues random_values(const Robot& robot, Random& random) {
  constexpr double kRoom = 10.0;  // of a base that could roll farther [m]
  DofValues values;
  for (const DegreeOfFreedom& dof : robot.dofs) {
    const double upper = std::min(dof.upper, dof.lower + kRoom);
    values.push_back(dof.lower + (upper - dof.lower) * random.uniform());
  }
  return values;
}

// Random reachable poses of the frame X_JT after `joint`; microseconds.
void measure_kinematics(const std::string& name, const Robot& robot, int joint, const Pose& X_JT,
                        int count) {
  Random random(1);
  std::vector<double> times;
  int solved = 0;
  IkOptions options;
  options.max_solutions = 1;
  for (int i = 0; i < count; ++i) {
    std::vector<Pose> X_BJ;
    joint_poses(robot, joint_values(robot, random_values(robot, random)), X_BJ);
    const IkTarget target{joint, X_JT, X_BJ[static_cast<std::size_t>(joint)] * X_JT};
    const DofValues start = initial_dofs(robot);
    const Clock::time_point begin = Clock::now();
    solved += !solve_all(robot, {target}, start, options).empty();
    times.push_back(1e3 * milliseconds_since(begin));
  }
  print(name, times, "us");
  std::printf("  %-28s %5d of %d solved\n", "", solved, count);
}

void measure_closed_form(const Robot& robot) {
  Random random(1);
  const SphericalWrist wrist(robot, robot.chains[0]);
  std::vector<double> times;
  int solved = 0;
  constexpr int kPoses = 10000;
  for (int i = 0; i < kPoses; ++i) {
    std::vector<Pose> X_BJ;
    joint_poses(robot, joint_values(robot, random_values(robot, random)), X_BJ);
    const Clock::time_point begin = Clock::now();
    solved += wrist.solve(X_BJ[5], {}).count > 0;
    times.push_back(1e3 * milliseconds_since(begin));
  }
  print(robot.name + ", closed form", times, "us");
  std::printf("  %-28s %5d of %d solved\n", "", solved, kPoses);
}

Robot without_closed_form(Robot robot) {
  for (Chain& chain : robot.chains) chain.closed_form = ClosedForm::none;
  return robot;
}

void measure_all_kinematics() {
  std::printf("inverse kinematics, all postures or one by least squares\n");
  constexpr int kPoses = 1000;
  for (const std::string& name : library_robot_names()) {
    const Robot robot = find_robot(name);
    if (robot.hand) continue;
    if (robot.chains[0].closed_form != ClosedForm::none) measure_closed_form(robot);
    measure_kinematics(name + ", numeric", without_closed_form(robot),
                       robot.chains[0].joint_count - 1, Pose::Identity(), kPoses);
  }
  for (const std::string& name : library_platform_names()) {
    const Platform platform = find_platform(name);
    const AssembledPlatform whole = assemble(platform);
    const PlatformPart& hand = whole.parts[static_cast<std::size_t>(hand_of(platform))];
    measure_kinematics(name + ", numeric", without_closed_form(whole.robot), hand.joint, hand.X_JR,
                       kPoses);
  }
}

void measure_scene(const std::string& name) {
  const CompiledScene scene = compile(load_scene(find_scene(name)));
  if (!scene.arm) return;
  std::printf(
      "%s: %zu links, %zu fixed bodies, %zu pairs of %zu may meet\n", name.c_str(),
      scene.arm->links.size(), scene.arm->bodies.size(),
      scene.arm->arm_pairs.size() + scene.arm->hand_pairs.size(),
      separate_pairs(scene.arm->links).size() + scene.arm->links.size() * scene.arm->bodies.size());
  PlanOptions options;
  options.rank.top = 1000;
  Clock::time_point begin = Clock::now();
  const PlanResult result = plan(scene, options);
  std::printf("  grasps in %.2f s, %zu different ones\n", 1e-3 * milliseconds_since(begin),
              result.grasps.size());
  std::vector<double> reaches;
  std::vector<double> paths;
  std::vector<double> checks;
  std::vector<double> lengths;
  for (const ScoredGrasp& grasp : result.grasps) {
    begin = Clock::now();
    (void)find_reach(*scene.arm, approach_line(scene, grasp.candidate, grasp.trial), {});
    reaches.push_back(milliseconds_since(begin));
    begin = Clock::now();
    const auto path = plan_grasp_path(scene, grasp.candidate, grasp.trial);
    if (!path) continue;
    paths.push_back(milliseconds_since(begin));
    lengths.push_back(path->times.back());
    begin = Clock::now();
    (void)check_path(scene, *path);
    checks.push_back(milliseconds_since(begin));
  }
  print("reach of a grasp", reaches, "ms");
  print("path, with its check", paths, "ms");
  print("  of that the check", checks, "ms");
  print("duration of the motion", lengths, "s");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    measure_all_kinematics();
    std::vector<std::string> scenes(argv + 1, argv + argc);
    if (scenes.empty()) scenes = library_scene_names();
    for (const std::string& scene : scenes) measure_scene(scene);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "path_benchmark: %s\n", error.what());
    return 1;
  }
  return 0;
}
