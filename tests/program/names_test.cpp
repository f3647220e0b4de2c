// Files whose names are not text in UTF-8, which JSON cannot say.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"

namespace prehend::test {
namespace {

using nlohmann::json;

const std::string kReplaced = "\xEF\xBF\xBD";  // U+FFFD

// A cube of 40 mm in a file of that name, in the folder.
std::filesystem::path write_cube(const std::filesystem::path& folder, const std::string& name) {
  std::ofstream file(folder / name);
  for (int i = 0; i < 8; ++i) {
    file << "v " << 0.04 * (i & 1) << ' ' << 0.02 * (i & 2) << ' ' << 0.01 * (i & 4) << '\n';
  }
  file << "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
  return folder / name;
}

std::string quoted(const std::filesystem::path& file) {
  return std::string("'").append(file.string()).append("'");
}

ProgramRun plan_cube(const std::filesystem::path& mesh, const std::filesystem::path& out) {
  return run_program("plan " + quoted(mesh) + " --hand parallel_jaw --top 1 --out " + quoted(out) +
                     " --export csv,isaac,moveit,gltf,mjcf");
}

TEST(NotUtf8, AMeshFileIsPlannedForAndNamedAsWellAsJsonCan) {
  const std::filesystem::path folder = fresh_folder("not_utf8");
  const std::filesystem::path out = folder / "out";
  const ProgramRun run = plan_cube(write_cube(folder, "cube\xFF.obj"), out);
  ASSERT_EQ(run.status, 0) << run.err;
  const json grasps = json::parse(content(out / "grasps.json"));
  EXPECT_EQ(grasps["object"]["name"], "cube" + kReplaced);
  EXPECT_EQ(grasps["scene"]["file"], (folder / ("cube" + kReplaced + ".obj")).string());
  EXPECT_EQ(grasps["grasps"].size(), 1U);
  EXPECT_NE(content(out / "report.html").find("\"title\":\"cube" + kReplaced), std::string::npos);
}

TEST(NotUtf8, GraspsOfSuchAFileAreEvaluatedWhereItIsNamedAgain) {
  const std::filesystem::path folder = fresh_folder("not_utf8_evaluated");
  const std::filesystem::path mesh = write_cube(folder, "cube\xFF.obj");
  ASSERT_EQ(plan_cube(mesh, folder / "out").status, 0);
  const std::string evaluate =
      "evaluate " + quoted(folder / "out" / "grasps.json") + " --out " + quoted(folder / "again");
  expect_refused(run_program(evaluate), "no such file");
  const ProgramRun run = run_program(evaluate + " --scene " + quoted(mesh));
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(json::parse(content(folder / "again" / "grasps.json"))["outcomes"]["stable"], 1);
}

TEST(NotUtf8, OtherLettersAreKeptAndFoundAgain) {
  const std::filesystem::path folder = fresh_folder("utf8");
  const std::filesystem::path mesh = write_cube(folder, "w\xC3\xBCrfel \xE2\x88\x9B.obj");
  ASSERT_EQ(plan_cube(mesh, folder / "out").status, 0);
  const json grasps = json::parse(content(folder / "out" / "grasps.json"));
  EXPECT_EQ(grasps["object"]["name"], mesh.stem().string());
  EXPECT_EQ(grasps["scene"]["file"], mesh.string());
  const ProgramRun run = run_program("evaluate " + quoted(folder / "out" / "grasps.json") +
                                     " --out " + quoted(folder / "again"));
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(json::parse(content(folder / "again" / "grasps.json"))["outcomes"]["stable"], 1);
}

// A saved scene cannot name the file, so it holds the mesh itself.
TEST(NotUtf8, ASavedSceneDoesWithoutTheFile) {
  const std::filesystem::path folder = fresh_folder("not_utf8_saved");
  const std::filesystem::path mesh = write_cube(folder, "cube\xFF.obj");
  const std::filesystem::path saved = folder / "saved.json";
  // Only scenes are saved: this one is beside the mesh, in a folder that has no name in UTF-8.
  const std::filesystem::path inside = folder / "in\xFF";
  std::filesystem::create_directories(inside);
  std::filesystem::rename(mesh, inside / "cube.obj");
  std::ofstream(inside / "scene.json")
      << R"({"object": {"name": "cube", "mesh": "cube.obj"}, "hand": "parallel_jaw"})";
  const ProgramRun run =
      run_program("inspect " + quoted(inside / "scene.json") + " --save " + quoted(saved));
  ASSERT_EQ(run.status, 0) << run.err;
  std::filesystem::remove_all(inside);
  const ProgramRun again = run_program("inspect " + quoted(saved));
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_NE(again.out.find("cube"), std::string::npos) << again.out;
  const json scene = json::parse(content(saved));
  EXPECT_FALSE(scene["object"].contains("mesh"));
  EXPECT_EQ(scene["object"]["geometry"][0]["vertices"].size(), 8U);
}

}  // namespace
}  // namespace prehend::test
