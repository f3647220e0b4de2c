// The one dial between speed and accuracy of a trial.
#pragma once

#include "sim/contact/surface_contact.h"
#include "sim/reach/reach.h"

namespace prehend {

struct TrialOptions {
  ContactOptions contact;
  // Motions end at this gap, or at most a tenth more; between 0 and 0.9 contact.threshold [m].
  // Ending at one gap rather than anywhere below the threshold keeps contacts the same however they
  // were reached.
  double contact_gap = 5e-5;
  // When a grasp does not hold, the hand goes back along its approach by this and closes again [m].
  double back_off_step = 8e-3;
  int back_off_tries = 3;
  // Whether soft links bear on patches, with torque about the normal; if not, all contacts are hard
  // points.
  bool soft_fingers = true;
  // Two self-centering fingers turn an object that they do not hold by steps of this angle, so
  // often; 0 steps: the object keeps its attitude.
  double settle_angle = 0.07;  // rad
  int settle_steps = 24;
  // Edges of the pyramid that stands for a friction cone (>= 3).
  int cone_edges = 8;
  ReachOptions reach;  // for scenes with an arm
  // A pair of bodies is asked for its gap at most this often in one motion; then it counts as
  // stopped where it is, which can cost a contact but never makes a penetration.
  int max_gap_queries = 400;

  // A gap at which a motion ends.
  double closed_gap() const { return 1.1 * contact_gap; }
};

}  // namespace prehend
