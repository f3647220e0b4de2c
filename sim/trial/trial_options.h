// Settings of a trial that trade speed for accuracy or change its result.
#pragma once

#include "sim/base/settings.h"
#include "sim/motion/dynamic_grasp/dynamic_grasp_options.h"
#include "sim/scene/reach/reach_options.h"
#include "sim/shape/contact/contact_options.h"

namespace prehend {

// By how much an overlap may be resolved; 0: any overlap ends the trial [m].
struct OverlapOptions {
  // Of hand and object: scans and models of hands are wrong by this much, and a light object moves
  // aside.
  double object = 2e-3;
  // Of a hand that overlaps obstacles only: how far an arm with a stiffness of 2 N/mm yields to
  // 10 N.
  double obstacle = 5e-3;
  // How deep an overlap that stays is measured (Trial::overlap); 0: it is not [m].
  double deepest = 20e-3;
};

template <SettingsOf<OverlapOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [object, obstacle, deepest] = options;
  visit("object", object, kAtLeast0);
  visit("obstacle", obstacle, kAtLeast0);
  visit("deepest", deepest, kAtLeast0);
}

// How an object settles between two self-centering fingers that do not hold it (see settle.h).
struct SettleOptions {
  double angle = 0.07;  // largest turn of a step [rad]
  double slide = 2e-3;  // farthest that the object moves between the fingers in a step [m]
  int steps = 48;       // most that are tried; 0: the object does not settle
  // A step that does not bring the fingers closer is tried again with half the motion, down to this
  // part of the largest one. Its angle then moves the surface, over the width of a finger, by less
  // than contacts need to count as even (ContactOptions::evenness).
  double least_part = 3.5e-3;
  // Fingers open by this before the object moves, so that they do not start inside it [m].
  double loosen = 3e-3;
  // Settling goes on while the fingers come closer by more than this in a step [m].
  double least_gain = 1e-6;
  // Forces of the fingers count as balanced when their sum is below this part of one of them, and
  // the distance between their lines of action below least_arm [m].
  double least_force = 1e-2;
  double least_arm = 1e-4;
};

template <SettingsOf<SettleOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [angle, slide, steps, least_part, loosen, least_gain, least_force, least_arm] = options;
  visit("angle", angle, kAbove0);
  visit("slide", slide, kAbove0);
  visit("steps", steps, kAtLeast0);
  visit("least_part", least_part, Range{.upper = 1.0, .without_lower = true});
  visit("loosen", loosen, kAtLeast0);
  visit("least_gain", least_gain, kAtLeast0);
  visit("least_force", least_force, kAtLeast0);
  visit("least_arm", least_arm, kAtLeast0);
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

// Settings of a trial. The defaults suit household objects in SI units.
struct TrialOptions {
  ContactOptions contact;
  // Gap at which a motion ends, up to 10 % more; above 0 and at most 0.9 contact.threshold [m].
  // Motions end at one gap instead of anywhere below the threshold so that the contacts found do
  // not depend on the steps by which they were reached.
  double contact_gap = 5e-5;
  OverlapOptions resolve_overlap;
  // A hand that an obstacle stops on its approach, such as the table on which the object lies,
  // moves back by this and closes there [m].
  double obstacle_clearance = 1e-3;
  // When a grasp does not hold, the hand backs off along its approach by this and closes again, at
  // most back_off_tries times [m].
  double back_off_step = 8e-3;
  int back_off_tries = 1;
  // Whether compliant links make patch contacts that resist torque about the normal (soft finger);
  // if not, all contacts are hard points with friction.
  bool soft_fingers = true;
  SettleOptions settle;
  // Edges of the pyramid that approximates each friction cone (>= 3).
  int cone_edges = 8;
  ReachOptions reach;  // used in scenes with an arm
  // Most gap queries for one pair of bodies in one motion. A pair that needs more counts as
  // touching where it is: the motion may then end short of a contact, but never in a penetration.
  int max_gap_queries = 400;
  GapTrackerOptions gaps;
  DynamicGraspOptions formation;  // whether the hand closes in time, and how

  // Largest gap that counts as touching [m]. The 10 % above contact_gap make the last step end:
  // steps of (gap - contact_gap) approach contact_gap without reaching it.
  double closed_gap() const { return 1.1 * contact_gap; }
};

template <SettingsOf<TrialOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [contact, contact_gap, resolve_overlap, obstacle_clearance, back_off_step, back_off_tries,
         soft_fingers, settle, cone_edges, reach, max_gap_queries, gaps, formation] = options;
  visit("contact", contact);
  visit("contact_gap", contact_gap, kAbove0);
  visit("give_way", resolve_overlap);
  visit("obstacle_clearance", obstacle_clearance, kAtLeast0);
  visit("back_off_step", back_off_step, kAbove0);
  visit("back_off_tries", back_off_tries, kAtLeast0);
  visit("soft_fingers", soft_fingers);
  visit("settle", settle);
  visit("cone_edges", cone_edges, Range{.lower = 3.0});
  visit("reach", reach);
  visit("max_gap_queries", max_gap_queries, kAtLeast1);
  visit("gaps", gaps);
  visit("formation", formation);
}

}  // namespace prehend
