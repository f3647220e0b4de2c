// What a command writes is whole or not there, whatever happens to it: a system that refuses a
// call, a signal at one, limits of files, memory and descriptors, and other processes that write
// the same.
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "tests/program/faulty_runs.h"
#include "tests/program/running_program.h"

namespace prehend::test {
namespace {

namespace fs = std::filesystem;

WritingCommand command_named(const std::string& name) {
  const std::vector<WritingCommand> commands = writing_commands();
  return *std::ranges::find(commands, name, &WritingCommand::name);
}

class Faults : public testing::TestWithParam<WritingCommand> {
 protected:
  void SetUp() override {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the address sanitizer wants to be loaded before all other libraries";
#endif
    home_ = fresh_folder("faults_" + GetParam().name);
    write_fault_inputs(home_);
    const std::string batch = "batch HOME/batch.json -o HOME/done";
    const std::string merge = "batch merge HOME/batch.json --pictures 0 -o HOME/done --formats ";
    if (GetParam().name == "learn") {
      ASSERT_EQ(run(batch).status, 0);
      ASSERT_EQ(run(merge + "acronym").status, 0);
    }
    if (GetParam().name == "merge") {
      ASSERT_EQ(run(batch).status, 0);
      fs::copy(home_ / "done", home_ / "merged_before", fs::copy_options::recursive);
      ASSERT_EQ(run(merge + "csv").status, 0);
      done_ = home_ / "done";
    }
    out_ = home_ / "out";
    make_out(false);
    const ProgramRun whole = run(GetParam().words, under("none", 0));
    if (whole.err.find("libxgboost-dev") != std::string::npos) {
      GTEST_SKIP() << "built without xgboost";
    }
    ASSERT_EQ(whole.status, 0) << whole.err;
    calls_ = std::stoi(content(home_ / "report"));
    results_ = files_below(out_);
  }

  // Of the words, HOME and OUT are filled in.
  ProgramRun run(const std::string& words, const std::string& before = "") const {
    return run_program(filled(words), before + "'" + PREHEND_PROGRAM + "'");
  }
  std::string filled(const std::string& words) const {
    return replaced(replaced(words, "HOME", home_.string()), "OUT", out_.string());
  }

  // What stands before a program whose calls shall fail (tests/support/fail_calls.cpp).
  std::string under(const std::string& how, int call) {
    fs::remove(home_ / "report");
    return "FAIL_CALL=" + std::to_string(call) + " FAIL_HOW=" + how + " FAIL_REPORT='" +
           (home_ / "report").string() + "' LD_PRELOAD='" PREHEND_FAIL_CALLS "' ";
  }

  // The folder as it is before a run: with results of an earlier one, or without.
  void make_out(bool earlier) {
    fs::remove_all(out_);
    if (GetParam().name == "merge") {
      fs::copy(earlier ? done_ : home_ / "merged_before", out_, fs::copy_options::recursive);
    } else if (earlier && GetParam().name != "batch") {
      for (const auto& [name, bytes] : results_) {
        fs::create_directories((out_ / name).parent_path());
        std::ofstream(out_ / name) << "of an earlier run";
      }
    }
    before_ = found();
  }

  FileTree found() const { return fs::exists(out_) ? files_below(out_) : FileTree{}; }

  // Numbers of calls: all of them, or some where they are many.
  std::vector<int> chosen_calls(int most) {
    std::vector<int> numbers;
    const int step = std::max(1, calls_ / most);
    for (int first = 1; first <= calls_; first += step) {
      numbers.push_back(std::min(calls_, first + random_.integer(0, step - 1)));
    }
    return numbers;
  }

  void expect_whole_files() const {
    expect_whole(found(), results_, before_);
    if (GetParam().name == "merge") {
      const FileTree now = found();
      EXPECT_TRUE(now == results_ || now == before_) << "a mixture of two data sets";
    }
  }

  // Besides those that say what was written.
  static void expect_one_line(const ProgramRun& run) {
    std::istringstream lines(run.err);
    int count = 0;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("wrote ")) continue;
      EXPECT_TRUE(line.starts_with("prehend: ")) << run.err;
      ++count;
    }
    EXPECT_EQ(count, 1) << run.err;
  }

  // With its result, or with one line; a program that a signal ended has the status -1.
  void expect_ends_well(const ProgramRun& run, const std::set<int>& statuses) const {
    if (run.status == 0) {
      expect_same(found(), results_);
      return;
    }
    EXPECT_TRUE(statuses.contains(run.status)) << run.status << ": " << run.err;
    expect_one_line(run);
    expect_whole_files();
  }

  void run_three_at_once() const {
    std::istringstream stream(filled(GetParam().words));
    const std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
    std::vector<std::unique_ptr<RunningProgram>> programs;
    for (int i = 0; i < 3; ++i) {
      const fs::path own = home_ / ("process" + std::to_string(i));
      fs::create_directories(own);
      programs.push_back(std::make_unique<RunningProgram>(words, own));
    }
    for (const auto& program : programs) {
      std::string rest;
      EXPECT_EQ(program->wait(rest), 0) << rest;
    }
  }

  fs::path home_;
  fs::path out_;
  fs::path done_;
  FileTree results_;
  FileTree before_;
  int calls_ = 0;
  Random random_{27};
};

