// The page of a report as a file: names in it stay text, it fetches nothing, and it is not too
// large.
#include "planner/show/report/report_html.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "planner/show/palette.h"
#include "planner/show/report/report_json.h"
#include "sim/quality/wrench_space.h"
#include "sim/shape/object_generator.h"
#include "tests/planner/show/report/page_data.h"
#include "tests/planner/show/report/unpack.h"
#include "tests/support/grasp_families.h"
#include "tests/support/held_cube.h"

namespace prehend {
namespace {

using test::data_of;
using test::held_cube;
using test::HeldCube;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

int count_of(const std::string& text, const std::string& word) {
  int count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++count;
  }
  return count;
}

// A report that says `name` wherever somebody's text can stand.
Report report_of(CompiledScene& scene, const Trial& trial, const std::string& name) {
  scene.scene.object.name = name;
  scene.scene.hand.name = name;
  for (Link& link : scene.scene.hand.links) {
    link.name = name;
    link.material = name;
  }
  for (StaticBody& body : scene.scene.obstacles) body.name = name;
  Report report;
  report.title = name;
  report.facts = {{"object", name}, {name, "value"}};
  report.scene = &scene;
  report.frame = scene.wrench_frame;
  report.unit_force = name;
  ReportGrasp grasp;
  grasp.outcome = name;
  grasp.origin = name;
  grasp.preshape = name;
  grasp.collision_of = name;
  for (const GraspContact& contact : trial.contacts) {
    grasp.contacts.push_back({contact.point, name, contact.gap});
  }
  grasp.motion = grasp_motion(scene, test::from_above(), trial, nullptr);
  for (TrajectorySegment& segment : grasp.motion->segments) segment.name = name;
  grasp.detail.emplace();
  grasp.detail->links = {{name, 0.5}};
  report.grasps = {grasp};
  report.outcomes = {{name, name, 1}};
  report.blockers = {{name, name, name, 1}};
  report.candidates = {{Vector3::Zero(), Vector3::UnitZ(), 0, name}};
  return report;
}

class Names : public testing::TestWithParam<const char*> {};

TEST_P(Names, StayText) {
  HeldCube held = held_cube({test::obstacle(make_box({0.1, 0.1, 0.1}), Vector3(1, 0, 0))});
  const std::string harmless =
      lower(report_html(report_of(held.scene, held.trial, "a harmless name")));
  const std::string name = GetParam();
  const Report report = report_of(held.scene, held.trial, name);
  const std::string html = report_html(report);
  for (const char* word : {"</script", "<script", "<!--", "<img", "<"}) {
    EXPECT_EQ(count_of(lower(html), word), count_of(harmless, word)) << word;
  }
  const nlohmann::json data = data_of(html);
  EXPECT_EQ(data["title"], name);
  EXPECT_EQ(data["facts"][0], nlohmann::json::array({"object", name}));
  EXPECT_EQ(data["facts"][1], nlohmann::json::array({name, "value"}));
  EXPECT_EQ(data["unit_force"], name);
  EXPECT_EQ(data["scene"]["object"]["name"], name);
  EXPECT_EQ(data["scene"]["obstacles"][0]["name"], name);
  EXPECT_EQ(data["scene"]["hand"]["links"][1]["name"], name);
  for (const char* field : {"outcome", "origin", "preshape", "blame"}) {
    EXPECT_EQ(data["grasps"][0][field], name) << field;
  }
  EXPECT_EQ(data["grasps"][0]["contacts"][0]["link"], name);
  EXPECT_EQ(data["grasps"][0]["detail"]["links"][0]["link"], name);
  EXPECT_EQ(data["grasps"][0]["motion"]["segments"][0]["name"], name);
  EXPECT_EQ(data["outcomes"][0]["meaning"], name);
  EXPECT_EQ(data["blockers"][0]["by"], name);
  EXPECT_EQ(data["candidates"]["blames"][0], name);
}

INSTANTIATE_TEST_SUITE_P(Nasty, Names,
                         testing::Values("<script>alert(1)</script>", "</script>",
                                         "</SCRIPT ><img src=x onerror=y>", "<!--<script>",
                                         "]]>-->", "\"'`${1}\\", "\\u003c/script>",
                                         "&lt;b&gt;&amp;", "line\nline\r\ttab\x01\x7F",
                                         "\xE2\x80\xA8\xE2\x80\xA9", "/*DATA*/",
                                         "\xF0\x9F\x98\x80 \xD7\x90 w\xC3\xBCrfel"));

TEST(ReportHtml, WhatIsNotUtf8IsReplaced) {
  HeldCube held = held_cube();
  const std::string replaced = "\xEF\xBF\xBD";
  const nlohmann::json data = data_of(report_of(held.scene, held.trial, "mug\xFF\xC3(\xE2\x80"));
  EXPECT_EQ(data["title"], "mug" + replaced + replaced + "(" + replaced);
  EXPECT_EQ(data["scene"]["hand"]["name"], data["title"]);
}

// An empty report is a page as well.
TEST(ReportHtml, OfNothing) {
  const nlohmann::json data = data_of(Report{});
  EXPECT_TRUE(data["scene"].is_null());
  EXPECT_TRUE(data["grasps"].empty());
  EXPECT_TRUE(data["candidates"]["rows"].empty());
}

std::string content(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

// What the page is made of: what all pages share, and its own.
std::vector<std::filesystem::path> page_parts() {
  const std::filesystem::path show = std::filesystem::path(PREHEND_SOURCE_DIR) / "planner/show";
  std::vector<std::filesystem::path> parts;
  for (const auto& folder : {show / "page", show / "report" / "page"}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string kind = entry.path().extension().string();
      if (kind == ".js" || kind == ".html" || kind == ".css") parts.push_back(entry.path());
    }
  }
  return parts;
}

// Whatever could make a browser ask for something: addresses must be of the page itself.
TEST(ReportHtml, ThePageFetchesNothing) {
  int parts = 0;
  for (const std::filesystem::path& part : page_parts()) {
    ++parts;
    const std::string text = content(part);
    for (const char* asks :
         {"http:", "https:", "ws:", "wss:", "src=", "srcset", "action=", "poster=", "fetch(",
          "import(", "import ", "XMLHttpRequest", "WebSocket", "EventSource", "sendBeacon",
          "importScripts", "new Worker", "serviceWorker", "url("}) {
      EXPECT_EQ(count_of(text, asks), 0) << part.filename() << ": " << asks;
    }
    EXPECT_EQ(count_of(text, "href="), count_of(text, "href=\"data:")) << part.filename();
  }
  EXPECT_GE(parts, 10);
  // Of the page as it is built, its elements: those of scripts end where their code begins.
  const std::string page(report_page());
  EXPECT_EQ(count_of(page, "<script"), 3);
  EXPECT_EQ(count_of(page, "<script>") + count_of(page, "<script type=\"application/json\""), 3);
  EXPECT_EQ(count_of(page, "<link"), 1);
  EXPECT_EQ(count_of(page, "<link rel=\"icon\" href=\"data:,\">"), 1);
  for (const char* element_of : {"<img", "<iframe", "<embed", "<audio", "<video"}) {
    EXPECT_EQ(count_of(page, element_of), 0) << element_of;
  }
}

// A part in [0, 1] of a colour, as a page writes it: two hexadecimal digits at `place`.
double part_of(const std::string& color, std::size_t place) {
  return std::stoi(color.substr(1 + 2 * place, 2), nullptr, 16) / 255.0;
}

void expect_color(const nlohmann::json& found, const Color& expected, const std::string& name) {
  const std::string color = found.get<std::string>();
  ASSERT_EQ(color.size(), 7U) << name;
  EXPECT_EQ(color[0], '#') << name;
  EXPECT_NEAR(part_of(color, 0), expected.red, 0.5 / 255.0 + 1e-12) << name;
  EXPECT_NEAR(part_of(color, 1), expected.green, 0.5 / 255.0 + 1e-12) << name;
  EXPECT_NEAR(part_of(color, 2), expected.blue, 0.5 / 255.0 + 1e-12) << name;
}

const std::vector<std::pair<std::string, Color>> kLooks = {
    {"object", palette::kObject},
    {"hard", palette::kHard},
    {"rubber", palette::kRubber},
    {"arm", palette::kArm},
    {"obstacle", palette::kObstacle},
    {"primitive", palette::kPrimitive},
    {"contact", palette::kContact},
    {"weakest", palette::kWeakest},
    {"pointed_at", palette::kPointedAt},
    {"center", palette::kCenterOfMass},
    {"wrench_space", palette::kWrenchSpace},
    {"epsilon_ball", palette::kEpsilonBall},
    {"force", palette::kForce},
    {"contribution", palette::kContribution}};

TEST(ReportJson, ColoursAndOpacitiesAreThoseOfPictures) {
  const nlohmann::json found = data_of(Report{})["palette"];
  for (const auto& [name, look] : kLooks) {
    ASSERT_TRUE(found.contains(name)) << name;
    expect_color(found[name]["color"], look, name);
    EXPECT_EQ(found[name]["opacity"], look.opacity) << name;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    expect_color(found["axes"][axis], palette::kAxes[axis], "axis");
  }
  for (const Outcome outcome : kAll<Outcome>) {
    const std::string name(name_of(outcome));
    ASSERT_TRUE(found["outcomes"].contains(name)) << name;
    expect_color(found["outcomes"][name], palette::of(outcome), name);
  }
  ASSERT_EQ(found["solids"].size(), palette::kTips.size());
  for (std::size_t k = 0; k < palette::kTips.size(); ++k) {
    expect_color(found["solids"][k]["color"], palette::of_solid(k), "solid");
    EXPECT_EQ(found["solids"][k]["opacity"], palette::of_solid(k).opacity);
  }
  EXPECT_EQ(found.size(), kLooks.size() + 3);
}

// The page takes them from there: it says no colour of the palette and no opacity itself.
TEST(ReportHtml, ThePageHasNoColoursOfItsOwn) {
  const nlohmann::json data = data_of(Report{})["palette"];
  std::string scripts;
  for (const std::filesystem::path& part : page_parts()) {
    const std::string text = lower(content(part));
    for (const auto& [name, look] : kLooks) {
      const std::string color = data[name]["color"];
      EXPECT_EQ(count_of(text, color), 0) << part.filename() << ": " << name;
    }
    for (const auto& list : {data["axes"], data["outcomes"]}) {
      for (const std::string color : list) {
        EXPECT_EQ(count_of(text, color), 0) << part.filename() << ": " << color;
      }
    }
    for (const char* number : {"0", "1", "."}) {
      EXPECT_EQ(count_of(text, std::string("opacity: ") + number), 0) << part.filename();
    }
    if (part.extension() == ".js") scripts += text;
  }
  for (const auto& [name, look] : kLooks) {
    EXPECT_GT(count_of(scripts, "palette." + name) + count_of(scripts, "looks." + name), 0) << name;
  }
}

TEST(ReportJson, MeshesAreThoseOfTheScene) {
  HeldCube held = held_cube({test::obstacle(make_box({0.1, 0.2, 0.3}), Vector3(1, 2, 3))});
  const nlohmann::json scene = data_of(report_of(held.scene, held.trial, "cube"))["scene"];
  const TriangleMesh object = test::unpacked(scene["object"]["mesh"]);
  EXPECT_EQ(object.triangles, held.scene.scene.object.mesh.triangles);
  EXPECT_FALSE(scene["object"]["mesh"].contains("simplified_from"));
  const nlohmann::json& obstacle = scene["obstacles"][0];
  EXPECT_EQ(test::pose_in(obstacle["X"]).translation(), Vector3(1, 2, 3));
  EXPECT_NEAR(bounds(test::unpacked(obstacle["mesh"])).diagonal(), std::sqrt(0.14), 1e-6);
}

// What a page has to draw, however fine the meshes are.
TEST(ReportJson, LargeMeshesAreSimplified) {
  HeldCube held = held_cube({test::obstacle(make_box({0.1, 0.2, 0.3}), Vector3(1, 2, 3))});
  const TriangleMesh fine = generate_object("mug", 300000);
  held.scene.scene.object.mesh = fine;
  held.scene.scene.hand.links[0].mesh = generate_object("mug", 70000);
  held.scene.scene.obstacles[0].mesh = generate_object("mug", 70000);
  const std::string html = report_html(report_of(held.scene, held.trial, "mug"));
  EXPECT_LT(html.size(), 6'000'000U);
  const nlohmann::json scene = data_of(html)["scene"];
  EXPECT_EQ(scene["object"]["mesh"]["simplified_from"], fine.triangles.size());
  for (const auto& [mesh, least] : {std::pair{scene["object"]["mesh"], 20000U},
                                    std::pair{scene["obstacles"][0]["mesh"], 20000U},
                                    std::pair{scene["hand"]["links"][0]["mesh"], 4000U}}) {
    const TriangleMesh drawn = test::unpacked(mesh);
    EXPECT_GT(drawn.triangles.size(), least);
    EXPECT_LE(drawn.triangles.size(), 3 * least);
    const Bounds all = bounds(drawn);
    EXPECT_LT((all.lower - bounds(fine).lower).norm(), 2e-3);
    EXPECT_LT((all.upper - bounds(fine).upper).norm(), 2e-3);
  }
}

// Sections keep their shape when they are a thousandth of the unit, or a million of it.
TEST(ReportJson, SectionsOfAnySizeKeepTheirShape) {
  for (const double size : {1.0, 1e-3, 1e-9, 1e7, 1e80, 1e-200}) {
    const WrenchFrame frame{Vector3::Zero(), 1.0};
    Report report;
    report.frame = frame;
    ReportGrasp grasp;
    grasp.detail.emplace();
    grasp.detail->sections = space_sections(test::octahedron_grasp(0.5), frame, {});
    grasp.detail->sections.torques.vertices *= size;
    report.grasps = {grasp};
    const nlohmann::json found = data_of(report)["grasps"][0]["detail"]["torques"]["vertices"];
    const Eigen::Matrix3Xd& vertices = report.grasps[0].detail->sections.torques.vertices;
    ASSERT_EQ(found.size(), static_cast<std::size_t>(vertices.size()));
    ASSERT_GT(found.size(), 10U);
    for (std::size_t i = 0; i < found.size(); ++i) {
      ASSERT_NEAR(found[i].get<double>(), vertices.data()[i], 1e-4 * size) << size;
    }
  }
}

}  // namespace
}  // namespace prehend
