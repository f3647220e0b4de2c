// What `inspect` says of robots.
#pragma once

#include "sim/robot/hand/posture_survey.h"
#include "sim/robot/platform.h"

namespace prehend {

// A robot as a hand, as far as it is one, and what its joints can do.
struct InspectedRobot {
  Robot robot;           // with derived preshapes where it is a hand that states none
  bool derived = false;  // whether they are
  std::string no_hand;   // why it cannot be one although it has fingers
  PostureSurvey survey;
};

InspectedRobot inspected(const Robot& robot);

// Prints joints, degrees of freedom, links, what a hand can take, self-collisions and workspace.
void print_robot(const InspectedRobot& inspected);

// Prints where each robot of the platform is mounted, and what it is.
void print_platform(const Platform& platform, const std::vector<InspectedRobot>& robots);

}  // namespace prehend
