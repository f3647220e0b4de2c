// Runs the program as a user would.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>

#include <gtest/gtest.h>

namespace prehend::test {

struct ProgramRun {
  int status = -1;  // exit status; -1 when a signal ended it
  std::string out;
  std::string err;
};

inline std::string content(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

// A fresh folder for one test.
inline std::filesystem::path fresh_folder(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

// `words` as typed in a shell; `program` stands before them.
inline ProgramRun run_program(const std::string& words,
                              const std::string& program = PREHEND_PROGRAM) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path folder =
      fresh_folder(std::string("run_") + test->test_suite_name() + "." + test->name());
  const std::string command = program + " " + words + " >'" + (folder / "out").string() + "' 2>'" +
                              (folder / "err").string() + "'";
  const int raw = std::system(command.c_str());
  return {WIFEXITED(raw) ? WEXITSTATUS(raw) : -1, content(folder / "out"), content(folder / "err")};
}

// One line, and nothing else anywhere.
inline void expect_ended(const ProgramRun& run, int status, const std::string& complaint) {
  EXPECT_EQ(run.status, status) << run.err;
  EXPECT_EQ(run.err.find("prehend: "), 0U) << run.err;
  EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err;
  EXPECT_NE(run.err.find(complaint), std::string::npos) << run.err;
}

// For the caller's mistake.
inline void expect_refused(const ProgramRun& run, const std::string& complaint) {
  expect_ended(run, 2, complaint);
}

}  // namespace prehend::test
