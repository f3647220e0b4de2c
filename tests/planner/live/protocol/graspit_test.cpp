// GraspIt!'s text protocol: what each line is answered with, whatever it is.
#include <condition_variable>
#include <deque>
#include <mutex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "planner/live/protocol/graspit_endpoint.h"
#include "planner/live/protocol/graspit_text.h"
#include "planner/live/protocol/recording.h"
#include "planner/live/protocol/session_endpoint.h"
#include "sim/base/pose.h"
#include "sim/base/random.h"
#include "tests/planner/live/protocol/listening_client.h"

namespace prehend::test {
namespace {

using Lines = std::vector<std::string>;

std::vector<double> numbers_in(const std::string& line) {
  std::istringstream stream(line);
  std::vector<double> numbers;
  for (double number = 0.0; stream >> number;) numbers.push_back(number);
  EXPECT_TRUE(stream.eof()) << line;
  return numbers;
}

// A client of lines.
class LineListening {
 public:
  explicit LineListening(Endpoint& endpoint) : endpoint_(endpoint) {
    id_ = endpoint.connect([this](const std::string& text) {
      const std::lock_guard hold(lock_);
      std::istringstream stream(text);
      for (std::string line; std::getline(stream, line);) lines_.push_back(line);
      came_.notify_all();
    });
  }
  ~LineListening() { endpoint_.disconnect(id_); }
  LineListening(const LineListening&) = delete;
  LineListening& operator=(const LineListening&) = delete;

  void send(const std::string& line) { endpoint_.receive(id_, line); }

  // What lines are answered with, all of it.
  Lines answers(const Lines& sent) {
    for (const std::string& line : sent) send(line);
    send("unknown-end");
    std::unique_lock hold(lock_);
    const std::string end = "Error: unknown command unknown-end.";
    came_.wait(hold, [&] { return !lines_.empty() && lines_.back() == end; });
    Lines all(lines_.begin(), lines_.end() - 1);
    lines_.clear();
    return all;
  }
  Lines answer(const std::string& line) { return answers({line}); }

 private:
  Endpoint& endpoint_;
  ClientId id_ = 0;
  std::mutex lock_;
  std::condition_variable came_;
  std::deque<std::string> lines_;
};

// A session of all kinds of clients with the default scene.
class GraspitProtocol : public ::testing::Test {
 protected:
  GraspitProtocol()
      : endpoint_({}, [this](const std::string& line) { recording_ += line + "\n"; }),
        graspit_(endpoint_),
        json_(endpoint_),
        client_(graspit_) {
    json_.result({{"command", "scene.load"}, {"scene", "mug"}});
  }

