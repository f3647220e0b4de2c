// Recorded sessions come out the same again, byte for byte.
#include "planner/live/protocol/recording.h"

#include <gtest/gtest.h>

#include "planner/live/protocol/session_endpoint.h"
#include "sim/base/random.h"
#include "tests/planner/live/protocol/listening_client.h"
#include "tests/support/refusal_of.h"

namespace prehend::test {
namespace {

Reply random_pose(Random& random) {
  const Eigen::Quaterniond q(random.rotation());
  const Vector3 p = random.in_box(0.25);
  return {{"position", {p.x(), p.y(), p.z()}}, {"quaternion_wxyz", {q.w(), q.x(), q.y(), q.z()}}};
}

// A command as somebody who tries everything may give it; some are refused.
Reply random_command(Random& random) {
  const std::vector<std::string> objects = {"box", "ball", "cylinder"};
  const std::string name(1, static_cast<char>('a' + random.integer(0, 2)));
  switch (random.integer(0, 15)) {
    case 0:
      return {
          {"command", "object.set"}, {"generate", objects[random.index(3)]}, {"triangles", 300}};
    case 1:
      return {{"command", "object.change"},
              {"mass", random.uniform(0.01, 1.0)},
              {"X_world_object", random_pose(random)}};
    case 2:
      return {{"command", "obstacle.add"},
              {"generate", "box"},
              {"triangles", 12},
              {"name", name},
              {"X_world_body", random_pose(random)}};
    case 3:
      return {{"command", "obstacle.remove"}, {"name", name}};
    case 4:
      return {{"command", "obstacle.change"}, {"name", name}, {"material", "metal"}};
    case 5:
    case 6:
      return {{"command", "hand.move"}, {"X_object_hand", random_pose(random)}};
    case 7:
      return {{"command", "hand.dofs"}, {"dofs", {random.uniform(-0.1, 0.2)}}};
    case 8:
      return {{"command", "hand.approach"}};
    case 9:
      return {{"command", "hand.auto_grasp"}};
    case 10:
      return {{"command", "hand.open"}};
    case 11:
      return {{"command", "hand.back_off"}, {"distance", random.uniform(0.0, 0.1)}};
    case 12:
      return {{"command", random.index(3) == 0 ? "redo" : "undo"}};
    case 13:
      return {{"command", "quality"}};
    case 14:
      return {{"command", "switches.set"}, {"stop_at_contact", random.index(4) != 0}};
    default:
      return {{"command", "pin.add"}, {"name", name}};
  }
}

TEST(Recording, TwoHundredRandomCommandsReplayToTheSameBytes) {
  std::string recording;
  std::vector<Reply> replies;
  Reply state;
  std::string scene;
  {
    SessionEndpoint endpoint({}, [&](const std::string& line) { recording += line + "\n"; });
    ListeningClient client(endpoint);
    Random random(17);
    replies.push_back(client.reply({{"command", "scene.new"}, {"hand", "parallel_jaw"}}));
    replies.push_back(
        client.reply({{"command", "object.set"}, {"generate", "cylinder"}, {"triangles", 600}}));
    replies.push_back(client.reply({{"command", "plan.start"}, {"trials", 40}}));
    client.next_event("plan");
    replies.push_back(client.reply({{"command", "plan.go"}, {"grasp", 0}}));
    replies.push_back(client.reply({{"command", "plan.start"}, {"trials", 1000000}}));
    client.next_event("grasps");
    replies.push_back(client.reply({{"command", "plan.cancel"}}));
    client.next_event("plan");
    replies.push_back(client.reply({{"command", "plan.go"}, {"grasp", 0}}));
    while (replies.size() < 200) replies.push_back(client.reply(random_command(random)));
    // Not recorded, and nothing that the replay would have to know.
    client.reply_to_text("garbage");
    state = client.result({{"command", "state"}});
    scene = client.result({{"command", "scene.text"}})["text"];
    replies.push_back({});
    replies.push_back({});
  }
  const Replayed once = replay(recording, "recording", {});
  ASSERT_EQ(once.replies.size(), replies.size());
  for (std::size_t i = 0; i < 200; ++i) EXPECT_EQ(Reply::parse(once.replies[i]), replies[i]) << i;
  EXPECT_EQ(Reply::parse(once.state), state);
  EXPECT_EQ(once.scene, scene);
  EXPECT_GT(once.refused, 0);
  EXPECT_LT(once.refused, 150);
  SessionOptions one_thread;
  one_thread.threads = 1;
  EXPECT_EQ(replay_text(once), replay_text(replay(recording, "recording", one_thread)));
}

TEST(Recording, LinesThatNoRecordingHasAreNamed) {
  for (const char* bad :
       {"garbage", R"({"recorded": "tea"})", R"({"recorded": "plan.finished"})",
        R"({"recorded": "plan.finished", "more": 1})", R"({"recorded": "path.finished"})",
        R"({"recorded": "path.finished", "results": ""})"}) {
    const std::string recording = std::string("{\"command\": \"state\"}\n\n") + bad + "\n";
    const InputError error = refusal_of([&] { (void)replay(recording, "r.jsonl", {}); });
    EXPECT_EQ(error.file(), "r.jsonl") << bad;
    EXPECT_EQ(error.field(), "line 3") << bad;
  }
}

}  // namespace
}  // namespace prehend::test
