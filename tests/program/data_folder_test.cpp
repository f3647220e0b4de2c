// Where the program finds the robots and scenes that come with it, wherever it was moved to.
#include <gtest/gtest.h>

#include "tests/program/program.h"

namespace prehend::test {
namespace {

namespace fs = std::filesystem;

const fs::path kBuilt = fs::path(PREHEND_PROGRAM).parent_path();
const std::string kPlain = "env -u PREHEND_DATA ";

// The program alone, in FOLDER/bin.
fs::path copied_program(const fs::path& folder) {
  fs::create_directories(folder / "bin");
  fs::copy_file(PREHEND_PROGRAM, folder / "bin" / "prehend");
  return folder / "bin" / "prehend";
}

void copy_data(const fs::path& to) {
  fs::create_directories(to);
  fs::copy(fs::path(PREHEND_SOURCE_DIR) / "robots", to / "robots", fs::copy_options::recursive);
  fs::copy(fs::path(PREHEND_SOURCE_DIR) / "benchmarks" / "scenes", to / "scenes",
           fs::copy_options::recursive);
}

void expect_finds_all(const std::string& program) {
  for (const char* name : {"parallel_jaw", "puma560_barrett", "mug"}) {
    const ProgramRun run = run_program("inspect " + std::string(name), program);
    EXPECT_EQ(run.status, 0) << name << ": " << run.err;
  }
}

TEST(DataFolder, IsFoundBesideAProgramThatWasInstalledElsewhere) {
  const fs::path folder = fresh_folder("data_installed");
  const fs::path program = copied_program(folder);
  copy_data(folder / "share" / "prehend");
  expect_finds_all(kPlain + program.string());
}

TEST(DataFolder, IsFoundThroughALinkToTheProgram) {
  const fs::path folder = fresh_folder("data_linked");
  const fs::path program = copied_program(folder / "package");
  copy_data(folder / "package" / "share" / "prehend");
  fs::create_symlink(program, folder / "prehend");
  expect_finds_all(kPlain + (folder / "prehend").string());
}

// argv[0] is no path then.
TEST(DataFolder, IsFoundForAProgramThatTheShellFound) {
  const fs::path folder = fresh_folder("data_path");
  copied_program(folder);
  copy_data(folder / "share" / "prehend");
  expect_finds_all("PATH=" + (folder / "bin").string() + ":$PATH " + kPlain + "prehend");
}

TEST(DataFolder, GoesWithABuildFolderThatIsMovedWithItsCheckout) {
  const fs::path folder = fresh_folder("data_moved");
  const fs::path source = PREHEND_SOURCE_DIR;
  const fs::path build = folder / fs::relative(kBuilt, source);
  fs::create_directories(build / "share" / "prehend");
  fs::copy_file(PREHEND_PROGRAM, build / "prehend");
  for (const char* data : {"robots", "scenes"}) {
    const fs::path link = kBuilt / "share" / "prehend" / data;
    EXPECT_TRUE(fs::read_symlink(link).is_relative()) << link;
    fs::copy_symlink(link, build / "share" / "prehend" / data);
  }
  fs::copy(source / "robots", folder / "robots", fs::copy_options::recursive);
  fs::create_directories(folder / "benchmarks");
  fs::copy(source / "benchmarks" / "scenes", folder / "benchmarks" / "scenes");
  expect_finds_all(kPlain + (build / "prehend").string());
}

// Changes a robot and a scene of the copy so that what is read tells where it came from.
void mark_the_copy(const fs::path& robots, const fs::path& scenes) {
  const fs::path robot = robots / "parallel_jaw" / "robot.json";
  std::string text = content(robot);
  text.replace(text.find("\"open\""), 6, "\"copied\"");
  std::ofstream(robot) << text;
  std::ofstream(scenes / "mug.json")
      << R"({"object": {"name": "copied", "geometry": [{"shape": "box", "size": [0.03, 0.03, 0.03]}]},)"
      << R"( "hand": "parallel_jaw"})";
}

void expect_reads_the_copy(const std::string& program, const fs::path& out) {
  const ProgramRun run = run_program(
      "plan mug --top 1 --trials 5 --no-report --out " + out.string(), kPlain + program);
  EXPECT_EQ(run.status, 0) << run.err;
  const std::string grasps = content(out / "grasps.json");
  EXPECT_NE(grasps.find("\"name\": \"copied\""), std::string::npos) << program;
  EXPECT_NE(grasps.find("\"preshape\": \"copied\""), std::string::npos) << program;
}

// The program still has the path of the checkout that it was built in, where the data are
// unchanged.
TEST(DataFolder, OfACopyOfTheCheckoutIsThatOfTheCopy) {
  const fs::path folder = fresh_folder("data_copied");
  const fs::path source = PREHEND_SOURCE_DIR;
  const fs::path copy = folder / "copy";
  const fs::path build = copy / fs::relative(kBuilt, source);
  fs::create_directories(build / "share" / "prehend");
  fs::copy_file(PREHEND_PROGRAM, build / "prehend");
  for (const char* data : {"robots", "scenes"}) {
    fs::copy_symlink(kBuilt / "share" / "prehend" / data, build / "share" / "prehend" / data);
  }
  fs::copy(source / "robots", copy / "robots", fs::copy_options::recursive);
  fs::create_directories(copy / "benchmarks");
  fs::copy(source / "benchmarks" / "scenes", copy / "benchmarks" / "scenes");
  mark_the_copy(copy / "robots", copy / "benchmarks" / "scenes");
  const fs::path out = folder / "out";
  expect_reads_the_copy((build / "prehend").string(), out);
  fs::create_symlink(build / "prehend", folder / "linked");
  expect_reads_the_copy((folder / "linked").string(), out);
  // From another working directory, by a relative path, and moved once more.
  fs::create_directories(folder / "elsewhere");
  const std::string relative = fs::relative(build / "prehend", folder / "elsewhere").string();
  const ProgramRun run = run_program(
      "inspect parallel_jaw", "cd " + (folder / "elsewhere").string() + " && " + kPlain + relative);
  EXPECT_NE(run.out.find("copied"), std::string::npos) << run.out << run.err;
  fs::rename(copy, folder / "moved");
  expect_reads_the_copy((folder / "moved" / fs::relative(kBuilt, source) / "prehend").string(),
                        out);
}

TEST(DataFolder, IsTheOneThatTheEnvironmentNames) {
  const fs::path folder = fresh_folder("data_named");
  const fs::path program = copied_program(folder);
  copy_data(folder / "elsewhere");
  expect_finds_all("PREHEND_DATA=" + (folder / "elsewhere").string() + " " + program.string());
}

TEST(DataFolder, ThatTheEnvironmentNamesWronglyIsRefused) {
  const fs::path folder = fresh_folder("data_misnamed");
  expect_refused(run_program("plan mug", "PREHEND_DATA=" + folder.string() + " " PREHEND_PROGRAM),
                 "PREHEND_DATA: no folder robots in it (" + folder.string() + ")");
}

TEST(DataFolder, ThatIsNowhereIsSaidInOneLine) {
  const fs::path folder = fresh_folder("data_nowhere");
  const fs::path program = copied_program(folder);
  expect_refused(run_program("plan mug", kPlain + program.string()),
                 "no such folder in or above " + (folder / "bin").string());
}

TEST(DataFolder, IsNotNeededForFilesOfOnesOwn) {
  const fs::path folder = fresh_folder("data_unneeded");
  const fs::path program = copied_program(folder);
  fs::copy(fs::path(PREHEND_SOURCE_DIR) / "robots" / "parallel_jaw", folder / "my_jaw");
  std::ofstream(folder / "scene.json")
      << R"({"object": {"geometry": [{"shape": "box", "size": [0.03, 0.03, 0.03]}]},)"
      << R"( "hand": "my_jaw/robot.json"})";
  const ProgramRun run = run_program("plan " + (folder / "scene.json").string() +
                                         " --no-report --top 1 --out " + (folder / "out").string(),
                                     kPlain + program.string());
  EXPECT_EQ(run.status, 0) << run.err;
}

}  // namespace
}  // namespace prehend::test
