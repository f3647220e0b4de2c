// Everything that trades speed for accuracy in a trial, or changes what comes out of it.
#pragma once

#include "sim/base/settings.h"
#include "sim/contact/surface_contact.h"
#include "sim/reach/reach.h"

namespace prehend {

// How an object settles between two self-centering fingers that do not hold it (see settle.h).
struct SettleOptions {
  double angle = 0.07;  // of one turn [rad]
  int steps = 24;       // turns that are tried at most; 0: the object keeps its attitude
  // Fingers open by this before the object turns, so that they do not start inside it [m].
  double loosen = 3e-3;
  // Turning goes on while the fingers come closer by more than this in a step [m].
  double least_gain = 1e-6;
  // Product of the distance between the fingers' contacts and the offset of their forces below
  // which their couple turns nothing [m].
  double least_arm = 1e-4;
};

template <SettingsOf<SettleOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [angle, steps, loosen, least_gain, least_arm] = options;
  visit("angle", angle);
  visit("steps", steps);
  visit("loosen", loosen);
  visit("least_gain", least_gain);
  visit("least_arm", least_arm);
}

// How the gap between two moving bodies is asked for (see GapTracker). All answers are proven
// bounds; looser ones cost less each, and more of them are needed.
struct GapTrackerOptions {
  // Triangle pairs are listed within this gap; farther away they would be too many [m].
  double near = 2e-3;
  // How far the list reaches beyond the gap: as a multiple of it, and at least by so much [m].
  double reach = 1.5;
  double least_reach = 3e-4;
  // A list longer than this costs more than walking the trees: none is kept then.
  int most_pairs = 400;
  // Part by which a query may be off that only has to say how far to go.
  double looseness = 0.4;
};

template <SettingsOf<GapTrackerOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [near, reach, least_reach, most_pairs, looseness] = options;
  visit("near", near);
  visit("reach", reach);
  visit("least_reach", least_reach);
  visit("most_pairs", most_pairs);
  visit("looseness", looseness);
}

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
  SettleOptions settle;
  // Edges of the pyramid that stands for a friction cone (>= 3).
  int cone_edges = 8;
  ReachOptions reach;  // of scenes with an arm
  // A pair of bodies is asked for its gap at most this often in one motion; then it counts as
  // stopped where it is, which can cost a contact but never makes a penetration.
  int max_gap_queries = 400;
  GapTrackerOptions gaps;

  // A gap at which a motion ends.
  double closed_gap() const { return 1.1 * contact_gap; }
};

template <SettingsOf<TrialOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [contact, contact_gap, back_off_step, back_off_tries, soft_fingers, settle, cone_edges,
         reach, max_gap_queries, gaps] = options;
  visit("contact", contact);
  visit("contact_gap", contact_gap);
  visit("back_off_step", back_off_step);
  visit("back_off_tries", back_off_tries);
  visit("soft_fingers", soft_fingers);
  visit("settle", settle);
  visit("cone_edges", cone_edges);
  visit("reach", reach);
  visit("max_gap_queries", max_gap_queries);
  visit("gaps", gaps);
}

}  // namespace prehend
