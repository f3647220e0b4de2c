// Pictures of a grasp. All throw Cancelled.
#pragma once

#include <array>
#include <string>

#include "planner/show/picture/image.h"
#include "sim/base/pose.h"
#include "sim/base/run_context.h"

namespace prehend {

struct CompiledScene;
struct PosedGrasp;

// Of a picture of one grasp.
inline constexpr PictureSize kGraspPicture{900, 700};

// Writes lines of text into the lower left corner.
void write_title(Image& image, const std::string& title);

// One view from `direction` (to the eye, any length, in the world's frame; best_viewpoint has one
// that shows much). What stands around is drawn as far as it is in the picture.
Image grasp_picture(const CompiledScene& scene, const PosedGrasp& grasp, const Vector3& direction,
                    const PictureSize& size = kGraspPicture, const RunContext& context = {});

// One view of the arm that holds the object; needs arm_joints.
Image arm_picture(const CompiledScene& scene, const PosedGrasp& grasp,
                  const PictureSize& size = kGraspPicture, const RunContext& context = {});

// One view of two hands that hold one object, each with its scene of it; obstacles are those of the
// first scene. Arms are drawn where the grasps have arm_joints.
Image shared_grasp_picture(const std::array<const CompiledScene*, 2>& scenes,
                           const std::array<PosedGrasp, 2>& grasps, const Vector3& direction,
                           const PictureSize& size = kGraspPicture, const RunContext& context = {});

// Four views around the vertical in one picture, half as wide and high each.
Image grasp_from_four_sides(const CompiledScene& scene, const PosedGrasp& grasp,
                            const PictureSize& size = kGraspPicture,
                            const RunContext& context = {});

}  // namespace prehend
