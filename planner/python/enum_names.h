// Names of enums of sim/quality, as Python and the contacts report say them.
#pragma once

#include <string_view>

#include "sim/quality/epsilon.h"
#include "sim/quality/forces.h"

namespace prehend::python {

constexpr std::string_view status_name(EpsilonStatus status) {
  switch (status) {
    case EpsilonStatus::converged:
      return "converged";
    case EpsilonStatus::no_force_closure:
      return "no_force_closure";
    case EpsilonStatus::below_cutoff:
      return "below_cutoff";
    case EpsilonStatus::limit:
      return "limit";
    case EpsilonStatus::stalled:
      return "stalled";
  }
  return "";
}

constexpr std::string_view outcome_name(ForceOutcome outcome) {
  switch (outcome) {
    case ForceOutcome::balanced:
      return "balanced";
    case ForceOutcome::impossible:
      return "impossible";
    case ForceOutcome::limit:
      return "limit";
  }
  return "";
}

}  // namespace prehend::python
