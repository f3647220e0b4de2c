// A jaw whose plates are wider than what they hold.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "planner/plan/plan.h"
#include "sim/base/index.h"
#include "sim/robot/files/robot_file.h"
#include "sim/scene/compiled_scene.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/object_generator.h"

namespace prehend {
namespace {

class Holds : public testing::TestWithParam<const char*> {};

TEST_P(Holds, TheWideParallelJawHoldsWithRegions) {
  Scene scene;
  const std::string name = GetParam();
  const TriangleMesh mesh = name == "mug"    ? generate_object("mug")
                            : name == "cube" ? make_box(Vector3::Constant(0.05), 4)
                                             : make_cylinder(0.03, 0.1);
  scene.object = make_graspable(name, mesh, Material::plastic);
  scene.hand = find_robot("parallel_jaw_wide");
  const CompiledScene compiled = compile(std::move(scene));
  PlanOptions options;
  options.search.trials = 200;
  const PlanResult result = plan(compiled, options);
  ASSERT_FALSE(result.grasps.empty());
  std::vector<int> points(compiled.links.size(), 0);
  for (const GraspContact& contact : result.grasps.front().trial.contacts) {
    ++points[index(contact.link)];
  }
  for (std::size_t plate = 1; plate < points.size(); ++plate) EXPECT_GE(points[plate], 2);
}

INSTANTIATE_TEST_SUITE_P(Objects, Holds, testing::Values("mug", "cube", "cylinder"),
                         [](const auto& object) { return std::string(object.param); });

}  // namespace
}  // namespace prehend
