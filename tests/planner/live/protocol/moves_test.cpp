// Bodies, arms and grasps by messages: dragged, refined, played back, recorded and replayed.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "planner/live/protocol/recording.h"
#include "planner/live/protocol/session_endpoint.h"
#include "sim/base/random.h"
#include "tests/planner/live/protocol/listening_client.h"

namespace prehend::test {
namespace {

Reply placed_at(double x, double y, double z) { return {{"position", {x, y, z}}}; }

TEST(Moves, ADraggedObjectEndsAtTheHandAndIsOneStep) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  client.result({{"command", "scene.new"}, {"hand", "parallel_jaw"}});
  client.result({{"command", "object.set"}, {"generate", "box"}, {"triangles", 300}});
  const Reply before = client.result({{"command", "state"}});
  Reply motion;
  for (int i = 0; i < 40; ++i) {
    motion = client.result({{"command", "object.move"},
                            {"X_world_object", placed_at(0.0, 0.0, 0.01 * i)},
                            {"drag", 12}});
  }
  EXPECT_EQ(motion["end"], "touched");
  EXPECT_TRUE(motion["touches"].is_string());
  const Reply after = client.result({{"command", "state"}});
  EXPECT_EQ(after["object"]["X_world_object"], motion["X_world_object"]);
  EXPECT_EQ(after["undo"], before["undo"].get<int>() + 1);
  EXPECT_TRUE(client.result({{"command", "collisions"}})["collisions"].empty());
  Reply undone = client.result({{"command", "undo"}})["state"];
  EXPECT_EQ(undone["object"], before["object"]);
  EXPECT_EQ(undone["hand"], before["hand"]);
  EXPECT_TRUE(client.result({{"command", "object.remove"}})["object"].is_null());
}

TEST(Moves, TheStateTellsOfTheArmThatFollows) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  const Reply scene = client.result({{"command", "scene.load"}, {"scene", "ur5e_on_table"}});
  EXPECT_EQ(scene["arm"]["reached"], true);
  ASSERT_EQ(scene["arm"]["joints"].size(), 6U);
  for (const Reply& joint : scene["arm"]["joints"]) {
    EXPECT_LE(joint["lower"], joint["value"]);
    EXPECT_LE(joint["value"], joint["upper"]);
  }
  const Reply branches = client.result({{"command", "arm.branches"}})["branches"];
  ASSERT_GT(branches.size(), 1U);
  const Reply chosen = client.result({{"command", "arm.choose"}, {"branch", 1}})["arm"];
  for (std::size_t j = 0; j < 6; ++j) {
    EXPECT_EQ(chosen["joints"][j]["value"], branches[1]["joints"][j]);
  }
  client.result({{"command", "undo"}});
  const std::string first = scene["arm"]["joints"][0]["name"];
  const double value = scene["arm"]["joints"][0]["value"];
  const Reply turned =
      client.result({{"command", "arm.joints"}, {"joint", first}, {"value", value + 0.05}});
  EXPECT_EQ(turned["end"], "arrived");
  EXPECT_NEAR(turned["arm"]["joints"][0]["value"].get<double>(), value + 0.05, 1e-12);
  EXPECT_NE(turned["hand"]["X_world_hand"], scene["hand"]["X_world_hand"]);
  client.result({{"command", "hand.move"}, {"X_world_hand", placed_at(9.0, 0.0, 1.0)}});
  const Reply far = client.result({{"command", "state"}})["arm"];
  EXPECT_EQ(far["reached"], false);
  EXPECT_TRUE(far["problem"].is_string());
  EXPECT_TRUE(client.result({{"command", "scene.load"}, {"scene", "mug"}})["arm"].is_null());
}

TEST(Moves, GraspsAreRefinedAndPlayedBack) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  client.result({{"command", "scene.new"}, {"hand", "parallel_jaw"}});
  client.result({{"command", "object.set"}, {"generate", "cylinder"}, {"triangles", 600}});
  client.result({{"command", "hand.approach"}});
  client.result({{"command", "hand.auto_grasp"}});
  const Reply refined = client.result({{"command", "grasp.refine"}, {"trials", 40}});
  EXPECT_EQ(refined["outcome"], "stable");
  EXPECT_EQ(refined["improved"].get<bool>(), refined["epsilon"] > refined["epsilon_before"]);
  client.result({{"command", "path.plan"}});
  EXPECT_EQ(client.next_event("path")["status"], "found");
  const Reply path = client.result({{"command", "path.result"}});
  ASSERT_EQ(path["status"], "found") << path["problem"];
  ASSERT_GT(path["samples"].size(), 2U);
  EXPECT_EQ(path["samples"][0]["joints"].size(), path["joints"].size());
  const Reply hand = client.result({{"command", "state"}})["hand"];
  EXPECT_EQ(path["samples"].back()["joints"], hand["joints"]);
}

// The field that a refusal names.
std::string refused(ListeningClient& client, const Reply& request) {
  const Reply reply = client.reply(request);
  EXPECT_EQ(reply["ok"], false) << request;
  return reply["error"].value("field", "");
}

