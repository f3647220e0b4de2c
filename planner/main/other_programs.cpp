#include "planner/main/other_programs.h"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <unistd.h>

#include <CLI/CLI.hpp>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

constexpr std::array kOtherCommands{kStudio, kServe, kMcp,   kReplay,
                                    kBatch,  kLearn, kTruth, kDesign};

}  // namespace

void add_other_commands(CLI::App& app) {
  for (const OtherCommand& other : kOtherCommands) app.add_subcommand(other.name, other.summary);
}

void start_other_program(int argc, char** argv) {
  if (argc < 2) return;
  for (const OtherCommand& other : kOtherCommands) {
    if (other.name != std::string_view(argv[1])) continue;
    const std::filesystem::path program =
        std::filesystem::read_symlink("/proc/self/exe").replace_filename(other.program);
    // Its name for itself stays prehend, in what it says of its commands.
    ::execv(program.c_str(), argv);
    throw InputError(
        {.problem = "needs the program " + program.string() + ", which cannot be started",
         .value = other.name});
  }
}

}  // namespace prehend
