// Whether a session does what it promises, looked at by those who talk to it.
#pragma once

#include <functional>
#include <string>

#include "benchmarks/live_soak/judge_reply.h"

namespace prehend::live_soak {

// Sends a request and gives the reply.
using Ask = std::function<Json(const Json&)>;

// The result of a request; an empty object where it was refused.
Json result_of(const Ask& ask, const Json& request);

// How a request has changed the session.
enum class ChangeEnd {
  refused,   // nothing has changed
  no_step,   // it was carried out and is not one step of undo: a query, or one with nothing to do
  one_step,  // it was undone and made again
};

struct JudgedChange {
  ChangeEnd end = ChangeEnd::no_step;
  Json after = {};         // the state
  std::string fault = {};  // empty: none
};

// Makes a change while nobody else does: refused it must leave all as it was; as one step of undo
// it must lead back and forth to the same states and scenes. `other` undoes it and makes it again.
JudgedChange judge_change(const Ask& ask, const Ask& other, const std::function<Json()>& make);

struct JudgedGrasp {
  bool is_evaluated = false;  // false: no hand that can close on an object
  bool is_stable = false;
  // Another epsilon, that of a hand less than a picometre away: contacts are found or not there by
  // the rounding of the pose in the message.
  bool is_at_an_edge = false;
  std::string fault = {};   // empty: none
  std::string detail = {};  // of the fault
};

// Closes the hand, which must have the outcome and the epsilon that evaluate() has for the file of
// the scene, or has a rounding error beside.
JudgedGrasp judge_grasp(const Ask& ask);

// Whether motions in this state promise to end before bodies overlap: with stop_at_contact, in a
// scene that is ready. Arms are left out: they follow the hand through whatever is there.
bool promises_no_overlap(const Json& state);

// What overlaps now; empty: nothing.
std::string overlap_of(const Ask& ask);

}  // namespace prehend::live_soak
