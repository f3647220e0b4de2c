#include "benchmarks/report/results_file.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/base/output_file.h"
#include "tests/support/sample_results.h"

namespace prehend::bench {
namespace {

std::filesystem::path results_written(const std::string& text) {
  const auto file = std::filesystem::path(testing::TempDir()) / "results.json";
  write_file(file, text);
  return file;
}

std::string why_not_read(const std::string& text) {
  try {
    (void)read_results(results_written(text));
  } catch (const InputError& error) {
    return error.field() + ": " + error.problem();
  }
  return "read";
}

// The text with `from`, which must be there, replaced once.
std::string exchanged(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(ResultsFile, ReadsBackTheSame) {
  const Results results = test::sample_results();
  const std::string text = results_json(results);
  const Results again = read_results(results_written(text));
  EXPECT_EQ(results_json(again), text);
  ASSERT_EQ(again.entries.size(), results.entries.size());
  EXPECT_EQ(again.machine.processor, results.machine.processor);
  for (std::size_t i = 0; i < results.entries.size(); ++i) {
    EXPECT_EQ(name_of(again.entries[i]), name_of(results.entries[i]));
    EXPECT_EQ(again.entries[i].value.p99, results.entries[i].value.p99);
  }
}

TEST(ResultsFile, SaysWhatIsWrong) {
  const std::string text = results_json(test::sample_results());
  EXPECT_EQ(why_not_read(text), "read");
  EXPECT_NE(why_not_read(exchanged(text, "\"format\": 1", "\"format\": 99")).find("format"),
            std::string::npos);
  EXPECT_NE(why_not_read(exchanged(text, "\"median\"", "\"middle\"")).find("entries[0]"),
            std::string::npos);
  EXPECT_NE(why_not_read(exchanged(text, "\"samples\": 3", "\"samples\": 0")).find("samples"),
            std::string::npos);
  EXPECT_NE(why_not_read(text.substr(0, text.size() / 2)), "read");
}

TEST(ResultsFile, RefusesTwoEntriesOfOneName) {
  Results results = test::sample_results();
  results.entries.push_back(results.entries.front());
  EXPECT_NE(why_not_read(results_json(results)).find("twice the entry kernels/call/inside test"),
            std::string::npos);
}

}  // namespace
}  // namespace prehend::bench
