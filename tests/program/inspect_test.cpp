// What the program says of meshes that are not whole.
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/program/program.h"
#include "tests/support/colored_stick.h"

namespace prehend::test {
namespace {

// A cube of 40 mm from twelve triangles, without the first `missing` of them.
std::filesystem::path cube_without(const std::string& name, std::size_t missing) {
  const std::vector<std::string> faces = {"1 3 2", "1 4 3", "5 6 7", "5 7 8", "1 2 6", "1 6 5",
                                          "2 3 7", "2 7 6", "3 4 8", "3 8 7", "4 1 5", "4 5 8"};
  const std::filesystem::path file = fresh_folder(name) / "cube.obj";
  std::ofstream stream(file);
  for (const char* z : {"0", "0.04"}) {
    stream << "v 0 0 " << z << "\nv 0.04 0 " << z << "\nv 0.04 0.04 " << z << "\nv 0 0.04 " << z
           << "\n";
  }
  for (std::size_t f = missing; f < faces.size(); ++f) stream << "f " << faces[f] << "\n";
  return file;
}

std::string inspected(const std::filesystem::path& file) {
  const ProgramRun run = run_program("inspect " + file.string());
  EXPECT_EQ(run.status, 0) << run.err;
  return run.out;
}

TEST(Inspect, SaysWhatTheMassWasTakenToFill) {
  const std::string whole = inspected(cube_without("inspect_whole", 0));
  EXPECT_NE(whole.find("from the signed volume\n"), std::string::npos) << whole;
  const std::filesystem::path cube = cube_without("inspect_holed", 1);
  const std::string repaired = inspected(cube);
  EXPECT_NE(repaired.find("repaired: 1 hole closed"), std::string::npos) << repaired;
  EXPECT_NE(repaired.find("volume 0.0640 litres"), std::string::npos) << repaired;
  EXPECT_NE(repaired.find("from the signed volume\n"), std::string::npos) << repaired;
  const std::string holed = run_program("inspect " + cube.string() + " --no-repair").out;
  EXPECT_NE(holed.find("from the signed volume, holes closed\n"), std::string::npos) << holed;
  EXPECT_EQ(holed.find("encloses nothing"), std::string::npos) << holed;
  const std::string flat = inspected(cube_without("inspect_flat", 10));
  EXPECT_NE(flat.find("from the surface, the mesh encloses nothing\n"), std::string::npos) << flat;
}

TEST(Inspect, ListsTheColoursOfAFile) {
  const std::filesystem::path file = fresh_folder("inspect_colors") / "stick.ply";
  std::string ply = colored_stick(true);
  std::ofstream(file) << ply;
  const std::string said = inspected(file);
  EXPECT_NE(said.find("  colours #cc3311 53 %, #2266aa 47 %\n"), std::string::npos) << said;
  ply.replace(ply.find("204 51 17"), 9, "304 51 17");
  std::ofstream(file) << ply;
  const std::string refused = inspected(file);
  EXPECT_NE(refused.find("  colours cannot be read: line 25: red must be from 0 to 255, not 304\n"),
            std::string::npos)
      << refused;
}

// With --keep-out the colour is in grasps.json, which replay reads.
TEST(KeepOut, OfAColourIsAWordWithAHash) {
  const std::filesystem::path folder = fresh_folder("keep_out_color");
  std::ofstream(folder / "stick.ply") << colored_stick();
  const std::string out = (folder / "out").string();
  const ProgramRun plan = run_program("plan " + (folder / "stick.ply").string() +
                                      " --hand parallel_jaw --keep-out '#cc3311/0.1' --trials 60 "
                                      "--no-report --out " +
                                      out);
  EXPECT_EQ(plan.status, 0) << plan.err;
  const std::string grasps = content(folder / "out" / "grasps.json");
  EXPECT_NE(grasps.find("#cc3311"), std::string::npos);
  const ProgramRun evaluated = run_program("evaluate " + out + "/grasps.json --out " + out + "2");
  EXPECT_EQ(evaluated.status, 0) << evaluated.err;
}

TEST(Inspect, SaysWhereBodiesAreInTheirFrameAndInTheWorld) {
  const std::filesystem::path file = fresh_folder("inspect_bounds") / "scene.json";
  std::ofstream(file) << R"({"hand": "parallel_jaw",
    "object": {"geometry": [{"shape": "box", "size": [0.04, 0.05, 0.06]}],
               "pose": {"position": [0.1, 0.2, 0.03],
                        "quaternion_wxyz": [0.7071067811865476, 0, 0.7071067811865476, 0]}},
    "obstacles": [{"name": "table", "geometry": [{"shape": "box", "size": [1, 1, 0.1]}],
                   "pose": {"position": [0, 0, -0.05]}}]})";
  const std::string said = inspected(file);
  const auto says = [&](const std::string& words) {
    EXPECT_NE(said.find(words), std::string::npos) << said;
  };
  says("in its own frame from (-20.00, -25.00, -30.00) to (20.00, 25.00, 30.00) mm\n");
  // Its lowest point is 10 mm above the table.
  says("in the world from (70.00, 175.00, 10.00) to (130.00, 225.00, 50.00) mm\n");
  says("in the world from (-500.00, -500.00, -100.00) to (500.00, 500.00, 0.00) mm\n");
}

