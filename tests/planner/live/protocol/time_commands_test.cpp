// Time by messages.
#include <string>

#include <gtest/gtest.h>

#include "planner/live/protocol/recording.h"
#include "planner/live/protocol/session_endpoint.h"
#include "tests/planner/live/protocol/listening_client.h"

namespace prehend::test {
namespace {

void set_ball(ListeningClient& client) {
  client.result({{"command", "scene.new"}, {"hand", "parallel_jaw"}});
  client.result({{"command", "object.set"}, {"generate", "ball"}, {"triangles", 600}});
}

TEST(TimeCommands, AMovingWorldIsToldAndEnds) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  set_ball(client);
  client.result({{"command", "hand.approach"}});
  client.result({{"command", "hand.auto_grasp"}});
  EXPECT_TRUE(client.result({{"command", "state"}})["time"].is_null());
  const Reply start = client.result({{"command", "time.start"}, {"gravity", false}});
  EXPECT_EQ(start["time"], 0.0);
  EXPECT_EQ(client.result({{"command", "state"}})["time"],
            Reply({{"gravity", false}, {"step", 0.0025}}));
  EXPECT_TRUE(client.result({{"command", "time.contacts"}})["contacts"].empty());
  const Reply drives = client.result({{"command", "time.drive"}, {"effort", 2.0}})["drives"];
  EXPECT_EQ(drives[0]["drive"]["effort"], 2.0);
  const Reply step = client.result({{"command", "time.step"}, {"seconds", 0.05}});
  EXPECT_EQ(step["outcome"], "moved");
  EXPECT_EQ(step["time"], 0.05);
  Reply state = client.result({{"command", "time.state"}});
  state["outcome"] = "moved";
  EXPECT_EQ(state, step);
  const Reply refused = client.reply({{"command", "hand.back_off"}, {"distance", 0.01}});
  EXPECT_EQ(refused["error"]["field"], "command");
  EXPECT_EQ(client.reply({{"command", "time.start"}})["ok"], false);
  EXPECT_EQ(client.result({{"command", "time.reset"}}), start);
  EXPECT_TRUE(client.result({{"command", "time.stop"}})["time"].is_null());
  EXPECT_EQ(client.reply({{"command", "time.step"}, {"seconds", 0.1}})["ok"], false);
}

TEST(TimeCommands, WhatDoesNotFitIsRefused) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  EXPECT_EQ(client.reply({{"command", "time.start"}})["error"]["field"], "scene");
  set_ball(client);
  EXPECT_EQ(client.reply({{"command", "time.start"}, {"step", 0.5}})["error"]["field"], "step");
  client.result({{"command", "time.start"}});
  const auto field_of = [&](const Reply& request) {
    return client.reply(request)["error"]["field"];
  };
  EXPECT_EQ(field_of({{"command", "time.step"}, {"seconds", 2}}), "seconds");
  EXPECT_EQ(field_of({{"command", "time.step"}, {"seconds", 0}}), "seconds");
  EXPECT_EQ(field_of({{"command", "time.drive"}, {"dof", "tail"}, {"effort", 1}}), "dof");
  EXPECT_EQ(field_of({{"command", "time.drive"}, {"target", 1}, {"effort", 1}}), "");
  EXPECT_EQ(field_of({{"command", "time.pull"}, {"stiffness", 1}}), "");
  EXPECT_EQ(field_of({{"command", "time.pull"},
                      {"point_object", {0, 0, 0}},
                      {"to_world", {0, 0, 1}},
                      {"stiffness", 1e9}}),
            "stiffness");
}

TEST(TimeCommands, RecordedTimeReplaysToTheSameBytes) {
  std::string recording;
  std::vector<Reply> replies;
  {
    SessionEndpoint endpoint({}, [&](const std::string& line) { recording += line + "\n"; });
    ListeningClient client(endpoint);
    const Reply pull{{"command", "time.pull"},
                     {"point_object", {0.02, 0, 0}},
                     {"to_world", {0.1, 0, 0.1}},
                     {"stiffness", 40}};
    const std::vector<Reply> commands = {
        {{"command", "scene.new"}, {"hand", "parallel_jaw"}},
        {{"command", "object.set"}, {"generate", "cylinder"}, {"triangles", 600}},
        {{"command", "hand.approach"}},
        {{"command", "time.start"}, {"step", 0.002}},
        {{"command", "time.drive"}, {"effort", 5}},
        {{"command", "time.step"}, {"seconds", 0.3}},
        {{"command", "time.contacts"}},
        {{"command", "hand.back_off"}},
        pull,
        {{"command", "time.step"}, {"seconds", 0.3}},
        {{"command", "time.pull"}},
        {{"command", "time.step"}, {"seconds", 0.1}},
        {{"command", "time.stop"}, {"keep", true}},
        {{"command", "undo"}}};
    for (const Reply& command : commands) replies.push_back(client.reply(command));
  }
  const Replayed once = replay(recording, "recording", {});
  ASSERT_EQ(once.replies.size(), replies.size());
  for (std::size_t i = 0; i < replies.size(); ++i) {
    EXPECT_EQ(Reply::parse(once.replies[i]), replies[i]) << i;
  }
  EXPECT_EQ(once.refused, 1);
  EXPECT_EQ(replay_text(once), replay_text(replay(recording, "recording", {})));
}

}  // namespace
}  // namespace prehend::test
