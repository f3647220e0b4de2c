// The scene of figure 14 of Miller and Allen, "Graspit!" (2004): a Barrett hand on a Puma closes
// around a wine glass that lies on a table. Plastic on glass has little friction and the glass is
// tapered, so that the hand squeezes it out; it rolls off the table.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "sim/manipulation/simulate.h"
#include "tests/support/library_scenes.h"

namespace prehend {
namespace {

Scene glass_on_its_side() { return load_scene(test::library_scene("wine_glass_on_its_side")); }

void make_fingers_of(const std::string& material, Robot& hand) {
  for (Link& link : hand.links) {
    if (link.joint >= 0) link.material = material;
  }
}

Simulation closed(const Scene& scene, double seconds) {
  const CompiledScene ready = compile(scene);
  return simulate(ready, start_of(ready), closing_procedure(ready, seconds));
}

bool happened(const Simulation& simulation, ObjectEventKind kind) {
  return std::any_of(simulation.events.begin(), simulation.events.end(),
                     [&](const ObjectEvent& event) { return event.kind == kind; });
}

TEST(WineGlass, IsSqueezedOutAndFallsOffTheTable) {
  const Simulation simulation = closed(glass_on_its_side(), 5.0);
  EXPECT_EQ(simulation.end, ObjectEnd::squeezed_out);
  EXPECT_TRUE(happened(simulation, ObjectEventKind::gripped));
  EXPECT_TRUE(happened(simulation, ObjectEventKind::left));
  EXPECT_TRUE(happened(simulation, ObjectEventKind::fell));
  const WorldFrame& last = simulation.frames.back();
  EXPECT_LT(last.bodies[kObjectBody].X_WB.translation().z(), 0.2);  // on the floor
  EXPECT_EQ(simulation.effort.last, StepOutcome::moved);
}

TEST(WineGlass, IsHeldByFingersOfRubber) {
  Scene scene = glass_on_its_side();
  make_fingers_of("rubber", scene.hand);
  Carrier& carrier = *scene.carrier;
  make_fingers_of("rubber", carrier.platform.robots[static_cast<std::size_t>(carrier.hand)].robot);
  const Simulation simulation = closed(scene, 2.5);
  EXPECT_EQ(simulation.end, ObjectEnd::held);
  EXPECT_FALSE(happened(simulation, ObjectEventKind::fell));
}

}  // namespace
}  // namespace prehend
