#include "planner/bulk/cluster/run_words.h"

#include <csignal>
#include <fstream>
#include <sys/wait.h>

#include <gtest/gtest.h>

#include "planner/bulk/cluster/process_mark.h"
#include "sim/base/input_error.h"

namespace prehend::test {
namespace {

TEST(RunWords, GivesWordsAsTheyAreAndReadsBothStreams) {
  const Finished finished =
      run_words({"sh", "-c", "printf '%s|' \"$@\"; echo bad >&2; exit 3", "sh", "a b", "$c", ""});
  EXPECT_EQ(finished.status, 3);
  EXPECT_EQ(finished.out, "a b|$c||");
  EXPECT_EQ(finished.err, "bad\n");
}

// More than a pipe holds, on both at once.
TEST(RunWords, ReadsMuch) {
  const Finished finished = run_words({"sh", "-c", "seq 100000; seq 100000 >&2"});
  EXPECT_EQ(finished.out, finished.err);
  EXPECT_TRUE(finished.out.ends_with("\n100000\n"));
}

TEST(RunWords, SaysOfASignalThatThereIsNoStatus) {
  EXPECT_EQ(run_words({"sh", "-c", "kill -KILL $$"}).status, -1);
}

// The program holds signals back and ignores those of closed pipes; what it starts must not.
TEST(RunWords, StartsWithSignalsAsUsual) {
  sigset_t held{};
  sigset_t before{};
  sigemptyset(&held);
  sigaddset(&held, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &held, &before);
  const int status = run_words({"sh", "-c", "kill -TERM $$; exit 0"}).status;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  EXPECT_EQ(status, -1);
}

TEST(RunWords, NamesAProgramThatIsNotThere) {
  try {
    run_words({"no-such-program-at-all"});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), "no-such-program-at-all: is not installed here");
  }
}

TEST(PrintedBy, SaysTheFirstLineOfAProgramThatRefuses) {
  EXPECT_EQ(printed_by({"echo", "a"}), "a\n");
  try {
    printed_by({"sh", "-c", "echo first >&2; echo second >&2; exit 1"});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), "sh: first");
  }
}

TEST(ProcessMark, KnowsAProcessFromALaterOneOfItsNumber) {
  const std::string log = testing::TempDir() + "run_words_log";
  const pid_t pid = start_detached({"sleep", "600"}, log);
  const std::optional<ProcessMark> mark = mark_of(pid);
  ASSERT_TRUE(mark.has_value());
  EXPECT_EQ(state_of(*mark), ProcessState::running);
  ProcessMark other = *mark;
  ++other.started;
  EXPECT_EQ(state_of(other), ProcessState::gone);
  other = *mark;
  other.boot = "another";
  EXPECT_EQ(state_of(other), ProcessState::gone);
  other = *mark;
  other.host += "x";
  EXPECT_EQ(state_of(other), ProcessState::elsewhere);
  EXPECT_EQ(::getpgid(pid), pid);
  ::kill(pid, SIGKILL);
  ::waitpid(pid, nullptr, 0);
  EXPECT_EQ(state_of(*mark), ProcessState::gone);
}

}  // namespace
}  // namespace prehend::test
