// Options that several commands have. Each function adds those that it names to a command.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "planner/main/command_line.h"
#include "planner/main/commands.h"

namespace prehend {

// --budget, --memory-limit.
void add_limits(CLI::App& command, Limits& limits);

// --threads, --seed, --out, --progress.
void add_common(CLI::App& command, CommonOptions& common);

// --uncertainty.
void add_uncertainty(CLI::App& command, bool& uncertainty);

// --shake.
void add_shake(CLI::App& command, std::string& protocol);

// --dynamic.
void add_dynamic(CLI::App& command, bool& dynamic);

// --no-report.
void add_no_report(CLI::App& command, bool& no_report);

// --accuracy.
void add_accuracy(CLI::App& command, CommonOptions& common);

// --contacts.
void add_contacts(CLI::App& command, CommonOptions& common);

// --unit, --no-repair.
void add_mesh_options(CLI::App& command, std::string& unit, bool& repair);

// --scene, --hand, --unit, --no-repair.
void add_scene_options(CLI::App& command, std::string& scene, std::string& hand, std::string& unit,
                       bool& repair);

// --package.
void add_packages(CLI::App& command, std::vector<std::string>& packages);

// --package, --srdf.
void add_foreign(CLI::App& command, std::vector<std::string>& packages,
                 std::filesystem::path& srdf);

// --listen, --record, --folder, --threads.
void add_live(CLI::App& command, LiveOptions& live);

// --folder, --threads.
void add_session(CLI::App& command, std::vector<std::filesystem::path>& folders, int& threads);

}  // namespace prehend
