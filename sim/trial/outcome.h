// How a trial ends.
#pragma once

#include <array>
#include <string_view>

namespace prehend {

enum class Outcome {
  stable,             // contacts in force closure
  not_force_closure,  // contacts that some wrench breaks
  no_contact,         // the hand closed on nothing
  hand_blocked,      // the hand collides where it starts, or where its palm is pushed to at the end
  approach_blocked,  // an obstacle stops the hand before it reaches the object
  unreachable,       // no posture of the arm brings the hand there along the approach
  arm_blocked,       // the arm collides in the posture that would, or on the line
  no_path,  // the arm finds no way from its start to the pre-grasp; found out by the planner
};

inline constexpr std::array<Outcome, 8> kOutcomes = {
    Outcome::stable,           Outcome::not_force_closure,
    Outcome::no_contact,       Outcome::hand_blocked,
    Outcome::approach_blocked, Outcome::unreachable,
    Outcome::arm_blocked,      Outcome::no_path};

constexpr std::string_view outcome_name(Outcome outcome) {
  constexpr std::array<std::string_view, 8> kNames = {
      "stable",           "not_force_closure", "no_contact",  "hand_blocked",
      "approach_blocked", "unreachable",       "arm_blocked", "no_path"};
  return kNames[static_cast<std::size_t>(outcome)];
}

// For a person who has not seen the word before.
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
