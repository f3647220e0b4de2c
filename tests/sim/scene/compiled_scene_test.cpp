// What is prepared before trials, and what is refused.
#include "sim/scene/compiled_scene.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/robot/files/robot_file.h"
#include "sim/shape/basic_shapes.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

using test::scene_with;

std::string refusal(const Scene& scene) {
  try {
    compile(scene);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

Scene jaw_scene() { return scene_with(find_robot("parallel_jaw"), make_box({0.03, 0.04, 0.05})); }

TEST(CompiledScene, RefusesARobotThatIsNoHand) {
  Scene scene = jaw_scene();
  scene.hand.hand.reset();
  EXPECT_EQ(refusal(scene), "parallel_jaw: hand: the robot is not a hand");
}

TEST(CompiledScene, RefusesAnUnknownMaterialOfALink) {
  Scene scene = jaw_scene();
  scene.hand.links[1].material = "cheese";
  EXPECT_EQ(
      refusal(scene),
      "parallel_jaw: link left_plate: unknown material, known are glass, metal, plastic, wood "
      "and rubber (cheese)");
}

TEST(CompiledScene, RefusesALinkWithoutTriangles) {
  Scene scene = jaw_scene();
  scene.hand.links[2].mesh = {};
  EXPECT_EQ(refusal(scene), "parallel_jaw: link right_plate: has no triangles");
}

TEST(CompiledScene, RefusesAPreshapeInWhichLinksCollide) {
  Scene scene = jaw_scene();
  scene.hand.hand->preshapes.push_back({.name = "crossed", .dofs = {-0.001, 0.0}});
  EXPECT_EQ(refusal(scene),
            "parallel_jaw: preshape crossed: links left_plate and right_plate collide");
}

TEST(CompiledScene, RefusesAnObjectWithoutExtent) {
  Scene scene = jaw_scene();
  for (Vector3& p : scene.object.mesh.vertices) p = scene.object.center_of_mass;
  EXPECT_EQ(refusal(scene), scene.name + ": object: has no extent (object)");
}

TEST(CompiledScene, ScalesTorqueByTheFarthestVertexFromTheCentreOfMass) {
  const CompiledScene scene = compile(jaw_scene());
  EXPECT_LT(scene.wrench_frame.torque_origin.norm(), 1e-15);
  EXPECT_NEAR(scene.wrench_frame.torque_scale, 2.0 / Vector3(0.03, 0.04, 0.05).norm(), 1e-10);
}

TEST(CompiledScene, TakesFrictionBetweenEachLinkAndTheObject) {
  Scene scene = jaw_scene();
  scene.friction.set(Material::plastic, Material::rubber, 0.9);
  const CompiledScene compiled = compile(scene);
  EXPECT_EQ(compiled.links[0].friction, 0.2);  // metal palm on plastic
  EXPECT_EQ(compiled.links[1].friction, 0.9);
}

TEST(CompiledScene, PlacesObstaclesInTheFrameOfTheObject) {
  Random random(131);
  Scene scene = jaw_scene();
  scene.object.X_WO = random.pose(0.4);
  StaticBody body = test::obstacle(make_box({0.1, 0.1, 0.1}), Vector3::Zero());
  body.X_WB = random.pose(0.4);
  scene.obstacles = {body};
  const CompiledScene compiled = compile(scene);
  const Vector3 p(0.01, 0.02, 0.03);
  EXPECT_LT((scene.object.X_WO * (compiled.obstacles()[0].X_RB * p) - body.X_WB * p).norm(), 1e-15);
}

TEST(CompiledScene, KnowsWhatHasAnInside) {
  Scene scene = jaw_scene();
  scene.obstacles = {test::obstacle(make_box({0.1, 0.1, 0.1}), {1.0, 0.0, 0.0})};
  scene.obstacles.push_back(scene.obstacles[0]);
  scene.obstacles[1].mesh.triangles.pop_back();
  append(scene.object.mesh, test::block({0.01, 0.01, 0.01}, {0.1, 0.0, 0.0}));
  scene.object.mesh.vertices.push_back({9.0, 9.0, 9.0});  // of no triangle
  const CompiledScene compiled = compile(scene);
  EXPECT_TRUE(compiled.object().is_solid);
  EXPECT_EQ(compiled.object().probes.size(), 2U);
  EXPECT_TRUE(compiled.obstacles()[0].is_solid);
  EXPECT_FALSE(compiled.obstacles()[1].is_solid);
  EXPECT_EQ(compiled.obstacles()[1].probes.size(), 1U);
}

std::set<std::string> pair_names(const CompiledScene& scene) {
  std::set<std::string> names;
  for (const LinkPair& pair : scene.self_pairs) {
    names.insert(scene.links[static_cast<std::size_t>(pair.a)].name + " " +
                 scene.links[static_cast<std::size_t>(pair.b)].name);
  }
  return names;
}

TEST(CompiledScene, PairsAllLinksButNeighboursInAChain) {
  EXPECT_EQ(pair_names(compile(jaw_scene())), std::set<std::string>{"left_plate right_plate"});
  const CompiledScene barrett =
      compile(scene_with(find_robot("barrett"), make_box({0.03, 0.04, 0.05})));
  const auto names = pair_names(barrett);
  // 9 links: of 36 pairs, 3 + 3 + 2 are neighbours.
  EXPECT_EQ(names.size(), 28U);
  for (const char* apart : {"palm proximal_1", "palm distal_3", "knuckle_1 knuckle_2",
                            "knuckle_1 distal_1", "proximal_1 proximal_3"}) {
    EXPECT_TRUE(names.contains(apart)) << apart;
  }
  for (const char* joined : {"palm knuckle_1", "palm proximal_3", "proximal_3 distal_3"}) {
    EXPECT_FALSE(names.contains(joined)) << joined;
  }
}

TEST(CompiledScene, KnowsTheGapsOfEachPreshape) {
  const CompiledScene scene =
      compile(scene_with(find_robot("barrett"), make_box({0.03, 0.04, 0.05})));
  const auto& preshapes = scene.scene.hand.hand->preshapes;
  ASSERT_EQ(scene.preshape_gaps.size(), preshapes.size());
  for (std::size_t s = 0; s < preshapes.size(); ++s) {
    const auto links = test::link_soups(scene, Pose::Identity(),
                                        joint_values(scene.scene.hand, preshapes[s].dofs));
    for (std::size_t p = 0; p < scene.self_pairs.size(); ++p) {
      const double gap = test::surface_gap(links[static_cast<std::size_t>(scene.self_pairs[p].a)],
                                           links[static_cast<std::size_t>(scene.self_pairs[p].b)]);
      EXPECT_NEAR(scene.preshape_gaps[s][p], gap, 1e-12);
    }
  }
}

// The bound that conservative steps rest on: no vertex ever moves farther than the reaches say.
TEST(CompiledScene, ReachesBoundTheMotionOfEveryVertex) {
  Random random(132);
  for (const std::string& name : library_robot_names()) {
    const Robot robot = find_robot(name);
    if (!robot.hand) continue;
    const CompiledScene scene = compile(scene_with(robot, make_box({0.03, 0.04, 0.05})));
    for (int i = 0; i < 50; ++i) {
      std::vector<double> from;
      std::vector<double> to;
      for (const Joint& joint : robot.joints) {
        from.push_back(random.uniform(joint.lower, joint.upper));
        to.push_back(random.uniform(joint.lower, joint.upper));
      }
      const auto before = test::link_poses_in_object(scene, Pose::Identity(), from);
      const auto after = test::link_poses_in_object(scene, Pose::Identity(), to);
      for (std::size_t l = 0; l < scene.links.size(); ++l) {
        const CompiledLink& link = scene.links[l];
        double most = 1e-12;
        for (std::size_t k = 0; k < link.joints.size(); ++k) {
          const auto j = static_cast<std::size_t>(link.joints[k]);
          most += link.reach[k] * std::abs(to[j] - from[j]);
        }
        for (const Vector3& p : link.mesh.mesh().vertices) {
          ASSERT_LE((after[l] * p - before[l] * p).norm(), most) << name << " " << link.name;
        }
      }
    }
  }
}

}  // namespace
}  // namespace prehend
