// The postures that say most about a robot, to be drawn.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/robot/robot.h"

namespace prehend {

// A body in the frame of the robot's base [m].
struct PlacedMesh {
  TriangleMesh mesh;
  Pose X_BM = Pose::Identity();
};

// A posture with the line that stands under it.
struct NamedPosture {
  std::string name;
  std::vector<double> joints;              // one value per joint [rad or m]
  std::optional<PlacedMesh> grasped = {};  // what the hand has closed on
};

// Of a hand: at most three of its preshapes; then the first of them half closed, closed until links
// touch each other, and closed on a cylinder of half its width where its fingers meet (left out
// where that is in the way of the open hand, or the hand closes on nothing). Of another robot: its
// initial posture. Throws Cancelled.
std::vector<NamedPosture> telling_postures(const Robot& robot, const RunContext& context = {});

}  // namespace prehend
