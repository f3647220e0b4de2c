// The suite as a program, at its smallest: that it runs and writes, not how fast.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>

#include <gtest/gtest.h>

#include "benchmarks/report/names.h"
#include "benchmarks/report/results_file.h"
#include "tests/support/well_formed.h"

namespace prehend::bench {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

// Its exit status; what it prints goes to `printed`.
int run_bench(const std::string& words, const fs::path& printed) {
  const std::string command =
      std::string("'") + PREHEND_BENCH + "' " + words + " > '" + printed.string() + "' 2>&1";
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Bench, MeasuresAllPartsAndWritesThem) {
  const fs::path folder = fs::path(testing::TempDir()) / "bench";
  const fs::path printed = fs::path(testing::TempDir()) / "printed";
  ASSERT_EQ(run_bench("--smoke --out '" + folder.string() + "'", printed), 0) << text_of(printed);

  const Results results = read_results(folder / "results.json");
  for (const char* part : kParts) {
    const bool found =
        std::any_of(results.entries.begin(), results.entries.end(),
                    [part](const Entry& entry) { return entry.part == std::string(part); });
    EXPECT_TRUE(found) << part;
  }
  for (const char* size : kSizes) EXPECT_FALSE(entries_of(results, kScaling, size).empty()) << size;

  const std::string page = text_of(folder / "results.md");
  int plots = 0;
  for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
    if (file.path().extension() != ".svg") continue;
    ++plots;
    EXPECT_TRUE(test::is_well_formed(text_of(file.path()))) << file.path();
    EXPECT_NE(page.find("](" + file.path().filename().string() + ")"), std::string::npos);
  }
  EXPECT_GE(plots, 8);

  // The page can be made again, and a file is no slower than itself.
  const std::string stored = "'" + (folder / "results.json").string() + "'";
  const fs::path again = fs::path(testing::TempDir()) / "again";
  EXPECT_EQ(run_bench("page " + stored + " --out '" + again.string() + "'", printed), 0);
  EXPECT_EQ(text_of(again / "results.md"), page);
  EXPECT_EQ(run_bench("compare " + stored + " " + stored, printed), 0) << text_of(printed);
  EXPECT_EQ(run_bench("compare " + stored + " " + stored + " --most 0.9", printed), 1);
  EXPECT_EQ(run_bench("nothing", printed), 2);
}

}  // namespace
}  // namespace prehend::bench