TEST(Moves, MistakesAreToldWithTheirFields) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  const Reply here = placed_at(0.0, 0.0, 0.0);
  EXPECT_EQ(refused(client, {{"command", "object.move"}, {"X_world_object", here}}), "object");
  EXPECT_EQ(refused(client, {{"command", "object.move"}}), "X_world_object");
  EXPECT_EQ(refused(client, {{"command", "object.remove"}}), "object");
  EXPECT_EQ(refused(client, {{"command", "obstacle.move"}, {"name", "a"}, {"X_world_body", here}}),
            "name");
  EXPECT_EQ(refused(client, {{"command", "hand.move"}, {"X_world_hand", here}, {"drag", 0.5}}),
            "drag");
  EXPECT_EQ(refused(client, {{"command", "arm.branches"}}), "command");
  EXPECT_EQ(refused(client, {{"command", "arm.choose"}, {"branch", 0}}), "command");
  EXPECT_EQ(refused(client, {{"command", "grasp.refine"}}), "scene");
  EXPECT_EQ(refused(client, {{"command", "grasp.refine"}, {"trials", 100000}}), "trials");
  EXPECT_EQ(refused(client, {{"command", "path.plan"}}), "scene");
  EXPECT_EQ(refused(client, {{"command", "path.result"}}), "command");
  EXPECT_EQ(refused(client, {{"command", "path.result"}, {"grasp", 0}}), "grasp");
  EXPECT_EQ(refused(client, {{"command", "path.result"}, {"grasp", -1}}), "grasp");
  EXPECT_EQ(client.result({{"command", "path.cancel"}})["cancelled"], false);
  EXPECT_EQ(refused(client, {{"command", "plan.start"}, {"paths", true}}), "command");
  client.result({{"command", "scene.load"}, {"scene", "ur5e_on_table"}});
  EXPECT_EQ(refused(client, {{"command", "arm.choose"}, {"branch", 1000}}), "branch");
  EXPECT_EQ(refused(client, {{"command", "arm.joints"}}), "joint");
  EXPECT_EQ(refused(client, {{"command", "arm.joints"}, {"joints", {1, 2}}}), "joints");
  EXPECT_EQ(refused(client, {{"command", "arm.joints"}, {"joint", "tail"}, {"value", 0}}), "joint");
  EXPECT_EQ(refused(client, {{"command", "grasp.refine"}}), "hand");
}

Reply random_move(Random& random, const Vector3& near) {
  const Vector3 p = near + random.in_box(0.15);
  const Reply pose = placed_at(p.x(), p.y(), p.z());
  const int drag = random.integer(1, 2);
  switch (random.integer(0, 10)) {
    case 0:
    case 1:
      return {{"command", "object.move"}, {"X_world_object", pose}, {"drag", drag}};
    case 2:
      return {
          {"command", "obstacle.move"}, {"name", "box"}, {"X_world_body", pose}, {"drag", drag}};
    case 3:
      return {{"command", "hand.move"}, {"X_object_hand", pose}, {"drag", drag}};
    case 4: {
      std::vector<double> joints;
      for (int j = 0; j < 6; ++j) joints.push_back(random.uniform(-2.0, 2.0));
      return {{"command", "arm.joints"}, {"joints", joints}, {"drag", drag}};
    }
    case 5:
      return {{"command", "arm.choose"}, {"branch", random.integer(0, 7)}};
    case 6:
      return {{"command", random.index(3) == 0 ? "redo" : "undo"}};
    case 7:
      return {{"command", random.index(2) == 0 ? "arm.branches" : "collisions"}};
    case 8:
      return {{"command", "switches.set"}, {"stop_at_contact", random.index(4) != 0}};
    case 9:
      return {{"command", random.index(2) == 0 ? "hand.approach" : "hand.auto_grasp"}};
    default:
      return {{"command", "grasp.refine"}, {"trials", 4}};
  }
}

TEST(Moves, DraggedScenesReplayToTheSameBytes) {
  std::string recording;
  std::vector<Reply> replies;
  Reply state;
  {
    SessionEndpoint endpoint({}, [&](const std::string& line) { recording += line + "\n"; });
    ListeningClient client(endpoint);
    Random random(23);
    const Reply scene = client.reply({{"command", "scene.load"}, {"scene", "ur5e_on_table"}});
    replies.push_back(scene);
    const Reply at = scene["result"]["object"]["X_world_object"]["position"];
    const Vector3 near(at[0], at[1], at[2]);
    replies.push_back(client.reply({{"command", "obstacle.add"},
                                    {"generate", "box"},
                                    {"triangles", 12},
                                    {"name", "box"},
                                    {"X_world_body", placed_at(0.0, 0.9, 0.6)}}));
    replies.push_back(
        client.reply({{"command", "plan.start"}, {"trials", 40}, {"top", 1}, {"paths", true}}));
    client.next_event("plan");
    replies.push_back(client.reply({{"command", "plan.go"}, {"grasp", 0}}));
    replies.push_back(client.reply({{"command", "path.plan"}}));
    EXPECT_EQ(client.next_event("path")["status"], "found");
    replies.push_back(client.reply({{"command", "path.result"}}));
    EXPECT_EQ(replies.back()["result"]["status"], "found");
    while (replies.size() < 150) replies.push_back(client.reply(random_move(random, near)));
    state = client.result({{"command", "state"}});
  }
  const Replayed once = replay(recording, "recording", {});
  ASSERT_EQ(once.replies.size(), replies.size() + 1);
  for (std::size_t i = 0; i < replies.size(); ++i) {
    EXPECT_EQ(Reply::parse(once.replies[i]), replies[i]) << i;
  }
  EXPECT_EQ(Reply::parse(once.state), state);
  EXPECT_LT(once.refused, 100);
  SessionOptions one_thread;
  one_thread.threads = 1;
  EXPECT_EQ(replay_text(once), replay_text(replay(recording, "recording", one_thread)));
}

}  // namespace
}  // namespace prehend::test
