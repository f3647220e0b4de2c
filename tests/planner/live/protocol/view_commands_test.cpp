// What a client that draws the session gets.
#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "planner/live/protocol/session_endpoint.h"
#include "sim/base/random.h"
#include "tests/planner/live/protocol/listening_client.h"
#include "tests/planner/show/report/unpack.h"

namespace prehend {
namespace {

using test::ListeningClient;
using test::Reply;

Reply surface_named(ListeningClient& client, const Reply& name) {
  return client.result({{"command", "view.surface"}, {"surface", name}})["mesh"];
}

TEST(ViewCommands, EqualSurfacesHaveOneName) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  client.result({{"command", "object.set"}, {"generate", "cylinder"}, {"triangles", 600}});
  const Reply add{{"command", "obstacle.add"}, {"generate", "cylinder"}, {"triangles", 600}};
  Reply named = add;
  named["name"] = "one";
  named["X_world_body"] = {{"position", {1, 0, 0}}};
  client.result(named);
  named["name"] = "two";
  named["triangles"] = 900;
  const Reply state = client.result(named);
  EXPECT_EQ(state["obstacles"][0]["surface"], state["object"]["surface"]);
  EXPECT_NE(state["obstacles"][1]["surface"], state["object"]["surface"]);
  // A place is not a part of a surface.
  const Reply moved = client.result({{"command", "obstacle.change"},
                                     {"name", "one"},
                                     {"X_world_body", {{"position", {2, 0, 0}}}}});
  EXPECT_EQ(moved["obstacles"][0]["surface"], state["obstacles"][0]["surface"]);
}

TEST(ViewCommands, ASurfaceIsThatOfTheBody) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  const Reply state =
      client.result({{"command", "object.set"}, {"generate", "ball"}, {"triangles", 500}});
  const TriangleMesh mesh = test::unpacked(surface_named(client, state["object"]["surface"]));
  EXPECT_EQ(Reply(mesh.triangles.size()), state["object"]["triangles"]);
  const Reply refused =
      client.reply({{"command", "view.surface"}, {"surface", "0123456789abcdef"}});
  EXPECT_EQ(refused["error"]["field"], "surface");
}

TEST(ViewCommands, RobotsHaveALinkForEachAndADriveForEachJoint) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  const Reply state = client.result({{"command", "state"}});
  const Reply robots = client.result({{"command", "view.robots"}});
  EXPECT_EQ(robots["robots"], state["robots"]);
  EXPECT_TRUE(robots["arm"].is_null());
  const Reply& hand = robots["hand"];
  ASSERT_EQ(hand["drives"].size(), hand["joints"].size());
  ASSERT_EQ(state["hand"]["joints"].size(), hand["joints"].size());
  // A drive says how a joint follows: here of the hand as it stands, where nothing touches.
  for (std::size_t j = 0; j < hand["drives"].size(); ++j) {
    const Reply& drive = hand["drives"][j];
    const double dof = state["hand"]["dofs"][drive["dof"].get<std::size_t>()]["value"];
    EXPECT_NEAR(drive["ratio"].get<double>() * dof + drive["offset"].get<double>(),
                state["hand"]["joints"][j].get<double>(), 1e-9);
  }
  const Reply other = client.result({{"command", "hand.choose"}, {"hand", "parallel_jaw"}});
  EXPECT_NE(other["robots"], state["robots"]);
}

TEST(ViewCommands, ThePlatformIsDrawnWithItsHand) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  client.result({{"command", "scene.load"}, {"scene", "panda_on_table"}});
  const Reply robots = client.result({{"command", "view.robots"}});
  ASSERT_TRUE(robots["arm"].is_object());
  EXPECT_EQ(robots["arm"]["drives"].size(), robots["arm"]["joints"].size());
  std::set<std::string> links;
  for (const Reply& link : robots["arm"]["links"]) links.insert(link["name"]);
  for (const Reply& link : robots["hand"]["links"]) {
    EXPECT_FALSE(links.contains(link["name"].get<std::string>())) << link["name"];
  }
}