TEST_P(Faults, OfTheDiskEndInOneLine) {
  int number = 0;
  for (const int call : chosen_calls(6)) {
    const bool is_full = number % 2 == 0;
    make_out(number % 4 < 2);
    ++number;
    const ProgramRun failed = run(GetParam().words, under(is_full ? "full" : "broken", call));
    SCOPED_TRACE("call " + std::to_string(call) + " of " + std::to_string(calls_) + ": " +
                 content(home_ / "report"));
    expect_ends_well(failed, {1});
    // There are fewer calls where a folder is there already, and a copy may do for a link.
    if (failed.status == 0) continue;
    const char* reason = is_full ? "No space left on device" : "Input/output error";
    EXPECT_NE(failed.err.find(reason), std::string::npos) << failed.err;
  }
}

TEST_P(Faults, SignalsLeaveWholeFilesAndTheNextRunEndsWithTheSame) {
  const std::vector<std::pair<std::string, int>> signals = {
      {"kill", SIGKILL}, {"term", SIGTERM}, {"int", SIGINT}};
  int number = 0;
  for (const int call : chosen_calls(5)) {
    const auto& [name, signal] = signals[static_cast<std::size_t>(number) % 3];
    make_out(number % 2 == 0);
    ++number;
    SCOPED_TRACE(name + " at call " + std::to_string(call) + " of " + std::to_string(calls_));
    const ProgramRun ended = run(GetParam().words, under(name, call));
    if (signal == SIGKILL) {
      FileTree left = found();
      std::erase_if(left,
                    [](const auto& file) { return file.first.find(".part") != std::string::npos; });
      expect_whole(left, results_, before_);
      const bool is_killed = ended.status == -1 || ended.status == 128 + SIGKILL;
      EXPECT_EQ(is_killed, fs::exists(home_ / "report")) << ended.status;
    } else {
      expect_ends_well(ended, {128 + signal});
    }
    ASSERT_EQ(run(GetParam().words).status, 0);
    expect_same(found(), results_);
  }
}

TEST_P(Faults, OfFilesThatMayNotGrow) {
  for (const int blocks : {1, 4, 16}) {
    make_out(blocks == 4);
    const ProgramRun limited = run(GetParam().words, "ulimit -f " + std::to_string(blocks) + "; ");
    SCOPED_TRACE(blocks);
    // A longer text on the standard output does not arrive, either.
    const bool is_printed = limited.err.find("standard output") != std::string::npos;
    if (!is_printed) expect_ends_well(limited, {1});
    if (is_printed) expect_one_line(limited);
    if (is_printed) expect_whole_files();
    if (limited.status != 0 && !is_printed) {
      EXPECT_NE(limited.err.find("File too large"), std::string::npos) << limited.err;
    }
  }
}

TEST_P(Faults, OfFewDescriptors) {
  for (const int most : {3, 4, 6, 10}) {
    make_out(most % 2 == 0);
    const ProgramRun limited =
        run(GetParam().words, "prlimit --nofile=" + std::to_string(most) + " ");
    SCOPED_TRACE(most);
    // The system's loader has words of its own where it cannot open the program's libraries.
    if (limited.err.find("error while loading shared libraries") != std::string::npos) continue;
    expect_ends_well(limited, {1, 2});
  }
}

TEST_P(Faults, OfMemory) {
  for (const int megabytes : {20, 40, 60, 80}) {
    make_out(megabytes % 20 == 0);
    const ProgramRun limited =
        run(GetParam().words + " --memory-limit " + std::to_string(megabytes));
    SCOPED_TRACE(megabytes);
    if (limited.status == 0) continue;
    EXPECT_EQ(limited.status, 1) << limited.err;
    EXPECT_NE(limited.err.find("not enough memory"), std::string::npos) << limited.err;
    expect_whole_files();
  }
}

TEST_P(Faults, OfThreeProcessesAtOnceThereAreNone) {
  for (const bool earlier : {false, true}) {
    make_out(earlier);
    run_three_at_once();
    expect_same(found(), results_);
  }
}

INSTANTIATE_TEST_SUITE_P(Commands, Faults, testing::ValuesIn(writing_commands()),
                         [](const auto& command) { return command.param.name; });

// Where folders cannot be exchanged, as on file systems of networks.
class FaultsApart : public Faults {
 protected:
  void SetUp() override {
    Faults::SetUp();
    ::setenv("LD_PRELOAD", PREHEND_FAIL_CALLS, 1);
    ::setenv("FAIL_HOW", "apart", 1);
  }
  void TearDown() override {
    ::unsetenv("LD_PRELOAD");
    ::unsetenv("FAIL_HOW");
  }
};

TEST_P(FaultsApart, MergesReplaceEachOther) {
  make_out(true);
  ASSERT_EQ(run(GetParam().words).status, 0);
  expect_same(found(), results_);
  for (int i = 0; i < 3; ++i) {
    run_three_at_once();
    expect_same(found(), results_);
  }
}

INSTANTIATE_TEST_SUITE_P(Commands, FaultsApart, testing::Values(command_named("merge")));

}  // namespace
}  // namespace prehend::test
