// What became of a grasp that was closed, lifted and shaken.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/named_enum.h"
#include "sim/manipulation/test_procedure.h"
#include "sim/motion/step_outcome.h"

namespace prehend {

// How a test, or the preparation before all tests, ended.
enum class ShakeOutcome {
  survived,
  moved,          // the object moved in the hand farther than the phase allows
  turned,         // it turned by more
  dropped,        // it sank by more
  not_lifted,     // it rose by less
  lost_contact,   // no link touches it at the end of the phase
  not_released,   // it did not fall from the open hand
  not_simulated,  // a step failed: the report says how and when
  unreachable,    // the arm that carries the hand cannot follow the motion of the phase
};

// The name in files: the same word as the enumerator.
constexpr auto enum_names(ShakeOutcome /*of*/) {
  return std::to_array<std::string_view>({"survived", "moved", "turned", "dropped", "not_lifted",
                                          "lost_contact", "not_released", "not_simulated",
                                          "unreachable"});
}

// What happened during a phase. The object's motion is that of its centre of mass and its axes in
// the hand's base frame, since the phase began.
struct PhaseReport {
  PhaseKind kind = PhaseKind::hold;
  double seconds = 0.0;  // that it took
  double moved = 0.0;    // farthest during the phase [m]
  double turned = 0.0;   // [rad]
  double sank = 0.0;     // lowest in the world below where it began [m]
  double rose = 0.0;     // at the end, above where it began [m]
  int touching = 0;      // links that touch the object at the end
};

// A contact that slid on the object.
struct FirstSlip {
  std::string link;
  double time = 0.0;  // since the test began [s]
};

struct ShakeTestReport {
  std::string name;  // of the test; "prepare" before all tests
  ShakeOutcome outcome = ShakeOutcome::survived;
  double failed_at = 0.0;  // since the test began [s]; of no meaning where it survived
  std::vector<PhaseReport> phases = {};
  std::optional<FirstSlip> first_slip = {};
  // What its growing pulls reached before it failed; none without such a phase [m/s^2].
  std::optional<double> largest_pull = {};
};

// How much work the simulation was, and how well it went.
struct SimulationEffort {
  int steps = 0;
  int shortened = 0;       // tries of steps that had to be shorter
  int not_converged = 0;   // steps that met the law of contact less well than to the tolerance
  int crossings = 0;       // pairs of surfaces that began to cross by a little
  double violation = 0.0;  // of that law, at most
  double simulated = 0.0;  // [s]
  StepOutcome last = StepOutcome::moved;  // of a run that was not simulated to its end
};

struct ShakeReport {
  std::string procedure;
  std::vector<ShakeTestReport> tests;  // "prepare" first, where the protocol has one
  SimulationEffort effort;
  // Tests that were survived, and how many there are; without the preparation.
  int survived() const;
  int count() const;
  // All tests, after a preparation that did not fail.
  bool holds() const;
  // The largest disturbance survived: what growing pulls reached before the grasp failed, in the
  // weakest of their tests; none without such a test [m/s^2].
  std::optional<double> largest_pull() const;
};

}  // namespace prehend
