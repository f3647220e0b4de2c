// A picture of a robot by itself.
#pragma once

#include <string>
#include <vector>

#include "planner/show/grasp_picture.h"
#include "sim/robot/hand/posture_survey.h"

namespace prehend {

// A posture to draw, with the line that stands under it.
struct NamedPosture {
  std::string name;
  std::vector<double> dofs;  // one value per degree of freedom [rad or m]
};

// The preshapes of a hand, at most five; of another robot its initial posture.
std::vector<NamedPosture> telling_postures(const Robot& robot);

// The postures in cells of one size, all from the same side, and in the last cell the first of them
// with the places that the tips reached in the survey, a colour each. Sizes are of the whole
// picture. Throws Cancelled.
Image robot_picture(const Robot& robot, const std::vector<NamedPosture>& postures,
                    const PostureSurvey& survey, const PictureSize& size = kGraspPicture,
                    const RunContext& context = {});

}  // namespace prehend
