// Broken, odd and huge mesh files: each gives a plan or one clear line, never a crash, a hang or a
// NaN.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"
#include "tests/support/shared_data.h"

namespace prehend::test {
namespace {

// Sizes in metres a unit where the file's own numbers are not metres.
std::string unit_of(const std::string& name) {
  return name == "wing_bad_ascii_stl.stl" || (name.ends_with(".iv") && !name.starts_with("vitalis"))
             ? "mm"
             : "m";
}

// JSON has no NaN: nlohmann writes null for it.
bool has_null_number(const nlohmann::json& grasp) {
  return grasp["epsilon"].is_null() || grasp["volume"].is_null() ||
         grasp["X_object_hand"].dump().find("null") != std::string::npos ||
         grasp["contacts"].dump().find("null") != std::string::npos;
}

// Without the lines that warn of the mesh, which stand before the refusal.
ProgramRun without_warnings(ProgramRun run) {
  while (run.err.starts_with("warning: ")) run.err.erase(0, run.err.find('\n') + 1);
  return run;
}

void plan_or_refuse(const std::filesystem::path& file) {
  SCOPED_TRACE(file.filename());
  const std::filesystem::path out = fresh_folder("corpus_out") / "out";
  const ProgramRun run = run_program("plan '" + file.string() + "' --unit " +
                                     unit_of(file.filename()) + " --out '" + out.string() + "'");
  if (run.status == 0) {
    const auto json = nlohmann::json::parse(content(out / "grasps.json"));
    for (const auto& grasp : json["grasps"]) EXPECT_FALSE(has_null_number(grasp));
    return;
  }
  expect_refused(without_warnings(run), "");
  if (!std::filesystem::exists(out)) return;
  // It was read, and no grasp could be tried: the file says so.
  const auto json = nlohmann::json::parse(content(out / "grasps.json"));
  EXPECT_NE(json["status"], "complete");
  EXPECT_TRUE(json["grasps"].empty());
}

class SlowMeshCorpus : public testing::TestWithParam<const char*> {};

TEST_P(SlowMeshCorpus, PlansOrRefuses) {
  const std::string folder = std::string("data/") + GetParam();
  PREHEND_NEEDS_SHARED(folder);
  for (const auto& entry : std::filesystem::directory_iterator(shared(folder))) {
    if (entry.is_regular_file()) plan_or_refuse(entry.path());
  }
}

INSTANTIATE_TEST_SUITE_P(Folders, SlowMeshCorpus,
                         testing::Values("nasty", "nasty/converted_obj", "parser"),
                         [](const auto& folder) {
                           std::string name = folder.param;
                           std::replace(name.begin(), name.end(), '/', '_');
                           return name;
                         });

}  // namespace
}  // namespace prehend::test
