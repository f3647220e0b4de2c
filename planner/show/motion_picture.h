// Pictures of the frames of a motion, all from the same cameras, so that they can be joined to a
// film.
#pragma once

#include <vector>

#include "planner/plan/path/grasp_motion.h"
#include "planner/show/grasp_picture.h"
#include "planner/show/picture/camera.h"

namespace prehend {

struct CompiledScene;
struct PosedGrasp;

// Where the viewer stands. With an arm there are two pictures side by side: one sees the robot on
// its whole way, one the hand at the object.
struct MotionView {
  Camera whole;
  Camera close;
  bool with_arm = false;
};

// Sees all of the frames (at least one; one of them is `grasp`). The side of the arm's picture is
// one across the hand's way on which the hand is hidden least; the other's is the telling side.
// Throws Cancelled.
MotionView motion_view(const CompiledScene& scene, const std::vector<MotionFrame>& frames,
                       const PosedGrasp& grasp, const PictureSize& size = kGraspPicture,
                       const RunContext& context = {});

// A moment of the motion, with its title. Throws Cancelled.
Image motion_picture(const CompiledScene& scene, const PosedGrasp& moment, const MotionView& view,
                     const PictureSize& size = kGraspPicture, const RunContext& context = {});

}  // namespace prehend
