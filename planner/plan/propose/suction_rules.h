// Where suction cups may hold an object: the faces of its primitives, and smooth places of its
// mesh.
#pragma once

#include <vector>

#include "planner/plan/propose/grasp_rules.h"

namespace prehend {

struct CompiledScene;
struct Primitive;

// A place on the surface on which a cup seals.
struct SuctionPlace {
  Vector3 point_O = Vector3::Zero();      // where the axis of the hand meets the surface [m]
  Vector3 approach_O = Vector3::UnitZ();  // unit: into the object
  double off_center = 0.0;  // of the centre of mass from the line along the approach [m]
  int sealed = 0;           // cups of the hand that seal, in the best of four turns
};

// Places spread evenly over the surface on which at least one cup of the hand seals, the hand along
// the mean normal there. Those on which most cups seal come first, among these the ones whose line
// of approach passes nearest to the centre of mass, and none is near one before it: nearer than
// half the radius of the largest cup.
std::vector<SuctionPlace> suction_places(const CompiledScene& scene);

// The rules of a hand with cups for each primitive, which close on nothing (width 0):
// - "face": onto the middle of each face of a box, and at places along both of its axes; onto both
//   ends of cylinders and cones; "side": onto the side of cylinders and cones and onto a sphere,
//   from any direction;
// - "smooth place": onto suction_places, each with the primitive whose surface is nearest, in their
//   order: the choice 1/2 is the first, the choices that a level of detail adds are the next ones.
// With several cups, or an arm, also any turn of the hand about its approach.
std::vector<std::vector<GraspRule>> suction_rules(const CompiledScene& scene,
                                                  const std::vector<Primitive>& primitives);

}  // namespace prehend
