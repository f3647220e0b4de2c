// Options that several commands have. Each function adds those that it names to a command.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "planner/main/command_line.h"
#include "sim/robot/files/package_folders.h"
#include "sim/scene/surface_region.h"
#include "sim/trial/pad_contact_options.h"

namespace prehend {

// Options of commands that compute something.
struct CommonOptions {
  std::filesystem::path out = "out";
  int threads = 0;  // 0: all processors
  std::uint64_t seed = 1;
  std::string accuracy = "standard";         // a name, or a file of settings
  std::optional<ContactKind> contacts = {};  // else as the accuracy says
  bool no_report = false;
  bool progress = false;  // lines on stderr that say how far the run is
};

// Shows these below the options in the command's help, each as it is typed after "prehend ".
void add_examples(CLI::App& command, const std::vector<std::string>& examples);

// --budget, --memory-limit.
void add_limits(CLI::App& command, Limits& limits);

// Declares a command below `app`. An Options has the values of its options, each with its default:
// declare(command, options) adds them, and run(options, interrupts) is what request.run calls once
// the command is read. Returns the command.
template <typename Options>
CLI::App& add_unlimited_command(CLI::App& app, CommandRequest& request, const std::string& name,
                                const std::string& summary, void (*declare)(CLI::App&, Options&),
                                int (*run)(const Options&, Interrupts&)) {
  CLI::App& command = *app.add_subcommand(name, summary);
  const auto options = std::make_shared<Options>();
  declare(command, *options);
  command.callback([options, run, &request] {
    request.run = [options, run](Interrupts& interrupts) { return run(*options, interrupts); };
  });
  return command;
}

// The same with --budget and --memory-limit.
template <typename Options>
void add_command(CLI::App& app, CommandRequest& request, const std::string& name,
                 const std::string& summary, void (*declare)(CLI::App&, Options&),
                 int (*run)(const Options&, Interrupts&)) {
  add_limits(add_unlimited_command(app, request, name, summary, declare, run), request.limits);
}

// --threads, --seed, --out, --progress.
void add_common(CLI::App& command, CommonOptions& common);

// --uncertainty.
void add_uncertainty(CLI::App& command, bool& uncertainty);

// --shake.
void add_shake(CLI::App& command, std::string& protocol);

// --dynamic.
void add_dynamic(CLI::App& command, bool& dynamic);

// --no-second-check.
void add_second_check(CLI::App& command, bool& no_second_check);

// --no-report.
void add_no_report(CLI::App& command, bool& no_report);

// --accuracy.
void add_accuracy(CLI::App& command, CommonOptions& common);

// --contacts.
void add_contacts(CLI::App& command, CommonOptions& common);

// --unit, and --scale in its place.
void add_unit(CLI::App& command, std::string& unit);
// The same, and --no-repair.
void add_mesh_options(CLI::App& command, std::string& unit, bool& repair);

// Words of --object, --keep-out, --prefer and --apart.
struct ChoiceWords {
  std::string object = {};
  std::vector<std::string> keep_out = {};
  std::vector<std::string> preferred = {};
  double apart = 0.0;  // m
};

// --object, --keep-out, --prefer, --apart.
void add_choice(CLI::App& command, ChoiceWords& words);

// What they say. A region is the name of a part of the mesh file, or two opposite corners of a box
// in the object's frame, "x,y,z:x,y,z" in mm. Throws InputError that names the option.
ObjectChoice object_choice(const ChoiceWords& words);

// --friction.
void add_friction(CLI::App& command, std::optional<double>& friction);

// --scene, --hand, --unit, --no-repair.
void add_scene_options(CLI::App& command, std::string& scene, std::string& hand, std::string& unit,
                       bool& repair);

// --package.
void add_packages(CLI::App& command, std::vector<std::string>& packages);

// --package, --srdf.
void add_foreign(CLI::App& command, std::vector<std::string>& packages,
                 std::filesystem::path& srdf);

// The options of readers of robots from NAME=FOLDER and the name of an SRDF file. Throws InputError
// for words without "=".
ForeignRobotOptions foreign_options(const std::vector<std::string>& packages,
                                    const std::filesystem::path& srdf);

}  // namespace prehend
