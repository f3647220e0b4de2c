// Paths that are looked for while a session goes on, and those of results.
#include <string>

#include <gtest/gtest.h>

#include "planner/live/protocol/recording.h"
#include "planner/live/protocol/session_endpoint.h"
#include "tests/planner/live/protocol/listening_client.h"

namespace prehend::test {
namespace {

// A session with the arm's best grasps, that records itself.
class PathCommands : public ::testing::Test {
 protected:
  PathCommands()
      : endpoint_({}, [this](const std::string& line) { recording_ += line + "\n"; }),
        client_(endpoint_) {}

  void plan(const std::string& scene, bool paths) {
    client_.result({{"command", "scene.load"}, {"scene", scene}});
    client_.result(
        {{"command", "plan.start"}, {"trials", 60}, {"top", paths ? 2 : 1}, {"paths", paths}});
    EXPECT_EQ(client_.next_event("plan")["status"], "complete");
    grasps_ = client_.result({{"command", "plan.results"}})["grasps"];
    ASSERT_FALSE(grasps_.empty());
    client_.result({{"command", "plan.go"}, {"grasp", 0}});
  }

  std::string refusal(const Reply& request) {
    const Reply reply = client_.reply(request);
    EXPECT_EQ(reply["ok"], false) << request;
    return reply["error"].value("problem", "");
  }

  // The state at the end, and the replayed recording, which ends in the same.
  Replayed replayed() {
    const Reply state = client_.result({{"command", "state"}});
    const Replayed again = replay(recording_, "recording", {});
    EXPECT_EQ(Reply::parse(again.state), state);
    return again;
  }

  std::string recording_;
  SessionEndpoint endpoint_;
  ListeningClient client_;
  Reply grasps_;
};

TEST_F(PathCommands, OthersAreAnsweredWhileAPathIsLookedFor) {
  plan("living_room", false);
  ListeningClient other(endpoint_);
  EXPECT_EQ(client_.result({{"command", "path.plan"}})["started"], true);
  const Reply state = other.result({{"command", "state"}});
  EXPECT_EQ(state["finding_path"], true);
  EXPECT_EQ(state["planning"], false);
  EXPECT_NE(refusal({{"command", "path.plan"}}).find("a path is looked for"), std::string::npos);
  EXPECT_NE(refusal({{"command", "plan.start"}}).find("a path is looked for"), std::string::npos);
  EXPECT_NE(refusal({{"command", "undo"}}).find("a path is looked for"), std::string::npos);
  EXPECT_EQ(refusal({{"command", "path.result"}}), "no path was found yet: path.plan");
  EXPECT_EQ(client_.result({{"command", "plan.cancel"}})["cancelled"], false);
  while (client_.next_event("progress")["stage"] != "paths") {
  }
  EXPECT_EQ(other.result({{"command", "path.cancel"}})["cancelled"], true);
  EXPECT_EQ(client_.next_event("path")["status"], "cancelled");
  EXPECT_EQ(client_.result({{"command", "state"}})["finding_path"], false);
  EXPECT_EQ(refusal({{"command", "path.result"}}), "no path was found yet: path.plan");
  EXPECT_EQ(client_.result({{"command", "path.cancel"}})["cancelled"], false);
  // A replay gives the search up where the session has.
  EXPECT_NE(recording_.find(R"({"recorded":"path.finished","cancelled":true})"), std::string::npos);
  const Replayed again = replayed();
  EXPECT_EQ(again.refused, 5);
}

TEST_F(PathCommands, APathIsThatOfTheHandAsItWas) {
  plan("panda_on_table", false);
  EXPECT_TRUE(grasps_[0]["path"].is_null());
  EXPECT_EQ(refusal({{"command", "path.result"}, {"grasp", 0}}), "was planned without a path");
  client_.result({{"command", "path.plan"}, {"lift", false}});
  EXPECT_EQ(client_.next_event("path")["status"], "found");
  const Reply path = client_.result({{"command", "path.result"}});
  EXPECT_EQ(path["samples"][0]["time"], 0.0);
  EXPECT_EQ(path["lift"], "not_asked");
  // Pins change nothing of it, the hand does.
  client_.result({{"command", "pin.add"}, {"name", "best"}});
  EXPECT_EQ(client_.result({{"command", "path.result"}}), path);
  client_.result({{"command", "hand.back_off"}, {"distance", 0.01}});
  EXPECT_EQ(refusal({{"command", "path.result"}}),
            "the hand or the scene have changed since the path was asked for");
  client_.result({{"command", "undo"}});
  const Reply last = client_.reply({{"command", "path.result"}});
  EXPECT_EQ(last["result"], path);
  const Replayed again = replayed();
  EXPECT_EQ(Reply::parse(again.replies.at(again.replies.size() - 2)), last);
}

TEST_F(PathCommands, ResultsThatWerePlannedWithPathsHaveThem) {
  plan("panda_on_table", true);
  for (std::size_t i = 0; i < grasps_.size(); ++i) {
    const Reply path = client_.result({{"command", "path.result"}, {"grasp", i}});
    EXPECT_EQ(path["status"], "found");
    EXPECT_NEAR(path["samples"].back()["time"].get<double>(), grasps_[i]["path"].get<double>(),
                1e-9);
    EXPECT_EQ(path["segments"][0]["first"], 0);
    client_.result({{"command", "plan.go"}, {"grasp", i}});
    // The hand of the path is at the grasp when it has closed.
    const Reply hand = client_.result({{"command", "state"}})["hand"]["X_world_hand"]["position"];
    for (const Reply& segment : path["segments"]) {
      if (segment["name"] != "close") continue;
      const Reply& end = path["samples"][segment["last"].get<std::size_t>()];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(end["X_world_hand"]["position"][axis].get<double>(), hand[axis].get<double>(),
                    1e-6);
      }
    }
  }
  EXPECT_EQ(refusal({{"command", "path.result"}, {"grasp", 1000}}), "no result has this number");
  (void)replayed();
}

}  // namespace
}  // namespace prehend::test
