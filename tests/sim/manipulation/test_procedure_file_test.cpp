#include "sim/manipulation/test_procedure_file.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

std::string with_phase(const std::string& phase) {
  return R"({"name": "p", "tests": [{"name": "t", "phases": [)" + phase + "]}]}";
}

std::string refusal(const std::string& text) {
  return test::refusal_of([&] { (void)parse_test_procedure(text, "p.json"); }).what();
}

TEST(ProtocolFile, EveryProtocolOfTheLibraryIsRead) {
  const std::vector<std::string> names = library_test_procedure_names();
  EXPECT_EQ(names.size(), 6U);
  for (const std::string& name : names) {
    const TestProcedure procedure = read_test_procedure(find_test_procedure(name));
    EXPECT_EQ(procedure.name, name);
    EXPECT_FALSE(procedure.source.empty()) << name;
    EXPECT_FALSE(procedure.tests.empty()) << name;
  }
}

TEST(ProtocolFile, PublishedNumbersOfDexGraspBench) {
  const TestProcedure procedure = read_test_procedure(find_test_procedure("dexgraspbench"));
  EXPECT_EQ(procedure.object.mass, 0.1);
  EXPECT_EQ(procedure.friction, 0.6);
  EXPECT_EQ(procedure.torsion, 0.02);
  ASSERT_EQ(procedure.tests.size(), 6U);
  Vector3 sum = Vector3::Zero();
  for (const ProcedureTest& test : procedure.tests) {
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
            "p.json: tests[0].phases[0].frequency: must be given");
  EXPECT_EQ(refusal(R"({"name": "p", "step": 10, "tests": []})"),
            "p.json: step: must be at least 1e-5 and at most 0.1 (10)");
  EXPECT_EQ(refusal(R"({"name": "p", "step": 1e-12, "tests": []})"),
            "p.json: step: must be at least 1e-5 and at most 0.1 (1e-12)");
  EXPECT_EQ(refusal(R"({"name": "p", "tests": []})"), "p.json: tests: must not be empty ([])");
  EXPECT_EQ(refusal(R"({"name": "p", "object": {"mass": -1}, "tests": []})"),
            "p.json: object.mass: must be above 0 (-1)");
  const InputError unknown = test::refusal_of([] { (void)find_test_procedure("earthquake"); });
  EXPECT_NE(std::string(unknown.what()).find("dexgraspbench"), std::string::npos);
}

}  // namespace
}  // namespace prehend
