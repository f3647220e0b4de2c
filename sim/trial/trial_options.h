// Settings of a trial that trade speed for accuracy or change its result.
#pragma once

#include "sim/base/settings.h"
#include "sim/motion/dynamic_grasp/dynamic_grasp_options.h"
#include "sim/scene/reach/reach_options.h"
#include "sim/shape/contact/contact_options.h"
#include "sim/trial/pad_contact_options.h"

namespace prehend {

struct OverlapOptions {
  static constexpr AboutSettings kAbout{"GiveWayOptions",
                                        "By how much an overlap at the start may be resolved, by "
                                        "moving the hand, instead of ending the trial; 0: none."};
  // Scans and models of hands are wrong by this much, and a light object moves aside.
  double object = 2e-3;
  // How far an arm with a stiffness of 2 N/mm yields to 10 N.
  double obstacle = 5e-3;
  double deepest = 20e-3;
};

template <SettingsOf<OverlapOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [object, obstacle, deepest] = options;
  visit("object", object, kDistance, "m", "Deepest overlap of hand and object.");
  visit("obstacle", obstacle, kDistance, "m", "Deepest overlap of a hand with obstacles only.");
  visit("deepest", deepest, kDistance, "m",
        "How deep an overlap that stays is measured; 0: it is not, as in plans, which leave such "
        "candidates out.");
}

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
  visit("angle", angle, kAngleAbove0, "rad", "Largest turn of a step.");
  visit("slide", slide, kLengthAbove0, "m",
        "Farthest that the object moves between the fingers in a step.");
  visit("steps", steps, kCount, "", "Most steps that are tried; 0: the object does not settle.");
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
  ContactKind contacts = ContactKind::soft;
  PadContactOptions pads;
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
         contacts, pads, settle, cone_edges, reach, formation] = options;
  visit("contact", contact, "What counts as a contact.");
  visit("contact_gap", contact_gap, kLengthAbove0, "m",
        "Gap at which a motion ends, up to 10 % more; at most 0.9 of the contact threshold.");
  // Within the threshold, 10 % more included.
  visit.relation("contact_gap", contact_gap <= 0.9 * contact.threshold,
                 "must be at most 0.9 of the contact threshold");
  visit("give_way", resolve_overlap, "Overlaps at the start that are resolved.");
  visit("obstacle_clearance", obstacle_clearance, kDistance, "m",
        "A hand that an obstacle stops on its approach, such as the table on which the object "
        "lies, moves back by this and closes there.");
  visit("back_off_step", back_off_step, kLengthAbove0, "m",
        "When a grasp does not hold, the hand backs off along its approach by this and closes "
        "again.");
  visit("back_off_tries", back_off_tries, kCount, "",
        "How often it does, in trials of given grasps. A search backs off only where it finds "
        "nothing (`patience`).");
  visit("contacts", contacts,
        "Of links that give way. hard: points with friction; soft: also patches that resist "
        "torque, of "
        "an elastic foundation; fem: pads of finite elements.");
  visit("pads", pads, "Pads of finite elements.");
  visit("settle", settle, "How an object settles between two fingers.");
  visit("cone_edges", cone_edges, kConeEdges, "",
        "Edges of the pyramid that stands for a friction cone, from inside: 8 leave up to 8 % of "
        "its width out, 16 up to 2 %.");
  visit("reach", reach, "How the arm follows, in scenes with one.");
  visit("formation", formation, "Whether the hand closes in time, and how.");
}

}  // namespace prehend