// The volumes of both parts together are more than there is room for.
TEST(Inspect, APartInsideAnotherIsNoHole) {
  const std::filesystem::path file = cube_without("inspect_inner", 0);
  std::ofstream stream(file, std::ios::app);
  for (const char* z : {"0.001", "0.039"}) {
    for (const char* xy : {"0.001 0.001 ", "0.039 0.001 ", "0.039 0.039 ", "0.001 0.039 "}) {
      stream << "v " << xy << z << "\n";
    }
  }
  stream
      << "f 9 12 11 10\nf 13 14 15 16\nf 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\nf 12 9 13 16\n";
  stream.close();
  const std::string inner = inspected(file);
  EXPECT_NE(inner.find("closed yes"), std::string::npos) << inner;
  EXPECT_NE(inner.find("from the convex hull, for holes or parts that overlap\n"),
            std::string::npos)
      << inner;
  EXPECT_EQ(inner.find("not closed"), std::string::npos) << inner;
}

// A scene of a bar of two boxes, the lower one 0 to 0.2 m along z, with these fields of the object.
std::filesystem::path bar_with(const std::string& name, const std::string& fields) {
  const std::filesystem::path file = fresh_folder(name) / "bar.json";
  std::ofstream(file) << R"({"object": {"name": "bar", "geometry": [
      {"shape": "box", "size": [0.02, 0.02, 0.2], "pose": [{"translate": [0, 0, 0.1]}]},
      {"shape": "box", "size": [0.02, 0.02, 0.1], "pose": [{"translate": [0, 0, 0.25]}]}])"
                      << fields << "}}";
  return file;
}

TEST(Inspect, SaysWhereTheMassIsAndWhoSaysSo) {
  const std::filesystem::path plain = bar_with("inspect_plain", "");
  const ProgramRun uniform = run_program("inspect " + plain.string());
  EXPECT_NE(uniform.err.find("warning: bar: 300 mm long and its mass is taken as uniform: state "
                             "center_of_mass or parts if it is heavier at one end\n"),
            std::string::npos)
      << uniform.err;
  EXPECT_NE(uniform.out.find("component 1: 0.0400 litres about (0.0, 0.0, 250.0) mm\n"),
            std::string::npos)
      << uniform.out;
  const std::filesystem::path saved = plain.parent_path() / "saved.json";
  const ProgramRun parts = run_program("inspect " +
                                       bar_with("inspect_parts", R"(, "density": 1000, "mass": 0.96,
          "parts": [{"name": "head", "component": 1, "density": 10000}])")
                                           .string() +
                                       " --save " + saved.string());
  const std::string told =
      "  mass 0.960 kg, centre of mass (0.0, 0.0, 225.0) mm, from the stated parts\n"
      "    head (component 1): 0.800 kg about (0.0, 0.0, 250.0) mm, 0.0400 litres of 20000 kg/m^3\n"
      "    all else: 0.160 kg about (0.0, 0.0, 100.0) mm, 0.0800 litres of 2000 kg/m^3\n"
      "    all of them times 2, for the stated mass\n";
  EXPECT_EQ(parts.err, "");
  EXPECT_NE(parts.out.find(told), std::string::npos) << parts.out;
  EXPECT_NE(inspected(saved).find(told), std::string::npos);
  const std::string stated =
      inspected(bar_with("inspect_center", R"(, "center_of_mass": [0, 0, 0.2])"));
  EXPECT_NE(stated.find("volume 0.1200 litres, from the signed volume\n"), std::string::npos);
  EXPECT_NE(stated.find("  mass 0.300 kg, centre of mass (0.0, 0.0, 200.0) mm, from the stated "
                        "centre of mass\n"),
            std::string::npos)
      << stated;
}

TEST(Inspect, RefusesPartsThatAreNotThereInOneLine) {
  const std::filesystem::path bar = bar_with("inspect_no_part", R"(, "density": 1000,
      "parts": [{"component": 2, "density": 1}])");
  const ProgramRun run = run_program("inspect " + bar.string());
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err,
            "prehend: " + bar.string() + ": object.parts[0].component: must be from 0 to 1 (2)\n");
}

