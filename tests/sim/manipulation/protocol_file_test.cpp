#include "sim/manipulation/protocol_file.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

std::string with_phase(const std::string& phase) {
  return R"({"name": "p", "tests": [{"name": "t", "phases": [)" + phase + "]}]}";
}

std::string refusal(const std::string& text) {
  return test::refusal_of([&] { (void)parse_protocol(text, "p.json"); }).what();
}

TEST(ProtocolFile, EveryProtocolOfTheLibraryIsRead) {
  const std::vector<std::string> names = library_protocol_names();
  EXPECT_EQ(names.size(), 6U);
  for (const std::string& name : names) {
    const Protocol protocol = read_protocol(find_protocol(name));
    EXPECT_EQ(protocol.name, name);
    EXPECT_FALSE(protocol.source.empty()) << name;
    EXPECT_FALSE(protocol.tests.empty()) << name;
  }
}

TEST(ProtocolFile, PublishedNumbersOfDexGraspBench) {
  const Protocol protocol = read_protocol(find_protocol("dexgraspbench"));
  EXPECT_EQ(protocol.object.mass, 0.1);
  EXPECT_EQ(protocol.friction, 0.6);
  EXPECT_EQ(protocol.torsion, 0.02);
  ASSERT_EQ(protocol.tests.size(), 6U);
  Vector3 sum = Vector3::Zero();
  for (const ProtocolTest& test : protocol.tests) {
    ASSERT_EQ(test.phases.size(), 1U);
    EXPECT_EQ(test.phases[0].pull.norm(), 10.0);
    EXPECT_EQ(test.phases[0].duration, 2.0);
    EXPECT_EQ(test.phases[0].fails.moved, 0.05);
    EXPECT_NEAR(test.phases[0].fails.turned, 15.0 * std::acos(-1.0) / 180.0, 1e-12);
    sum += test.phases[0].pull;
  }
  EXPECT_EQ(sum, Vector3::Zero());
}

TEST(ProtocolFile, WhatIsWrongIsNamed) {
  EXPECT_EQ(
      refusal(with_phase(R"({"kind": "hold", "duration": 1, "wobble": 2})")),
      "p.json: tests[0].phases[0].wobble: unknown field, known here are kind, duration, pull, "
      "pull_grows, gravity, frame, fails (2)");
  EXPECT_EQ(refusal(with_phase(R"({"kind": "hold", "duration": 0})")),
            "p.json: tests[0].phases[0].duration: must be above 0 (0)");
  EXPECT_EQ(refusal(with_phase(R"({"kind": "jump", "duration": 1})")),
            "p.json: tests[0].phases[0].kind: must be one of settle, approach, close, hold, lift, "
            "circle, swing, turn, open (\"jump\")");
  EXPECT_EQ(refusal(with_phase(R"({"kind": "swing", "duration": 1, "amplitude": 1})")),
            "p.json: tests[0].phases[0].frequency: missing field");
  EXPECT_EQ(refusal(R"({"name": "p", "step": 10, "tests": []})"),
            "p.json: step: must be at most 0.1 s (10)");
  EXPECT_EQ(refusal(R"({"name": "p", "tests": []})"), "p.json: tests: must not be empty ([])");
  EXPECT_EQ(refusal(R"({"name": "p", "object": {"mass": -1}, "tests": []})"),
            "p.json: object.mass: must be above 0 (-1)");
  const InputError unknown = test::refusal_of([] { (void)find_protocol("earthquake"); });
  EXPECT_NE(std::string(unknown.what()).find("dexgraspbench"), std::string::npos);
}

}  // namespace
}  // namespace prehend
