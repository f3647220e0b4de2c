#include "sim/quality/measures.h"

#include <algorithm>
#include <array>

#include "sim/base/input_error.h"
#include "sim/quality/grasp_matrix.h"

namespace prehend {
namespace {

// Each function below turns one measure into the common signature. Measures that enclose their
// value return both bounds, the others the value twice.
using Contacts = std::span<const Contact>;

Interval exactly(double value) { return {value, value}; }

EpsilonBracket bracket_of(Contacts contacts, const WrenchFrame& frame,
                          const MeasureOptions& options) {
  return grasp_epsilon(contacts, frame, options.space,
                       options.epsilon.value_or(epsilon_options(options.space)));
}

Interval measure_epsilon(Contacts contacts, const WrenchFrame& frame,
                         const MeasureOptions& options) {
  const EpsilonBracket bracket = bracket_of(contacts, frame, options);
  return {bracket.lower, bracket.upper};
}

Interval measure_volume(Contacts contacts, const WrenchFrame& frame,
                        const MeasureOptions& options) {
  if (contacts.empty()) return {};
  const SetHull hull = set_hull(*wrench_space(contacts, frame, options.space), options.hull);
  return {hull.volume_lower, hull.volume_upper};
}

Interval measure_force_closure(Contacts contacts, const WrenchFrame& frame,
                               const MeasureOptions& options) {
  return exactly(bracket_of(contacts, frame, options).force_closure() ? 1.0 : 0.0);
}

Interval measure_singular_value(Contacts contacts, const WrenchFrame& frame,
                                const MeasureOptions&) {
  return exactly(smallest_singular_value(grasp_matrix(contacts, frame)));
}

Interval measure_isotropy(Contacts contacts, const WrenchFrame& frame, const MeasureOptions&) {
  return exactly(isotropy(grasp_matrix(contacts, frame)));
}

Interval measure_task(Contacts contacts, const WrenchFrame& frame, const MeasureOptions& options) {
  if (!options.task) throw InputError({.field = "task_resistance", .problem = "there is no task"});
  return task_resistance(contacts, frame, *options.task, options.space);
}

Interval measure_object(Contacts contacts, const WrenchFrame& frame,
                        const MeasureOptions& options) {
  if (options.surface.empty()) {
    throw InputError(
        {.field = "object_wrench_ratio", .problem = "there are no contacts all over the object"});
  }
  return object_wrench_ratio(contacts, frame, options.surface, options.space);
}

// One function for each statistic: all samples are computed again for each of them.
template <double RobustEpsilon::*part>
Interval measure_robust(Contacts contacts, const WrenchFrame& frame,
                        const MeasureOptions& options) {
  return exactly(robust_epsilon(contacts, frame, options.space, options.noise).*part);
}

Interval measure_manipulability(Contacts, const WrenchFrame&, const MeasureOptions& options) {
  if (!options.jacobian)
    throw InputError({.field = "manipulability", .problem = "there is no jacobian"});
  return exactly(manipulability(*options.jacobian));
}

}  // namespace

std::span<const NamedMeasure> measures() {
  static constexpr std::array<NamedMeasure, 11> kMeasures = {{
      {"epsilon", measure_epsilon},
      {"volume", measure_volume},
      {"force_closure", measure_force_closure},
      {"smallest_singular_value", measure_singular_value},
      {"isotropy", measure_isotropy},
      {"task_resistance", measure_task},
      {"object_wrench_ratio", measure_object},
      {"robust_mean", measure_robust<&RobustEpsilon::mean>},
      {"robust_percentile_5", measure_robust<&RobustEpsilon::percentile_5>},
      {"robust_force_closure", measure_robust<&RobustEpsilon::force_closure>},
      {"manipulability", measure_manipulability},
  }};
  return kMeasures;
}

const NamedMeasure* find_measure(std::string_view name) {
  const auto all = measures();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const NamedMeasure& m) { return m.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace prehend
