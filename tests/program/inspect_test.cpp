// What the program says of meshes that are not whole.
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/program/program.h"

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
  const std::string holed = inspected(cube_without("inspect_holed", 1));
  EXPECT_NE(holed.find("from the signed volume, holes closed\n"), std::string::npos) << holed;
  EXPECT_EQ(holed.find("encloses nothing"), std::string::npos) << holed;
  const std::string flat = inspected(cube_without("inspect_flat", 10));
  EXPECT_NE(flat.find("from the surface, the mesh encloses nothing\n"), std::string::npos) << flat;
}

}  // namespace
}  // namespace prehend::test
