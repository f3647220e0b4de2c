// Outcomes of a trial, their names in files and their meanings in words.
#pragma once

#include <array>
#include <string_view>

namespace prehend {

enum class Outcome {
  stable,             // the contacts are in force closure
  not_force_closure,  // there are contacts, but some wrench on the object breaks them
  no_contact,         // the hand closed without touching the object
  hand_blocked,       // the hand collides at the pre-grasp, or where centring pushes it
  approach_blocked,   // an obstacle stops the hand before it touches the object
  unreachable,        // inverse kinematics finds no posture of the arm along the whole approach
  arm_blocked,        // such postures exist, but the arm collides in them
  no_path,  // no collision-free path of the arm from its start to the pre-grasp was found;
            // set by the planner, never by a trial
};

// All outcomes, in the order of the enumeration.
inline constexpr std::array<Outcome, 8> kOutcomes = {
    Outcome::stable,           Outcome::not_force_closure,
    Outcome::no_contact,       Outcome::hand_blocked,
    Outcome::approach_blocked, Outcome::unreachable,
    Outcome::arm_blocked,      Outcome::no_path};

// Whether the hand was stopped on its way to the object, before arm and fingers were asked.
constexpr bool is_blocked(Outcome outcome) {
  return outcome == Outcome::hand_blocked || outcome == Outcome::approach_blocked;
}

// The name in files and tables: the same word as the enumerator.
constexpr std::string_view outcome_name(Outcome outcome) {
  constexpr std::array<std::string_view, 8> kNames = {
      "stable",           "not_force_closure", "no_contact",  "hand_blocked",
      "approach_blocked", "unreachable",       "arm_blocked", "no_path"};
  return kNames[static_cast<std::size_t>(outcome)];
}

// What the outcome means, as a clause for reports.
constexpr std::string_view outcome_meaning(Outcome outcome) {
  constexpr std::array<std::string_view, 8> kMeanings = {
      "the contacts can resist a disturbance in any direction",
      "the hand touches the object, but some disturbance moves it freely",
      "the hand closed without touching the object",
      "the hand collides where it starts or where the approach ends",
      "an obstacle stops the hand before it reaches the object",
      "no posture of the arm brings the hand there",
      "the arm collides on the way along the approach",
      "the arm finds no way to where the approach starts"};
  return kMeanings[static_cast<std::size_t>(outcome)];
}

}  // namespace prehend
