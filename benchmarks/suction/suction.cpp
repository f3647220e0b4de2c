// Whether suction cups hold what the planner says, in MuJoCo's opinion, whose actuators adhere:
//
//   suction [--picks N] [--grasps N] [--trials N] [--hand HAND]... [--list] MESH...
//
// HAND: of suction cups, a name of the library or a robot file. Of the grasps of a plan on each
// mesh some are taken, from the ones near the centre of mass to those far from it; each is turned
// some way, and the object so heavy that the planner's margin is between 0.3 and 3. Tables in
// Markdown; with --list before them a line for each pick.
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/suction/suction_cases.h"
#include "benchmarks/suction/suction_table.h"
#include "benchmarks/support/word_reader.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/parallel/parallel.h"

namespace prehend::bench {
namespace {

constexpr double kLeastMargin = 0.3;
constexpr double kLargestMargin = 3.0;

struct Arguments {
  int picks = 100;
  int grasps = 8;  // of an object and a hand, at most
  int trials = 200;
  bool list = false;
  std::vector<std::string> hands;
  std::vector<std::string> meshes;
};

Arguments arguments_of(const std::vector<std::string>& words) {
  Arguments arguments;
  WordReader reader(words);
  while (reader.next()) {
    if (reader.word() == "--picks")
      arguments.picks = reader.number();
    else if (reader.word() == "--grasps")
      arguments.grasps = reader.number();
    else if (reader.word() == "--trials")
      arguments.trials = reader.number();
    else if (reader.word() == "--list")
      arguments.list = true;
    else if (reader.word() == "--hand")
      arguments.hands.push_back(reader.text());
    else
      arguments.meshes.push_back(reader.word());
  }
  if (arguments.hands.empty()) arguments.hands = {"suction_cup_30", "suction_array_4"};
  require(!arguments.meshes.empty(), {.field = "MESH", .problem = "at least one is needed"});
  return arguments;
}

std::vector<SuctionCase> cases_of(const Arguments& arguments) {
  std::vector<SuctionCase> cases;
  for (const std::string& mesh : arguments.meshes) {
    std::vector<TriangleMesh> pieces;
    for (const std::string& hand : arguments.hands) {
      try {
        cases.push_back(suction_case(mesh, hand, arguments.trials,
                                     static_cast<std::size_t>(arguments.grasps), pieces));
        std::fprintf(stderr, "%s, %s: %zu grasps\n", mesh.c_str(), hand.c_str(),
                     cases.back().grasps.size());
      } catch (const InputError& error) {
        std::fprintf(stderr, "%s, %s: left out: %s\n", mesh.c_str(), hand.c_str(), error.what());
      }
    }
  }
  return cases;
}

// The attitudes take turns, shifted from round to round, so that each object sees them all.
std::vector<SuctionPick> picks_of(const std::vector<SuctionCase>& cases, std::size_t count) {
  std::vector<std::size_t> sizes;
  for (const SuctionCase& of : cases) sizes.push_back(of.grasps.size());
  const std::vector<TakenItem> taken = in_turn(sizes, count);
  const std::vector<double> margins = spread_factors(kLeastMargin, kLargestMargin, taken.size());
  std::vector<SuctionPick> picks(taken.size());
  for_each_in_parallel(taken.size(), 0, [&](std::size_t k) {
    const auto& [list, item] = taken[k];
    const HungAttitude attitude = kAll<HungAttitude>[(list + item) % kAll<HungAttitude>.size()];
    picks[k] = suction_pick(cases[list], cases[list].grasps[item], attitude, margins[k]);
  });
  return picks;
}

struct BothEnds {
  HangingEnd adheres;
  HangingEnd leaks;
};

// None: the pick is left out. Where no lip lifts, or all is lost, the seal changes nothing.
std::optional<BothEnds> ends_of(const SuctionPick& pick) {
  try {
    BothEnds ends;
    ends.adheres = hang_in_mujoco(pick.hanging, LiftedLip::adheres);
    ends.leaks = ends.adheres.held && ends.adheres.lifted
                     ? hang_in_mujoco(pick.hanging, LiftedLip::leaks)
                     : ends.adheres;
    return ends;
  } catch (const InputError& error) {
    std::fprintf(stderr, "%s, %s: left out: %s\n", pick.object.c_str(), pick.hand.c_str(),
                 error.what());
    return std::nullopt;
  }
}

SuctionResult result_of(const SuctionPick& pick, const BothEnds& ends) {
  SuctionResult result{pick.hand, pick.attitude, pick.margin, pick.elastic_margin, {}};
  result.held[HeldReading::adhesion] = ends.adheres.held;
  result.held[HeldReading::seal] = ends.leaks.held;
  result.held[HeldReading::strain] = ends.leaks.held && ends.leaks.tilted <= pick.strain;
  return result;
}

void print_pick(const SuctionPick& pick, const BothEnds& ends) {
  const auto print_end = [](const HangingEnd& end) {
    std::printf(" %s%s, %.1f mm, %.3f rad;", end.held ? "held" : "lost",
                end.unstable ? " (unstable)"
                : end.lifted ? " (lifted)"
                             : "",
                1e3 * end.moved, end.tilted);
  };
  std::printf("%-16s %-16s %zu cups %-19s %6.2f kg margin %.2f, elastic %.2f:", pick.object.c_str(),
              pick.hand.c_str(), pick.hanging.cups.size(),
              std::string(name_of(pick.attitude)).c_str(), pick.hanging.inertial.mass, pick.margin,
              pick.elastic_margin);
  print_end(ends.adheres);
  print_end(ends.leaks);
  std::printf(" linear %.2f, facing %.2f\n", ends.adheres.linear_margin, ends.adheres.facing);
}

int run(const std::vector<std::string>& words) {
  const Arguments arguments = arguments_of(words);
  const std::vector<SuctionCase> cases = cases_of(arguments);
  const std::vector<SuctionPick> picks = picks_of(cases, static_cast<std::size_t>(arguments.picks));
  std::vector<std::optional<BothEnds>> ends(picks.size());
  for_each_in_parallel(picks.size(), 0, [&](std::size_t k) { ends[k] = ends_of(picks[k]); });
  std::vector<SuctionResult> results;
  for (std::size_t k = 0; k < picks.size(); ++k) {
    if (!ends[k]) continue;
    results.push_back(result_of(picks[k], *ends[k]));
    if (arguments.list) print_pick(picks[k], *ends[k]);
  }
  if (results.empty()) throw InputError({.field = "MESH", .problem = "nothing was lifted"});
  std::printf("%s%s", arguments.list ? "\n" : "", suction_tables(results).c_str());
  return 0;
}

}  // namespace
}  // namespace prehend::bench

int main(int count, char** words) {
  try {
    return prehend::bench::run({words + 1, words + count});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "suction: %s\n", error.what());
    return 1;
  }
}
