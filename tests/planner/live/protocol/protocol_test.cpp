// Messages in, replies and events out: every message is answered once, whatever it is.
#include <condition_variable>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "planner/live/protocol/graspit_text.h"
#include "planner/live/protocol/protocol_schema.h"
#include "planner/live/protocol/request.h"
#include "planner/live/protocol/session_endpoint.h"
#include "sim/base/input_file.h"
#include "sim/base/output_file.h"
#include "sim/base/random.h"
#include "tests/planner/live/protocol/listening_client.h"

namespace prehend::test {
namespace {

TEST(Protocol, AHandTakesHoldOfAnObject) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  EXPECT_EQ(client.result({{"command", "hello"}})["version"], 1);
  client.result({{"command", "scene.new"}, {"hand", "parallel_jaw"}});
  client.result({{"command", "object.set"}, {"generate", "cylinder"}, {"triangles", 600}});
  const Reply moved = client.result({{"command", "hand.approach"}});
  EXPECT_EQ(moved["end"], "touched");
  EXPECT_EQ(moved["by"], "cylinder");
  const Reply grasp = client.result({{"command", "hand.auto_grasp"}});
  EXPECT_EQ(grasp["outcome"], "stable");
  const Reply quality = client.result({{"command", "quality"}});
  EXPECT_EQ(quality["epsilon"], grasp["epsilon"]);
  EXPECT_GT(quality["volume"], 0.0);
  const Reply forces = client.result({{"command", "forces"}, {"force_object", {0, 0, -3}}});
  EXPECT_EQ(forces["outcome"], "balanced");
  EXPECT_EQ(forces["forces"].size(), quality["contacts"].size());
  EXPECT_TRUE(client.result({{"command", "collisions"}})["collisions"].empty());
  EXPECT_EQ(client.result({{"command", "undo"}})["done"], true);
}

// What the paper's users change while they look at a grasp.
TEST(Protocol, FrictionNormEdgesAndSectionAreChangedWhileOneLooks) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  client.result({{"command", "scene.new"}, {"hand", "parallel_jaw"}});
  client.result({{"command", "object.set"}, {"generate", "cylinder"}, {"triangles", 600}});
  client.result({{"command", "hand.approach"}});
  client.result({{"command", "hand.auto_grasp"}});
  const Reply first = client.result({{"command", "state"}});
  EXPECT_EQ(first["judge"], (Reply{{"norm", "l1"}, {"edges", 8}, {"fixed", nullptr}}));
  ASSERT_FALSE(first["friction"].empty());
  const std::string pad = first["friction"].back()["material"];
  const auto quality = [&] { return client.result({{"command", "quality"}, {"sections", true}}); };
  const auto epsilon = [&] { return quality()["epsilon"]["lower"].get<double>(); };
  const double before = epsilon();
  EXPECT_FALSE(quality()["sections"].contains("chosen"));

  const Reply slippery =
      client.result({{"command", "friction.set"}, {"static", 0.05}, {"material", pad}});
  EXPECT_EQ(slippery["friction"].back()["static"], 0.05);
  EXPECT_LT(epsilon(), before);
  client.result({{"command", "undo"}});
  EXPECT_EQ(client.result({{"command", "judge.set"}, {"norm", "linf"}})["judge"]["norm"], "linf");
  EXPECT_GT(epsilon(), before);
  client.result({{"command", "judge.set"}, {"norm", "l1"}, {"edges", 24}});
  EXPECT_GE(epsilon(), before);
  client.result({{"command", "judge.set"}, {"fixed", "tx,ty,tz"}, {"values", {0, 0, 0}}});
  const Reply sections = quality()["sections"];
  EXPECT_EQ(sections["chosen"]["axes"], (Reply{"fx", "fy", "fz"}));
  EXPECT_EQ(sections["chosen"]["vertices"], sections["forces"]["vertices"]);
  client.result({{"command", "judge.set"}, {"fixed", "fz,tx,tz"}, {"values", {0, 0, 100}}});
  EXPECT_EQ(quality()["sections"]["chosen"]["axes"], (Reply{"fx", "fy", "ty"}));
  EXPECT_TRUE(quality()["sections"]["chosen"]["vertices"].empty());
  client.result({{"command", "judge.set"}, {"section", false}});
  EXPECT_FALSE(quality()["sections"].contains("chosen"));
  while (client.result({{"command", "state"}})["judge"] != first["judge"]) {
    ASSERT_EQ(client.result({{"command", "undo"}})["done"], true);
  }
  EXPECT_EQ(epsilon(), before);
}

