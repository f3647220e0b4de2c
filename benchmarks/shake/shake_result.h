// What a protocol did to a grasp, in any simulator.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/named_enum.h"
#include "sim/manipulation/test_procedure.h"

namespace prehend::bench {

// What was measured during a phase. Motions in the hand are those in its base frame, since the
// phase began.
struct PhaseMeasure {
  double moved = 0.0;      // farthest that the object's centre of mass was in the hand [m]
  double turned = 0.0;     // most that the object turned in the hand [rad]
  double moved_end = 0.0;  // of the centre of mass, at the end [m]
  double dropped = 0.0;    // most that the object sank in the world [m]
  double rise = 0.0;       // of the object in the world, at the end; negative: it sank [m]
  bool in_contact = true;  // a link pressed on the object at the end
  double deepest = 0.0;    // by which a link and the object overlapped, most [m]
};

// Why a phase failed.
enum class PhaseFailure {
  none,
  moved,
  turned,
  dropped,
  did_not_rise,
  lost_contact,
  did_not_fall,
  unstable,  // the simulator could not go on
};

constexpr auto enum_names(PhaseFailure /*of*/) {
  return std::to_array<std::string_view>({"none", "moved", "turned", "dropped", "did_not_rise",
                                          "lost_contact", "did_not_fall", "unstable"});
}

struct PhaseResult {
  PhaseKind kind = PhaseKind::hold;
  PhaseMeasure measure;
  PhaseFailure failure = PhaseFailure::none;
};

// The phases up to the first that failed.
struct ShakeTestResult {
  std::string name;
  std::vector<PhaseResult> phases;

  bool survived() const { return phases.empty() || phases.back().failure == PhaseFailure::none; }
};

struct ShakeResult {
  ShakeTestResult prepare;
  std::vector<ShakeTestResult> tests;  // none where the preparation failed
  double steps = 0.0;                  // of all phases together
  double opened = 0.0;  // part of the way to its preshape by which the hand was opened at the start

  bool survived() const {
    return prepare.survived() && !tests.empty() &&
           std::all_of(tests.begin(), tests.end(),
                       [](const ShakeTestResult& test) { return test.survived(); });
  }
};

// The first limit that a phase exceeded.
constexpr PhaseFailure judged(const PhaseMeasure& measure, const PhaseLimits& limits) {
  if (measure.moved > limits.moved) return PhaseFailure::moved;
  if (measure.turned > limits.turned) return PhaseFailure::turned;
  if (measure.dropped > limits.dropped) return PhaseFailure::dropped;
  if (measure.rise < limits.least_rise && limits.least_rise > 0.0) {
    return PhaseFailure::did_not_rise;
  }
  if (limits.loses_contact && !measure.in_contact) return PhaseFailure::lost_contact;
  if (limits.least_fall > 0.0 && -measure.rise < limits.least_fall) {
    return PhaseFailure::did_not_fall;
  }
  return PhaseFailure::none;
}

}  // namespace prehend::bench
