// Bodies that fall, slide, roll, lie on each other and are grasped by robots, stepped through time.
//
// A step finds velocities at its end that obey momentum, Signorini's condition and Coulomb's law at
// all contacts, and the limits, clutches and drives of all joints, at once (contact_problem.h; time
// stepping after Stewart and Trinkle 1996 and Anitescu and Potra 1997), and moves everything with
// them. Contacts are those of the exact meshes. Robots move in the coordinates of their joints
// (Featherstone 2008), so that joints do not drift. Bodies that would pass through each other
// within a step make it shorter.
#pragma once

#include "sim/motion/step_options.h"
#include "sim/motion/step_outcome.h"

namespace prehend {

struct World;

struct StepResult {
  StepOutcome outcome = StepOutcome::moved;
  double time = 0.0;       // that the step took [s]
  int newton_steps = 0;    // of the solver, of all islands, in the last try
  int shortened = 0;       // how often it was made shorter because bodies met too far from contacts
  int crossings = 0;       // pairs that began to cross, by no more than StepOptions::shallow
  double violation = 0.0;  // of the law of contact, relative (ContactSolution)
};

// Moves the world on by at most options.step. The same world gives the same bytes.
StepResult step_world(World& world, const StepOptions& options = {});

}  // namespace prehend
