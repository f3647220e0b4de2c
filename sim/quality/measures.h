// All quality measures by name, with one signature: from contacts to a number.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "sim/quality/contact.h"
#include "sim/quality/epsilon.h"
#include "sim/quality/interval.h"
#include "sim/quality/robust_epsilon.h"
#include "sim/quality/set_hull.h"
#include "sim/quality/task.h"
#include "sim/quality/wrench_space.h"

namespace prehend {

// What measures need besides the contacts. A measure that misses something throws an InputError
// that names it.
struct MeasureOptions {
  WrenchSpaceOptions space;
  std::optional<EpsilonOptions> epsilon;  // empty: epsilon_options(space)
  SetHullOptions hull;
  std::optional<Task> task;                 // task_resistance
  std::vector<Contact> surface;             // object_wrench_ratio: contacts all over the object
  NoiseOptions noise;                       // robust_*
  std::optional<Eigen::MatrixXd> jacobian;  // manipulability
};

// The value lies in the interval; both ends are equal for what is computed directly.
using Measure = Interval (*)(std::span<const Contact>, const WrenchFrame&, const MeasureOptions&);

struct NamedMeasure {
  std::string_view name;
  Measure measure = nullptr;
};

// epsilon, volume, force_closure (0 or 1), smallest_singular_value, isotropy, task_resistance,
// object_wrench_ratio, robust_mean, robust_percentile_5, robust_force_closure, manipulability.
std::span<const NamedMeasure> measures();

// Null for a name that is not among them.
const NamedMeasure* find_measure(std::string_view name);

}  // namespace prehend
