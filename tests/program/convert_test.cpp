// The program writes robots and meshes in other formats.
#include <fstream>

#include <gtest/gtest.h>

#include "tests/program/program.h"

namespace prehend::test {
namespace {

TEST(Convert, RobotsGoToUrdfAndBack) {
  const std::filesystem::path folder = fresh_folder("convert_robot");
  const ProgramRun to = run_program("convert barrett " + (folder / "barrett.urdf").string());
  EXPECT_EQ(to.status, 0) << to.err;
  EXPECT_EQ(to.err, "");
  EXPECT_NE(to.out.find("barrett.prehend.json, barrett.urdf"), std::string::npos) << to.out;
  const ProgramRun back = run_program("convert " + (folder / "barrett.urdf").string() + " " +
                                      (folder / "back.json").string());
  EXPECT_EQ(back.status, 0) << back.err;
  const ProgramRun seen = run_program("inspect " + (folder / "back.json").string());
  EXPECT_EQ(seen.status, 0) << seen.err;
  EXPECT_NE(seen.out.find("9 links, 8 joints, 4 degrees of freedom"), std::string::npos)
      << seen.out;
  // A hand that went there and back plans.
  const ProgramRun plan =
      run_program("plan mug --hand " + (folder / "back.json").string() +
                  " --trials 20 --no-report --out " + (folder / "out").string());
  EXPECT_EQ(plan.status, 0) << plan.err;
}

TEST(Convert, MeshesGoFromFormatToFormat) {
  const std::filesystem::path folder = fresh_folder("convert_mesh");
  std::ofstream(folder / "t.obj") << "v 0 0 0\nv 40 0 0\nv 0 40 0\nv 0 0 40\n"
                                     "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  std::string before = (folder / "t.obj").string() + " ";
  std::string unit = " --unit mm";
  for (const char* name : {"t.stl", "t.ply", "t.off", "u.obj"}) {
    const std::string after = (folder / name).string();
    const ProgramRun run = run_program("convert " + before + after + unit);
    EXPECT_EQ(run.status, 0) << run.err;
    before = after + " ";
    unit = "";
  }
  const ProgramRun seen = run_program("inspect " + before);
  EXPECT_NE(seen.out.find("size 40.00 x 40.00 x 40.00 mm"), std::string::npos) << seen.out;
  EXPECT_NE(seen.out.find("triangles 4, vertices 4, components 1"), std::string::npos) << seen.out;
}

TEST(Convert, MistakesAreNamedAndNothingIsWritten) {
  const std::filesystem::path folder = fresh_folder("convert_bad");
  const std::string target = (folder / "made.urdf").string();
  expect_refused(run_program("convert barett " + target), "neither a file nor one of");
  expect_refused(run_program("convert barrett " + (folder / "made.sdf").string()),
                 "unknown format to write");
  expect_refused(run_program("convert barrett " + target + " --package there"),
                 "--package: must be NAME=FOLDER (there)");
  std::ofstream(target) << "<robot name=\"a\">\n<joint/>\n</robot>";
  expect_refused(run_program("convert " + target + " " + target),
                 "is the file that would be converted");
  expect_refused(run_program("convert " + target + " " + (folder / "made.json").string()),
                 "made.urdf: line 2, <joint>: attribute name is missing");
  EXPECT_FALSE(std::filesystem::exists(folder / "made.json"));
}

// What the reader assumed goes to stderr, what was asked for to stdout.
TEST(Convert, NotesAreForPeople) {
  const std::filesystem::path folder = fresh_folder("convert_notes");
  std::ofstream(folder / "a.urdf")
      << "<robot name=\"a\"><link name=\"base\"/><link name=\"tip\"><collision><geometry><box "
         "size=\"1 1 1\"/></geometry></collision></link><joint name=\"j\" type=\"continuous\">"
         "<parent link=\"base\"/><child link=\"tip\"/></joint></robot>";
  const ProgramRun run = run_program("inspect " + (folder / "a.urdf").string());
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.err.find("note: a: joints without limits"), std::string::npos) << run.err;
  EXPECT_EQ(run.out.find("note:"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace prehend::test
