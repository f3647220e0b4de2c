#include <exception>
#include <optional>
#include <pybind11/stl.h>
#include <stdexcept>

#include "planner/python/arrays.h"
#include "planner/python/background.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/base/parallel/parallel.h"
#include "sim/quality/quality.h"

namespace prehend::python {
namespace {

// Measures take many grasps in one call, so that a data set is judged in parallel and without a
// Python call for each grasp. Results are arrays with one entry or row for each grasp.

// The contacts of many grasps, each with its frame of wrenches.
struct ContactSets {
  std::vector<std::vector<Contact>> contacts;
  std::vector<WrenchFrame> frames;

  std::size_t size() const { return contacts.size(); }
};

// All arrays have M rows; `models` are numbers of ContactModel. Grasp g has the contacts from
// offsets[g] up to offsets[g + 1].
ContactSets make_sets(const Doubles& positions, const Doubles& normals, const Doubles& friction,
                      const Doubles& torsion, const Doubles& moment, const Doubles& vacuum,
                      const std::vector<int>& models, const std::vector<std::size_t>& offsets,
                      const Doubles& origins, const Doubles& scales) {
  const std::vector<Vector3> p = vectors_of(positions);
  const std::vector<Vector3> n = vectors_of(normals);
  const std::vector<double> mu = numbers_of(friction);
  const std::vector<double> r = numbers_of(torsion);
  const std::vector<double> tilt = numbers_of(moment);
  const std::vector<double> pull = numbers_of(vacuum);
  const std::vector<Vector3> origin = vectors_of(origins);
  const std::vector<double> scale = numbers_of(scales);
  const std::size_t m = p.size();
  const std::size_t grasps = origin.size();
  if (n.size() != m || mu.size() != m || r.size() != m || tilt.size() != m || pull.size() != m ||
      models.size() != m || scale.size() != grasps || offsets.size() != grasps + 1 ||
      offsets.back() != m) {
    throw std::invalid_argument("arrays of different lengths");
  }
  ContactSets sets;
  for (std::size_t g = 0; g < grasps; ++g) {
    sets.frames.push_back({origin[g], scale[g]});
    std::vector<Contact>& contacts = sets.contacts.emplace_back();
    for (std::size_t i = offsets[g]; i < offsets.at(g + 1); ++i) {
      contacts.push_back(
          {p.at(i), n[i], mu[i], static_cast<ContactModel>(models[i]), r[i], tilt[i], pull[i]});
    }
  }
  return sets;
}

// What is found out of one grasp, and how long that may take: `quick` is well below a second.
using Judge = std::function<void(std::size_t grasp, const RunContext& context)>;
enum class Duration { quick, long_call };

// Calls `judge` for each grasp without the GIL. Several grasps are judged on several threads,
// Python can interrupt between them, and errors name the grasp. A single grasp that is judged
// quickly is judged in the calling thread, where nothing interrupts it: that saves the start of a
// thread.
void for_each_grasp(const ContactSets& sets, const CallOptions& call, const Judge& judge,
                    Duration duration = Duration::quick) {
  if (sets.size() == 1 && duration == Duration::quick) {
    const py::gil_scoped_release no_gil;
    judge(0, {});
    return;
  }
  // The threads judge several grasps at a time; each is judged by one.
  run_in_background(call, [&](const RunContext& context) {
    for_each_in_parallel(sets.size(), context.threads, [&](std::size_t g) {
      context.cancellation.check();
      try {
        judge(g, {.threads = 1, .cancellation = context.cancellation});
      } catch (const InputError& error) {
        throw error.under("grasps[" + std::to_string(g) + "]");
      }
    });
  });
}

Doubles wrench_rows(const std::vector<Wrench>& wrenches) {
  std::vector<std::vector<double>> rows;
  for (const Wrench& wrench : wrenches) rows.emplace_back(wrench.begin(), wrench.end());
  return to_array(rows, 6);
}

std::vector<Wrench> wrenches_from(const Doubles& rows) {
  const Eigen::MatrixXd matrix = matrix_of(rows);
  if (matrix.cols() != 6) throw std::invalid_argument("an array of another shape");
  std::vector<Wrench> wrenches;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) wrenches.emplace_back(matrix.row(i));
  return wrenches;
}

py::dict epsilon_of(const ContactSets& sets, const WrenchSpaceOptions& space,
                    const std::optional<EpsilonOptions>& asked, const CallOptions& call) {
  const EpsilonOptions options = asked.value_or(epsilon_options(space));
  std::vector<EpsilonBracket> found(sets.size());
  for_each_grasp(sets, call, [&](std::size_t g, const RunContext&) {
    found[g] = grasp_epsilon(sets.contacts[g], sets.frames[g], space, options);
  });
  std::vector<double> lower;
  std::vector<double> upper;
  std::vector<Wrench> weakest;
  std::vector<std::string> status;
  for (const EpsilonBracket& bracket : found) {
    lower.push_back(bracket.lower);
    upper.push_back(bracket.upper);
    weakest.push_back(bracket.weakest);
    status.emplace_back(name_of(bracket.status));
  }
  py::dict fields;
  fields["lower"] = to_array(lower);
  fields["upper"] = to_array(upper);
  fields["weakest"] = wrench_rows(weakest);
  fields["status"] = status;
  return fields;
}

// "wrenches" N x 6, "ellipsoid" 6 x 6 (axes are columns), or "gravity" 4: direction and weight.
std::optional<Task> task_from(const std::string& kind, const Doubles& numbers) {
  if (kind.empty()) return std::nullopt;
  if (kind == "wrenches") return TaskWrenches{wrenches_from(numbers)};
  const Eigen::MatrixXd matrix = matrix_of(numbers);
  if (kind == "ellipsoid" && matrix.rows() == 6 && matrix.cols() == 6) return TaskEllipsoid{matrix};
  if (kind == "gravity" && matrix.rows() == 1 && matrix.cols() == 4) {
    return TaskGravity{matrix.row(0).head<3>(), matrix(0, 3)};
  }
  throw std::invalid_argument("task: of another shape");
}

py::tuple measure_of(const ContactSets& sets, const std::string& name,
                     const MeasureOptions& options, const CallOptions& call) {
  const NamedMeasure* measure = find_measure(name);
  if (measure == nullptr) {
    const std::string known = joined(measures(), ", ", &NamedMeasure::name);
    throw InputError({.field = "name", .problem = "not one of " + known, .value = name});
  }
  std::vector<double> lower(sets.size());
  std::vector<double> upper(sets.size());
  for_each_grasp(sets, call, [&](std::size_t g, const RunContext&) {
    const Interval value = measure->measure(sets.contacts[g], sets.frames[g], options);
    lower[g] = value.lower;
    upper[g] = value.upper;
  });
  return py::make_tuple(to_array(lower), to_array(upper));
}

Doubles robust_epsilon_of(const ContactSets& sets, const WrenchSpaceOptions& space,
                          const NoiseOptions& noise, const CallOptions& call) {
  std::vector<std::vector<double>> rows(sets.size());
  const auto judge = [&](std::size_t g, const RunContext& context) {
    const RobustEpsilon found =
        robust_epsilon(sets.contacts[g], sets.frames[g], space, noise, context);
    rows[g] = {found.mean, found.percentile_5, found.force_closure};
  };
  for_each_grasp(sets, call, judge, Duration::long_call);
  return to_array(rows, 3);
}

py::dict forces_dict(const ContactForces& found) {
  py::dict fields;
  fields["outcome"] = std::string(name_of(found.outcome));
  fields["components"] = to_array(Eigen::MatrixXd(found.components.transpose()));
  fields["forces"] = to_array(Eigen::MatrixXd(found.forces.transpose()));
  fields["largest_normal"] = found.largest_normal;
  fields["sum_of_normals"] = found.sum_of_normals;
  fields["residual"] = found.residual;
  fields["lowest"] = found.lowest;
  fields["gap"] = found.gap;
  fields["separating"] =
      to_array(std::vector<double>(found.separating.begin(), found.separating.end()));
  return fields;
}

py::list balancing_forces_of(const ContactSets& sets, const Doubles& external,
                             const ForceOptions& options, const CallOptions& call) {
  const std::vector<Wrench> wrenches = wrenches_from(external);
  if (wrenches.size() != sets.size()) throw std::invalid_argument("another number of wrenches");
  std::vector<ContactForces> found(sets.size());
  for_each_grasp(sets, call, [&](std::size_t g, const RunContext&) {
    found[g] = balancing_forces(sets.contacts[g], sets.frames[g], wrenches[g], options);
  });
  py::list list;
  for (const ContactForces& forces : found) list.append(forces_dict(forces));
  return list;
}

py::tuple resistance_of(const ContactSets& sets, const Doubles& external,
                        const ForceOptions& options, const CallOptions& call) {
  const std::vector<Wrench> wrenches = wrenches_from(external);
  if (wrenches.size() != sets.size()) throw std::invalid_argument("another number of wrenches");
  std::vector<double> lower(sets.size());
  std::vector<double> upper(sets.size());
  for_each_grasp(sets, call, [&](std::size_t g, const RunContext&) {
    const Resistance found =
        wrench_resistance(sets.contacts[g], sets.frames[g], wrenches[g], options);
    lower[g] = found.lower;
    upper[g] = found.upper;
  });
  return py::make_tuple(to_array(lower), to_array(upper));
}

MeasureOptions measure_options(const WrenchSpaceOptions& space,
                               const std::optional<EpsilonOptions>& epsilon,
                               const SetHullOptions& hull, const NoiseOptions& noise,
                               const std::pair<std::string, Doubles>& task,
                               const ContactSets& surface, const std::optional<Doubles>& jacobian) {
  MeasureOptions options;
  options.space = space;
  options.epsilon = epsilon;
  options.hull = hull;
  options.noise = noise;
  options.task = task_from(task.first, task.second);
  if (surface.size() > 0) options.surface = surface.contacts.front();
  if (jacobian) options.jacobian = matrix_of(*jacobian);
  return options;
}

}  // namespace

void bind_quality(py::module_& core) {
  py::class_<ContactSets>(core, "_ContactSets").def(py::init(&make_sets));
  py::class_<MeasureOptions>(core, "_MeasureOptions").def(py::init(&measure_options));
  core.def("quality_epsilon", &epsilon_of);
  core.def("quality_measure", &measure_of);
  core.def("quality_robust_epsilon", &robust_epsilon_of);
  core.def("quality_balancing_forces", &balancing_forces_of);
  core.def("quality_wrench_resistance", &resistance_of);
  core.def("quality_grasp_matrix", [](const ContactSets& sets, std::size_t grasp) {
    return to_array(grasp_matrix(sets.contacts.at(grasp), sets.frames.at(grasp)));
  });
  core.def("quality_contact_wrenches", [](const ContactSets& sets, std::size_t grasp, int edges) {
    return to_array(Eigen::MatrixXd(
        contact_wrenches(sets.contacts.at(grasp), sets.frames.at(grasp), edges).transpose()));
  });
  core.def("quality_measures", [] {
    std::vector<std::string> names;
    for (const NamedMeasure& measure : measures()) names.emplace_back(measure.name);
    return names;
  });
}

}  // namespace prehend::python
