// The examples that end the help of each command, and the page of the manual.
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/program/program.h"

namespace prehend::test {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// Commands that a help lists, each at the start of a line of two blanks.
std::vector<std::string> commands_of(const std::string& help) {
  std::vector<std::string> commands;
  bool below = false;
  for (const std::string& line : lines_of(help)) {
    if (line.starts_with("Subcommands:")) below = true;
    if (line.starts_with("Examples:")) break;
    if (!below || line.size() < 3 || !line.starts_with("  ") || line[2] == ' ') continue;
    commands.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return commands;
}

// Each example begins with the command, and its options are among those that the help lists.
void expect_examples(const std::string& command, const std::string& help) {
  SCOPED_TRACE(command);
  const std::size_t start = help.find("Examples:\n");
  ASSERT_NE(start, std::string::npos) << help;
  const std::string above = help.substr(0, start);
  int count = 0;
  for (const std::string& line : lines_of(help.substr(start))) {
    if (!line.starts_with("  prehend ")) continue;
    ++count;
    EXPECT_TRUE(line.starts_with("  prehend " + command)) << line;
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      if (word.starts_with("-")) EXPECT_NE(above.find(word), std::string::npos) << line;
    }
  }
  EXPECT_GT(count, 0) << help;
}

TEST(Help, OfEveryCommandEndsWithExamples) {
  const std::vector<std::string> commands = commands_of(run_program("--help").out);
  EXPECT_GE(commands.size(), 13U);
  for (const std::string& command : commands) {
    const ProgramRun run = run_program(command + " --help");
    ASSERT_EQ(run.status, 0) << run.err;
    expect_examples(command == "batch" ? "batch " : command, run.out);
    for (const std::string& below : commands_of(run.out)) {
      const std::string both = command + " " + below;
      expect_examples(both, run_program(both + " --help").out);
    }
  }
}

TEST(Help, OfEveryCommandIsInThePageOfTheManual) {
  const std::string page = content(PREHEND_SOURCE_DIR "/planner/main/package/prehend.1");
  for (const std::string& command : commands_of(run_program("--help").out)) {
    EXPECT_NE(page.find("\n.B " + command + "\n"), std::string::npos) << command;
  }
}

}  // namespace
}  // namespace prehend::test
