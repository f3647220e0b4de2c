// What the program says to a caller's mistake: one line that names file, field and value, status 2,
// and nothing in --out.
#include <fstream>
#include <string>
#include <vector>

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

INSTANTIATE_TEST_SUITE_P(
    Corpus, BadInput,
    testing::Values(
        Mistake{"MissingFile", "plan FOLDER/none.obj --out FOLDER/out", "", "none.obj"},
        Mistake{"MissingScene", "plan teacup --out FOLDER/out", "", "teacup"},
        Mistake{"RankByShakeWithoutShake", "plan mug --rank shake --out FOLDER/out", "",
                "--rank: needs the tests of --shake (shake)"},
        Mistake{"RankBySuccessWithoutUncertainty", "plan mug --rank success --out FOLDER/out", "",
                "--rank: needs the trials of --uncertainty (success)"},
        Mistake{"ApproachWithoutUnit", "plan mug --approach down/30 --out FOLDER/out", "",
                "--approach: the angle must be 0deg to 180deg, or in rad: 30deg, 0.5rad (down/30)"},
        Mistake{"ApproachWithoutLength", "plan mug --accuracy FOLDER/in.json --out FOLDER/out",
                R"({"approach": {"direction": [0, 0, 0]}})",
                "approach.direction: must not be zero"},
        Mistake{"UnknownObject", "plan mug --object cup --out FOLDER/out", "",
                "object: the scene has no such object; it has mug (cup)"},
        Mistake{"KeepOutOfAPartWithoutName", "plan mug --keep-out handle --out FOLDER/out", "",
                "keep_out: the object has no parts with names; state a shape that it is inside "
                "(handle)"},
        Mistake{"KeepOutOfAColourOfNone", "plan mug --keep-out '#cc3311' --out FOLDER/out", "",
                "keep_out: the object has no colours of vertices, faces or materials; state a "
                "shape that it is inside (#cc3311)"},
        Mistake{"PreferNoColour", "plan mug --prefer '#cc331' --out FOLDER/out", "",
                "--prefer: must be a colour, such as \"#cc3311\": # and two hexadecimal digits "
                "each of red, green, blue (#cc331)"},
        Mistake{"PreferAColourTooFar", "plan mug --prefer '#cc3311/3' --out FOLDER/out", "",
                "--prefer: a colour's distance must be from 0 to 2, as in #cc3311/0.1 "
                "(#cc3311/3)"},
        Mistake{"PreferAFlatBox", "plan mug --prefer 0,0,0:1,0,1 --out FOLDER/out", "",
                "--prefer: a box is two corners in mm that differ in each coordinate, such as "
                "-10,-10,0:10,10,50 (0,0,0:1,0,1)"},
        Mistake{"AnyOfOneObject", "plan mug --any --out FOLDER/out", "",
                "mug: objects: missing; --any needs a scene file that lists its objects there"},
        Mistake{"AnyOfOneOfThem", "plan FOLDER/in.json --any --object a --out FOLDER/out", "{}",
                "--any: not together with --object"},
        Mistake{"PathPlannerWithoutPath",
                "plan mug_on_table --path-planner roadmap --out FOLDER/out", "",
                "--path-planner requires --path"},
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
        Mistake{"BudgetWithoutAUnit", "plan mug --budget 5 --out FOLDER/out", "",
                "with its unit, such as 500ms, 2s or 1.5min (5)"},
        Mistake{"SwitchWithANumber", "plan mug --uncertainty=3 --out FOLDER/out", "",
                "--uncertainty: is on where it stands and takes no value"},
        Mistake{"SwitchWithAWord", "plan mug --path=no --out FOLDER/out", "",
                "--path: is on where it stands and takes no value"},
        Mistake{"SwitchOfTwoNames", "plan mug --no-picture=false --out FOLDER/out", "",
                "--no-picture: is on where it stands and takes no value"},
        Mistake{"RankByShakingWithoutIt", "plan mug --rank shake --out FOLDER/out", "",
                "--rank: needs the tests of --shake"},
        Mistake{"MisspeltOption", "plan mug --no-reprot --out FOLDER/out", "",
                "--no-reprot: plan has no such option, did you mean --no-report?"},
        Mistake{"MisspeltCommand", "paln mug", "", "did you mean plan?"},
        Mistake{"MisspeltHand", "plan mug --hand barett --out FOLDER/out", "",
                "did you mean barrett?"},
        Mistake{"MisspeltScene", "plan living_rom --out FOLDER/out", "",
                "did you mean living_room?"},
        Mistake{"MisspeltField", "plan FOLDER/in.json --out FOLDER/out",
                R"({"object": {"mesh": "mug.obj", "unti": "m"}, "hand": "barrett"})",
                "; did you mean unit?"},
        Mistake{"BudgetOfAnUnknownUnit", "plan mug --budget 3weeks --out FOLDER/out", "",
                "--budget"},
        Mistake{"UnitOfAScene", "plan mug --unit mm --out FOLDER/out", "", "unit"},
        Mistake{"PrimitivesOfARobot", "inspect barrett --primitives FOLDER/a.png", "",
                "--primitives: only for meshes and scenes"},
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

// A protocol with some fields, and one phase that would be fine.
std::string procedure_with(const std::string& fields) {
  return R"({"name": "p", )" + fields +
         R"(, "tests": [{"name": "t", "phases": [{"kind": "hold", "duration": 1}]}]})";
}

// A robot of one joint, with fields of its link and of its joint.
std::string robot_with(const std::string& of_link, const std::string& of_joint) {
  return R"({"name": "lever", "units": {"length": "m", "angle": "rad", "angular_velocity": "rad/s"},
    "base": {"name": "foot", "material": "metal",
             "geometry": [{"shape": "box", "size": [0.1, 0.1, 0.1]}]},
    "chains": [{"name": "arm",
      "joints": [{"name": "hinge", "type": "revolute", "theta": 0, "d": 0, "a": 0, "alpha": 0,
                  "limits": [-1, 1])" +
         of_joint + R"(}],
      "links": [{"name": "rod", "joint": "hinge", "material": "metal",
                 "geometry": [{"shape": "box", "size": [0.1, 0.1, 0.1]}])" +
         of_link + R"(}]}],
    "dofs": [{"name": "turn", "drives": [{"joint": "hinge"}], "closing_velocity": 0}]})";
}

struct BadMotion {
  const char* name;
  std::string words;
  std::string file;
  const char* complaint;
};

// What would be moved: masses, inertias, efforts, and how grasps are shaken.
TEST(BadMotions, OneLineAndNothingWritten) {
  const std::string shake = "plan mug --shake FOLDER/in.json --out FOLDER/out";
  const std::string scene = "plan FOLDER/in.json --out FOLDER/out";
  const std::string robot = "inspect FOLDER/in.json";
  const std::string mass = R"(, "mass": 1, "center_of_mass": [0, 0, 0], "inertia": )";
  for (const BadMotion& bad : std::vector<BadMotion>{
           {"unknown field", shake, procedure_with(R"("wobble": 1)"), "wobble: unknown field"},
           {"step of 10 s", shake, procedure_with(R"("step": 10)"),
            "step: must be at least 1e-5 and at most 0.1"},
           {"step of 0 s", shake, procedure_with(R"("step": 0)"), "step: must be at least 1e-5"},
           {"no mass", shake, procedure_with(R"("object": {"mass": 0})"), "object.mass"},
           {"negative mass", shake, procedure_with(R"("object": {"mass": -1})"), "object.mass"},
           {"negative friction", shake, procedure_with(R"("friction": -1)"), "friction"},
           {"protocol without its support", "plan mug --shake simready --out FOLDER/out", "",
            "the scene has nothing that could bear mug"},
           {"unknown protocol", "plan mug --shake earthquake --out FOLDER/out", "", "earthquake"},
           {"scene's mass", scene, R"({"object": {"generate": "mug", "mass": -1}})", "object.mass"},
           {"scene's no mass", scene, R"({"object": {"generate": "mug", "mass": 0}})",
            "object.mass"},
           {"link's mass", robot, robot_with(R"(, "mass": -1)", ""), "mass: must be above 0"},
           {"link's no mass", robot, robot_with(R"(, "mass": 0)", ""), "mass: must be above 0"},
           {"inertia of no body", robot, robot_with(mass + "[[1, 0, 0], [0, 1, 0], [0, 0, 3]]", ""),
            "inertia"},
           {"negative inertia", robot, robot_with(mass + "[[-1, 0, 0], [0, 1, 0], [0, 0, 1]]", ""),
            "inertia"},
           {"negative effort", robot, robot_with("", R"(, "effort": -1)"), "effort"},
           {"negative joint friction", robot, robot_with("", R"(, "friction": {"viscous": -1})"),
            "friction.viscous"},
       }) {
    SCOPED_TRACE(bad.name);
    const std::filesystem::path folder = fresh_folder("bad_motion");
    std::ofstream(folder / "in.json") << bad.file;
    expect_refused(run_program(with_folder(bad.words, folder)), bad.complaint);
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  }
}

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

// As `| head -1` does: one who has read enough is no failure, and all files are written.
TEST(Program, EndsWellWhereNobodyReadsOn) {
  const std::filesystem::path folder = fresh_folder("read_in_part");
  const std::string words = "'" + std::string(PREHEND_PROGRAM) + " plan mug --trials 40 --out " +
                            (folder / "out").string() + " 2>" + (folder / "err").string() +
                            " | head -1 >" + (folder / "read").string() +
                            "; exit ${PIPESTATUS[0]}'";
  const int raw = std::system(("bash -c " + words).c_str());
  EXPECT_EQ(WEXITSTATUS(raw), 0);
  EXPECT_EQ(content(folder / "err"), "");
  EXPECT_EQ(content(folder / "read").rfind("rank ", 0), 0U);
  for (const char* file : {"grasps.json", "timings.json", "report.html", "best.png"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / "out" / file)) << file;
  }
}

}  // namespace
}  // namespace prehend::test
