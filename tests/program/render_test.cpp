// Pictures of a grasp file: which ones, how large, and what is refused.
#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"

namespace prehend::test {
namespace {

using nlohmann::json;

// Two grasps of a cube, which the jaw comes down on; the second one slips.
json cube_grasps() {
  const json pose = {{"position", {0, 0, 0.06}}, {"quaternion_wxyz", {0, 1, 0, 0}}};
  const json contacts = {{{"link", "left_plate"},
                          {"position", {-0.02, 0, 0}},
                          {"normal", {1, 0, 0}},
                          {"friction", 0.8}},
                         {{"link", "right_plate"},
                          {"position", {0.02, 0, 0}},
                          {"normal", {-1, 0, 0}},
                          {"friction", 0.8}}};
  json held = {
      {"X_object_hand", pose},  {"preshape", "open"},
      {"joints", {0.02, 0.02}}, {"epsilon", 0.25},
      {"volume", 0.0125},       {"outcome", "stable"},
      {"contacts", contacts},   {"approach", {{"direction", {0, 0, -1}}, {"travel", 0.08}}}};
  json slips = held;
  slips["outcome"] = "not_force_closure";
  return {{"scene", "cube.json"}, {"hand", "parallel_jaw"}, {"grasps", {held, slips}}};
}

// A folder with the scene and the grasps.
std::filesystem::path written(const std::string& name, const json& grasps) {
  const std::filesystem::path folder = fresh_folder(name);
  std::ofstream(folder / "cube.json")
      << R"({"object": {"name": "cube", "geometry": [{"shape": "box", "size": [0.04, 0.04, 0.04]}]}})";
  std::ofstream(folder / "grasps.json") << grasps;
  return folder;
}

ProgramRun render(const std::filesystem::path& folder, const std::string& words,
                  const std::string& out = "out") {
  return run_program("render " + (folder / "grasps.json").string() + " --out " +
                     (folder / out).string() + " " + words);
}

// Names in a folder, sorted.
std::vector<std::string> names(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

// One of the sizes in a PNG's header: big-endian, after signature, length and type of the chunk.
int size_in(const std::string& png, std::size_t at) {
  int value = 0;
  for (std::size_t k = 0; k < 4; ++k)
    value = 256 * value + static_cast<unsigned char>(png.at(at + k));
  return value;
}
int width_of(const std::string& png) { return size_in(png, 16); }
int height_of(const std::string& png) { return size_in(png, 20); }

TEST(Render, WritesEachGraspTheSheetAndFramesTheSameTwice) {
  const std::filesystem::path folder = written("render_all", cube_grasps());
  const ProgramRun run = render(folder, "--frames 3");
  ASSERT_EQ(run.status, 0) << run.err;
  const std::vector<std::string> expected = {"approach_001_frame_01.png",
                                             "approach_001_frame_02.png",
                                             "approach_001_frame_03.png",
                                             "contact_sheet.png",
                                             "grasp_001.png",
                                             "grasp_002.png"};
  ASSERT_EQ(names(folder / "out"), expected);
  const std::string out = (folder / "out").string();
  EXPECT_EQ(run.out, "wrote " + out + "/grasp_001.png ... grasp_002.png\n" + "wrote " + out +
                         "/contact_sheet.png\n" + "wrote " + out +
                         "/approach_001_frame_01.png ... approach_001_frame_03.png\n");
  const std::string sheet = content(folder / "out" / "contact_sheet.png");
  EXPECT_EQ(width_of(sheet), 1000);
  EXPECT_GT(height_of(sheet), 400);
  EXPECT_LT(height_of(sheet), 520);
  EXPECT_EQ(width_of(content(folder / "out" / "approach_001_frame_01.png")), 800);
  ASSERT_EQ(render(folder, "--frames 3", "again").status, 0);
  for (const std::string& name : expected) {
    EXPECT_EQ(content(folder / "out" / name), content(folder / "again" / name)) << name;
  }
}

TEST(Render, OneGraspWithItsFramesAndNoneOfAnEarlierRun) {
  const std::filesystem::path folder = written("render_one", cube_grasps());
  const ProgramRun eight = render(folder, "--grasp 2");
  ASSERT_EQ(eight.status, 0) << eight.err;
  EXPECT_EQ(names(folder / "out").size(), 9U);
  EXPECT_TRUE(std::filesystem::exists(folder / "out" / "approach_002_frame_08.png"));
  ASSERT_EQ(render(folder, "--grasp 2 --frames 2").status, 0);
  EXPECT_EQ(names(folder / "out").size(), 3U);
  ASSERT_EQ(render(folder, "--grasp 2 --frames 0").status, 0);
  EXPECT_EQ(names(folder / "out"), std::vector<std::string>{"grasp_002.png"});
}

TEST(Render, AFileThatSaysLittleShowsWhatIsKnown) {
  json grasps = cube_grasps();
  json& first = grasps["grasps"][0];
  for (const char* key : {"epsilon", "volume", "outcome", "contacts", "approach"}) first.erase(key);
  const std::filesystem::path closing = written("render_closing", grasps);
  const ProgramRun closes = render(closing, "--grasp 1 --frames 2");
  ASSERT_EQ(closes.status, 0) << closes.err;
  EXPECT_TRUE(std::filesystem::exists(closing / "out" / "approach_001_frame_02.png"));

  first.erase("joints");
  const std::filesystem::path still = written("render_still", grasps);
  const ProgramRun stands = render(still, "--grasp 1");
  ASSERT_EQ(stands.status, 0) << stands.err;
  EXPECT_NE(stands.out.find("no frames: the file does not say"), std::string::npos) << stands.out;
  EXPECT_EQ(names(still / "out"), std::vector<std::string>{"grasp_001.png"});
}

// A grasp of the mug on the table by the library's robot, which comes there in two samples.
json arm_grasps() {
  const std::vector<std::string> joints = {"arm/waist",
                                           "arm/shoulder",
                                           "arm/elbow",
                                           "arm/forearm_roll",
                                           "arm/wrist_pitch",
                                           "arm/wrist_roll",
                                           "hand/finger_1_spread",
                                           "hand/finger_1_proximal",
                                           "hand/finger_1_distal",
                                           "hand/finger_2_spread",
                                           "hand/finger_2_proximal",
                                           "hand/finger_2_distal",
                                           "hand/thumb_proximal",
                                           "hand/thumb_distal"};
  std::vector<double> from(joints.size(), 0.0);
  std::vector<double> to(joints.size(), 0.1);
  const json path = {{"joints", joints},
                     {"times", {0.0, 1.0}},
                     {"positions", {from, to}},
                     {"velocities", {from, from}},
                     {"segments", {{{"name", "close"}, {"first", 0}, {"last", 1}}}}};
  const json pose = {{"position", {-0.15, 0, 0.05}},
                     {"quaternion_wxyz", {0.7071068, 0, 0.7071068, 0}}};
  return {{"scene", "mug_on_table"},
          {"grasps", {{{"X_object_hand", pose}, {"preshape", "spread_0"}, {"path", path}}}}};
}

TEST(Render, FramesOfAPathShowTheArmAsWell) {
  const std::filesystem::path folder = written("render_arm", arm_grasps());
  const ProgramRun run = render(folder, "--grasp 1 --frames 2");
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string frame = content(folder / "out" / "approach_001_frame_01.png");
  EXPECT_EQ(width_of(frame), 1600);
  EXPECT_EQ(height_of(frame), 640);
  EXPECT_NE(frame, content(folder / "out" / "approach_001_frame_02.png"));
}

// The grasp above with one field changed.
struct BadGrasp {
  const char* name;
  const char* pointer;  // in the first grasp
  const char* value;
  const char* complaint;
};

void PrintTo(const BadGrasp& bad, std::ostream* stream) { *stream << bad.name; }

class BadRender : public testing::TestWithParam<BadGrasp> {};

TEST_P(BadRender, OneLineAndNothingWritten) {
  json grasps = arm_grasps();
  grasps["grasps"][0][json::json_pointer(GetParam().pointer)] = json::parse(GetParam().value);
  const std::filesystem::path folder =
      written(std::string("bad_render_") + GetParam().name, grasps);
  expect_refused(render(folder, ""), GetParam().complaint);
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

INSTANTIATE_TEST_SUITE_P(
    Corpus, BadRender,
    testing::Values(
        BadGrasp{"OtherJoint", "/path/joints/1", R"("arm/hip")",
                 "grasps[0].path.joints[1]: this joint of puma560_barrett is arm/shoulder"},
        BadGrasp{"FewJoints", "/path/joints", R"(["arm/waist"])",
                 "grasps[0].path.joints: puma560_barrett has 14 joints, here are 1"},
        BadGrasp{"ShortRow", "/path/positions/1", "[0, 0]",
                 "grasps[0].path.positions[1]: must be a list of 14 numbers"},
        BadGrasp{"Degrees", "/path/positions/1/2", "90",
                 "grasps[0].path.positions[1][2]: arm/elbow is outside its limits (90)"},
        BadGrasp{"FewRows", "/path/velocities", "[]", "as many rows as there are times: 2, not 0"},
        BadGrasp{"TimeStands", "/path/times/1", "0", "times[1]: times must increase"},
        BadGrasp{"NoTimes", "/path/times", "[]", "path.times: must not be empty"},
        BadGrasp{"SegmentBeyond", "/path/segments/0/last", "2", "last: must be from 0 to 1"},
        BadGrasp{"SegmentMissing", "/path/segments", "[]", "must go on to the last sample: 1"},
        BadGrasp{"NoPath", "/path", "7", "grasps[0].path: must be an object"},
        BadGrasp{"FewArmDofs", "/arm_dofs", "[0, 0]", "grasps[0].arm_dofs: must be a list of"},
        BadGrasp{"BackwardsTravel", "/approach", R"({"travel": -0.1})",
                 "travel: must not be negative"},
        BadGrasp{"NoDirection", "/approach", R"({"direction": [0, 0, 0]})",
                 "direction: must not be zero"},
        BadGrasp{"JointsOfAnotherHand", "/joints", "[0.02, 0.02]", "joints: must be a list of 8"}),
    [](const auto& bad) { return std::string(bad.param.name); });

}  // namespace
}  // namespace prehend::test
