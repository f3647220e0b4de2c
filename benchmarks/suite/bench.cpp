// The benchmark suite: measures, and makes a page of results (docs/how-to/benchmarks.md).
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "benchmarks/report/compare.h"
#include "benchmarks/report/hands_page.h"
#include "benchmarks/report/machine.h"
#include "benchmarks/report/names.h"
#include "benchmarks/report/page.h"
#include "benchmarks/report/results_file.h"
#include "benchmarks/suite/arguments.h"
#include "benchmarks/suite/hands.h"
#include "benchmarks/suite/memory.h"
#include "benchmarks/suite/parts.h"
#include "sim/base/input_error.h"
#include "sim/base/output_file.h"

namespace {

using namespace prehend;         // NOLINT(google-build-using-namespace): a program of its own
using namespace prehend::bench;  // NOLINT(google-build-using-namespace)

constexpr const char* kResultsFile = "results.json";

// The page and its plots. Plots of an earlier page that this one does not have are removed; those
// of other programs are not named in it.
void write_page(const Results& results, const std::filesystem::path& folder) {
  const std::vector<PageFile> files = page_of(results);
  std::ostringstream earlier;
  earlier << std::ifstream(folder / "results.md").rdbuf();
  remove_regular_files(folder, [&](const std::string& name) {
    const bool ours = std::any_of(files.begin(), files.end(),
                                  [&](const PageFile& file) { return file.name == name; });
    return name.ends_with(".svg") && !ours && earlier.str().find(name) != std::string::npos;
  });
  for (const PageFile& file : files) write_file(folder / file.name, file.content);
  std::printf("%s\n", (folder / "results.md").c_str());
}

std::string this_program(const char* called) {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::string(called) : program.string();
}

int run(const Arguments& arguments, const std::string& program) {
  const std::filesystem::path folder = arguments.folder;
  require_writable(folder);
  const Sizes sizes = sizes_of(arguments.effort);
  Results results;
  results.effort = effort_name(arguments.effort);
  results.machine = this_machine(PREHEND_VERSION, PREHEND_BUILD_TYPE);
  const auto wanted = [&](const char* part) {
    return std::find(arguments.parts.begin(), arguments.parts.end(), part) != arguments.parts.end();
  };
  if (wanted(kKernels)) measure_kernels(sizes, results.entries);
  if (wanted(kTrials)) {
    measure_trials(sizes, results.entries);
    measure_paths(sizes, results.entries);
  }
  if (wanted(kPlans)) measure_plans(sizes, results.entries);
  if (wanted(kTrade)) measure_trade(sizes, results.entries);
  if (wanted(kScaling)) {
    measure_scaling(sizes, program, results.machine.cores, results.entries);
  }
  make_folder(folder);
  write_file(folder / kResultsFile, results_json(results));
  write_page(results, folder);
  return 0;
}

int run_hands(const Arguments& arguments) {
  const std::filesystem::path folder = arguments.folder;
  require_writable(folder);
  const std::string page = hands_page(plan_hands(arguments.words));
  make_folder(folder);
  write_file(folder / "hands.md", page);
  std::printf("%s\n", (folder / "hands.md").c_str());
  return 0;
}

int compare_files(const Arguments& arguments) {
  const Comparison comparison =
      compare(read_results(arguments.words[0]), read_results(arguments.words[1]));
  std::printf("%s", comparison_text(comparison, arguments.most).c_str());
  return slower_than(comparison, arguments.most).empty() ? 0 : 1;
}

int make_page(const Arguments& arguments) {
  const Results results = read_results(arguments.words[0]);
  make_folder(arguments.folder);
  write_page(results, arguments.folder);
  return 0;
}

int act(const Arguments& arguments, const std::string& program) {
  switch (arguments.command) {
    case Command::run:
      return run(arguments, program);
    case Command::hands:
      return run_hands(arguments);
    case Command::page:
      return make_page(arguments);
    case Command::compare:
      return compare_files(arguments);
    case Command::memory:
      std::printf("%.3f\n", memory_here({arguments.words[0], std::stoi(arguments.words[1]),
                                         std::stoi(arguments.words[2])}));
      return 0;
    case Command::help:
      std::printf("%s", usage().c_str());
      return 0;
  }
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return act(read_arguments({argv + 1, argv + argc}), this_program(argv[0]));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench: %s\n", error.what());
    return 2;
  }
}
