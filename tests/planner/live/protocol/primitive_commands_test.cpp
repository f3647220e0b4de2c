// Which shapes a session says that its object is taken for.
#include <algorithm>

#include <gtest/gtest.h>

#include "planner/live/protocol/session_endpoint.h"
#include "planner/plan/object_primitives.h"
#include "planner/plan/search_settings.h"
#include "sim/scene/json_primitive.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"
#include "tests/planner/live/protocol/listening_client.h"

namespace prehend {
namespace {

using test::ListeningClient;
using test::Reply;

const Reply kAsk{{"command", "primitives"}};

TEST(PrimitiveCommands, ABoxIsOneBoxAtNoDistance) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  const Reply state =
      client.result({{"command", "object.set"},
                     {"format", "obj"},
                     {"unit", "m"},
                     {"mesh_text",
                      "v 0 0 0\nv 0.06 0 0\nv 0.06 0.04 0\nv 0 0.04 0\nv 0 0 0.1\nv 0.06 0 0.1\n"
                      "v 0.06 0.04 0.1\nv 0 0.04 0.1\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\n"
                      "f 3 4 8 7\nf 4 1 5 8\n"}});
  const Reply found = client.result(kAsk);
  EXPECT_EQ(found["surface"], state["object"]["surface"]);
  ASSERT_EQ(found["primitives"].size(), 1U);
  const Reply& box = found["primitives"][0];
  EXPECT_EQ(box["shape"], "box");
  auto size = box["size"].get<std::vector<double>>();
  std::sort(size.begin(), size.end());
  const std::vector<double> sides = {0.04, 0.06, 0.1};
  const std::vector<double> middle = {0.03, 0.02, 0.05};
  for (std::size_t i = 0; i < 3; ++i) {
    // Sizes are fitted to the vertices up to rounding.
    EXPECT_NEAR(size[i], sides[i], 1e-6);
    EXPECT_NEAR(box["pose"]["position"][i].get<double>(), middle[i], 1e-6);
  }
  EXPECT_NEAR(box["share"].get<double>(), 1.0, 1e-9);
  for (const Reply& distances : {box["distances"], found["distances"]}) {
    EXPECT_LE(distances["median"], distances["percentile_95"]);
    EXPECT_LE(distances["percentile_95"], distances["largest"]);
    EXPECT_LT(distances["largest"], 1e-6);
  }
}

// Rims and bars come last, and nobody has measured how far the surface is from them.
TEST(PrimitiveCommands, OfAMugAreThoseOfItsPlan) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  client.result({{"command", "scene.load"}, {"scene", "mug"}});
  const Reply found = client.result(kAsk);
  const CompiledScene scene = compile(load_scene(find_scene("mug")));
  const PlanOptions options = search_settings({});
  const ObjectPrimitives planned = object_primitives(scene, options.primitives, options.thin_parts);
  ASSERT_EQ(found["primitives"].size(), planned.all.size());
  const std::size_t solids = planned.solids->primitives.size();
  EXPECT_LT(solids, planned.all.size());
  for (std::size_t k = 0; k < planned.all.size(); ++k) {
    Reply one = found["primitives"][k];
    EXPECT_EQ(one["share"].is_null(), k >= solids);
    EXPECT_EQ(one["distances"].is_null(), k >= solids);
    if (k < solids) {
      EXPECT_EQ(one["share"], planned.solids->share[k]);
      EXPECT_EQ(one["distances"]["median"], planned.solids->distances_of[k].median);
    }
    one.erase("share");
    one.erase("distances");
    EXPECT_EQ(one, Reply(primitive_to_json(planned.all[k])));
  }
  EXPECT_EQ(found["distances"]["percentile_95"], planned.solids->distances.percentile_95);
  // They are of the object's frame, so that they stay where it is moved.
  client.result({{"command", "switches.set"}, {"stop_at_contact", false}});
  client.result({{"command", "object.move"}, {"X_world_object", {{"position", {0.3, 0, 0.2}}}}});
  EXPECT_EQ(client.result(kAsk), found);
}

TEST(PrimitiveCommands, AnotherObjectHasOthers) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  for (const char* generated : {"ball", "cylinder", "ball"}) {
    const Reply state =
        client.result({{"command", "object.set"}, {"generate", generated}, {"triangles", 600}});
    const Reply found = client.result(kAsk);
    EXPECT_EQ(found["surface"], state["object"]["surface"]);
    ASSERT_EQ(found["primitives"].size(), 1U);
    EXPECT_EQ(found["primitives"][0]["shape"] == "sphere", generated == std::string("ball"));
  }
}

TEST(PrimitiveCommands, StatedOnesAreAsTheSceneSays) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  const auto load = [&](double radius) {
    Reply scene =
        Reply::parse(client.result({{"command", "scene.text"}})["text"].get<std::string>());
    scene["object"]["primitives"] = Reply::array({{{"shape", "sphere"}, {"radius", radius}}});
    client.result({{"command", "scene.load"}, {"text", scene.dump()}});
  };
  client.result({{"command", "object.set"}, {"generate", "ball"}, {"triangles", 600}});
  const Reply measured = client.result(kAsk);
  EXPECT_FALSE(measured["distances"].is_null());
  for (const double radius : {0.02, 0.03}) {
    load(radius);
    const Reply found = client.result(kAsk);
    EXPECT_TRUE(found["distances"].is_null());
    ASSERT_EQ(found["primitives"].size(), 1U);
    EXPECT_EQ(found["primitives"][0]["radius"], radius);
    EXPECT_TRUE(found["primitives"][0]["distances"].is_null());
  }
}

TEST(PrimitiveCommands, WithoutAnObjectThereAreNone) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  EXPECT_EQ(client.reply(kAsk)["error"]["problem"], "there is no object");
  client.result({{"command", "object.set"}, {"generate", "ball"}, {"triangles", 600}});
  client.result(kAsk);
  client.result({{"command", "object.remove"}});
  EXPECT_EQ(client.reply(kAsk)["error"]["field"], "scene");
}

// An object in an obstacle, with which nothing can be planned, still has its shape.
TEST(PrimitiveCommands, ASceneThatIsNotReadyHasThemAsWell) {
  SessionEndpoint endpoint({});
  ListeningClient client(endpoint);
  client.result({{"command", "obstacle.add"}, {"generate", "box"}, {"name", "wall"}});
  const Reply state =
      client.result({{"command", "object.set"}, {"generate", "ball"}, {"triangles", 600}});
  ASSERT_FALSE(state["problem"].is_null());
  EXPECT_EQ(client.result(kAsk)["primitives"].size(), 1U);
}

}  // namespace
}  // namespace prehend
