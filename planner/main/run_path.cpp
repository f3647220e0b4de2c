#include <algorithm>
#include <charconv>
#include <iostream>
#include <optional>
#include <sstream>
#include <utility>

#include "planner/main/option_values.h"
#include "planner/main/print_notes.h"
#include "planner/main/shared_options.h"
#include "planner/plan/path/arm_path.h"
#include "planner/show/exports/csv.h"
#include "planner/show/exports/end_effector.h"
#include "planner/show/exports/moveit.h"
#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/base/output_file.h"
#include "sim/base/range.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/moveit_scene.h"
#include "sim/scene/reach/reach.h"
#include "sim/scene/scene_file.h"

namespace prehend {
namespace {

// Arguments of `path`.
struct PathCommand {
  std::string scene;              // name, scene file or scene of MoveIt
  std::string robot;              // of a scene of MoveIt; empty: the one it names
  std::string hand;               // empty: that of the platform
  std::string from;               // values of joints; empty: as the scene says
  std::string to;                 // values of joints
  std::string pose;               // of a frame of the hand in the world
  std::string frame;              // which; empty: the hand's base link
  bool straight = false;          // to the pose in a straight line
  std::filesystem::path request;  // of MoveIt; empty: none
  std::string planner = "rrt_connect";
  std::optional<int> iterations;  // empty: those of TransferOptions
  bool no_second_check = false;
  std::vector<std::string> packages;
  CommonOptions common = {.out = "out/path"};
};

void declare(CLI::App& command, PathCommand& options) {
  add_examples(command, {"path panda_on_table --to panda_joint1=0.5",
                         "path panda_on_table --to-pose 0.4,0,0.6,1,0,0,0 --frame panda_hand_tcp",
                         "path panda_on_table --to-pose 0.4,0,0.5,1,0,0,0 --straight",
                         "path scene.yaml --request request.yaml"});
  command.add_option("scene", options.scene, "scene name, scene file, or scene of MoveIt (YAML)")
      ->required();
  command.add_option("--to", options.to,
                     "goal: JOINT=VALUE,..., or the values of the arm's joints, in rad or m");
  command.add_option("--to-pose", options.pose,
                     "goal: x,y,z,qx,qy,qz,qw in the world, in m; of --frame");
  command.add_option("--frame", options.frame,
                     "frame of the hand or arm that --to-pose is of; else the hand's base");
  command.add_flag("--straight", options.straight,
                   "to --to-pose in a straight line of the hand, turning at a constant rate");
  command.add_option("--from", options.from, "start, as --to; else where the scene has the arm");
  command
      .add_option("--request", options.request,
                  "start and goal from a motion plan request of MoveIt (YAML)")
      ->check(CLI::ExistingFile);
  command.add_option("--robot", options.robot,
                     "arm with its hand for a scene of MoveIt: platform or robot file");
  command.add_option("--hand", options.hand, "robot of the library or robot file");
  command.add_option("--planner", options.planner, "rrt_connect, roadmap or rrt_star")
      ->check(CLI::IsMember(texts(enum_names(PathPlanner{}))))
      ->capture_default_str();
  command.add_option("--iterations", options.iterations, "after which the search ends")
      ->check(CLI::PositiveNumber);
  add_second_check(command, options.no_second_check);
  add_packages(command, options.packages);
  add_common(command, options.common);
}

// What stands between the commas.
std::vector<std::string> parts_of(const std::string& words) {
  std::vector<std::string> parts;
  std::istringstream stream(words);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

std::vector<double> numbers_of(const std::string& words, const std::string& option) {
  std::vector<double> numbers;
  for (const std::string& word : parts_of(words)) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    require(error == std::errc() && end == word.data() + word.size() && kCoordinate.contains(value),
            {.field = option, .problem = "not a number", .value = word});
    numbers.push_back(value);
  }
  return numbers;
}

// What --from or --to says: names with values, or values of the arm's joints from base to tip.
NamedJoints joints_of(const std::string& words, const Carrier& carrier, const std::string& option) {
  NamedJoints joints;
  if (words.find('=') != std::string::npos) {
    for (const std::string& word : parts_of(words)) {
      const std::size_t equals = word.find('=');
      require(equals != std::string::npos && equals > 0,
              {.field = option, .problem = "not JOINT=VALUE", .value = word});
      const std::vector<double> value = numbers_of(word.substr(equals + 1), option);
      require(value.size() == 1, {.field = option, .problem = "not JOINT=VALUE", .value = word});
      joints[word.substr(0, equals)] = value.front();
    }
    return joints;
  }
  std::vector<std::string> names;
  for (std::size_t r = 0; r < carrier.platform.robots.size(); ++r) {
    if (static_cast<int>(r) == carrier.hand) continue;
    for (const Joint& joint : carrier.platform.robots[r].robot.joints) {
      names.push_back(driver_name(joint));
    }
  }
  const std::vector<double> values = numbers_of(words, option);
  require(
      values.size() == names.size(),
      {.field = option,
       .problem = formatted("%zu values for %zu joints of the arm: ", values.size(), names.size()) +
                  joined(names)});
  for (std::size_t i = 0; i < names.size(); ++i) joints[names[i]] = values[i];
  return joints;
}

// The pose of the hand's base link H in the frame F of the hand, or of the arm at its flange.
Pose hand_in_frame(const Scene& scene, const std::string& name) {
  if (name.empty() || name == scene.hand.links[0].name) return Pose::Identity();
  std::string known = scene.hand.links[0].name;
  for (const RobotFrame& frame : scene.hand.frames) {
    if (frame.joint >= 0) continue;
    if (frame.name == name) return frame.X_AF.inverse();
    add_part(known, frame.name);
  }
  throw InputError(
      {.field = "--frame", .problem = "the hand has no such frame, but " + known, .value = name});
}

// The pose of the hand's base at the goal, in the world.
Pose hand_at_goal(const PathCommand& command, const CompiledScene& scene) {
  const std::vector<double> p = numbers_of(command.pose, "--to-pose");
  require(p.size() == 7,
          {.field = "--to-pose", .problem = "must be x,y,z,qx,qy,qz,qw", .value = command.pose});
  const Eigen::Quaterniond turn(p[6], p[3], p[4], p[5]);
  require(turn.norm() > 1e-6,
          {.field = "--to-pose", .problem = "the quaternion is zero", .value = command.pose});
  const Pose X_WF = pose_from(turn.normalized().toRotationMatrix(), Vector3(p[0], p[1], p[2]));
  return X_WF * hand_in_frame(scene.scene, command.frame);
}

void require_one_goal(const PathCommand& command) {
  const int goals =
      int{!command.to.empty()} + int{!command.pose.empty()} + int{!command.request.empty()};
  require(goals == 1, {.problem = "path: exactly one of --to, --to-pose and --request is needed"});
  require(command.frame.empty() || !command.pose.empty(),
          {.field = "--frame", .problem = "only beside --to-pose", .value = command.frame});
  require(!command.straight || !command.pose.empty(),
          {.field = "--straight", .problem = "only beside --to-pose"});
}

// The scene with the arm at the start, and the values at the goal where it is one of joints.
struct AskedPath {
  CompiledScene scene;
  std::optional<DofValues> goal;
};

AskedPath asked_of(const PathCommand& command) {
  SceneSource source{.hand = command.hand, .robot = command.robot, .needs_object = false};
  source.foreign = foreign_options(command.packages, {});
  Scene scene = load_scene(command.scene, source);
  require(scene.carrier.has_value(),
          {.file = command.scene, .field = "robot", .problem = "needed, for there is no arm"});
  MotionRequest request;
  if (!command.request.empty()) request = read_motion_request(command.request);
  if (!command.to.empty()) request.goal = joints_of(command.to, *scene.carrier, "--to");
  if (!command.from.empty()) request.start = joints_of(command.from, *scene.carrier, "--from");
  if (!request.start.empty()) set_start(request.start, scene);
  std::optional<DofValues> goal;
  if (!request.goal.empty()) {
    Scene there = scene;
    there.notes.clear();
    set_start(request.goal, there);
    goal = there.carrier->start;
    scene.notes.insert(scene.notes.end(), there.notes.begin(), there.notes.end());
  }
  print_notes(scene);
  return {compile(std::move(scene)), std::move(goal)};
}

ArmPath path_to(const PathCommand& command, const AskedPath& asked, const GraspPathOptions& options,
                const RunContext& context) {
  const CompiledScene& scene = asked.scene;
  if (asked.goal) return plan_arm_path(scene, {*asked.goal}, options, context);
  const Pose X_WH = hand_at_goal(command, scene);
  if (command.straight) return plan_arm_line(scene, X_WH, options, context);
  // Nearest to the start first.
  const Pose X_OH = scene.scene.object.X_WO.inverse() * X_WH;
  return plan_arm_path(scene, postures_at(*scene.arm, X_OH, options.reach, context), options,
                       context);
}

int print_failure(const ArmPath& path) {
  std::cout << "no path: " << name_of(path.end);
  if (!path.why.empty()) std::cout << " (" << path.why << ")";
  if (path.end == ArmPathEnd::not_found) {
    std::cout << ": more --iterations or another --seed may find one";
  }
  std::cout << "\n";
  return 1;
}

int run_path(const PathCommand& command, Interrupts& interrupts) {
  require_one_goal(command);
  require_writable(command.common.out);
  const AskedPath asked = asked_of(command);
  const RunContext context{command.common.threads, interrupts.cancellation(), {}, {}};
  interrupts.end_at_once("nothing is written");
  GraspPathOptions options;
  options.transfer.planner = *value_named<PathPlanner>(command.planner);
  options.transfer.seed = command.common.seed;
  options.transfer.max_iterations = command.iterations.value_or(options.transfer.max_iterations);
  options.check.collisions = !command.no_second_check;
  const ArmPath path = path_to(command, asked, options, context);
  make_folder(command.common.out);
  const std::vector<std::string> names = {"path.csv", "path_moveit.yaml"};
  if (path.end != ArmPathEnd::found) {
    remove_regular_files(command.common.out, [&](const std::string& name) {
      return std::find(names.begin(), names.end(), name) != names.end();
    });
    return print_failure(path);
  }
  interrupts.write(command.common.out / names[0], path_csv(path.motion));
  interrupts.write(command.common.out / names[1],
                   moveit_trajectories_yaml(path.motion, driver_names(asked.scene.arm->robot())));
  const std::string way =
      command.straight ? std::string("along a straight line of the hand")
                       : formatted("by %zu straight lines of the joints, %.2f times as long as one",
                                   path.waypoints.size() - 1, relative_length(path.waypoints));
  std::cout << formatted("path of %.3f s ", path.motion.times.back()) << way
            << formatted("; %d postures checked, none collides\n", path.check.postures) << "wrote "
            << command.common.out.string() << ": " << joined(names) << "\n";
  return 0;
}

}  // namespace

void add_path(CLI::App& app, CommandRequest& request) {
  add_command(app, request, "path", "plan a motion of an arm to a posture or a pose", declare,
              run_path);
}

}  // namespace prehend
