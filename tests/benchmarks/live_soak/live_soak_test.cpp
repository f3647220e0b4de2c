// A short run of the clients that try everything, and what their judges find.
#include "benchmarks/live_soak/live_soak.h"

#include <set>

#include <gtest/gtest.h>

#include "benchmarks/live_soak/judge_reply.h"
#include "benchmarks/live_soak/random_request.h"
#include "planner/live/protocol/request.h"

namespace prehend::live_soak {
namespace {

TEST(LiveSoak, EightHundredMessagesShowNoFault) {
  LiveSoakOptions options;
  options.messages = 800;
  options.seed = 5;
  options.replays = true;
  const LiveSoakResult result = run_live_soak(options);
  for (const auto& [words, fault] : result.faults) ADD_FAILURE() << words << ": " << fault.first;
  EXPECT_GE(result.messages(), options.messages);
  // It does something, and not all of it is sound.
  EXPECT_GT(result.carried_out, options.messages / 3);
  EXPECT_GT(result.refused, options.messages / 20);
  EXPECT_GT(result.undone, 0);
  EXPECT_GT(result.evaluated, 0);
}

TEST(LiveSoak, EveryCommandIsAskedFor) {
  Random random(3);
  KnownNames names{{"barrett"}, {"ur5e"}, {"mug"}, {"ball"}, {}};
  std::set<std::string> asked;
  std::set<std::string> sound;
  for (int i = 0; i < 20000; ++i) {
    const Json request = random_request(random, names);
    if (!request["command"].is_string()) continue;
    asked.insert(request["command"]);
    if (!read_request(request.dump()).error) sound.insert(request["command"]);
  }
  for (const Command& command : commands()) {
    EXPECT_TRUE(asked.contains(std::string(command.name))) << command.name;
    EXPECT_TRUE(sound.contains(std::string(command.name))) << command.name;
  }
  Random one(9);
  Random same(9);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(random_request(one, names), random_request(same, names));
    EXPECT_EQ(random_nonsense(one, names), random_nonsense(same, names));
  }
}

TEST(LiveSoak, JudgesSeeWhatIsWrong) {
  const Json sound{{"id", 3}, {"ok", true}, {"result", {{"problem", nullptr}, {"x", {1, 2}}}}};
  EXPECT_EQ(fault_of_reply(sound, 3), "");
  EXPECT_NE(fault_of_reply(sound, 4), "");
  for (const char* bad :
       {R"({"id":3,"ok":true})", R"({"id":3})", R"([])", R"({"id":3,"ok":true,"result":3})",
        R"({"id":3,"ok":true,"result":{"x":[1,null]}})",
        R"({"id":3,"ok":true,"result":{"a":{"epsilon":null}}})", R"({"id":3,"ok":false})",
        R"({"id":3,"ok":false,"error":{"field":"","value":""}})",
        R"({"id":3,"ok":false,"error":{"field":"","value":"","problem":""}})",
        R"({"id":3,"ok":false,"error":{"field":"","value":"","problem":"internal error: x"}})"}) {
    EXPECT_NE(fault_of_reply(Json::parse(bad), 3), "") << bad;
  }
  EXPECT_NE(fault_of_event({{"event", "state"}, {"state", {{"epsilon", nullptr}}}}), "");
}

TEST(LiveSoak, GrowthIsThatAfterTheFirstQuarter) {
  LiveSoakResult result;
  for (const double megabytes : {100.0, 90.0, 110.0}) {
    for (int i = 0; i < 10; ++i) result.resident.push_back(i == 3 ? 200.0 : megabytes);
  }
  result.resident.push_back(300.0);
  EXPECT_EQ(result.quarters(), (std::vector{100.0, 90.0, 110.0}));
  EXPECT_NEAR(result.growth(), 0.1, 1e-12);
}

}  // namespace
}  // namespace prehend::live_soak
