// Whether what is exported can be run: plans grasps with paths, writes them as MoveIt trajectories,
// reads the messages back from the files, joins them as a controller would, and lets FCL look at
// whole meshes so often that no link moves by more than 1 mm and no joint by more than 0.1 degrees
// between two looks. Limits of joints, velocities and accelerations are those of the robot.
//   exported_paths FOLDER COUNT SCENE...
// FOLDER: for the files, which stay there; COUNT: how many trajectories of all scenes together.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>
#include <vector>
#include <yaml-cpp/yaml.h>

#include "planner/plan/path/check_path.h"
#include "planner/plan/plan.h"
#include "planner/show/exports/export_files.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/output_file.h"
#include "sim/motion/control/trajectory.h"
#include "sim/scene/compiled_arm.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/scene_file.h"

namespace {

using namespace prehend;  // NOLINT(google-build-using-namespace): a program of its own

constexpr double kStep = 1e-3;                            // of any point of a link [m]
constexpr double kTurn = 0.1 * std::numbers::pi / 180.0;  // of any joint [rad, or 0.17 mm]

double seconds_of(const YAML::Node& duration) {
  return duration["sec"].as<double>() + 1e-9 * duration["nanosec"].as<double>();
}

// The messages of a file, one after the other; joints that one does not name stay where they are.
class JoinedMessages {
 public:
  JoinedMessages(const CompiledArm& arm, std::vector<double> start) : joints_(std::move(start)) {
    const Robot& robot = arm.robot();
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      path_.joints.push_back(robot.joints[j].name);
      place_[driver_name(robot.joints[j])] = j;
    }
  }

  void add(const YAML::Node& entry) {
    const YAML::Node message = entry["trajectory"]["joint_trajectory"];
    std::vector<std::size_t> places;
    for (const YAML::Node& name : message["joint_names"]) {
      places.push_back(place_.at(name.as<std::string>()));
    }
    const double from = path_.times.empty() ? 0.0 : path_.times.back();
    const int first = std::max(0, static_cast<int>(path_.times.size()) - 1);
    for (const YAML::Node& point : message["points"]) {
      std::vector<double> rates(joints_.size(), 0.0);
      for (std::size_t k = 0; k < places.size(); ++k) {
        joints_[places[k]] = point["positions"][k].as<double>();
        rates[places[k]] = point["velocities"][k].as<double>();
      }
      const double time = from + seconds_of(point["time_from_start"]);
      if (!path_.times.empty() && !(time > path_.times.back())) {
        jumps_ = std::max(jumps_, farthest_from_last());
        continue;
      }
      add_between(time, rates);
    }
    path_.segments.push_back(
        {entry["segment"].as<std::string>(), first, static_cast<int>(path_.times.size()) - 1});
  }

  const Trajectory& path() const { return path_; }
  // Farthest that a message begins from where the one before it ended [rad or m].
  double jumps() const { return jumps_; }

 private:
  double farthest_from_last() const {
    double farthest = 0.0;
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      farthest = std::max(farthest, std::abs(joints_[j] - path_.positions.back()[j]));
    }
    return farthest;
  }

  // The point, and before it those on the cubic from the last one on that keep to kTurn.
  void add_between(double time, const std::vector<double>& rates) {
    if (!path_.times.empty()) {
      const std::vector<double> p = path_.positions.back();
      const std::vector<double> v = path_.velocities.back();
      const double start = path_.times.back();
      const double h = time - start;
      double way = 0.0;
      for (std::size_t j = 0; j < joints_.size(); ++j) {
        way = std::max(way, h * std::max({std::abs(v[j]), std::abs(rates[j]),
                                          1.5 * std::abs(joints_[j] - p[j]) / h}));
      }
      const int steps = std::max(1, static_cast<int>(std::ceil(way / kTurn)));
      for (int k = 1; k < steps; ++k) {
        const double s = static_cast<double>(k) / steps;
        std::vector<double> at(joints_.size());
        std::vector<double> rate(joints_.size());
        for (std::size_t j = 0; j < joints_.size(); ++j) {
          const double d = joints_[j] - p[j];
          const double a = h * v[j];
          const double b = h * rates[j];
          at[j] = p[j] + s * (a + s * (3.0 * d - 2.0 * a - b + s * (a + b - 2.0 * d)));
          rate[j] = (a + s * (2.0 * (3.0 * d - 2.0 * a - b) + s * 3.0 * (a + b - 2.0 * d))) / h;
        }
        push(start + s * h, at, rate);
      }
    }
    push(time, joints_, rates);
  }

  void push(double time, const std::vector<double>& positions, const std::vector<double>& rates) {
    path_.times.push_back(time);
    path_.positions.push_back(positions);
    path_.velocities.push_back(rates);
  }

  std::map<std::string, std::size_t> place_;
  std::vector<double> joints_;
  Trajectory path_;
  double jumps_ = 0.0;
};

