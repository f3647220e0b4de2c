// The scene of figure 14 of Miller and Allen, "Graspit!" (2004): a Barrett hand on a Puma closes
// around a wine glass that lies on a table. Plastic on glass has little friction and the glass is
// tapered, so that the hand squeezes it out; it rolls off the table.
#include <algorithm>
#include <numbers>
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

// The paper's hand: its fingers begin 2.5 degrees further closed, both links, and its clutches let
// the last links go on a third as fast as the motor.
void make_hand_of_paper(Robot& hand) {
  for (Joint& joint : hand.joints) {
    const bool proximal = joint.name.ends_with("proximal");
    const bool distal = joint.name.ends_with("distal");
    if (proximal) joint.zero += (5.0 - 2.46) * std::numbers::pi / 180.0;
    if (distal) joint.zero += (40.0 - 37.54) * std::numbers::pi / 180.0;
    if (proximal || distal) joint.upper = 144.0 * std::numbers::pi / 180.0;
    joint.across = -1;
  }
}

// On which way it goes then depends on how the fingers meet it.
TEST(WineGlass, IsSqueezedOut) {
  const Simulation simulation = closed(glass_on_its_side(), 2.5);
  EXPECT_EQ(simulation.end, ObjectEnd::squeezed_out);
  EXPECT_TRUE(happened(simulation, ObjectEventKind::gripped));
  EXPECT_TRUE(happened(simulation, ObjectEventKind::left));
}

TEST(WineGlass, IsSqueezedOutOfTheHandOfThePaperAndFallsOffTheTable) {
  Scene scene = glass_on_its_side();
  make_hand_of_paper(scene.hand);
  Carrier& carrier = *scene.carrier;
  make_hand_of_paper(carrier.platform.robots[static_cast<std::size_t>(carrier.hand)].robot);
  const Simulation simulation = closed(scene, 5.0);
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
