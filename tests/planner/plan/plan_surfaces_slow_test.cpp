// The scenes of the library with parts of other materials: a screwdriver whose handle is of rubber
// and a glass with a wet stripe, against the same without these parts.
#include <algorithm>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "planner/plan/plan.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/scene_file.h"

namespace prehend {
namespace {

struct RegionTouch {
  double in_region = 0.0;  // share of the contacts of the best grasps
  double epsilon = 0.0;    // of the first
};

// Plans with or without the parts, and looks where the ten best grasps touch.
RegionTouch touch_of_best(const std::string& name, bool with_parts) {
  Scene scene = load_scene(name);
  const SurfaceRegions regions({scene.object.surfaces.front().where});
  if (!with_parts) scene.object.surfaces.clear();
  PlanOptions options;
  options.rank.top = 10;
  options.search.settled = 1.0;  // ten of the best there are
  options.volumes = false;
  const PlanResult result = plan(compile(std::move(scene)), options);
  RegionTouch touch;
  double contacts = 0.0;
  for (const ScoredGrasp& grasp : result.grasps) {
    for (const GraspContact& contact : grasp.trial.contacts) {
      contacts += 1.0;
      if (regions.contain(contact.point.position)) touch.in_region += 1.0;
    }
  }
  EXPECT_GT(contacts, 0.0);
  touch.in_region /= contacts;
  touch.epsilon = result.grasps.empty() ? 0.0 : result.grasps.front().trial.epsilon.lower;
  return touch;
}

TEST(PlanSurfacesSlow, TheBestGraspsMoveToTheRubberOfAHandle) {
  const RegionTouch without = touch_of_best("screwdriver_rubber_handle", false);
  const RegionTouch with = touch_of_best("screwdriver_rubber_handle", true);
  EXPECT_LT(without.in_region, 0.7);
  EXPECT_GT(with.in_region, 0.9);
  EXPECT_GT(with.epsilon, without.epsilon);
}

TEST(PlanSurfacesSlow, TheBestGraspsAvoidAWetStripe) {
  const RegionTouch without = touch_of_best("wet_glass", false);
  const RegionTouch with = touch_of_best("wet_glass", true);
  EXPECT_GT(without.in_region, 0.3);
  EXPECT_LT(with.in_region, 0.05);
  EXPECT_LT(with.epsilon, without.epsilon);
}

}  // namespace
}  // namespace prehend
