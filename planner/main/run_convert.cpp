#include <iostream>

#include "planner/main/shared_options.h"
#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/base/output_file.h"
#include "sim/robot/files/converted.h"

namespace prehend {
namespace {

// Arguments of `convert`.
struct ConvertCommand {
  std::string source;
  std::filesystem::path target;
  std::string unit;                   // of what is read; empty: m
  std::vector<std::string> packages;  // NAME=FOLDER
  std::filesystem::path srdf;         // empty: beside the URDF file, if it is there
};

void declare(CLI::App& command, ConvertCommand& options) {
  add_examples(command, {"convert gripper.urdf gripper.json", "convert panda panda.xrdf",
                         "convert bottle.stl bottle.obj --unit mm"});
  command.add_option("source", options.source, "robot or mesh file, or a robot of the library")
      ->required();
  command
      .add_option("target", options.target,
                  "file to write: .json or .urdf for a robot, .xrdf or .srdf with its spheres, "
                  ".obj .stl .ply .off for a mesh")
      ->required();
  add_unit(command, options.unit);
  add_foreign(command, options.packages, options.srdf);
}

int run_convert(const ConvertCommand& command, Interrupts& interrupts) {
  const std::filesystem::path folder = std::filesystem::absolute(command.target).parent_path();
  require_writable(folder);
  std::vector<std::string> notes;
  const std::vector<RobotTextFile> files =
      converted(command.source, command.target, command.unit.empty() ? "m" : command.unit,
                foreign_options(command.packages, command.srdf), notes);
  for (const std::string& note : notes) std::cerr << "note: " << on_one_line(note) << "\n";
  std::string names;
  for (const RobotTextFile& file : files) {
    make_folder((folder / file.name).parent_path());
    interrupts.write(folder / file.name, file.content);
    add_part(names, file.name.string());
  }
  std::cout << "wrote " << folder.string() << ": " << names << "\n";
  return 0;
}

}  // namespace

void add_convert(CLI::App& app, CommandRequest& request) {
  add_command(app, request, "convert", "write a robot or a mesh in another format", declare,
              run_convert);
}

}  // namespace prehend
