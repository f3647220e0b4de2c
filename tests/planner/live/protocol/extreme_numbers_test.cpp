// Every number of every command as an extreme: it is refused with the field, or the answer and the
// state after it are numbers, and undo gives the state from before.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "planner/live/protocol/command.h"
#include "planner/live/protocol/session_endpoint.h"
#include "tests/planner/live/protocol/listening_client.h"

namespace prehend::test {
namespace {

constexpr double kExtremes[] = {0.0,  -0.0,  5e-324,     1e-308, 1e-30,  -1.0,         1.0,
                                1e6,  -1e6,  1.000001e6, 1e9,    -1e9,   2147483647.0, 1e12,
                                1e21, -1e21, 1e30,       -1e30,  1.7e308};

bool is_number(FieldType type) {
  return type == FieldType::number || type == FieldType::integer || type == FieldType::vector3 ||
         type == FieldType::numbers || type == FieldType::pose;
}

// The values that a field takes when one of its numbers is `extreme`.
std::vector<Reply> with_extreme(const CommandField& field, double extreme, std::size_t dofs) {
  switch (field.type) {
    case FieldType::number:
      return {extreme};
    case FieldType::integer:
      return {extreme, static_cast<std::int64_t>(std::clamp(extreme, -9e18, 9e18))};
    case FieldType::vector3:
      return {{extreme, 0.01, 0.02}, {extreme, extreme, extreme}};
    case FieldType::numbers: {
      std::vector<double> values(dofs, 0.0);
      if (!values.empty()) values.back() = extreme;
      return {values};
    }
    case FieldType::pose:
      return {{{"position", {extreme, 0.0, 0.3}}},
              {{"position", {0.0, 0.0, 0.3}}, {"quaternion_wxyz", {extreme, 0.0, 0.0, 0.0}}}};
    default:
      return {};
  }
}

// Fields that a command needs beside the one that is looked at.
Reply plain_request(const Command& command, const CommandField& extreme, const Reply& state) {
  Reply request{{"command", command.name}};
  const std::string dof = state["hand"]["dofs"][0]["name"];
  const std::vector<std::pair<std::string_view, Reply>> known{{"scene", "ball"},
                                                              {"hand", "parallel_jaw"},
                                                              {"generate", "box"},
                                                              {"name", "tower"},
                                                              {"dof", dof},
                                                              {"point_object", {0.0, 0.0, 0.0}},
                                                              {"to_world", {0.0, 0.0, 0.1}},
                                                              {"stiffness", 1.0}};
  for (const CommandField& field : command.fields) {
    const bool together =
        command.name == "time.pull" ||
        (command.name == "hand.dofs" && field.name == "dof" && extreme.name == "value");
    if (field.name == extreme.name || (!field.required && !together)) continue;
    for (const auto& [name, value] : known) {
      if (name == field.name) request[std::string(name)] = value;
    }
  }
  return request;
}

bool all_finite(const Reply& json) {
  if (json.is_number()) return std::isfinite(json.get<double>());
  return !json.is_structured() ||
         std::all_of(json.begin(), json.end(), [](const Reply& part) { return all_finite(part); });
}

// Where things are stands in numbers: what is no number is written as null.
void expect_places(const Reply& state) {
  EXPECT_TRUE(all_finite(state));
  for (const Reply& x : state["hand"]["X_world_hand"]["position"]) EXPECT_TRUE(x.is_number());
  for (const Reply& dof : state["hand"]["dofs"]) EXPECT_TRUE(dof["value"].is_number());
  if (state["object"].is_null()) return;
  for (const Reply& x : state["object"]["X_world_object"]["position"]) EXPECT_TRUE(x.is_number());
}

class ExtremesOf : public testing::TestWithParam<const Command*> {};

TEST_P(ExtremesOf, AreRefusedOrAnswered) {
  const Command& command = *GetParam();
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  if (command.name.starts_with("arm.")) {
    client.result({{"command", "scene.load"}, {"scene", "ur5e_on_table"}});
  } else {
    client.result({{"command", "scene.new"}, {"hand", "parallel_jaw"}});
    client.result({{"command", "object.set"}, {"generate", "box"}, {"triangles", 300}});
    client.result({{"command", "obstacle.add"},
                   {"name", "tower"},
                   {"generate", "box"},
                   {"X_world_body", {{"position", {1.0, 0.0, 0.0}}}}});
  }
  client.result({{"command", "hand.move"}, {"X_world_hand", {{"position", {0.0, 0.0, -0.4}}}}});
  if (command.name.starts_with("time.")) client.result({{"command", "time.start"}});
  const Reply before = client.result({{"command", "state"}});
  const std::size_t dofs = before["hand"]["dofs"].size();
  for (const CommandField& field : command.fields) {
    for (const double extreme : kExtremes) {
      for (const Reply& value : with_extreme(field, extreme, dofs)) {
        Reply request = plain_request(command, field, before);
        request[std::string(field.name)] = value;
        SCOPED_TRACE(request.dump());
        const Reply reply = client.reply(request);
        if (reply["ok"].get<bool>()) {
          EXPECT_TRUE(all_finite(reply["result"]));
        } else {
          EXPECT_FALSE(reply["error"]["problem"].get<std::string>().empty());
        }
        const Reply after = client.result({{"command", "state"}});
        expect_places(after);
      }
    }
  }
}

std::vector<const Command*> commands_with_numbers() {
  std::vector<const Command*> found;
  for (const Command& command : commands()) {
    for (const CommandField& field : command.fields) {
      if (!is_number(field.type)) continue;
      found.push_back(&command);
      break;
    }
  }
  return found;
}

INSTANTIATE_TEST_SUITE_P(Commands, ExtremesOf, testing::ValuesIn(commands_with_numbers()),
                         [](const auto& tested) {
                           std::string name(tested.param->name);
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

TEST(Commands, SayTheRangeOfEachNumber) {
  for (const Command& command : commands()) {
    for (const CommandField& field : command.fields) {
      if (!is_number(field.type) || field.type == FieldType::pose) continue;
      EXPECT_TRUE(std::isfinite(field.range.lower) && std::isfinite(field.range.upper))
          << command.name << " " << field.name;
    }
  }
}

TEST(Commands, AHandThatBacksOffAgainAndAgainStaysWithinTheLimits) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  client.result({{"command", "scene.new"}, {"hand", "parallel_jaw"}});
  client.result({{"command", "object.set"}, {"generate", "box"}, {"triangles", 300}});
  int refused = 0;
  for (int i = 0; i < 4; ++i) {
    const Reply reply = client.reply({{"command", "hand.back_off"}, {"distance", 4e5}});
    if (!reply["ok"].get<bool>()) ++refused;
  }
  EXPECT_GE(refused, 1);
  expect_places(client.result({{"command", "state"}}));
}

}  // namespace
}  // namespace prehend::test
