// Settings of a trial that trade speed for accuracy or change its result.
#pragma once

#include "sim/base/settings.h"
#include "sim/motion/dynamic_grasp/form_dynamic_grasp.h"
#include "sim/scene/reach/reach.h"
#include "sim/shape/contact/surface_contact.h"
#include "sim/trial/resolve_overlap.h"

namespace prehend {

struct SettleOptions {
  static constexpr AboutSettings kAbout{"SettleOptions",
                                        "How an object settles between two self-centering fingers "
                                        "that do not hold it."};
  double angle = 0.07;
  double slide = 2e-3;
  int steps = 48;
};

template <SettingsOf<SettleOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [angle, slide, steps] = options;
  visit("angle", angle, kAbove0, "rad", "Largest turn of a step.");
  visit("slide", slide, kAbove0, "m",
        "Farthest that the object moves between the fingers in a step.");
  visit("steps", steps, kAtLeast0, "", "Most steps that are tried; 0: the object does not settle.");
}

// Settings of the gap queries between two moving bodies (see GapTracker). They change the time that
// queries take, never their validity: every answer is a proven bound. A looser bound costs less to
// compute but allows shorter steps, so that more queries are needed.
struct GapTrackerOptions {
  // Below this gap the pairs of nearby triangles are listed; at larger gaps the list would be too
  // long [m].
  double near = 5e-4;
  // The list holds all pairs closer than reach * gap, and at least those closer than gap +
  // least_reach [m].
  double reach = 2.0;
  double least_reach = 3e-4;
  // A longer list is not kept; the next one is tried when the gap is half as large. Searches of the
  // bounding-volume trees cost more than this many pairs, of which most are only looked at.
  int most_pairs = 2000;
  // Relative error allowed in a query of the trees, whose answer only limits the next step.
  double relative_error = 0.5;
};

template <SettingsOf<GapTrackerOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [near, reach, least_reach, most_pairs, relative_error] = options;
  visit("near", near, kAtLeast0);
  visit("reach", reach, kAtLeast1);
  visit("least_reach", least_reach, kAtLeast0);
  visit("most_pairs", most_pairs, kAtLeast0);
  visit("looseness", relative_error, kPart);
}

struct TrialOptions {
  static constexpr AboutSettings kAbout{"TrialOptions",
                                        "How the hand approaches, closes and is scored; the "
                                        "defaults suit household objects in SI units."};
  ContactOptions contact;
  // Motions end at one gap instead of anywhere below the threshold so that the contacts found do
  // not depend on the steps by which they were reached.
  double contact_gap = 5e-5;
  OverlapOptions resolve_overlap;
  double obstacle_clearance = 1e-3;
  double back_off_step = 8e-3;
  int back_off_tries = 1;
  bool soft_fingers = true;
  SettleOptions settle;
  int cone_edges = 8;
  ReachOptions reach;
  DynamicGraspOptions formation;

  // Largest gap that counts as touching [m]. The 10 % above contact_gap make the last step end:
  // steps of (gap - contact_gap) approach contact_gap without reaching it.
  double closed_gap() const { return 1.1 * contact_gap; }
};

template <SettingsOf<TrialOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [contact, contact_gap, resolve_overlap, obstacle_clearance, back_off_step, back_off_tries,
         soft_fingers, settle, cone_edges, reach, formation] = options;
  visit("contact", contact, "What counts as a contact.");
  visit("contact_gap", contact_gap, kAbove0, "m",
        "Gap at which a motion ends, up to 10 % more; at most 0.9 of the contact threshold.");
  // Within the threshold, 10 % more included.
  visit.relation("contact_gap", contact_gap <= 0.9 * contact.threshold,
                 "must be at most 0.9 of the contact threshold");
  visit("give_way", resolve_overlap, "Overlaps at the start that are resolved.");
  visit("obstacle_clearance", obstacle_clearance, kAtLeast0, "m",
        "A hand that an obstacle stops on its approach, such as the table on which the object "
        "lies, moves back by this and closes there.");
  visit("back_off_step", back_off_step, kAtLeast0, "m",
        "When a grasp does not hold, the hand backs off along its approach by this and closes "
        "again.");
  visit("back_off_tries", back_off_tries, kAtLeast0, "",
        "How often it does; more: more grasps hold, seldom the best.");
  visit("soft_fingers", soft_fingers,
        "Whether compliant links make patch contacts that resist torque about the normal; if not, "
        "all contacts are hard points with friction.");
  visit("settle", settle, "How an object settles between two fingers.");
  visit("cone_edges", cone_edges, kConeEdges, "",
        "Edges of the pyramid that stands for a friction cone, from inside: 8 leave up to 8 % of "
        "its width out, 16 up to 2 %.");
  visit("reach", reach, "How the arm follows, in scenes with one.");
  visit("formation", formation, "Whether the hand closes in time, and how.");
}

}  // namespace prehend