// A message that is refused, and the field that the refusal names.
struct Mistake {
  const char* message;
  const char* field;
};

constexpr Mistake kMistakes[] = {
    {"", "line 1"},
    {"nonsense", "line 1"},
    {"{\"command\": \"state\"", "line 1"},
    {"[]", ""},
    {"3", ""},
    {"{}", "command"},
    {R"({"command": 3})", "command"},
    {R"({"command": "fly"})", "command"},
    {R"({"command": "state", "command": "state"})", "command"},
    {R"({"command": "state", "id": [1]})", "id"},
    {R"({"command": "state", "id": 1.5})", "id"},
    {R"({"command": "state", "more": 1})", "more"},
    {R"({"command": "hand.dofs", "dofs": "open"})", "dofs"},
    {R"({"command": "hand.dofs", "dofs": [1, null]})", "dofs[1]"},
    {R"({"command": "hand.dofs", "dofs": [1]})", "dofs"},
    {R"({"command": "hand.dofs", "dof": "tail", "value": 1})", "dof"},
    {R"({"command": "hand.dofs", "dof": "spread"})", "value"},
    {R"({"command": "hand.move"})", ""},
    {R"({"command": "hand.move", "X_world_hand": {"position": [0, 0]}})", "X_world_hand.position"},
    {R"({"command": "hand.move", "X_world_hand": {"quaternion_wxyz": [0, 0, 0, 0]}})",
     "X_world_hand.quaternion_wxyz"},
    {R"({"command": "hand.back_off", "distance": 1e999})", ""},
    {R"({"command": "hand.back_off", "distance": NaN})", "line 1"},
    {R"({"command": "hand.back_off", "distance": -1})", "distance"},
    {R"({"command": "hand.preshape", "preshape": "none"})", "preshape"},
    {R"({"command": "hand.choose", "hand": "claw"})", "hand"},
    {R"({"command": "hand.choose", "hand": "/etc/passwd"})", "hand"},
    {R"({"command": "scene.load", "scene": "/etc/passwd"})", "scene"},
    {R"({"command": "scene.load", "scene": "mug", "text": "{}"})", ""},
    {R"({"command": "scene.load", "text": "{"})", "text"},
    {R"({"command": "scene.save", "file": "a.json"})", "file"},
    {R"({"command": "scene.text"})", "scene"},
    {R"({"command": "object.set"})", ""},
    {R"({"command": "object.set", "generate": "cat"})", "generate"},
    {R"({"command": "object.set", "generate": "ball", "material": "air"})", "material"},
    {R"({"command": "object.set", "generate": "ball", "mass": 0})", "mass"},
    {R"({"command": "object.set", "mesh_text": "v 0 0 0"})", "format"},
    {R"({"command": "object.set", "mesh_text": "v 0 0 0", "format": "obj"})", "mesh_text"},
    {R"({"command": "object.set", "mesh_text": "v 0 0 0", "format": "exe"})", "format"},
    {R"({"command": "object.set", "mesh_text": "{}", "format": "gltf"})", "format"},
    {R"({"command": "object.change", "mass": 1})", "object"},
    {R"({"command": "friction.set", "static": 0.5})", "object"},
    {R"({"command": "friction.set", "static": -1})", "static"},
    {R"({"command": "friction.set"})", "static"},
    {R"({"command": "friction.set", "static": 1, "material": "air"})", "material"},
    {R"({"command": "judge.set", "norm": "l3"})", "norm"},
    {R"({"command": "judge.set", "edges": 2})", "edges"},
    {R"({"command": "judge.set", "edges": 1000})", "edges"},
    {R"({"command": "judge.set", "fixed": "fx,fy,fz"})", ""},
    {R"({"command": "judge.set", "values": [0, 0, 0]})", ""},
    {R"({"command": "judge.set", "fixed": "fx,fy", "values": [0, 0, 0]})", "fixed"},
    {R"({"command": "judge.set", "fixed": "fx,fy,fz,tx", "values": [0, 0, 0]})", "fixed"},
    {R"({"command": "judge.set", "fixed": "fx,fy,fx", "values": [0, 0, 0]})", "fixed"},
    {R"({"command": "judge.set", "fixed": "fx,fy,force", "values": [0, 0, 0]})", "fixed"},
    {R"({"command": "obstacle.remove", "name": "wall"})", "name"},
    {R"({"command": "platform.mount", "platform": "cart"})", "platform"},
    {R"({"command": "hand.auto_grasp"})", "scene"},
    {R"({"command": "plan.start"})", "scene"},
    {R"({"command": "plan.start", "trials": 0})", "trials"},
    {R"({"command": "plan.start", "seed": -1})", "seed"},
    {R"({"command": "plan.start", "accuracy": "/etc/passwd"})", "accuracy"},
    {R"({"command": "plan.start", "approach": "sideways"})", "approach"},
    {R"({"command": "plan.go", "grasp": 0})", "grasp"},
    {R"({"command": "plan.export"})", "command"},
    {R"({"command": "pin.remove", "name": "a"})", "name"},
    {"{\"command\": \"\xff\"}", "line 1"},
};

TEST(Protocol, EveryMistakeIsToldWithItsField) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  for (const Mistake& mistake : kMistakes) {
    const Reply reply = client.reply_to_text(mistake.message);
    ASSERT_EQ(reply["ok"], false) << mistake.message;
    EXPECT_EQ(reply["error"]["field"], mistake.field) << mistake.message << reply;
    EXPECT_NE(reply["error"]["problem"], "") << mistake.message;
  }
  const std::string deep(100000, '[');
  EXPECT_NE(client.reply_to_text(deep)["error"]["problem"].get<std::string>().find("nested"),
            std::string::npos);
  // The session has not changed.
  EXPECT_EQ(client.result({{"command", "state"}})["revision"], 0);
}

