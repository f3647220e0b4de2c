// A picture of a robot by itself.
#pragma once

#include <vector>

#include "planner/show/grasp_picture.h"
#include "planner/show/telling_postures.h"
#include "sim/robot/hand/posture_survey.h"

namespace prehend {

// The postures in cells of one size, all from the same side, with the axes of a hand in the first
// (its approach blue, its closing direction as wide as it opens red), and in the last cell the
// first of them with the places that the tips reached in the survey, a colour each. Sizes are of
// the whole picture. Throws Cancelled.
Image robot_picture(const Robot& robot, const std::vector<NamedPosture>& postures,
                    const PostureSurvey& survey, const PictureSize& size = kGraspPicture,
                    const RunContext& context = {});

}  // namespace prehend
