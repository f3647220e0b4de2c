// The bodies that are drawn of a grasp: object, hand, contacts, obstacles and arm.
#pragma once

#include <vector>

#include "planner/show/picture/drawn_body.h"
#include "planner/show/picture/marks.h"
#include "planner/show/posed_grasp.h"

namespace prehend {

struct CompiledScene;

// All in the world's frame. Meshes of the object, of links and of obstacles are those of the scene,
// not copies of them: the scene must outlive the bodies.
struct GraspBodies {
  DrawnBody object;                  // partly transparent
  std::vector<DrawnBody> surfaces;   // its parts of other materials, as skins on it
  std::vector<DrawnBody> hand;       // its links, solid, in the hand's order
  std::vector<DrawnBody> contacts;   // a friction cone each, as wide as the friction
  std::vector<DrawnBody> weakest;    // arrows: force thick, torque thin; none for a zero wrench
  std::vector<DrawnBody> obstacles;  // partly transparent, in the scene's order
  std::vector<DrawnBody> arm;        // links that are not the hand's, solid; none without a posture

  // Object and its surfaces, hand, contacts and the weakest wrench, in this order: what a picture
  // is about.
  std::vector<DrawnBody> grasp() const;

  // Obstacles and the arm.
  std::vector<DrawnBody> surroundings() const;

  // The grasp, then its surroundings.
  std::vector<DrawnBody> all() const;

  // The grasp and the arm that holds it, without links that only mark a place (a base of a few
  // millimetres): what a picture of the arm is about.
  std::vector<DrawnBody> grasp_and_arm() const;
};

// Friction cones have `cone_sides` sides.
GraspBodies grasp_bodies(const CompiledScene& scene, const PosedGrasp& grasp,
                         int cone_sides = kRoundSides);

}  // namespace prehend
