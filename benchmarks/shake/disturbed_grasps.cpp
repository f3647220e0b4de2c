// Whether shaking tells more of a grasp than its quality: published grasps as they are, and moved
// off their place.
//
//   disturbed_grasps [--each N] [--protocol NAME]... FOLDER
//
// FOLDER holds grasps/dexycb_franka_*.json and ycb/*.obj; every N-th grasp is taken (4). For each
// protocol a table by disturbance: how many hold by force closure, the median of epsilon over all,
// how many survive, how many of those in force closure, and how well epsilon tells survivors from
// others: the probability that of one of each the survivor has the larger epsilon (AUC), among all
// and among those in force closure.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/support/percentile.h"
#include "planner/plan/plan.h"
#include "planner/plan/shake_grasps.h"
#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/manipulation/test_procedure_file.h"
#include "sim/robot/files/robot_file.h"
#include "sim/scene/make_scene.h"
#include "sim/shape/files/mesh_file.h"
#include "tests/support/published_grasps.h"

namespace prehend::bench {
namespace {

struct Perturbation {
  std::string name;
  double distance = 0.0;  // m
  double angle = 0.0;     // rad
};

std::vector<Perturbation> perturbations() {
  constexpr double kDegree = 3.14159265358979323846 / 180.0;
  return {{"0"},
          {"5 mm", 0.005},
          {"10 mm", 0.010},
          {"20 mm", 0.020},
          {"10 deg", 0.0, 10.0 * kDegree},
          {"20 deg", 0.0, 20.0 * kDegree},
          {"40 deg", 0.0, 40.0 * kDegree}};
}

Vector3 random_direction(Random& random) {
  Vector3 v = Vector3::Zero();
  do {
    for (double& value : v) value = random.uniform(-1.0, 1.0);
  } while (v.norm() > 1.0 || v.norm() < 1e-3);
  return v.normalized();
}

// The hand is moved along a random direction and turned about a random axis through the point
// between its fingers.
Candidate disturbed(Candidate grasp, const Perturbation& by, const Hand& hand, double depth,
                    Random& random) {
  const Vector3 grip_H = hand.origin + depth * hand.approach;
  const Vector3 grip_O = grasp.X_OH * grip_H;
  const Matrix3 turn = Eigen::AngleAxisd(by.angle, random_direction(random)).toRotationMatrix();
  grasp.X_OH.linear() = turn * grasp.X_OH.linear();
  grasp.X_OH.translation() =
      grip_O - grasp.X_OH.linear() * grip_H + by.distance * random_direction(random);
  grasp.approach_O = grasp.X_OH.linear() * hand.approach;
  return grasp;
}

CompiledScene franka_at(const std::filesystem::path& folder, const std::string& object) {
  Scene scene;
  scene.object = make_graspable(object, load_mesh(folder / "ycb" / (object + ".obj")).mesh,
                                Material::plastic, 0.1);
  scene.hand = find_robot("franka_hand");
  return compile(std::move(scene));
}

// What became of the grasps of one disturbance. Where the hand did not close on the object, a grasp
// has no quality and does not survive.
struct Tally {
  int tried = 0;
  int force_closed = 0;
  int survived = 0;
  int survived_force_closed = 0;
  std::vector<double> surviving;  // epsilon, 0 without force closure
  std::vector<double> failing;

  void add(const ScoredGrasp& grasp) {
    ++tried;
    const bool survives = grasp.shake && grasp.shake->holds();
    const bool closed = grasp.trial.outcome == Outcome::stable;
    (survives ? surviving : failing).push_back(closed ? grasp.trial.epsilon.lower : 0.0);
    survived += survives ? 1 : 0;
    force_closed += closed ? 1 : 0;
    survived_force_closed += survives && closed ? 1 : 0;
  }

  void add(const Tally& other) {
    tried += other.tried;
    force_closed += other.force_closed;
    survived += other.survived;
    survived_force_closed += other.survived_force_closed;
    surviving.insert(surviving.end(), other.surviving.begin(), other.surviving.end());
    failing.insert(failing.end(), other.failing.begin(), other.failing.end());
  }

