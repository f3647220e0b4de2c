// What a robot can do with its joints, found by trying: where its tips get, and which of its links
// are in each other's way.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/robot/robot.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Two links that collide in some of the postures.
struct CollidingLinks {
  int first = 0;  // indices in Robot::links
  int second = 0;
  int postures = 0;  // in how many
};

// Where one tip gets in the postures without collision: the far end of a finger's last link, or of
// a robot without fingers the end of a chain on which other robots can be mounted.
struct TipWorkspace {
  std::string name;             // of the link or the chain
  std::vector<Vector3> points;  // in the base frame, one a posture [m]
  Bounds box;                   // of the points; empty where there are none
  double farthest = 0.0;        // largest distance of a point from the origin of the base frame [m]
};

struct PostureSurvey {
  int postures = 0;
  int colliding = 0;                  // with links that collide
  std::vector<CollidingLinks> pairs;  // of pairs that are checked (link_pairs.h), most often first
  std::vector<TipWorkspace> tips;     // in the order of the joints
};

// Draws each degree of freedom uniformly between its limits, joints follow by their couplings. One
// that may turn without end is drawn from one turn about its initial value, one that may slide
// without end stays there. The same arguments give the same survey. Throws InputError for
// less than one posture and for a link without triangles.
PostureSurvey survey_postures(const Robot& robot, int postures = 1000, std::uint64_t seed = 1);

}  // namespace prehend
