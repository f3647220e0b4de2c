// Bodies that move, appear and disappear, as a binary glTF 2.0 file (.glb) with an animation.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "planner/show/picture/draw.h"
#include "planner/show/picture/drawn_body.h"

namespace prehend {

// A frame N that moves in that of another, and what is fixed to it.
struct AnimatedNode {
  std::string name = {};
  int parent = -1;              // a node that stands before it; -1: the world
  SharedMesh mesh = {};         // in N; without triangles: only a frame
  Color color = {};             // of the mesh
  std::vector<Pose> X_PN = {};  // N in the parent's frame (world: W): one a moment, or one for all
  std::vector<bool> shown =
      {};  // one a moment, or none: always. What is below it is hidden with it
};

// As glb_bytes, with a node for each of `nodes` in their order and one animation, in which the
// nodes are at `times[m]` [s] as at moment m. Between two moments they move along straight lines
// while they turn evenly, by the shorter way, and are shown as at the earlier one. What never
// changes is no part of the animation. Programs that show no animations show the last moment.
// Throws InputError as glb_bytes does, for times that do not increase, and for nodes that do not
// have the number of poses or of `shown` that they need.
std::string animated_glb(const std::vector<AnimatedNode>& nodes, const std::vector<double>& times,
                         const std::string& name, const nlohmann::ordered_json& extras,
                         double crease_angle = DrawOptions().crease_angle);

}  // namespace prehend