  double median_epsilon() const {
    std::vector<double> all = surviving;
    all.insert(all.end(), failing.begin(), failing.end());
    return benchmark::percentile(std::move(all), 0.5);
  }
};

// The probability that of a survivor and another the survivor has the larger epsilon (AUC); none
// where one of the two is missing.
std::optional<double> ranked_right(const std::vector<double>& surviving,
                                   const std::vector<double>& failing) {
  double right = 0.0;
  for (const double a : surviving) {
    for (const double b : failing) right += a > b ? 1.0 : a == b ? 0.5 : 0.0;
  }
  if (surviving.empty() || failing.empty()) return std::nullopt;
  return right / static_cast<double>(surviving.size() * failing.size());
}

// The same among grasps in force closure only.
std::optional<double> ranked_right_of_closed(const Tally& tally) {
  const auto closed = [](std::vector<double> values) {
    std::erase(values, 0.0);
    return values;
  };
  return ranked_right(closed(tally.surviving), closed(tally.failing));
}

std::string percent_text(int part, int whole) {
  if (whole == 0) return "-";
  return std::to_string(std::lround(100.0 * part / whole)) + " %";
}

std::string share_text(const std::optional<double>& share) {
  if (!share) return "-";
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.2f", *share);
  return text.data();
}

void print_row(const std::string& name, const Tally& tally) {
  std::printf("%-8s %6d %14s %15.3f %9s %13s %8s %13s\n", name.c_str(), tally.tried,
              percent_text(tally.force_closed, tally.tried).c_str(), tally.median_epsilon(),
              percent_text(tally.survived, tally.tried).c_str(),
              percent_text(tally.survived_force_closed, tally.force_closed).c_str(),
              share_text(ranked_right(tally.surviving, tally.failing)).c_str(),
              share_text(ranked_right_of_closed(tally)).c_str());
}

void print_table(const std::string& procedure, const std::vector<Perturbation>& perturbations,
                 const std::vector<Tally>& tallies) {
  std::printf("\n%s\n%-8s %6s %14s %15s %9s %13s %8s %13s\n", procedure.c_str(), "off by", "tried",
              "force closure", "median epsilon", "survive", "of f.c.", "AUC", "AUC in f.c.");
  Tally all;
  for (std::size_t d = 0; d < perturbations.size(); ++d) {
    print_row(perturbations[d].name, tallies[d]);
    all.add(tallies[d]);
  }
  print_row("all", all);
  std::fflush(stdout);
}

struct Arguments {
  int each = 4;
  std::vector<std::string> protocols;
  std::filesystem::path folder;
};

Arguments read_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool is_option = words[i] == "--each" || words[i] == "--protocol";
    if (is_option && i + 1 == words.size()) {
      throw InputError({.field = words[i], .problem = "needs a value"});
    }
    if (words[i] == "--each") {
      arguments.each = std::max(1, std::stoi(words[++i]));
    } else if (words[i] == "--protocol") {
      arguments.protocols.push_back(words[++i]);
    } else {
      arguments.folder = words[i];
    }
  }
  if (arguments.folder.empty()) throw InputError({.field = "FOLDER", .problem = "is missing"});
  if (arguments.protocols.empty()) arguments.protocols = {"dexgraspbench", "acronym"};
  return arguments;
}

std::vector<std::string> objects_in(const std::filesystem::path& folder) {
  const std::string prefix = "dexycb_franka_";
  std::vector<std::string> objects;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "grasps")) {
    const std::string stem = entry.path().stem().string();
    if (stem.starts_with(prefix)) objects.push_back(stem.substr(prefix.size()));
  }
  std::sort(objects.begin(), objects.end());
  return objects;
}

int run(const std::vector<std::string>& words) {
  const Arguments arguments = read_arguments(words);
  const std::vector<Perturbation> all = perturbations();
  std::vector<std::vector<Tally>> tallies(arguments.protocols.size(),
                                          std::vector<Tally>(all.size()));
  for (const std::string& object : objects_in(arguments.folder)) {
    const CompiledScene scene = franka_at(arguments.folder, object);
    const Hand& hand = *scene.scene.hand.hand;
    const std::vector<Candidate> published = test::published_grasps(
        arguments.folder / "grasps" / ("dexycb_franka_" + object + ".json"), scene);
    for (std::size_t d = 0; d < all.size(); ++d) {
      Random random(1 + d);
      std::vector<Candidate> grasps;
      for (std::size_t i = 0; i < published.size(); i += static_cast<std::size_t>(arguments.each)) {
        const double depth =
            hand.preshapes[static_cast<std::size_t>(published[i].preshape.value_or(0))].depth;
        grasps.push_back(disturbed(published[i], all[d], hand, depth, random));
      }
      for (std::size_t p = 0; p < arguments.protocols.size(); ++p) {
        PlanResult result = evaluate(scene, grasps, {});
        shake_grasps(scene, read_test_procedure(find_test_procedure(arguments.protocols[p])), {},
                     result);
        for (const ScoredGrasp& grasp : result.grasps) tallies[p][d].add(grasp);
      }
    }
  }
  for (std::size_t p = 0; p < arguments.protocols.size(); ++p) {
    print_table(arguments.protocols[p], all, tallies[p]);
  }
  return 0;
}

}  // namespace
}  // namespace prehend::bench

int main(int count, char** words) {
  try {
    return prehend::bench::run({words + 1, words + count});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "disturbed_grasps: %s\n", error.what());
    return 1;
  }
}
