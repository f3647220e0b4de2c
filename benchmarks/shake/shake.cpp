// How many of the best grasps survive the protocols of shaking, and in whose opinion:
//
//   shake [--grasps N] [--trials N] [--protocol NAME]... [--no-causes] SCENE[:HAND]...
//
// A scene is a name of the library, a scene or mesh file, or a generated object ("bowl"). For
// protocols on a support, objects without obstacles are put on a table. Each grasp on which the
// simulators do not agree has a line that names the cause (disagreements.h).
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "benchmarks/shake/shake_cases.h"
#include "benchmarks/shake/shake_table.h"
#include "benchmarks/support/word_reader.h"
#include "sim/base/input_error.h"
#include "sim/manipulation/test_procedure_file.h"

namespace prehend::bench {
namespace {

struct Arguments {
  int grasps = 10;
  int trials = 1000;
  bool explain = true;
  std::vector<std::string> protocols;
  std::vector<std::string> cases;
};

Arguments read_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  WordReader reader(words);
  while (reader.next()) {
    if (reader.word() == "--grasps")
      arguments.grasps = reader.number();
    else if (reader.word() == "--trials")
      arguments.trials = reader.number();
    else if (reader.word() == "--no-causes")
      arguments.explain = false;
    else if (reader.word() == "--protocol")
      arguments.protocols.push_back(reader.text());
    else
      arguments.cases.push_back(reader.word());
  }
  if (arguments.protocols.empty()) arguments.protocols = library_test_procedure_names();
  if (arguments.cases.empty()) {
    arguments.cases = {"mug:barrett",       "mug:robotiq_2f85", "bottle:barrett",
                       "phone:franka_hand", "box:parallel_jaw", "mug_on_table"};
  }
  return arguments;
}

// The protocols of one kind, on the support or not: each kind has grasps of its own.
void add_case(const std::string& name, const Arguments& arguments,
              const std::vector<TestProcedure>& protocols, bool on_support, ShakeTable& table) {
  std::vector<TestProcedure> of_kind;
  for (const TestProcedure& procedure : protocols) {
    if (procedure.on_support == on_support) of_kind.push_back(procedure);
  }
  if (of_kind.empty()) return;
  const ShakeCase shaken = shake_case(name, arguments.trials, arguments.grasps, on_support);
  if (shaken.grasps.empty()) std::printf("%-28s no grasp\n", name.c_str());
  for (const TestProcedure& procedure : of_kind) {
    if (!shaken.grasps.empty()) table.add(shaken, procedure);
  }
}

int run(const std::vector<std::string>& words) {
  const Arguments arguments = read_arguments(words);
  std::vector<TestProcedure> protocols;
  for (const std::string& name : arguments.protocols) {
    protocols.push_back(read_test_procedure(find_test_procedure(name)));
  }
  ShakeTable table(arguments.explain);
  ShakeTable::print_head();
  for (const std::string& name : arguments.cases) {
    for (const bool on_support : {false, true}) {
      try {
        add_case(name, arguments, protocols, on_support, table);
      } catch (const InputError& error) {  // the others are worth their time all the same
        std::printf("%-28s left out: %s\n", name.c_str(), error.what());
      }
    }
  }
  table.print_sums();
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