struct Checked {
  int trajectories = 0;
  long postures = 0;
  int colliding = 0;  // trajectories
  int beyond = 0;     // trajectories that break a limit
  double jumps = 0.0;
};

void check_file(const CompiledScene& scene, const std::filesystem::path& file, Checked& checked) {
  const Scene& given = scene.scene;
  const CompiledArm& arm = *scene.arm;
  JoinedMessages messages(arm, joint_values(arm.robot(), given.carrier->start));
  for (const YAML::Node& entry : YAML::LoadFile(file.string())) messages.add(entry);
  const PathCheck check = check_path(scene, messages.path(), {.step = kStep});
  ++checked.trajectories;
  checked.postures += check.postures;
  checked.jumps = std::max(checked.jumps, messages.jumps());
  // Times are rounded to a nanosecond, which changes rates by as much over short samples.
  constexpr double kRounded = 1e-4;
  const bool beyond = check.velocity > 1.0 + kRounded || check.acceleration > 1.0 + kRounded ||
                      check.beyond_limits > 1e-6;
  if (check.collisions > 0) ++checked.colliding;
  if (beyond) ++checked.beyond;
  if (check.collisions > 0 || beyond) {
    std::printf("%s: %d of %d postures collide (%s), velocity %.6f, acceleration %.6f, beyond %g\n",
                file.c_str(), check.collisions, check.postures, check.first_collision.c_str(),
                check.velocity, check.acceleration, check.beyond_limits);
  }
}

void check_scene(const std::string& name, std::uint64_t seed, const std::filesystem::path& folder,
                 int most, Checked& checked) {
  const CompiledScene scene = compile(load_scene(name));
  PlanOptions options;
  options.seed = seed;
  options.volumes = false;
  options.paths = GraspPathOptions{};
  options.rank.top = most;
  options.free_closing = 0;
  const PlanResult result = plan(scene, options);
  std::filesystem::create_directories(folder);
  for (const ExportFile& file : export_files(scene, result, "moveit")) {
    write_file(folder / file.name, file.content);
  }
  int rank = 0;
  for (const ScoredGrasp& grasp : result.grasps) {
    ++rank;
    if (!grasp.path) continue;
    check_file(scene, folder / ("path_" + std::to_string(rank) + "_moveit.yaml"), checked);
  }
}

void add(const Checked& one, Checked& all) {
  all.trajectories += one.trajectories;
  all.postures += one.postures;
  all.colliding += one.colliding;
  all.beyond += one.beyond;
  all.jumps = std::max(all.jumps, one.jumps);
}

void print(const std::string& name, const Checked& checked) {
  std::printf("| %s | %d | %ld | %d | %d |\n", name.c_str(), checked.trajectories, checked.postures,
              checked.colliding, checked.beyond);
  std::fflush(stdout);
}

// Scene after scene with one seed, then with the next, until there are enough.
void run(const std::filesystem::path& folder, int count, const std::vector<std::string>& scenes) {
  constexpr std::uint64_t kMostSeeds = 20;
  constexpr int kMostOfAPlan = 50;
  Checked all;
  std::printf("| scene | trajectories | postures | that collide | that break a limit |\n");
  std::printf("|---|---|---|---|---|\n");
  for (std::uint64_t seed = 1; seed <= kMostSeeds; ++seed) {
    for (std::size_t s = 0; s < scenes.size() && all.trajectories < count; ++s) {
      Checked checked;
      check_scene(scenes[s], seed, folder / (std::to_string(seed) + "_" + std::to_string(s)),
                  std::min(kMostOfAPlan, count - all.trajectories), checked);
      print(scenes[s], checked);
      add(checked, all);
    }
  }
  print("all", all);
  std::printf("Messages begin at most %.2g rad or m from where the one before ended.\n", all.jumps);
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count < 4) throw std::invalid_argument("exported_paths FOLDER COUNT SCENE...");
    run(words[1], std::stoi(words[2]), {words + 3, words + count});
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "exported_paths: %s\n", error.what());
    return 1;
  }
}