TEST(Protocol, RepliesHaveTheIdAndTheOrderOfTheRequests) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  for (int i = 0; i < 100; ++i) {
    endpoint.receive(client.id(), R"({"id": )" + std::to_string(i) + R"(, "command": "state"})");
  }
  for (int i = 0; i < 100; ++i) EXPECT_EQ(client.next_reply()["id"], i);
  EXPECT_EQ(client.reply_to_text(R"({"id": "a", "command": "fly"})")["id"], "a");
}

TEST(Protocol, TwoClientsSeeTheSame) {
  SessionEndpoint endpoint({});
  ListeningClient one(endpoint);
  ListeningClient two(endpoint);
  one.result({{"command", "scene.new"}, {"hand", "parallel_jaw"}});
  two.result({{"command", "object.set"}, {"generate", "ball"}});
  one.result({{"command", "hand.back_off"}, {"distance", 0.2}});
  for (ListeningClient* client : {&one, &two}) {
    for (int change = 1; change <= 3; ++change) {
      const Reply event = client->next_event("state");
      EXPECT_EQ(event["state"]["revision"], change);
    }
  }
  EXPECT_EQ(one.result({{"command", "state"}}), two.result({{"command", "state"}}));
  {
    ListeningClient third(endpoint);
    EXPECT_EQ(third.result({{"command", "state"}})["object"]["name"], "ball");
  }
  // One that has left is not told any more.
  EXPECT_EQ(one.result({{"command", "undo"}})["done"], true);
}

