// Plans of objects whose surface has parts of other materials.
#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

#include "planner/plan/plan.h"
#include "sim/quality/wrench_space.h"
#include "sim/trial/grasp_contacts.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

// What lies beyond z = 0.
SurfaceRegion upper_side() {
  SurfaceRegion region;
  region.beyond = BeyondPlane{Vector3::Zero(), Vector3::UnitZ()};
  return region;
}

SurfaceRegion all_around() {
  SurfaceRegion region;
  region.inside = {Sphere{1.0}};
  return region;
}

// A block along z, between jaws of rubber.
Scene slim_block() {
  return test::scene_with(find_robot("parallel_jaw"), make_box({0.03, 0.04, 0.15}));
}

PlanOptions short_search() {
  PlanOptions options;
  options.search.trials = 120;
  options.rank.top = 40;
  options.volumes = false;
  return options;
}

void expect_equal_grasps(const PlanResult& a, const PlanResult& b) {
  ASSERT_EQ(a.grasps.size(), b.grasps.size());
  ASSERT_FALSE(a.grasps.empty());
  for (std::size_t i = 0; i < a.grasps.size(); ++i) {
    const Trial& one = a.grasps[i].trial;
    const Trial& other = b.grasps[i].trial;
    EXPECT_EQ(one.epsilon.lower, other.epsilon.lower);
    EXPECT_EQ(one.X_OH.matrix(), other.X_OH.matrix());
    ASSERT_EQ(one.contacts.size(), other.contacts.size());
    for (std::size_t c = 0; c < one.contacts.size(); ++c) {
      EXPECT_EQ(one.contacts[c].point.position, other.contacts[c].point.position);
      EXPECT_EQ(one.contacts[c].point.friction, other.contacts[c].point.friction);
      EXPECT_EQ(one.contacts[c].point.torsion, other.contacts[c].point.torsion);
    }
  }
}

// Whether it is the body or one region that says what all of the object is made of.
TEST(PlanSurfaces, ARegionThatIsTheWholeObjectIsAnObjectOfThatMaterial) {
  for (const Material material : {Material::glass, Material::rubber}) {
    Scene of_material = slim_block();
    of_material.object.material = material;
    Scene of_region = slim_block();
    of_region.object.surfaces.push_back({all_around(), {material}});
    expect_equal_grasps(plan(compile(of_material), short_search()),
                        plan(compile(of_region), short_search()));
  }
}

TEST(PlanSurfaces, ARegionThatIsTheWholeLinkIsALinkOfThatMaterial) {
  Scene of_material = slim_block();
  Scene of_region = slim_block();
  for (Link& link : of_material.hand.links) {
    if (link.name != "left_plate") continue;
    link.material = "wood";
    of_region.link_surfaces.push_back({link.name, {{all_around(), {Material::wood}}}});
  }
  ASSERT_EQ(of_region.link_surfaces.size(), 1U);
  expect_equal_grasps(plan(compile(of_material), short_search()),
                      plan(compile(of_region), short_search()));
}

TEST(PlanSurfaces, EachContactHasTheFrictionOfTheMaterialUnderIt) {
  Scene scene = slim_block();
  SurfaceMaterial wet{Material::plastic, "wet"};
  wet.friction[Material::rubber] = 0.25;
  scene.object.surfaces.push_back({upper_side(), wet});
  scene.friction_deviations.set(Material::plastic, Material::rubber, 0.4);
  const Robot hand = scene.hand;
  const PlanResult result = plan(compile(std::move(scene)), short_search());
  bool straddles = false;
  for (const ScoredGrasp& grasp : result.grasps) {
    bool above = false;
    bool below = false;
    for (const GraspContact& contact : grasp.trial.contacts) {
      if (hand.links[index(contact.link)].material != "rubber") continue;  // the palm
      const bool is_above = contact.point.position.z() >= -SurfaceRegions::kMargin;
      EXPECT_EQ(contact.point.friction, is_above ? 0.25 : 1.0);
      EXPECT_EQ(contact.point.friction_deviation, 0.4);
      (is_above ? above : below) = true;
    }
    straddles = straddles || (above && below);
  }
  EXPECT_TRUE(straddles);
}

// A pad on both materials holds at least as well as one on the slippery one alone, and at most as
// well as one on the other alone: its regions are parts of theirs.
TEST(PlanSurfaces, AGraspOfTwoMaterialsIsBetweenThoseOfEach) {
  Scene scene = slim_block();
  SurfaceMaterial wet{Material::plastic, "wet"};
  wet.friction.entries.fill(0.25);
  const CompiledScene dry = compile(scene);
  scene.object.surfaces = {{all_around(), wet}};
  const CompiledScene all_wet = compile(scene);
  scene.object.surfaces = {{upper_side(), wet}};
  const CompiledScene half_wet = compile(scene);
  const PlanResult found = plan(dry, short_search());
  int between = 0;
  for (const ScoredGrasp& grasp : found.grasps) {
    const auto epsilon = [&](const CompiledScene& in) {
      const std::vector<GraspContact> contacts =
          grasp_contacts(in, grasp.trial.X_OH, grasp.trial.joints, test::kDefaultTrial);
      return grasp_epsilon(contacts_of(contacts), in.wrench_frame, {}).lower;
    };
    const double most = epsilon(dry);
    const double least = epsilon(all_wet);
    const double both = epsilon(half_wet);
    // Soft patches are of the material at their centre, and corners are left out of regions.
    EXPECT_LE(both, 1.02 * most);
    EXPECT_GE(both, 0.98 * least);
    if (both > 1.02 * least && both < 0.98 * most) ++between;
  }
  EXPECT_GT(between, 0);
}

}  // namespace
}  // namespace prehend
