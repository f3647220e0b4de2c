// A recorded session as keyframes.
#include "planner/live/protocol/session_film.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "planner/live/protocol/recording.h"
#include "sim/base/random.h"
#include "sim/robot/platform.h"
#include "sim/scene/compiled_arm.h"
#include "tests/support/glb_file.h"

namespace prehend::test {
namespace {

struct Filmed {
  SceneFilm film;
  std::vector<SessionState> states;  // the session at each moment
};

Filmed filmed(const std::vector<nlohmann::json>& commands) {
  Filmed filmed;
  std::string recording;
  for (const nlohmann::json& command : commands) recording += command.dump() + "\n";
  const Replayed replayed =
      replay(recording, "recording", {}, {}, [&filmed](const Session& session) {
        add_moment(filmed.film, session);
        filmed.states.push_back(session.state());
      });
  EXPECT_EQ(replayed.refused, 0);
  EXPECT_EQ(filmed.film.moment_count(), filmed.states.size());
  return filmed;
}

nlohmann::json pose_json(const Pose& X) {
  const Eigen::Quaterniond q = quaternion_of(X);
  const Vector3& p = X.translation();
  return {{"position", {p.x(), p.y(), p.z()}}, {"quaternion_wxyz", {q.w(), q.x(), q.y(), q.z()}}};
}

// The first of this name below the world.
const AnimatedNode& root(const SceneFilm& film, const std::string& name) {
  for (const AnimatedNode& node : film.nodes()) {
    if (node.name == name && node.parent < 0) return node;
  }
  ADD_FAILURE() << "no node " << name;
  return film.nodes().front();
}

// Of a node in the world, `share` of the way from moment m to the next, as glTF has it: along a
// straight line, turned evenly.
Pose X_WN(const SceneFilm& film, std::size_t n, std::size_t m, double share = 0.0) {
  const AnimatedNode& node = film.nodes()[n];
  const bool moves = node.X_PN.size() > 1;
  const Pose& from = node.X_PN[moves ? m : 0];
  Pose X = from;
  if (share > 0.0 && moves) {
    const Pose& to = node.X_PN[m + 1];
    X = pose_from(quaternion_of(from).slerp(share, quaternion_of(to)).toRotationMatrix(),
                  (1.0 - share) * from.translation() + share * to.translation());
  }
  return node.parent < 0 ? X : X_WN(film, static_cast<std::size_t>(node.parent), m, share) * X;
}

// Which node below a robot's has this name and a mesh.
std::size_t link_node(const SceneFilm& film, const std::string& name) {
  for (std::size_t n = film.nodes().size(); n-- > 0;) {
    const AnimatedNode& node = film.nodes()[n];
    if (node.name == name && node.parent >= 0 && !node.mesh->empty()) return n;
  }
  ADD_FAILURE() << "no link " << name;
  return 0;
}

void expect_hand_at(const Filmed& session, std::size_t m, double share, const HandPosture& hand) {
  const EditedScene& world = *session.states[m].world;
  std::vector<Pose> X_HL;
  link_poses(world.scene().hand, hand.joints, X_HL);
  for (std::size_t l = 0; l < X_HL.size(); ++l) {
    const std::string& name = world.scene().hand.links[l].name;
    const Pose X_WL = world.X_WO() * hand.X_OH * X_HL[l];
    const Pose X = X_WN(session.film, link_node(session.film, name), m, share);
    EXPECT_TRUE(X.isApprox(X_WL, 1e-9)) << name << " at moment " << m;
  }
}

TEST(SessionFilm, AMoveOfTheHandIsAKeyWithItsPose) {
  Random random(3);
  std::vector<nlohmann::json> commands;
  std::vector<Pose> poses;
  for (int k = 0; k < 10; ++k) {
    poses.push_back(random.pose(1.0));
    commands.push_back({{"command", "hand.move"}, {"X_world_hand", pose_json(poses.back())}});
    commands.push_back({{"command", "state"}});  // changes nothing, and has no key
  }
  const Filmed session = filmed(commands);
  ASSERT_EQ(session.film.moment_count(), 11);
  const AnimatedNode& hand = root(session.film, "barrett");
  for (std::size_t k = 0; k < poses.size(); ++k) {
    EXPECT_TRUE(hand.X_PN[k + 1].isApprox(poses[k], 1e-12));
  }
}

TEST(SessionFilm, LinksAreWhereTheHandHasThemAlsoBetweenKeys) {
  Random random(4);
  std::vector<nlohmann::json> commands;
  for (int k = 0; k < 5; ++k) {
    commands.push_back({{"command", "hand.dofs"},
                        {"dofs",
                         {random.uniform(0.0, 3.0), random.uniform(0.0, 2.4),
                          random.uniform(0.0, 2.4), random.uniform(0.0, 2.4)}}});
    commands.push_back({{"command", "switches.set"}, {"stop_at_contact", k % 2 == 0}});
    commands.push_back({{"command", "hand.move"}, {"X_world_hand", pose_json(random.pose(1.0))}});
  }
  const Filmed session = filmed(commands);
  ASSERT_EQ(session.film.moment_count(), 16);
  for (std::size_t m = 0; m < session.states.size(); ++m) {
    expect_hand_at(session, m, 0.0, session.states[m].hand);
    if (m + 1 == session.states.size()) break;
    // The session's own way from one posture to the next.
    for (const double share : {0.25, 0.5, 0.9}) {
      expect_hand_at(session, m, share,
                     between(session.states[m].hand, session.states[m + 1].hand, share));
    }
  }
}

TEST(SessionFilm, BodiesAndHandsComeAndGo) {
  const nlohmann::json at = pose_json(translation(Vector3(1.0, 0.0, 0.0)));
  const Filmed session = filmed({
      {{"command", "object.set"}, {"generate", "ball"}, {"triangles", 300}},  // 1
      {{"command", "obstacle.add"}, {"name", "wall"}, {"generate", "box"}, {"X_world_body", at}},
      {{"command", "hand.choose"}, {"hand", "parallel_jaw"}},               // 3
      {{"command", "object.set"}, {"generate", "box"}, {"triangles", 12}},  // 4
      {{"command", "obstacle.remove"}, {"name", "wall"}},                   // 5
      {{"command", "undo"}},                                                // 6
      {{"command", "undo"}},                                                // 7: the ball
  });
  using Shown = std::vector<bool>;
  const SceneFilm& film = session.film;
  EXPECT_EQ(root(film, "barrett").shown, (Shown{1, 1, 1, 0, 0, 0, 0, 0}));
  EXPECT_EQ(root(film, "parallel_jaw").shown, (Shown{0, 0, 0, 1, 1, 1, 1, 1}));
  EXPECT_EQ(root(film, "ball").shown, (Shown{0, 1, 1, 1, 0, 0, 0, 1}));
  EXPECT_EQ(root(film, "box").shown, (Shown{0, 0, 0, 0, 1, 1, 1, 0}));
  EXPECT_EQ(root(film, "wall").shown, (Shown{0, 0, 1, 1, 1, 0, 1, 1}));
  EXPECT_EQ(root(film, "wall").X_PN.front().translation(), Vector3(1.0, 0.0, 0.0));
}

TEST(SessionFilm, TheArmIsWhereTheSessionHasIt) {
  const Filmed session = filmed(
      {{{"command", "scene.load"}, {"scene", "mug_on_table"}}, {{"command", "hand.back_off"}}});
  const CompiledArm& arm = *session.states.back().world->compiled().arm;
  std::vector<Pose> X_BL;
  arm_link_poses(arm, joint_values(arm.robot(), session.states.back().arm->dofs), X_BL);
  int links = 0;
  for (std::size_t l = 0; l < X_BL.size(); ++l) {
    const std::string& name = arm.robot().links[l].name;
    if (arm.is_hand_link(link_id(l))) {
      for (const AnimatedNode& node : session.film.nodes()) EXPECT_NE(node.name, name);
      continue;
    }
    const Pose X = X_WN(session.film, link_node(session.film, name), 2);
    EXPECT_TRUE(X.isApprox(arm.X_WB * X_BL[l], 1e-9)) << name;
    ++links;
  }
  EXPECT_GT(links, 5);
}

TEST(SessionFilm, ACommandTakesAQuarterOfASecond) {
  const Filmed session = filmed({
      {{"command", "hand.move"}, {"X_world_hand", pose_json(translation(Vector3(0.0, 0.0, 1.0)))}},
      {{"command", "hand.move"}, {"X_world_hand", pose_json(translation(Vector3(0.0, 1.0, 1.0)))}},
  });
  const Glb glb(session_glb(session.film));
  const nlohmann::json& animation = glb.document["animations"][0];
  ASSERT_EQ(animation["channels"].size(), 1);  // the hand moves, and neither turns nor bends
  EXPECT_EQ(glb.entry("nodes", animation["channels"][0]["target"]["node"])["name"], "barrett");
  const nlohmann::json& sampler = animation["samplers"][0];
  EXPECT_EQ(glb.numbers(sampler["input"], 1), (std::vector<float>{0.0F, 0.25F, 0.5F}));
  const std::vector<float> p = glb.numbers(sampler["output"], 3);
  EXPECT_EQ(std::vector<float>(p.begin() + 3, p.end()), (std::vector<float>{0, 0, 1, 0, 1, 1}));
}

}  // namespace
}  // namespace prehend::test