TEST(Inspect, PrintsGainsAndSpringsOfARobot) {
  const std::string sprung = inspected(std::filesystem::path(PREHEND_SOURCE_DIR) / "tests" /
                                       "corpus" / "robot" / "good_sprung.json");
  EXPECT_NE(sprung.find(" spring 200 N/m about 0.07\n"), std::string::npos) << sprung;
  EXPECT_NE(sprung.find(" gains: stiffness 4000 N/m, damping 12.5 N s/m\n"), std::string::npos)
      << sprung;
  const std::string jaws = inspected(std::filesystem::path(PREHEND_SOURCE_DIR) / "tests" /
                                     "corpus" / "robot" / "good_jaws.json");
  EXPECT_EQ(jaws.find("spring"), std::string::npos) << jaws;
  EXPECT_EQ(jaws.find("gains"), std::string::npos) << jaws;
}

// The surface of a cube is its primitive.
TEST(Inspect, SaysHowFarTheSurfaceIsFromThePrimitives) {
  const std::filesystem::path cube = cube_without("inspect_distances", 0);
  const std::string out = inspected(cube);
  // 5 % of the diagonal, 40 sqrt(3) mm.
  EXPECT_NE(out.find("100.0 % of the surface: it is within 3.46 mm of them"), std::string::npos)
      << out;
  EXPECT_NE(out.find("distance of the surface from them: median "), std::string::npos) << out;
  const ProgramRun asked = run_program("inspect " + cube.string() + " --primitive-tolerance 1.5");
  EXPECT_NE(asked.out.find("it is within 1.5 mm of them"), std::string::npos) << asked.out;
  for (const char* refused : {"0", "-1", "70"}) {
    const ProgramRun run =
        run_program("inspect " + cube.string() + " --primitive-tolerance " + refused);
    EXPECT_EQ(run.status, 2) << run.out;
    EXPECT_NE(run.err.find("--primitive-tolerance: must be above 0 and at most the object's "
                           "diagonal, 69.28 mm"),
              std::string::npos)
        << run.err;
  }
}

TEST(Inspect, RefusesCoordinatesOutOfRange) {
  const std::filesystem::path folder = fresh_folder("inspect_range");
  const auto refused = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder / name) << text;
    const ProgramRun run = run_program("inspect " + (folder / name).string());
    EXPECT_EQ(run.status, 2) << run.out;
    return run.err;
  };
  EXPECT_NE(refused("far.obj", "v 0 0 0\nv 1e7 0 0\nv 0 1e7 0\nv 0 0 1e7\nf 1 2 3\nf 1 2 4\n")
                .find("is farther out than 1e6 m"),
            std::string::npos);
  const std::string start = R"({"object": {"geometry": [{"shape": "box", "size": [)";
  EXPECT_NE(refused("large.json", start + "1e29, 1, 1]}]}}")
                .find("size: each must be above 0 and at most 1e6"),
            std::string::npos);
  EXPECT_NE(refused("moved.json", start + R"(1, 1, 1]}], "pose": {"position": [0, 1e29, 0]}}})")
                .find("object.pose.position: each must be within 1e6 of 0"),
            std::string::npos);
}

TEST(Inspect, SaysWhatAHandCanDo) {
  const std::string out = run_program("inspect barrett").out;
  for (const char* words :
       {"  joint ", "  dof ", "  link ", "  hand  approaches along (0.000, 0.000, 1.000)",
        "  aperture 186 mm\n", "  self-collision in ", " of 1000 random postures\n",
        "  reach of distal_1: x "}) {
    EXPECT_NE(out.find(words), std::string::npos) << words << "\n" << out;
  }
  EXPECT_EQ(out.find("(derived)"), std::string::npos) << out;
  EXPECT_EQ(run_program("inspect barrett").out, out);
}

TEST(Inspect, DerivesTheHandOfARobotThatStatesNone) {
  const std::filesystem::path folder = fresh_folder("inspect_derived");
  const std::string urdf = (folder / "jaw.urdf").string();
  ASSERT_EQ(run_program("convert parallel_jaw " + urdf).status, 0);
  std::filesystem::remove(folder / "jaw.prehend.json");
  const ProgramRun run = run_program("inspect " + urdf);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("holds 0 to 80 mm, fingers meet at 40 mm (derived)"), std::string::npos)
      << run.out;
  const ProgramRun arm = run_program("inspect puma560");
  EXPECT_EQ(arm.out.find("aperture"), std::string::npos) << arm.out;
  EXPECT_NE(arm.out.find("  reach of "), std::string::npos) << arm.out;
}

TEST(Inspect, DrawsRobotsOnly) {
  const std::filesystem::path folder = fresh_folder("inspect_picture");
  const std::string picture = (folder / "puma560_barrett.png").string();
  const ProgramRun run = run_program("inspect puma560_barrett --picture " + picture);
  EXPECT_EQ(run.status, 0) << run.err;
  std::ifstream file(picture, std::ios::binary);
  std::string start(8, ' ');
  file.read(start.data(), 8);
  EXPECT_EQ(start, "\x89PNG\r\n\x1a\n");
  const std::string scene = (folder / "scene.png").string();
  const ProgramRun refused = run_program("inspect mug --picture " + scene);
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("--picture: only for robots"), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(scene));
}

}  // namespace
}  // namespace prehend::test