// A convex polyhedron holds a ball about the origin where it reaches as far in every direction.
TEST(ViewCommands, SectionsOfTheWrenchSpaceHoldTheBallOfEpsilon) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  client.result({{"command", "scene.new"}, {"hand", "parallel_jaw"}});
  client.result({{"command", "object.set"}, {"generate", "cylinder"}, {"triangles", 600}});
  const Reply ask{{"command", "quality"}, {"sections", true}};
  const Reply flat = client.result(ask)["sections"];
  EXPECT_TRUE(flat["forces"]["vertices"].empty());
  client.result({{"command", "hand.approach"}});
  const Reply grasp = client.result({{"command", "hand.auto_grasp"}});
  ASSERT_EQ(grasp["outcome"], "stable");
  const double epsilon = grasp["epsilon"]["lower"];
  EXPECT_FALSE(client.result({{"command", "quality"}}).contains("sections"));
  const Reply wrenches = client.result(ask)["sections"];
  for (const char* section : {"forces", "torques"}) {
    const auto vertices = wrenches[section]["vertices"].get<std::vector<double>>();
    ASSERT_GE(vertices.size(), 12U) << section;
    Random random(1);
    for (int sample = 0; sample < 500; ++sample) {
      const Vector3 direction = random.direction();
      double reach = 0.0;
      for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) {
        reach = std::max(reach, direction.dot(Vector3(vertices.data() + i)));
      }
      EXPECT_GT(reach, epsilon - 1e-3) << section;  // coordinates are rounded
    }
  }
}

TEST(ViewCommands, APinIsGoneBackTo) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  client.result({{"command", "object.set"}, {"generate", "ball"}, {"triangles", 500}});
  const Reply before = client.result({{"command", "state"}});
  client.result({{"command", "pin.add"}, {"name", "here"}});
  client.result({{"command", "hand.move"}, {"X_world_hand", {{"position", {0.3, 0.3, 0.6}}}}});
  const Reply back = client.result({{"command", "pin.go"}, {"name", "here"}});
  EXPECT_EQ(back["hand"], before["hand"]);
  EXPECT_EQ(client.reply({{"command", "pin.go"}, {"name", "there"}})["error"]["field"], "name");
  client.result({{"command", "hand.choose"}, {"hand", "parallel_jaw"}});
  EXPECT_EQ(client.reply({{"command", "pin.go"}, {"name", "here"}})["error"]["field"], "name");
}

TEST(ViewCommands, AFreshSceneHasNothingToUndo) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  const Reply later = client.result({{"command", "scene.load"}, {"scene", "mug"}});
  EXPECT_EQ(later["undo"], 1);
  const Reply fresh = client.result({{"command", "scene.load"}, {"scene", "mug"}, {"fresh", true}});
  EXPECT_EQ(fresh["undo"], 0);
  EXPECT_EQ(client.result({{"command", "undo"}})["done"], false);
}

// The same triangle as text, in base64 and, with both, refused.
TEST(ViewCommands, AMeshMayBeSentInBase64) {
  const std::string text =
      "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  const std::string coded =
      "diAwIDAgMAp2IDAuMSAwIDAKdiAwIDAuMSAwCnYgMCAwIDAuMQpmIDEgMyAyCmYgMSAyIDQKZiAyIDMgNApmIDEg"
      "NCAzCg==";
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  const Reply by_text = client.result(
      {{"command", "object.set"}, {"mesh_text", text}, {"format", "obj"}, {"unit", "m"}});
  const Reply by_base64 = client.result(
      {{"command", "object.set"}, {"mesh_base64", coded}, {"format", "obj"}, {"unit", "m"}});
  EXPECT_EQ(by_base64["object"], by_text["object"]);
  const Reply both = client.reply(
      {{"command", "object.set"}, {"mesh_text", text}, {"mesh_base64", coded}, {"format", "obj"}});
  EXPECT_EQ(both["error"]["field"], "mesh_base64");
  const Reply damaged =
      client.reply({{"command", "object.set"}, {"mesh_base64", "%%"}, {"format", "obj"}});
  EXPECT_EQ(damaged["error"]["field"], "mesh_base64");
}

}  // namespace
}  // namespace prehend