  std::string recording_;
  SessionEndpoint endpoint_;
  GraspitEndpoint graspit_;
  ListeningClient json_;
  LineListening client_;
};

TEST_F(GraspitProtocol, BodiesAndRobotsHaveNumbers) {
  EXPECT_EQ(client_.answer("getBodyName ALL"),
            Lines({"13", "mug", "none", "none", "palm", "knuckle_1", "proximal_1", "distal_1",
                   "knuckle_2", "proximal_2", "distal_2", "none", "proximal_3", "distal_3"}));
  EXPECT_EQ(client_.answer("getBodyName 3 6 9 12"), Lines({"distal_1", "distal_2", "distal_3"}));
  EXPECT_EQ(client_.answer("getBodyName 0"), Lines({}));
  EXPECT_EQ(client_.answer("getRobotName ALL"), Lines({"1", "barrett"}));
  EXPECT_EQ(client_.answer("getRobotName 2 0 2"), Lines({"barrett", "barrett"}));
  EXPECT_EQ(client_.answer("getBodyName 1 13"), Lines({"Error: Cannot find body 13"}));
  EXPECT_EQ(client_.answer("getBodyName 1 -1"), Lines({"Error: Cannot find body -1"}));
  EXPECT_EQ(client_.answer("getRobotName 1 1"), Lines({"Error: Cannot find robot 1"}));
}

TEST_F(GraspitProtocol, DegreesOfFreedomMoveUntilContact) {
  EXPECT_EQ(client_.answer("getDOFVals ALL"), Lines({"1", "4", "0", "0", "0", "0"}));
  EXPECT_EQ(client_.answer("moveDOFs 0 4 0.5 0.25 0 0 1 1 1 1"), Lines({"0.5", "0.25", "0", "0"}));
  EXPECT_EQ(client_.answer("getDOFVals 1 0"), Lines({"4", "0.5", "0.25", "0", "0"}));
  EXPECT_EQ(json_.result({{"command", "state"}})["hand"]["dofs"][1]["value"], 0.25);
  EXPECT_EQ(client_.answer("moveDOFs 7 4 0 0 0 0 1 1 1 1"),
            Lines({"Error: Robot does not exist."}));
  EXPECT_EQ(client_.answer("moveDOFs"), Lines({"Error: Robot does not exist."}));
  EXPECT_EQ(client_.answer("moveDOFs 0 3 0 0 0 1 1 1"), Lines({"Error: robot has 4 DOF."}));
  EXPECT_EQ(client_.answer("setDOFForces 1 0 3 0 0 0"), Lines({"Error: robot has 4 DOF."}));
}

// What two fingers came to that closed from 0 until something was touched.
std::vector<double> closed_by(LineListening& client, const std::string& steps) {
  const Lines reached = client.answer("moveDOFs 0 4 0 2.4 2.4 0 0 " + steps + " 0");
  EXPECT_EQ(reached.size(), 4U);
  return {numbers_in(reached.at(1)).at(0), numbers_in(reached.at(2)).at(0)};
}

TEST_F(GraspitProtocol, StepsSayHowFastDegreesOfFreedomGo) {
  client_.answer("moveToContacts");
  const Reply start = json_.result({{"command", "state"}})["hand"]["dofs"];
  for (const double ratio : {1.0, 2.0, 4.0}) {
    const std::vector<double> closed = closed_by(client_, "0.01 " + std::to_string(0.01 * ratio));
    EXPECT_GT(closed[0], 0.05);
    EXPECT_LT(closed[1], 2.4);
    EXPECT_NEAR(closed[1], ratio * closed[0], 1e-9);
    // One step of undo.
    json_.result({{"command", "undo"}});
    EXPECT_EQ(json_.result({{"command", "state"}})["hand"]["dofs"], start);
  }
  // Where the faster one has arrived, the other goes on; without a step it is there first.
  EXPECT_EQ(client_.answer("moveDOFs 0 4 0 0.3 0.2 0 0 0.1 0.1 0"),
            Lines({"0", "0.3", "0.2", "0"}));
  const std::vector<double> first = closed_by(client_, "0.01 0");
  EXPECT_NEAR(first[0], 0.3, 1e-6);
  EXPECT_GT(first[1], 0.3);
}

TEST_F(GraspitProtocol, AHandThatRestsHasContactsWithoutForces) {
  EXPECT_EQ(client_.answer("getContacts 3 2 0 6"), Lines({"0", "0"}));
  json_.result({{"command", "hand.approach"}});
  json_.result({{"command", "hand.auto_grasp"}});
  const Reply told = json_.result({{"command", "contacts"}})["contacts"];
  ASSERT_FALSE(told.empty());
  const Lines lines = client_.answer("getContacts 3 1 0");
  ASSERT_EQ(lines.size(), 1 + 3 * told.size());
  EXPECT_EQ(lines[0], std::to_string(told.size()));
  for (std::size_t i = 0; i < told.size(); ++i) {
    EXPECT_EQ(lines[1 + 3 * i], "0 0 0 0 0 0");
    const std::vector<double> place = numbers_in(lines[2 + 3 * i]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(place.at(axis), 1e3 * told[i]["position_object"][axis].get<double>(), 1e-5);
    }
    EXPECT_NEAR(numbers_in(lines[3 + 3 * i]).at(0), 1e3 * told[i]["gap"].get<double>(), 1e-6);
  }
  // Those of the links are the same, and near the link's own origin.
  std::size_t of_links = 0;
  for (int body = 3; body < 13; ++body) {
    const Lines own = client_.answer("getContacts 2 1 " + std::to_string(body));
    const auto count = std::stoul(own.at(0));
    ASSERT_EQ(own.size(), 1 + 2 * count);
    of_links += count;
    for (std::size_t i = 0; i < count; ++i) {
      const std::vector<double> place = numbers_in(own[2 + 2 * i]);
      EXPECT_LT(Vector3(place.at(0), place.at(1), place.at(2)).norm(), 120.0) << body;
    }
  }
  EXPECT_EQ(of_links, told.size());
  EXPECT_TRUE(json_.result({{"command", "state"}})["time"].is_null());
}

TEST_F(GraspitProtocol, ForcesAreClampedAndTimeBegins) {
  // 50, 2.5, 2.5 and 5 N m at most, in 1e-6 N mm.
  EXPECT_EQ(client_.answer("setDOFForces 1 0 4 1e9 -9e9 2e9 1e12"),
            Lines({"1e+09", "-2.5e+09", "2e+09", "5e+09"}));
  EXPECT_TRUE(json_.result({{"command", "state"}})["time"].is_object());
  EXPECT_EQ(client_.answer("setDOFForces ALL 4 0 0 0 0"), Lines({"1", "0", "0", "0", "0"}));
  EXPECT_EQ(client_.answer("moveDynamicBodies 0.01"), Lines({"0.01"}));
  EXPECT_EQ(client_.answer("moveDynamicBodies"), Lines({"0.0025"}));
  EXPECT_EQ(client_.answer("moveDynamicBodies -1"), Lines({"0.0025"}));
  EXPECT_EQ(client_.answer("computeNewVelocities 0.01"), Lines({"0"}));
  EXPECT_EQ(client_.answer("moveDynamicBodies 2").size(), 1U);
  // Nothing touches.
  EXPECT_EQ(client_.answer("getContacts 3 2 0 6"), Lines({"0", "0"}));
  EXPECT_EQ(client_.answer("getAverageContacts 1 6"), Lines({"0 0 0 0 0 0", "0 0 0"}));
  EXPECT_EQ(client_.answer("render"), Lines({}));
  // Static motions end time, and keep what it came to.
  const double time = json_.result({{"command", "time.state"}})["time"].get<double>();
  EXPECT_NEAR(time, 0.015, 1e-12);
  EXPECT_EQ(client_.answer("moveToContacts"), Lines({}));
  EXPECT_TRUE(json_.result({{"command", "state"}})["time"].is_null());
}

// A pair of calls is one step of the world.
TEST_F(GraspitProtocol, APeriodIsOneStep) {
  json_.result({{"command", "time.start"}, {"gravity", false}});
  json_.result({{"command", "time.drive"}, {"dof", "thumb"}, {"effort", 0.1}});
  json_.result({{"command", "time.step"}, {"seconds", 0.0025}});
  const Reply stepped = json_.result({{"command", "time.state"}});
  json_.result({{"command", "time.reset"}});
  client_.answers({"setDOFForces 1 2 4 0 0 0 1e8"});
  for (const char* dof : {"spread", "finger_1", "finger_2"}) {
    json_.result({{"command", "time.drive"}, {"dof", dof}});
  }
  EXPECT_EQ(client_.answers({"moveDynamicBodies 0.0025", "computeNewVelocities 0.0025"}),
            Lines({"0.0025", "0"}));
  EXPECT_EQ(json_.result({{"command", "time.state"}}), stepped);
}

constexpr const char* kMalformed[] = {"",
                                      " ",
                                      "getcontacts 1 ALL",
                                      "getContacts",
                                      "getContacts ALL",
                                      "getContacts 1",
                                      "getContacts 1 2 0",
                                      "getContacts 1 1 0 0",
                                      "getBodyName",
                                      "getBodyName -1",
                                      "getBodyName ALL 1",
                                      "getBodyName all",
                                      "getBodyName 99999999999999999999",
                                      "getRobotName 1 0 x",
                                      "moveDOFs 0 4 0 0 0 0",
                                      "moveDOFs 0 4 0 0 0 nan 1 1 1 1",
                                      "setDOFForces",
                                      "setDOFForces 1 0 4 0 0 0",
                                      "setDOFForces 1 0 4 0 0 0 0 0",
                                      "setDOFForces 1 0 4 inf 0 0 0",
                                      "moveDynamicBodies fast",
                                      "moveDynamicBodies 0.0025 1",
                                      "computeNewVelocities",
                                      "moveToContacts now",
                                      "render all",
                                      "{\"command\": \"state\"}",
                                      "\xff\xfe"};

TEST_F(GraspitProtocol, MalformedLinesGetOneErrorLine) {
  const Reply before = json_.result({{"command", "state"}});
  for (const char* line : kMalformed) {
    const Lines lines = client_.answer(line);
    ASSERT_EQ(lines.size(), 1U) << line;
    EXPECT_TRUE(lines[0].starts_with("Error: ")) << lines[0];
  }
  EXPECT_EQ(json_.result({{"command", "state"}}), before);
}

TEST_F(GraspitProtocol, PipelinedLinesHaveNothingOfEachOther) {
  Lines sent;
  Lines expected;
  for (int i = 0; i < 100; ++i) {
    for (const char* line : {"getBodyName 2 0 3", "getBodyName 2 6", "getBodyName 1 12",
                             "getAverageContacts 1 6", "render", "getBodyName 0"}) {
      sent.push_back(line);
    }
    for (const char* line : {"mug", "palm", "Error: the line ends before a number of the list.",
                             "distal_3", "0 0 0 0 0 0", "0 0 0"}) {
      expected.push_back(line);
    }
  }
  EXPECT_EQ(client_.answers(sent), expected);
}

// A line of words that may belong into it, with a byte of any kind in some.
std::string random_line(Random& random) {
  static const std::vector<std::string> commands = {
      "getContacts", "getAverageContacts", "getBodyName",          "getRobotName", "getDOFVals",
      "moveDOFs",    "setDOFForces",       "computeNewVelocities", "render"};
  static const std::vector<std::string> words = {
      "ALL", "ALL",   "1 0", "1 2", "0",  "1",  "2",      "4",   "12",     "-1",
      "0.5", "1e999", "nan", "x",   "\t", "%s", "Error:", "1e8", "render", "4 0 0 0 0"};
  std::string line = random.index(20) == 0 ? "" : commands[random.index(commands.size())];
  for (std::size_t count = random.index(5); count > 0; --count) {
    line += random.index(9) == 0 ? "  " : " ";
    line += words[random.index(words.size())];
  }
  if (random.index(5) == 0 && !line.empty()) {
    line[random.index(line.size())] = static_cast<char>(random.index(256));
  }
  return line;
}

TEST(GraspitText, TenThousandRandomLinesAreEachAnsweredAsDocumented) {
  Session session;
  session.set_scene(open_scene("mug", {}));
  Random random(5);
  int errors = 0;
  int answers = 0;
  for (int i = 0; i < 10000; ++i) {
    const std::string line = random_line(random);
    const Lines lines = graspit_reply(session, line);
    const bool refused = !lines.empty() && lines[0].starts_with("Error: ");
    EXPECT_TRUE(!refused || lines.size() == 1U) << line;
    // Nothing is what render replies, and what there is of an empty list.
    const bool may_be_silent =
        line.find("render") != std::string::npos || line.find('0') != std::string::npos;
    EXPECT_TRUE(!lines.empty() || may_be_silent) << line;
    if (!refused) ++answers;
    if (refused) ++errors;
    for (const std::string& told : lines) EXPECT_EQ(told.find('\n'), std::string::npos) << line;
  }
  EXPECT_GT(errors, 5000);
  EXPECT_GT(answers, 300);
  EXPECT_EQ(graspit_reply(session, "getRobotName 1 0"), Lines({"barrett"}));
}

Vector3 force_in(const std::string& wrench) {
  const std::vector<double> numbers = numbers_in(wrench);
  EXPECT_EQ(numbers.size(), 6U) << wrench;
  return {numbers.at(0), numbers.at(1), numbers.at(2)};
}

// The loop of the paper, with forces that close the hand, on a ball that floats.
TEST_F(GraspitProtocol, TheControlLoopClosesTheHandUntilContactForcesAppear) {
  json_.result({{"command", "object.set"}, {"generate", "ball"}, {"triangles", 800}});
  json_.result({{"command", "hand.approach"}});
  json_.result({{"command", "hand.back_off"}, {"distance", 0.01}});
  // How many of the distal links press on something with more than half a newton.
  int pressing = 0;
  for (int i = 0; i < 1200 && pressing < 3; ++i) {
    const Lines step = client_.answer("moveDynamicBodies 0.0025");
    ASSERT_EQ(step, Lines({"0.0025"}));
    ASSERT_EQ(client_.answer("computeNewVelocities " + step[0]).size(), 1U);
    const Lines contacts = client_.answer("getAverageContacts 3 6 9 12");
    ASSERT_EQ(contacts.size(), 6U);
    pressing = 0;
    for (const std::size_t body : {0U, 2U, 4U}) {
      if (force_in(contacts[body]).norm() > 0.5e6) ++pressing;
    }
    ASSERT_EQ(client_.answer("setDOFForces 1 2 4 0 1e9 1e9 2e9").size(), 4U);
  }
  EXPECT_EQ(pressing, 3);
  // The contacts of the ball are those that other clients hear of, in other units.
  const Lines lines = client_.answer("getContacts 3 1 0");
  const Reply told = json_.result({{"command", "time.contacts"}})["contacts"];
  std::size_t next = 1;
  int distal = 0;
  for (const Reply& contact : told) {
    if (contact["bodies"][0] != "ball") continue;
    ASSERT_LT(next + 2, lines.size());
    const auto force = contact["force_world"].get<std::vector<double>>();
    const double size = 1e6 * Vector3(force[0], force[1], force[2]).norm();
    EXPECT_NEAR(force_in(lines[next]).norm(), size, 1e-6 * size + 1e-6);
    EXPECT_EQ(numbers_in(lines[next + 1]).size(), 3U);
    EXPECT_NEAR(numbers_in(lines[next + 2]).at(0), 1e3 * contact["gap"].get<double>(), 1e-6);
    if (contact["bodies"][1].get<std::string>().starts_with("distal_")) ++distal;
    next += 3;
  }
  EXPECT_EQ(next, lines.size());
  EXPECT_EQ(lines[0], std::to_string((next - 1) / 3));
  EXPECT_GT(distal, 0);
  // The session was recorded as any other.
  const Reply state = json_.result({{"command", "time.state"}});
  const Replayed replayed = replay(recording_, "recording", {});
  EXPECT_EQ(Reply::parse(replayed.replies.back())["result"], state);
}

}  // namespace
}  // namespace prehend::test
