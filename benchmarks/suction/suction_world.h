// An object that hangs on suction cups, in MuJoCo: its adhesion actuators pull with the force of
// the vacuum.
#pragma once

#include "benchmarks/suction/hanging_object.h"

namespace prehend::bench {

// What becomes of the vacuum of a cup when a point of its lip comes off the object.
enum class LiftedLip {
  adheres,  // the points that still touch share the same force: MuJoCo's adhesion, which knows no
            // seal
  leaks,    // the cup has no vacuum any more
};

struct HangingEnd {
  bool held = false;    // the object came to rest on cups with vacuum
  bool lifted = false;  // some point of a lip came off, by 0.1 mm
  double moved = 0.0;   // the centre of mass [m]
  double tilted = 0.0;  // the largest turn of the object about tangents of the first cup [rad]
  // Mean cosine between the axes of the cups and the normals under their lips, along which adhesion
  // acts.
  double facing = 0.0;
  // How many times the weight the cups would bear before a point of a lip comes off, if friction
  // held and all lips were springs that share it.
  double linear_margin = 0.0;
  bool unstable = false;
};

// The cups stay where they are. Each lip is a ring of points on springs along the axis of the cup,
// which touch the object at the start, with the stiffness of the lip; nothing else of the hand is
// there. The weight grows in one second, and stays for two. Throws InputError where a point of a
// lip is beside the pieces, and for a model that MuJoCo refuses.
HangingEnd hang_in_mujoco(const HangingObject& object, LiftedLip lifted);

}  // namespace prehend::bench
