// What the program says to a caller's mistake: one line that names file, field and value, status 2,
// and nothing in --out.
#include <fstream>

#include <gtest/gtest.h>

#include "tests/program/program.h"

namespace prehend::test {
namespace {

struct Mistake {
  const char* name;
  const char* words;  // FOLDER stands for the test's folder
  const char* file;   // content of FOLDER/in.json
  const char* complaint;
};

void PrintTo(const Mistake& mistake, std::ostream* stream) { *stream << mistake.name; }

class BadInput : public testing::TestWithParam<Mistake> {};

std::string with_folder(std::string words, const std::filesystem::path& folder) {
  const std::string mark = "FOLDER";
  for (std::size_t at = words.find(mark); at != std::string::npos; at = words.find(mark)) {
    words.replace(at, mark.size(), folder.string());
  }
  return words;
}

TEST_P(BadInput, OneLineAndNothingWritten) {
  const std::filesystem::path folder = fresh_folder(std::string("bad_") + GetParam().name);
  std::ofstream(folder / "in.json") << GetParam().file;
  const ProgramRun run = run_program(with_folder(GetParam().words, folder));
  expect_refused(run, GetParam().complaint);
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

const char* const kNoScene = R"({"grasps": []})";
const char* const kLargeBox =
    R"({"object": {"name": "crate", "geometry": [{"shape": "box", "size": [1, 1, 1]}]}})";

INSTANTIATE_TEST_SUITE_P(
    Corpus, BadInput,
    testing::Values(
        Mistake{"MissingFile", "plan FOLDER/none.obj --out FOLDER/out", "", "none.obj"},
        Mistake{"MissingScene", "plan teacup --out FOLDER/out", "", "teacup"},
        Mistake{"UnknownUnit", "plan FOLDER/in.json --unit yard --out FOLDER/out",
                R"({"object": {"mesh": "in.json", "unit": "yard"}})", "yard"},
        Mistake{"EmptyMesh", "plan FOLDER/in.json --out FOLDER/out",
                R"({"object": {"mesh": "in.json"}})", "in.json"},
        Mistake{"UnknownHand", "plan mug --hand tentacle --out FOLDER/out", "", "tentacle"},
        Mistake{"NegativeFriction", "plan FOLDER/in.json --out FOLDER/out",
                R"({"object": {"generate": "mug"},
                    "friction": [{"between": ["wood", "metal"], "static": -1}]})",
                "-1"},
        Mistake{"TooSmall", "plan FOLDER/in.json --out FOLDER/out",
                R"({"object": {"geometry": [{"shape": "box", "size": [1e-4, 1e-4, 1e-4]}]}})",
                "0.1 mm large"},
        Mistake{"TooLarge", "plan FOLDER/in.json --out FOLDER/out", kLargeBox, "crate"},
        Mistake{"ZeroTop", "plan mug --top 0 --out FOLDER/out", "", "--top"},
        Mistake{"NotANumber", "plan mug --threads many --out FOLDER/out", "", "--threads"},
        Mistake{"UnknownOption", "plan mug --colour red --out FOLDER/out", "", "--colour"},
        Mistake{"NoCommand", "", "", "subcommand"},
        Mistake{"UnknownCommand", "grasp mug", "", "unknown command, known are plan"},
        Mistake{"NegativeSeed", "plan mug --seed -1 --out FOLDER/out", "", "--seed"},
        Mistake{"SeedTooLarge", "plan mug --seed 18446744073709551616 --out FOLDER/out", "",
                "--seed"},
        Mistake{"LettersAfterANumber", "plan mug --top 3x --out FOLDER/out", "", "--top"},
        Mistake{"AccuracyThatDoesNotExist", "plan mug --accuracy coarse --out FOLDER/out", "",
                "coarse"},
        Mistake{"BudgetNotANumber", "plan mug --budget nan --out FOLDER/out", "", "--budget"},
        Mistake{"BudgetOfNothing", "plan mug --budget 0s --out FOLDER/out", "", "--budget"},
        Mistake{"BudgetOfAnUnknownUnit", "plan mug --budget 3weeks --out FOLDER/out", "",
                "--budget"},
        Mistake{"UnitOfAScene", "plan mug --unit mm --out FOLDER/out", "", "unit"},
        Mistake{"UnitOfARobot", "inspect barrett --unit mm", "", "--unit"},
        Mistake{"OutIsAFile", "plan mug --out FOLDER/in.json", "", "is not a folder"},
        Mistake{"OutInAFile", "plan mug --out FOLDER/in.json/out", "", "is not a folder"},
        Mistake{"SaveOverADevice", "inspect mug --save /dev/null", "", "is not a regular file"},
        Mistake{"Device", "evaluate /dev/zero --out FOLDER/out", "", "is not a regular file"},
        Mistake{"LongName", "plan FOLDER/in.json --out FOLDER/out",
                R"({"object": {"mesh": "in.json\nbroken"}})", "broken"},
        Mistake{"GraspsWithoutScene", "evaluate FOLDER/in.json --out FOLDER/out", kNoScene,
                "scene"},
        Mistake{"NoGrasps", "evaluate FOLDER/in.json --out FOLDER/out", R"({"scene": "mug"})",
                "grasps"},
        Mistake{"GraspWithoutPose", "evaluate FOLDER/in.json --out FOLDER/out",
                R"({"scene": "mug", "grasps": [{"preshape": "spread_0"}]})", "grasps[0]"},
        Mistake{"GraspWithoutPosture", "evaluate FOLDER/in.json --out FOLDER/out",
                R"({"scene": "mug", "grasps": [{"X_object_hand": {"position": [0, 0, 1]}}]})",
                "preshape"},
        Mistake{"UnknownPreshape", "evaluate FOLDER/in.json --out FOLDER/out",
                R"({"scene": "mug", "grasps": [{"X_object_hand": {}, "preshape": "fist"}]})",
                "fist"},
        Mistake{"DofsOutsideLimits", "evaluate FOLDER/in.json --out FOLDER/out",
                R"({"scene": "mug", "grasps": [{"X_object_hand": {}, "dofs": [0, 0, 0, 9]}]})",
                "limits"},
        Mistake{"NothingToDraw", "render FOLDER/in.json --out FOLDER/out",
                R"({"scene": "mug", "grasps": []})", "none to draw"},
        Mistake{"InspectNothing", "inspect FOLDER/none.stl", "", "none.stl"}),
    [](const auto& mistake) { return std::string(mistake.param.name); });

TEST(BadOutput, AFolderThatCannotBeMadeIsNamed) {
  const std::filesystem::path folder = fresh_folder("bad_out");
  std::ofstream(folder / "taken") << "a file";
  std::ofstream(folder / "in.json") << R"({"scene": "mug", "grasps": []})";
  const ProgramRun run = run_program("evaluate " + (folder / "in.json").string() + " --out " +
                                     (folder / "taken").string());
  expect_refused(run, "taken");
}

TEST(Program, SaysItsVersion) {
  const ProgramRun run = run_program("--version");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out.rfind("prehend ", 0), 0U) << run.out;
}

// What is printed goes to a device that is always full.
TEST(Program, SaysWhenItsOutputIsLost) {
  const std::filesystem::path folder = fresh_folder("lost_output");
  const std::string words = std::string(PREHEND_PROGRAM) + " inspect mug > /dev/full 2>'" +
                            (folder / "err").string() + "'";
  const int raw = std::system(words.c_str());
  EXPECT_EQ(WEXITSTATUS(raw), 1);
  EXPECT_EQ(content(folder / "err"), "prehend: the standard output cannot be written\n");
}

}  // namespace
}  // namespace prehend::test
