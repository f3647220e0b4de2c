#include "planner/python/controller_handle.h"

#include <memory>
#include <utility>

#include "planner/python/arrays.h"
#include "sim/base/input_error.h"

namespace prehend::python {
namespace {

// A callable of Python that C++ may copy and drop without the GIL.
std::shared_ptr<const py::object> shared(const py::object& callable) {
  return {new py::object(callable), [](const py::object* object) {
            const py::gil_scoped_acquire gil;
            delete object;
          }};
}

std::string shape_words(const py::array& array) {
  return py::str(py::tuple(array.attr("shape"))).cast<std::string>();
}

// A number or a row of numbers. `field`: who answered so, for errors.
Eigen::VectorXd numbers_from(const py::object& answer, const std::string& field) {
  Doubles array = answer.is_none() ? Doubles() : Doubles::ensure(answer);
  if (answer.is_none() || !array) {
    throw InputError({.field = field,
                      .problem = "must answer with an array of numbers",
                      .value = py::str(py::type::of(answer).attr("__name__")).cast<std::string>()});
  }
  if (array.ndim() > 1) {
    throw InputError({.field = field,
                      .problem = "must answer with a row of numbers",
                      .value = "shape " + shape_words(array)});
  }
  return Eigen::Map<const Eigen::VectorXd>(array.data(), array.size());
}

void require_callable(const py::object& object, const std::string& field,
                      const std::string& problem) {
  if (PyCallable_Check(object.ptr()) != 0) return;
  throw InputError({.field = field,
                    .problem = problem,
                    .value = py::str(py::type::of(object).attr("__name__")).cast<std::string>()});
}

Eigen::VectorXd of_size(Eigen::VectorXd values, Eigen::Index dofs) {
  if (values.size() == dofs) return values;
  throw InputError(
      {.field = "motion",
       .problem = "must have a number for each of " + std::to_string(dofs) + " degrees of freedom",
       .value = std::to_string(values.size())});
}

}  // namespace

ControllerHandle controller_of(const py::object& controller) {
  if (py::isinstance<ControllerHandle>(controller)) return controller.cast<ControllerHandle>();
  require_callable(controller, "controller", "must be a controller, or a function of a state");
  return {[call = shared(controller)](const ControlState& state) -> Eigen::VectorXd {
            const py::gil_scoped_acquire gil;
            const py::object answer =
                (*call)(StateHandle{state.time, state.step, state.robot, state.gravity_W});
            return numbers_from(answer, state.robot.name + ": controller");
          },
          true};
}

MotionHandle motion_of(const py::object& motion, Eigen::Index dofs) {
  if (py::isinstance<MotionHandle>(motion)) {
    MotionHandle handle = motion.cast<MotionHandle>();
    (void)of_size(handle.motion(0.0), dofs);
    return handle;
  }
  if (py::isinstance<py::array>(motion)) {
    const Eigen::VectorXd still = of_size(numbers_from(motion, "motion"), dofs);
    return {[still](double) { return still; }, false};
  }
  require_callable(motion, "motion", "must be values, or a function of time");
  return {[call = shared(motion), dofs](double time) -> Eigen::VectorXd {
            const py::gil_scoped_acquire gil;
            return of_size(numbers_from((*call)(time), "motion"), dofs);
          },
          true};
}

Controller made_for(const RobotModel& model, Controller controller) {
  return [dofs = model.dofs(), controller = std::move(controller)](const ControlState& state) {
    const Eigen::Index there = state.robot.model->dofs();
    if (there != dofs) {
      throw InputError(
          {.field = state.robot.name + ": controller",
           .problem = "is of a robot with " + std::to_string(dofs) + " degrees of freedom",
           .value = std::to_string(there)});
    }
    return controller(state);
  };
}

}  // namespace prehend::python
