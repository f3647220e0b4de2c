// ./run, with programs in place of CMake and Ninja that only note down how they were called.
#include <gtest/gtest.h>

#include "tests/program/program.h"

namespace prehend::test {
namespace {

namespace fs = std::filesystem;

void write_script(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "#!/bin/sh\n" << text << "\n";
  fs::permissions(file, fs::perms::owner_all);
}

// A checkout that was configured when it was at `configured_for`, with a program that is built.
fs::path checkout(const std::string& name, const fs::path& configured_for) {
  const fs::path folder = fresh_folder(name);
  fs::copy_file(fs::path(PREHEND_SOURCE_DIR) / "run", folder / "run");
  fs::create_directories(folder / ".ci");
  for (const char* list : {"packages", "packages-python"}) {
    std::ofstream(folder / ".ci" / list) << "# none\n";
  }
  std::ofstream(folder / "CMakePresets.json") << "{}\n";
  write_script(folder / "build" / "release" / "prehend", "echo planned");
  std::ofstream(folder / "build" / "release" / "CMakeCache.txt")
      << "CMAKE_HOME_DIRECTORY:INTERNAL=" << configured_for.string() << "\n";
  std::ofstream(folder / "build" / "release" / "build.ninja") << "\n";
  for (const std::string tool : {"cmake", "ninja"}) {
    write_script(folder / "tools" / tool,
                 "echo " + tool + " \"$@\" >> " + (folder / "calls").string() + "; exit 0");
  }
  return folder;
}

ProgramRun run_in(const fs::path& folder) {
  return run_program("plan",
                     "PATH=" + (folder / "tools").string() + ":$PATH " + (folder / "run").string());
}

TEST(RunScript, BuildsAnewInACheckoutThatWasMoved) {
  const fs::path folder = checkout("run_moved", "/somewhere/else");
  const ProgramRun run = run_in(folder);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "planned\n");
  EXPECT_NE(run.err.find("was configured in another place"), std::string::npos) << run.err;
  EXPECT_EQ(content(folder / "calls").find("cmake --fresh"), 0U) << content(folder / "calls");
}

TEST(RunScript, DoesNotConfigureAgainWhereNothingMoved) {
  const fs::path folder = checkout("run_unmoved", fs::path(testing::TempDir()) / "run_unmoved");
  const ProgramRun run = run_in(folder);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "planned\n");
  EXPECT_EQ(content(folder / "calls").find("ninja"), 0U) << content(folder / "calls");
}

// A copy beside the original, which is still there: its build folder names the original.
TEST(RunScript, BuildsAnewInACopyBesideTheOriginal) {
  const fs::path original = fs::path(testing::TempDir()) / "run_original";
  (void)checkout("run_original", original);
  const fs::path copy = checkout("run_copy", original);
  const ProgramRun run = run_in(copy);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(content(copy / "calls").find("cmake --fresh -S " + copy.string() + " "), 0U)
      << content(copy / "calls");
  EXPECT_NE(content(copy / "calls").find("ninja -C " + copy.string() + "/build/release prehend"),
            std::string::npos)
      << content(copy / "calls");
  EXPECT_FALSE(fs::exists(original / "calls"));
}

// The path of the checkout may have a link in it; it is the same checkout.
TEST(RunScript, KnowsItsCheckoutThroughALink) {
  const fs::path folder = checkout("run_linked", fs::path(testing::TempDir()) / "run_linked");
  const fs::path link = fresh_folder("run_links") / "checkout";
  fs::create_directory_symlink(folder, link);
  const ProgramRun run = run_program(
      "plan", "cd / && PATH=" + (folder / "tools").string() + ":$PATH " + (link / "run").string());
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "planned\n");
  EXPECT_EQ(content(folder / "calls").find("ninja"), 0U) << content(folder / "calls");
}

// The configuration of the other place knows no Python; CMake would refuse to change it here.
TEST(RunScript, BuildsThePythonModuleAnewInACheckoutThatWasMoved) {
  const fs::path folder = checkout("run_python", "/somewhere/else");
  const ProgramRun run =
      run_program("python -c 'print(1)'",
                  "PATH=" + (folder / "tools").string() + ":$PATH " + (folder / "run").string());
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "1\n");
  EXPECT_EQ(content(folder / "calls").find("cmake --fresh"), 0U) << content(folder / "calls");
}

// Of a list with a package that nobody has, beside one without any.
TEST(RunScript, TheDoctorSaysWhatIsMissingAndChangesNothing) {
  const fs::path folder = checkout("run_doctor", fs::path(testing::TempDir()) / "run_doctor");
  write_script(folder / "tools" / "dpkg-query", "echo 'ii bash'");
  std::ofstream(folder / ".ci" / "packages-python") << "bash\nno-such-package\n";
  const std::string run_it =
      "PATH=" + (folder / "tools").string() + ":$PATH " + (folder / "run").string();
  const ProgramRun run = run_program("doctor", run_it);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("to build and plan        ready\n"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("Python module            missing: no-such-package\n"), std::string::npos)
      << run.out;
  EXPECT_FALSE(fs::exists(folder / "calls"));
  std::ofstream(folder / ".ci" / "packages") << "no-such-compiler\n";
  const ProgramRun without = run_program("doctor", run_it);
  EXPECT_EQ(without.status, 1);
  EXPECT_NE(without.out.find("missing: no-such-compiler"), std::string::npos) << without.out;
  const ProgramRun elsewhere = run_program("doctor", "PREHEND_DATA=/nowhere " + run_it);
  EXPECT_NE(elsewhere.out.find("/nowhere has no folder robots"), std::string::npos)
      << elsewhere.out;
}

}  // namespace
}  // namespace prehend::test