TEST(Protocol, PlansAreToldOfCancelledAndKept) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  ListeningClient other(endpoint);
  client.result({{"command", "scene.new"}, {"hand", "parallel_jaw"}});
  client.result({{"command", "object.set"}, {"generate", "cylinder"}, {"triangles", 600}});
  client.result({{"command", "plan.start"}, {"trials", 1000000}});
  const Reply found = other.next_event("grasps");
  EXPECT_GT(found["grasps"][0]["epsilon"], 0.0);
  EXPECT_GT(other.next_event("progress")["total"], 0);
  // The hand may be moved meanwhile, the scene not.
  client.result({{"command", "hand.back_off"}});
  EXPECT_EQ(client.reply({{"command", "object.change"}, {"mass", 1}})["error"]["field"], "command");
  EXPECT_EQ(other.result({{"command", "plan.cancel"}})["cancelled"], true);
  const Reply end = client.next_event("plan");
  EXPECT_EQ(end["status"], "cancelled");
  EXPECT_GT(end["size"], 0);
  const Reply results = client.result({{"command", "plan.results"}});
  EXPECT_EQ(results["size"], end["size"]);
  client.result({{"command", "plan.go"}, {"grasp", 0}});
  EXPECT_NEAR(client.result({{"command", "quality"}})["epsilon"]["lower"].get<double>(),
              results["grasps"][0]["epsilon"].get<double>(), 1e-9);
  const Reply files = client.result({{"command", "plan.export"}, {"format", "csv"}})["files"];
  EXPECT_FALSE(files.empty());
  EXPECT_EQ(client.result({{"command", "plan.cancel"}})["cancelled"], false);
}

TEST(Protocol, AnEndpointEndsWhileAPlanRuns) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  client.result({{"command", "scene.new"}, {"hand", "parallel_jaw"}});
  client.result({{"command", "object.set"}, {"generate", "ball"}});
  client.result({{"command", "plan.start"}, {"trials", 1000000}});
}

// Text with mistakes in it, or of nothing but mistakes.
std::string garbage(Random& random) {
  static const std::vector<std::string> kSound = {
      R"({"id": 1, "command": "state"})",
      R"({"id": "x", "command": "hand.move", "X_world_hand": {"position": [0.1, 0, 0.3]}})",
      R"({"command": "hand.dofs", "dofs": [1, 1, 1, 0]})",
      R"({"command": "switches.set", "stop_at_contact": false})",
      R"({"command": "hand.open"})",
      R"({"command": "undo"})",
      R"({"command": "pin.add", "name": "p"})"};
  std::string text = kSound[random.index(kSound.size())];
  const int kind = random.integer(0, 4);
  if (kind == 0) {
    text.clear();
    for (int i = random.integer(0, 60); i > 0; --i) {
      text.push_back(static_cast<char>(random.integer(0, 255)));
    }
    return text;
  }
  if (kind == 1) return text.substr(0, random.index(text.size() + 1));
  if (kind == 2) {
    const std::size_t depth = random.index(400);
    return std::string(depth, random.index(2) == 0 ? '[' : '{');
  }
  for (int i = random.integer(1, 3); i > 0; --i) {
    text[random.index(text.size())] = static_cast<char>(random.integer(0, 255));
  }
  return text;
}

TEST(Protocol, GarbageIsAnsweredOnceEach) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  Random random(11);
  for (int i = 0; i < 10000; ++i) {
    const Reply reply = client.reply_to_text(garbage(random));
    ASSERT_TRUE(reply.contains("ok"));
    if (!reply["ok"]) {
      ASSERT_TRUE(reply["error"]["field"].is_string());
    }
  }
  EXPECT_EQ(client.replies_left(), 0U);
  EXPECT_TRUE(client.result({{"command", "state"}}).contains("hand"));
}

