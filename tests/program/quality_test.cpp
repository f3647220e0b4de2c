// `prehend quality`, on contacts of our own and on those of another simulator, converted.
#include <algorithm>
#include <optional>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"
#include "tests/support/shared_data.h"

namespace prehend::test {
namespace {

using nlohmann::json;

std::filesystem::path write(const std::string& name, const json& contacts) {
  const std::filesystem::path file = fresh_folder("quality_" + name) / "contacts.json";
  std::ofstream(file) << contacts;
  return file;
}

json answer(const std::filesystem::path& file, const std::string& words = "") {
  const ProgramRun run =
      run_program(std::string("quality ").append(file.string()) + " --no-report " + words);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  return json::parse(run.out);
}

json contact(std::vector<double> position, std::vector<double> normal, double friction) {
  return {{"position", position}, {"normal", normal}, {"friction", friction}};
}

// Six fingers on a ball of radius 0.1 m.
json six_fingers() {
  json contacts = json::array();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      std::vector<double> out(3, 0.0);
      std::vector<double> in(3, 0.0);
      out[axis] = 0.1 * sign;
      in[axis] = -sign;
      contacts.push_back(contact(out, in, 0.5));
    }
  }
  return {{"contacts", contacts}, {"torque_scale", 10.0}};
}

TEST(QualityCommand, AnswersWhatIsAsked) {
  json asked = six_fingers();
  asked["external"] = {{"force", {0.0, 0.0, -3.0}}};
  asked["task"] = {{"gravity", {{"direction", {0, 0, -1}}}}};
  const std::filesystem::path file = write("asked", asked);
  const json found = answer(file, "--cone exact --measures isotropy,task_resistance");
  EXPECT_TRUE(found.at("force_closure").get<bool>());
  EXPECT_GT(found.at("epsilon").at("lower"), 0.0);
  EXPECT_LE(found.at("epsilon").at("lower"), found.at("epsilon").at("upper"));
  EXPECT_EQ(found.at("epsilon").at("status"), "converged");
  EXPECT_GT(found.at("volume"), 0.0);
  EXPECT_TRUE(found.at("weakest_wrench").contains("torque"));
  EXPECT_TRUE(found.at("isotropy").contains("lower"));
  EXPECT_NEAR(found.at("task_resistance").at("lower").get<double>(), 1.0, 1e-6);
  const json& forces = found.at("forces");
  EXPECT_EQ(forces.at("outcome"), "balanced");
  EXPECT_NEAR(forces.at("sum_of_normals").get<double>(), 3.0, 1e-6);  // the finger below
  EXPECT_LT(forces.at("residual"), 1e-8);
}

TEST(QualityCommand, WritesASection) {
  const std::filesystem::path file = write("section", six_fingers());
  const std::filesystem::path out = file.parent_path() / "out";
  const std::filesystem::path mesh = out / "slice.ply";
  answer(file, std::string("--project force --out ").append(out.string()));
  EXPECT_FALSE(std::filesystem::exists(out / "report.html"));
  const ProgramRun inspected = run_program(std::string("inspect ").append(mesh.string()));
  EXPECT_EQ(inspected.status, 0) << inspected.err;
  EXPECT_NE(inspected.out.find("closed yes, oriented yes"), std::string::npos) << inspected.out;
}

TEST(QualityCommand, WritesAReportAndJsonAlone) {
  const std::filesystem::path file = write("report", six_fingers());
  const std::filesystem::path out = file.parent_path() / "out";
  const ProgramRun run = run_program(
      std::string("quality ").append(file.string()).append(" --out ").append(out.string()));
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(json::parse(run.out), answer(file));
  EXPECT_EQ(run.err, "wrote " + out.string() + ": report.html\n");
  EXPECT_EQ(content(out / "report.html").substr(0, 15), "<!DOCTYPE html>");
}

TEST(QualityCommand, NoContactsAreNoForceClosure) {
  const json found = answer(write("none", {{"contacts", json::array()}}));
  EXPECT_FALSE(found.at("force_closure").get<bool>());
  EXPECT_EQ(found.at("volume"), 0.0);
}

TEST(QualityCommand, RefusesMistakesInOneLine) {
  const std::string quality =
      std::string("quality ").append(write("mistakes", six_fingers()).string()) + " --no-report ";
  expect_refused(run_program("quality /no/such/file.json"), "/no/such/file.json");
  expect_refused(run_program(quality + "--cone pyramid:2"), "pyramid:2");
  expect_refused(run_program(quality + "--cone round"), "round");
  expect_refused(run_program(quality + "--space L2"), "L2");
  expect_refused(run_program(quality + "--measures beauty"), "beauty");
  expect_refused(run_program(quality + "--measures task_resistance"), "task");
  expect_refused(run_program(quality + "--project tx=0,ty=0"), "tx=0,ty=0");
  expect_refused(run_program(quality + "--project tx=0,ty=0,q=1"), "q=1");
  expect_refused(run_program(quality + "--project tx=9,ty=0,tz=0"), "empty");
}

// Nothing where a contact is of a model that these files define in their own way.
std::optional<json> converted(const json& reference) {
  const auto metres = [](const json& mm) {
    std::vector<double> vector;
    for (const json& value : mm) vector.push_back(1e-3 * value.get<double>());
    return vector;
  };
  json contacts = json::array();
  for (const json& c : reference.at("contacts")) {
    if (c.at("model") != "point_contact_with_friction") return std::nullopt;
    contacts.push_back(contact(metres(c.at("position_mm")), c.at("normal_in"), c.at("mu")));
  }
  return json{{"contacts", contacts},
              {"torque_origin", metres(reference.at("torque_origin_cog_mm"))},
              {"torque_scale", 1e3 / reference.at("max_radius_mm").get<double>()}};
}

TEST(QualityCommand, AgreesWithAnotherSimulator) {
  PREHEND_NEEDS_SHARED("reference/graspit");
  int compared = 0;
  for (const auto& entry : std::filesystem::directory_iterator(shared("reference/graspit"))) {
    if (entry.path().extension() != ".json") continue;
    const json reference = json::parse(std::ifstream(entry.path()));
    if (!reference.contains("gws")) continue;
    const std::optional<json> contacts = converted(reference);
    if (!contacts) continue;
    SCOPED_TRACE(entry.path().filename());
    const json found = answer(write(entry.path().stem(), *contacts));
    const json& expected = reference.at("gws").at("L1");
    EXPECT_EQ(found.at("force_closure"), expected.at("force_closure"));
    const double volume = expected.at("volume");
    EXPECT_NEAR(found.at("volume").get<double>(), volume, 2e-3 * volume);
    if (expected.at("force_closure").get<bool>()) {
      EXPECT_NEAR(found.at("epsilon").at("lower").get<double>(),
                  expected.at("epsilon").get<double>(), 1e-5);
    }
    ++compared;
  }
  EXPECT_GE(compared, 6);
}

}  // namespace
}  // namespace prehend::test
