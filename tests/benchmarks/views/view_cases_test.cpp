// Things on a table as noisy depth cameras see them.
#include "benchmarks/views/view_cases.h"

#include <gtest/gtest.h>

#include "sim/shape/basic_shapes.h"
#include "sim/shape/mesh_checks.h"

namespace prehend::bench {
namespace {

// High enough that rays past its rim end far behind it: readings there are a mixture of both, and
// noise of what is far stands out of the table. Neither joins it to anything.
TEST(ViewCases, AHighThingIsSeenByThreeNoisyCamerasAsItIs) {
  const TableCase jug{"jug", transformed(make_cylinder(0.07, 0.24), translation({0.0, 0.0, 0.12}))};
  for (const double angle : {0.3, 1.1, 2.0}) {
    const Reconstruction found = reconstruct(views_of(jug, angle, 3));
    ASSERT_GE(found.objects.size(), 1U) << angle;
    const Bounds box = bounds(found.objects.front().mesh);
    EXPECT_NEAR(box.size().x(), 0.14, 0.01) << angle;
    EXPECT_NEAR(box.size().y(), 0.14, 0.01) << angle;
    EXPECT_NEAR(box.size().z(), 0.24, 0.01) << angle;
  }
}

}  // namespace
}  // namespace prehend::bench