TEST(Protocol, ManyClientsAtOnceGetTheirOwnReplies) {
  SessionEndpoint endpoint({});
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&endpoint, t] {
      ListeningClient client(endpoint);
      Random random(20 + static_cast<std::uint64_t>(t));
      for (int i = 0; i < 300; ++i) {
        const std::string id = std::to_string(t) + "-" + std::to_string(i);
        EXPECT_EQ(client.reply({{"id", id}, {"command", "hand.open"}})["id"], id);
        client.reply_to_text(garbage(random));
      }
      EXPECT_EQ(client.replies_left(), 0U);
    });
  }
  for (std::thread& thread : threads) thread.join();
}

// Holds the thread of commands at the first request, as one that takes long would.
class Gate {
 public:
  RecordLine record() {
    return [this](const std::string&) {
      std::unique_lock hold(lock_);
      has_come_ = true;
      changed_.notify_all();
      changed_.wait(hold, [this] { return is_open_; });
    };
  }
  void wait_for_request() {
    std::unique_lock hold(lock_);
    changed_.wait(hold, [this] { return has_come_; });
  }
  void open() {
    const std::lock_guard hold(lock_);
    is_open_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex lock_;
  std::condition_variable changed_;
  bool has_come_ = false;
  bool is_open_ = false;
};

TEST(Protocol, RequestsThatAClientSendsAheadAreBounded) {
  Gate gate;
  SessionEndpoint endpoint({}, gate.record());
  ListeningClient client(endpoint);
  ListeningClient other(endpoint);
  const std::string request = R"({"command": "state"})";
  std::size_t taken = 0;
  const auto send_until_refused = [&] {
    try {
      while (true) {
        endpoint.receive(client.id(), request);
        ++taken;
      }
    } catch (const std::runtime_error&) {
    }
  };
  endpoint.receive(client.id(), request);
  gate.wait_for_request();
  send_until_refused();
  // Each that was taken is answered once, in order; the others cost nothing but their refusals.
  EXPECT_EQ(++taken, 2 * kMostWaiting);
  gate.open();
  for (std::size_t i = 0; i < taken; ++i) {
    EXPECT_EQ(client.next_reply()["ok"], i < kMostWaiting) << i;
  }
  // After that there is room again.
  EXPECT_EQ(client.reply_to_text(request)["ok"], true);
  EXPECT_EQ(other.reply_to_text(request)["ok"], true);
  endpoint.receive(other.id() + 1, "{}");  // of nobody
}

TEST(Protocol, BytesThatAClientSendsAheadAreBounded) {
  Gate gate;
  SessionEndpoint endpoint({}, gate.record());
  ListeningClient client(endpoint);
  ListeningClient other(endpoint);
  endpoint.receive(client.id(), R"({"command": "state"})");
  gate.wait_for_request();
  const std::size_t size = kMostWaitingBytes / 4;
  const std::string large = R"({"command": "state", "id": ")" + std::string(size, 'x') + R"("})";
  for (int i = 0; i < 6; ++i) endpoint.receive(client.id(), large);
  // What still fits is taken, also of others.
  endpoint.receive(client.id(), R"({"command": "state"})");
  endpoint.receive(other.id(), large);
  gate.open();
  EXPECT_EQ(client.next_reply()["ok"], true);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(client.next_reply()["ok"], true);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(client.next_reply()["error"]["problem"], "too many bytes waiting");
  }
  EXPECT_EQ(client.next_reply()["ok"], true);
  EXPECT_EQ(other.next_reply()["ok"], true);
}

