// The second opinion on paths: it agrees with our own trees where both look, and sees what no proof
// was asked for.
#include "planner/plan/path/second_check.h"

#include <gtest/gtest.h>

#include "planner/plan/path/arm_path.h"
#include "planner/plan/path/check_path.h"
#include "planner/plan/path/fcl_mesh.h"
#include "sim/base/random.h"
#include "sim/motion/control/time_path.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/make_scene.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/proximity.h"

namespace prehend {
namespace {

// The Panda beside a post and a ball.
CompiledScene panda_and_post() {
  Scene scene;
  scene.name = "panda";
  scene.object = nothing_to_grasp();
  mount(scene, "panda");
  add_obstacle(scene, "post", make_box({0.05, 0.05, 0.9}), translation({0.22, 0.22, 0.45}));
  add_obstacle(scene, "ball", make_sphere(0.1), translation({-0.3, 0.5, 0.5}));
  return compile(scene);
}

bool crosses(const SecondCheck& check, const CompiledArm& arm, const ArmPair& pair,
             const std::vector<Pose>& X_BL) {
  const FclMesh& mesh = check.link(pair.link);
  const Pose& X_BA = X_BL[index(pair.link)];
  if (const LinkId* link = std::get_if<LinkId>(&pair.other)) {
    return mesh.crosses(X_BA, check.link(*link), X_BL[index(*link)]);
  }
  const BodyId body = std::get<BodyId>(pair.other);
  return mesh.crosses(X_BA, check.body(body), arm.body(body).X_RB);
}

// The same by our own trees.
bool own_cross(const CompiledArm& arm, const ArmPair& pair, const std::vector<Pose>& X_BL) {
  const ProximityMesh& mesh = arm.links[index(pair.link)].mesh;
  const Pose X_AB = X_BL[index(pair.link)].inverse();
  if (const LinkId* link = std::get_if<LinkId>(&pair.other)) {
    return surfaces_cross(mesh, arm.links[index(*link)].mesh, X_AB * X_BL[index(*link)]);
  }
  const PlacedBody& body = arm.body(std::get<BodyId>(pair.other));
  return surfaces_cross(mesh, body.mesh, X_AB * body.X_RB);
}

TEST(SecondCheck, AgreesWithOurOwnTrees) {
  const CompiledScene scene = panda_and_post();
  const CompiledArm& arm = *scene.arm;
  const SecondCheck check(arm);
  Random random(3);
  int crossing = 0;
  int different = 0;
  for (int n = 0; n < 300; ++n) {
    DofValues dofs;
    for (const DegreeOfFreedom& dof : arm.robot().dofs) {
      dofs.push_back(random.uniform(dof.lower, dof.upper));
    }
    std::vector<Pose> X_BL;
    arm_link_poses(arm, joint_values(arm.robot(), dofs), X_BL);
    for (const auto* pairs : {&arm.arm_pairs, &arm.hand_pairs}) {
      for (const ArmPair& pair : *pairs) {
        const bool own = own_cross(arm, pair, X_BL);
        crossing += int{own};
        different += int{own != crosses(check, arm, pair, X_BL)};
      }
    }
  }
  EXPECT_GT(crossing, 50);
  EXPECT_EQ(different, 0);
}

// A path that nobody proved: straight through the post.
Trajectory through_the_post(const CompiledScene& scene) {
  const CompiledArm& arm = *scene.arm;
  DofValues there = arm.start;
  there[0] = 1.5;
  const std::vector<double> from = joint_values(arm.robot(), arm.start);
  const std::vector<double> to = joint_values(arm.robot(), there);
  const JointLimits limits{std::vector<double>(from.size(), 1.0),
                           std::vector<double>(from.size(), 1.0)};
  Trajectory path;
  for (const Joint& joint : arm.robot().joints) path.joints.push_back(joint.name);
  append(path, "transfer", time_path({from, to}, PathKind::corners, limits));
  return path;
}

TEST(SecondCheck, FindsWhatAPathRunsInto) {
  const CompiledScene scene = panda_and_post();
  const Trajectory path = through_the_post(scene);
  const PathCheck check = check_path(scene, path);
  EXPECT_GT(check.collisions, 0);
  EXPECT_LT(check.collisions, check.postures);
  EXPECT_NE(check.first_collision.find("meets post"), std::string::npos) << check.first_collision;
  EXPECT_FALSE(check.ok());
  const PathCheck limits = check_path(scene, path, {.collisions = false});
  EXPECT_EQ(limits.postures, 0);
  EXPECT_TRUE(limits.ok());
  EXPECT_EQ(limits.velocity, check.velocity);
}

}  // namespace
}  // namespace prehend
