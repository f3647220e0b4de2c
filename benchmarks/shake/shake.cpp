// How many of the best grasps survive the protocols of shaking, and in whose opinion:
//
//   shake [--grasps N] [--trials N] [--protocol NAME]... SCENE[:HAND]...
//
// A scene is a name of the library, a scene or mesh file, or a generated object ("bowl").
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "benchmarks/shake/opinions.h"
#include "benchmarks/shake/shake_cases.h"
#include "benchmarks/support/percentile.h"
#include "sim/base/input_error.h"
#include "sim/manipulation/protocol_file.h"

namespace prehend::bench {
namespace {

struct Arguments {
  int grasps = 10;
  int trials = 1000;
  std::vector<std::string> protocols;
  std::vector<std::string> cases;
};

Arguments read_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto value = [&] {
      if (i + 1 >= words.size()) throw InputError({.field = words[i], .problem = "needs a value"});
      return words[++i];
    };
    if (words[i] == "--grasps")
      arguments.grasps = std::stoi(value());
    else if (words[i] == "--trials")
      arguments.trials = std::stoi(value());
    else if (words[i] == "--protocol")
      arguments.protocols.push_back(value());
    else
      arguments.cases.push_back(words[i]);
  }
  if (arguments.protocols.empty()) arguments.protocols = library_protocol_names();
  if (arguments.cases.empty()) {
    arguments.cases = {"mug:barrett",       "mug:robotiq_2f85", "bottle:barrett",
                       "phone:franka_hand", "box:parallel_jaw", "mug_on_table"};
  }
  return arguments;
}

// On how many grasps all opinions agree, and the ranks of the others.
void print_agreement(const ShakeCase& shaken, const std::vector<std::vector<bool>>& held) {
  int agreed = 0;
  std::string others;
  for (std::size_t g = 0; g < shaken.grasps.size(); ++g) {
    const bool agrees = std::all_of(held.begin(), held.end(), [&](const std::vector<bool>& by) {
      return by[g] == held.front()[g];
    });
    if (agrees) {
      ++agreed;
    } else {
      others.append(" ").append(std::to_string(shaken.grasps[g].rank));
    }
  }
  std::printf("   agree on %d%s%s", agreed, others.empty() ? "" : ", not on", others.c_str());
}

// One line: of each opinion the share that survives, the time of a grasp, and why others failed.
void print_row(const ShakeCase& shaken, const Protocol& protocol) {
  std::printf("%-22s %-18s %6zu", shaken.name.c_str(), protocol.name.c_str(), shaken.grasps.size());
  std::vector<std::vector<bool>> held;  // by opinion and grasp
  for (const Opinion& opinion : opinions()) {
    const auto start = benchmark::Clock::now();
    held.emplace_back();
    int survived = 0;
    double steps = 0.0;
    std::vector<int> failures(kPhaseFailures.size(), 0);
    for (const ShakenGrasp& grasp : shaken.grasps) {
      const ShakeResult result = opinion.shake(shaken, grasp, protocol);
      survived += result.survived() ? 1 : 0;
      held.back().push_back(result.survived());
      steps += result.steps;
      for (const ShakeTestResult& test : failed_tests(result)) {
        ++failures[static_cast<std::size_t>(test.phases.back().failure)];
      }
    }
    const double seconds = 1e-3 * benchmark::milliseconds_since(start);
    const auto count = static_cast<double>(shaken.grasps.size());
    std::printf("   %5.0f %% %7.2f s %6.0f us", 100.0 * survived / count, seconds / count,
                1e6 * seconds / steps);
    for (const PhaseFailure failure : kPhaseFailures) {
      const int times = failures[static_cast<std::size_t>(failure)];
      if (times == 0) continue;
      std::printf(" %s %d", std::string(phase_failure_name(failure)).c_str(), times);
    }
  }
  print_agreement(shaken, held);
  std::printf("\n");
  std::fflush(stdout);
}

int run(const std::vector<std::string>& words) {
  const Arguments arguments = read_arguments(words);
  std::printf("%-22s %-18s %6s", "object:hand", "protocol", "grasps");
  for (const Opinion& opinion : opinions()) {
    std::printf("   %-7s s/grasp   a step  tests that failed", opinion.name.c_str());
  }
  std::printf("\n");
  for (const std::string& name : arguments.cases) {
    const ShakeCase shaken = shake_case(name, arguments.trials, arguments.grasps);
    if (shaken.grasps.empty()) {
      std::printf("%-22s no grasp\n", name.c_str());
      continue;
    }
    for (const std::string& protocol_name : arguments.protocols) {
      const Protocol protocol = read_protocol(find_protocol(protocol_name));
      if (protocol.on_support && shaken.scene.scene.obstacles.empty()) continue;
      print_row(shaken, protocol);
    }
  }
  return 0;
}

}  // namespace
}  // namespace prehend::bench

int main(int count, char** words) {
  try {
    return prehend::bench::run({words + 1, words + count});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "shake: %s\n", error.what());
    return 1;
  }
}