// Who comes, sends and leaves again and again leaves no more behind than all may have together.
TEST(Protocol, WhatClientsLeaveBehindIsBounded) {
  Gate gate;
  SessionEndpoint endpoint({}, gate.record());
  ListeningClient client(endpoint);
  endpoint.receive(client.id(), R"({"command": "state"})");
  gate.wait_for_request();
  std::size_t taken = 0;
  for (std::size_t k = 0; k < 3 * kWaitingOfAll; ++k) {
    const ListeningClient passing(endpoint);
    try {
      for (std::size_t i = 0; i < 2 * kMostWaiting; ++i, ++taken)
        endpoint.receive(passing.id(), "{}");
    } catch (const std::runtime_error&) {
    }
  }
  EXPECT_LE(taken, 2 * kWaitingOfAll * kMostWaiting);
  gate.open();
  EXPECT_EQ(client.next_reply()["ok"], true);
  EXPECT_EQ(client.reply_to_text(R"({"command": "state"})")["ok"], true);
}

TEST(Protocol, WhereARecordingEndsAllAreToldOnce) {
  int lines = 0;
  SessionEndpoint endpoint({}, [&](const std::string&) {
    if (++lines > 2) throw std::runtime_error("the disk is full");
  });
  ListeningClient client(endpoint);
  ListeningClient other(endpoint);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(client.reply({{"command", "state"}})["ok"], true);
  ListeningClient late(endpoint);
  for (ListeningClient* one : {&client, &other, &late}) {
    const Reply event = one->next_event("recording");
    EXPECT_EQ(event["status"], "failed");
    EXPECT_EQ(event["problem"], "the disk is full");
    EXPECT_EQ(one->events_left("recording"), 0);
  }
  // A recording without a line in the middle would be that of another session.
  EXPECT_EQ(lines, 3);
}

TEST(Protocol, RequestsAreObjects) {
  EXPECT_TRUE(is_request(R"( {"command": "fly"})"));
  for (const char* text : {"", " ", "[]", "3", "{", "{\"a\": 1} 2", "GET / HTTP/1.1", "null"}) {
    EXPECT_FALSE(is_request(text)) << text;
  }
  EXPECT_FALSE(is_request(std::string(1000000, '{')));
  EXPECT_TRUE(is_graspit_command("  getDOFVals ALL"));
  EXPECT_TRUE(is_graspit_command("render"));
  for (const char* text : {"", "GET / HTTP/1.1", "renderer", "getDOFVals2", "{}"}) {
    EXPECT_FALSE(is_graspit_command(text)) << text;
  }
}

// The documents in which the table of commands is written down. With PREHEND_WRITE_PROTOCOL in the
// environment they are written instead of compared.
std::filesystem::path document(const std::string& name) {
  return std::filesystem::path(PREHEND_SOURCE_DIR) / "docs/reference" / name;
}

bool writes_documents() { return std::getenv("PREHEND_WRITE_PROTOCOL") != nullptr; }

constexpr const char* kHint = "PREHEND_WRITE_PROTOCOL=1 protocol_tests writes it anew";

TEST(Protocol, TheSchemaIsThatOfTheCommands) {
  const std::filesystem::path file = document("protocol.schema.json");
  if (writes_documents()) write_file(file, protocol_schema());
  EXPECT_TRUE(read_file(file) == protocol_schema()) << kHint;
  // Every command is there, with its fields.
  const Reply requests = Reply::parse(protocol_schema())["$defs"]["request"]["oneOf"];
  ASSERT_EQ(requests.size(), commands().size());
  for (std::size_t i = 0; i < commands().size(); ++i) {
    EXPECT_EQ(requests[i]["properties"]["command"]["const"], commands()[i].name);
    EXPECT_EQ(requests[i]["properties"].size(), 2 + commands()[i].fields.size());
  }
}

TEST(Protocol, TheDocumentListsTheCommands) {
  const std::string heading = "## Commands\n\n";
  const std::filesystem::path file = document("protocol.md");
  std::string text = read_file(file);
  const std::size_t begin = text.find(heading);
  ASSERT_NE(begin, std::string::npos);
  if (writes_documents()) {
    text = text.substr(0, begin) + heading + protocol_reference();
    write_file(file, text);
  }
  EXPECT_TRUE(text.substr(begin + heading.size()) == protocol_reference()) << kHint;
}

}  // namespace
}  // namespace prehend::test
