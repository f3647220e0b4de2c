#include "planner/main/command_line.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/base/nearest_name.h"

namespace prehend {
namespace {

// CLI11 says of an unknown command only that one is required.
void check_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands(nullptr)) {
    if (command->get_name() == argv[1]) return;
    known.push_back(command->get_name());
  }
  throw InputError(
      {.problem = "unknown command, " + did_you_mean(argv[1], known) + "known are " + joined(known),
       .value = argv[1]});
}

// The command that the words ask for, the innermost one.
const CLI::App& asked_command(const CLI::App& app) {
  const std::vector<CLI::App*> below = app.get_subcommands();
  return below.empty() ? app : asked_command(*below.front());
}

// All names of an option, as they are typed.
std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_fnames()) names.push_back("--" + name);
  return names;
}

// Switches take no value, not even one that CLI11 could make sense of: "--path=no" would be read as
// an option that is not there, and "--uncertainty=3" as one that is there three times.
void check_switch(const CLI::App& command, std::string_view word) {
  const std::size_t sign = word.find('=');
  if (!word.starts_with("--") || sign == std::string_view::npos) return;
  const std::string name(word.substr(0, sign));
  for (const CLI::Option* option : command.get_options()) {
    const std::vector<std::string> names = names_of(*option);
    if (option->get_items_expected_max() != 0 || std::ranges::find(names, name) == names.end()) {
      continue;
    }
    throw InputError({.field = name,
                      .problem = "is on where it stands and takes no value; leave it out",
                      .value = std::string(word.substr(sign + 1))});
  }
}

// What CLI11 cannot place: an option that the command does not have, with the one that may be
// meant.
void check_known(const CLI::App& app, const CLI::App& command) {
  for (const std::string& word : app.remaining(true)) {
    if (!word.starts_with('-') || word.size() < 2) continue;
    std::vector<std::string> known;
    for (const CLI::Option* option : command.get_options()) {
      for (const std::string& name : names_of(*option)) known.push_back(name);
    }
    const std::string name = word.substr(0, word.find('='));
    throw InputError({.field = name,
                      .problem = command.get_name() + " has no such option, " +
                                 did_you_mean(name, known) + "see --help"});
  }
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
      for (int i = 1; i < argc; ++i) check_switch(asked_command(app), argv[i]);
      check_known(app, asked_command(app));
      throw InputError(std::string(error.what()) + " (see --help)");
    }
    app.exit(error);
    return std::nullopt;
  }
  for (int i = 1; i < argc; ++i) check_switch(asked_command(app), argv[i]);
  return request;
}

}  // namespace prehend
