#include "sim/motion/dynamic_grasp/object_watch.h"

#include <gtest/gtest.h>

#include "sim/motion/step_world.h"
#include "sim/shape/basic_shapes.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

// A tall box that stands on a table, and the parallel jaw beside it, which points at it.
class PushedBox : public ::testing::Test {
 protected:
  static constexpr double kTall = 0.15;

  PushedBox() {
    Scene scene;
    scene.object = make_graspable("box", make_box({0.03, 0.06, kTall}), Material::plastic, 0.2);
    scene.hand = find_robot("parallel_jaw");
    StaticBody table{"table", make_box({2.0, 2.0, 0.02})};
    table.X_WB = translation({0.0, 0.0, -0.5 * kTall - 0.0101});
    scene.obstacles = {table};
    scene_ = compile(std::move(scene));
  }

  // Pushes the box with the tips of the closed plates, their middle `height` above the table and 20
  // mm less and more, and goes back.
  ObjectWatch pushed(double height, double speed) {
    World world = make_scene_world(scene_, true);
    Matrix3 ahead;
    ahead << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    const Pose X_WH = pose_from(ahead, Vector3(-0.115, 0.0, -0.5 * kTall + height));
    const WorldHand hand = add_hand(world, scene_, hand_model(scene_), X_WH, {0.0, 0.0});
    ObjectWatch watch(world, hand);
    double time = 0.0;
    for (const double sign : {1.0, -1.0, 0.0}) {
      world.robots.front().base_linear = {sign * speed, 0.0, 0.0};
      const double end = time + (sign > 0.0 ? 0.06 / speed : 0.25);
      while (time < end) {
        const StepResult step = step_world(world);
        EXPECT_EQ(step.outcome, StepOutcome::moved);
        if (step.time == 0.0) return watch;
        time += step.time;
        watch.look(world, time);
      }
    }
    return watch;
  }

  CompiledScene scene_;
};

bool has(const ObjectWatch& watch, ObjectEventKind kind) {
  return std::any_of(watch.events().begin(), watch.events().end(),
                     [&](const ObjectEvent& event) { return event.kind == kind; });
}

// Friction of 0.4 resists a push with 0.4 of the weight, which tips the box over from a height of
// 0.015 / 0.4 = 37 mm on. Pushed below that it slides.
TEST_F(PushedBox, TipsOverWhenPushedHighUp) {
  const ObjectWatch watch = pushed(0.11, 0.2);
  EXPECT_EQ(watch.end(), ObjectEnd::toppled);
  EXPECT_TRUE(has(watch, ObjectEventKind::touched));
  EXPECT_TRUE(has(watch, ObjectEventKind::tilted));
  EXPECT_FALSE(has(watch, ObjectEventKind::gripped));
}

TEST_F(PushedBox, SlidesWhenPushedLowDown) {
  const ObjectWatch watch = pushed(0.021, 0.05);
  EXPECT_EQ(watch.end(), ObjectEnd::pushed_away);
  EXPECT_FALSE(has(watch, ObjectEventKind::tilted));
  EXPECT_TRUE(watch.has_left());
}

TEST_F(PushedBox, NamesTheLinkThatTouchesFirst) {
  const ObjectWatch watch = pushed(0.021, 0.05);
  ASSERT_FALSE(watch.events().empty());
  EXPECT_EQ(watch.events().front().kind, ObjectEventKind::touched);
  EXPECT_EQ(watch.events().front().link, "left_plate");
}

}  // namespace
}  // namespace prehend
