#include "planner/main/command_line.h"

#include <CLI/CLI.hpp>

#include "sim/base/input_error.h"
#include "sim/base/joined.h"

namespace prehend {
namespace {

// CLI11 says of an unknown command only that one is required.
void check_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::string known;
  for (const CLI::App* command : app.get_subcommands(nullptr)) {
    if (command->get_name() == argv[1]) return;
    add_part(known, command->get_name());
  }
  throw InputError({.problem = "unknown command, known are " + known, .value = argv[1]});
}

}  // namespace

std::optional<CommandRequest> read_command_line(int argc, char** argv, const AddCommands& add) {
  CLI::App app{"prehend plans robot grasps: a mesh and a hand in, ranked grasps out."};
  CommandRequest request;
  app.require_subcommand(1);
  app.set_version_flag("--version", "prehend " PREHEND_VERSION);
  add(app, request);
  check_command(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // --help and --version are reported as errors with the exit code 0.
    if (error.get_exit_code() != 0) {
      throw InputError(std::string(error.what()) + " (see --help)");
    }
    app.exit(error);
    return std::nullopt;
  }
  return request;
}

}  // namespace prehend
