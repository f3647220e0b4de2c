// What a grasp looks like.
#pragma once

#include <string>
#include <vector>

#include "planner/picture/draw.h"
#include "sim/trial/trial.h"

namespace prehend {

// A hand where it is, with what it touches.
struct PosedGrasp {
  Pose X_OH = Pose::Identity();
  std::vector<double> joints;
  std::vector<GraspContact> contacts;
  Wrench weakest = Wrench::Zero();      // drawn from the centre of mass; zero: not drawn
  std::string title;                    // lines under the picture
  std::vector<double> arm_joints = {};  // of the whole platform; empty: no arm is drawn
};

struct GraspPictureOptions {
  int width = 900;
  int height = 700;
};

// Object partly transparent, hand solid, friction cones red (as wide as the friction), weakest
// wrench purple (force thick, torque thin). In the world's frame; the object first, then the links
// of the hand, then a cone a contact, each in their order.
std::vector<DrawnBody> grasp_bodies(const CompiledScene& scene, const PosedGrasp& grasp);

// What stands around: the obstacles, which can be seen through, then the arm, solid.
std::vector<DrawnBody> surrounding_bodies(const CompiledScene& scene, const PosedGrasp& grasp);

// The grasp and the arm that holds it, without a base that only marks a place: what a picture of
// the arm is about.
std::vector<DrawnBody> framed_bodies(const CompiledScene& scene, const PosedGrasp& grasp);

// Writes lines of text into the lower left corner.
void write_title(Image& image, const std::string& title);

// One view from `direction` (to the eye, any length, in the world's frame; telling_side has one
// that shows much). What stands around is drawn as far as it is in the picture.
Image grasp_picture(const CompiledScene& scene, const PosedGrasp& grasp, const Vector3& direction,
                    const GraspPictureOptions& options = {});

// One view of the arm that holds the object; needs arm_joints.
Image arm_picture(const CompiledScene& scene, const PosedGrasp& grasp,
                  const GraspPictureOptions& options = {});

// Four views around the vertical in one picture, half as wide and high each.
Image grasp_from_four_sides(const CompiledScene& scene, const PosedGrasp& grasp,
                            const GraspPictureOptions& options = {});

}  // namespace prehend
