#include <iostream>

#include "planner/main/commands.h"
#include "sim/base/input_error.h"
#include "sim/base/output_file.h"
#include "sim/robot/files/converted.h"

namespace prehend {

ForeignRobotOptions foreign_options(const std::vector<std::string>& packages,
                                    const std::filesystem::path& srdf) {
  ForeignRobotOptions options{.srdf = srdf};
  for (const std::string& words : packages) {
    const std::size_t sign = words.find('=');
    require(sign != std::string::npos && sign > 0 && sign + 1 < words.size(),
            {.field = "--package", .problem = "must be NAME=FOLDER", .value = words});
    options.packages[words.substr(0, sign)] = words.substr(sign + 1);
  }
  return options;
}

int run_convert(const ConvertCommand& command, Interrupts& interrupts) {
  const std::filesystem::path folder = std::filesystem::absolute(command.target).parent_path();
  require_writable(folder);
  ConvertOptions options{.unit = command.unit,
                         .foreign = foreign_options(command.packages, command.srdf)};
  std::vector<std::string> notes;
  const std::vector<RobotTextFile> files =
      converted(command.source, command.target, options, notes);
  for (const std::string& note : notes) std::cerr << "note: " << on_one_line(note) << "\n";
  std::string names;
  for (const RobotTextFile& file : files) {
    make_folder((folder / file.name).parent_path());
    interrupts.write(folder / file.name, file.content);
    names += (names.empty() ? "" : ", ") + file.name.string();
  }
  std::cout << "wrote " << folder.string() << ": " << names << "\n";
  return 0;
}

}  // namespace prehend
