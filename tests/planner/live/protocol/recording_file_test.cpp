// Recordings are made of whole lines, also where no more can be written.
#include "planner/live/protocol/recording_file.h"

#include <csignal>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <sys/resource.h>
#include <system_error>
#include <vector>

#include <gtest/gtest.h>

#include "planner/live/protocol/recording.h"
#include "sim/base/random.h"
#include "tests/support/refusal_of.h"

namespace prehend::test {
namespace {

std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Files of this process may not become larger meanwhile, as on a disk that is full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : before_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &limit_);
    const rlimit smaller{bytes, limit_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &smaller);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &limit_);
    std::signal(SIGXFSZ, before_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  void (*before_)(int);
  rlimit limit_{};
};

// What the system says against it; empty: nothing.
std::string failure_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::system_error& error) {
    return error.what();
  }
  return "";
}

TEST(RecordingFile, EndsWithAWholeLineHoweverMuchFits) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "full.jsonl";
  Random random(5);
  for (int round = 0; round < 30; ++round) {
    const std::size_t room = 100 + random.index(2000);
    RecordingFile recording(file);
    std::string written;
    std::string refusal;
    {
      const FullDisk full(room);
      while (true) {
        const std::string line =
            R"({"command":"state","id":")" + std::string(random.index(200), 'x') + R"("})";
        try {
          recording.add(line);
        } catch (const std::system_error& error) {
          refusal = error.what();
          break;
        }
        written += line + "\n";
      }
      EXPECT_EQ(content_of(file), written);
    }
    EXPECT_LE(written.size(), room);
    EXPECT_TRUE(refusal.starts_with(file.string() + ": ")) << refusal;
    // When there is room again nothing is added, for a line is missing.
    EXPECT_EQ(failure_of([&] { recording.add("{}"); }), refusal);
    EXPECT_EQ(content_of(file), written);
    EXPECT_NO_THROW((void)replay(written, "recording", {}));
  }
}

TEST(RecordingFile, ADeviceThatTakesNothingIsNamed) {
  RecordingFile recording("/dev/full");
  const std::string failure = failure_of([&] { recording.add("{}"); });
  EXPECT_TRUE(failure.starts_with("/dev/full: ")) << failure;
  EXPECT_NE(failure.find("No space left"), std::string::npos) << failure;
}

TEST(RecordingFile, WhatCannotBeMadeIsRefusedAtOnce) {
  EXPECT_EQ(refusal_of([] { const RecordingFile recording("/dev/null/r.jsonl"); }).file(),
            "/dev/null");
  EXPECT_EQ(refusal_of([] { const RecordingFile recording(testing::TempDir()); }).field(),
            "--record");
}

}  // namespace
}  // namespace prehend::test
