// Outcomes of a trial, their names in files and their meanings in words.
#pragma once

#include <array>
#include <string_view>

#include "sim/base/named_enum.h"

namespace prehend {

enum class Outcome {
  stable,             // the contacts are in force closure
  not_force_closure,  // there are contacts, but some wrench on the object breaks them
  no_contact,         // the hand closed without touching the object
  hand_blocked,       // the hand collides at the pre-grasp, or where centring pushes it
  approach_blocked,   // an obstacle stops the hand before it touches the object
  unreachable,        // inverse kinematics finds no posture of the arm along the whole approach
  arm_blocked,        // such postures exist, but the arm collides in them
  // Of trials whose hand closes in time (DynamicGraspOptions::dynamic):
  pushed_away,    // the hand pushed the object out of its reach
  toppled,        // it pushed the object over
  squeezed_out,   // the object slipped out of the closing hand
  dropped,        // the object fell out of the hand that had lifted it
  not_simulated,  // a step of the simulation failed
  no_path,        // no collision-free path of the arm from its start to the pre-grasp was found;
                  // set by the planner, never by a trial
  keep_out,       // the hand touches a part of the object that it must keep out of
  no_seal,        // no suction cup of the hand seals on the object
};

// Whether the hand was stopped on its way to the object, before arm and fingers were asked.
constexpr bool is_blocked(Outcome outcome) {
  return outcome == Outcome::hand_blocked || outcome == Outcome::approach_blocked;
}

// The name in files and tables: the same word as the enumerator.
constexpr auto enum_names(Outcome /*of*/) {
  return std::to_array<std::string_view>(
      {"stable", "not_force_closure", "no_contact", "hand_blocked", "approach_blocked",
       "unreachable", "arm_blocked", "pushed_away", "toppled", "squeezed_out", "dropped",
       "not_simulated", "no_path", "keep_out", "no_seal"});
}

// What the outcome means, as a clause for reports.
constexpr std::string_view outcome_meaning(Outcome outcome) {
  constexpr std::array<std::string_view, kAll<Outcome>.size()> kMeanings = {
      "the contacts can resist a disturbance in any direction",
      "the hand touches the object, but some disturbance moves it freely",
      "the hand closed without touching the object",
      "the hand collides where it starts or where the approach ends",
      "an obstacle stops the hand before it reaches the object",
      "no posture of the arm brings the hand there",
      "the arm collides on the way along the approach",
      "the closing hand pushes the object out of its reach",
      "the closing hand pushes the object over",
      "the object slips out of the closing hand",
      "the object falls out of the hand that has lifted it",
      "the simulation of the closing hand could not go on",
      "the arm finds no way to where the approach starts",
      "the hand touches a part of the object that it must keep out of",
      "no suction cup of the hand seals on the object"};
  return kMeanings[static_cast<std::size_t>(outcome)];
}

}  // namespace prehend
