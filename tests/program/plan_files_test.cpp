// Which files `plan` writes beside the grasps.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/program/program.h"

namespace prehend::test {
namespace {

struct PlanFiles {
  const char* words;
  std::vector<std::string> files;  // besides grasps.json and timings.json
};

TEST(PlanFiles, AreTheReportAndThePictureWhereWanted) {
  const std::vector<PlanFiles> cases = {
      {"", {"report.html", "best.png"}}, {"--picture", {"report.html", "best.png"}},
      {"--no-picture", {"report.html"}}, {"--no-report", {}},
      {"--no-report --no-picture", {}},  {"--no-report --picture", {"best.png"}}};
  std::string picture;
  for (const PlanFiles& one : cases) {
    SCOPED_TRACE(one.words);
    const std::filesystem::path out = fresh_folder("plan_files");
    const ProgramRun run =
        run_program("plan mug --trials 40 --top 1 --out '" + out.string() + "' " + one.words);
    EXPECT_EQ(run.status, 0) << run.err;
    const std::string timings = content(out / "timings.json");
    for (const auto& [file, stage] :
         {std::pair("report.html", "\"report\""), std::pair("best.png", "\"picture\"")}) {
      const bool wanted = std::count(one.files.begin(), one.files.end(), file) == 1;
      EXPECT_EQ(std::filesystem::exists(out / file), wanted) << file;
      EXPECT_EQ(run.out.find(file) != std::string::npos, wanted) << run.out;
      EXPECT_EQ(timings.find(stage) != std::string::npos, wanted) << timings;
    }
    // The same side is found with the report and without it.
    const std::string bytes = content(out / "best.png");
    if (picture.empty()) picture = bytes;
    EXPECT_TRUE(bytes.empty() || bytes == picture);
  }
  EXPECT_FALSE(picture.empty());
}

}  // namespace
}  // namespace prehend::test
