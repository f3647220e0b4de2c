#include "planner/show/motion_picture.h"

#include <gtest/gtest.h>

#include "planner/show/best_viewpoint.h"
#include "planner/show/contact_sheet.h"
#include "planner/show/grasp_bodies.h"
#include "planner/show/motion_frames.h"
#include "tests/support/held_cube.h"

namespace prehend {
namespace {

using test::held_cube;
using test::HeldCube;
using test::motion_of;

TEST(MotionPicture, OneCameraSeesAllFrames) {
  const HeldCube held = held_cube();
  std::vector<MotionFrame> frames;
  for (const NamedFrame& named : named_frames(motion_of(held), 4)) frames.push_back(named.frame);
  const PictureSize size{160, 120};
  const MotionView view = motion_view(held.scene, frames, held.grasp, size);
  EXPECT_FALSE(view.with_arm);
  const Projection projection(view.close, size.width, size.height);
  for (const MotionFrame& frame : frames) {
    for (const DrawnBody& body : grasp_bodies(held.scene, posed_at(frame)).grasp()) {
      for (const Vector3& p_B : body.mesh->vertices) {
        const Eigen::Vector2d pixel = projection.pixel(projection.X_CW() * (body.X_WB * p_B));
        EXPECT_TRUE(pixel.x() >= 0 && pixel.x() <= size.width);
        EXPECT_TRUE(pixel.y() >= 0 && pixel.y() <= size.height);
      }
    }
  }
  const Image first = motion_picture(held.scene, posed_at(frames.front()), view, size);
  const Image last = motion_picture(held.scene, posed_at(frames.back()), view, size);
  EXPECT_EQ(first.width, 160);
  EXPECT_EQ(first.height, 120);
  EXPECT_NE(first.rgb, last.rgb);
}

TEST(CancelledBeforehand, PicturesThrow) {
  const HeldCube held = held_cube();
  std::vector<MotionFrame> frames;
  for (const NamedFrame& named : named_frames(motion_of(held), 2)) frames.push_back(named.frame);
  const PictureSize size{160, 120};
  const MotionView view = motion_view(held.scene, frames, held.grasp, size);
  RunContext context;
  context.cancellation.request();
  const Vector3 side = Vector3::UnitX();
  EXPECT_THROW(grasp_picture(held.scene, held.grasp, side, size, context), Cancelled);
  EXPECT_THROW(grasp_from_four_sides(held.scene, held.grasp, size, context), Cancelled);
  EXPECT_THROW(best_viewpoint(held.scene, held.grasp, context), Cancelled);
  EXPECT_THROW(contact_sheet(held.scene, {held.grasp}, 2, size, context), Cancelled);
  EXPECT_THROW(motion_view(held.scene, frames, held.grasp, size, context), Cancelled);
  EXPECT_THROW(motion_picture(held.scene, posed_at(frames.front()), view, size, context),
               Cancelled);
}

}  // namespace
}  // namespace prehend
