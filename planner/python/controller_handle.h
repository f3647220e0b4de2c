// Controllers and motions as Python holds them, and those that are Python functions.
#pragma once

#include <pybind11/pybind11.h>
#include <string>

#include "sim/motion/control/controller.h"

namespace prehend::python {

namespace py = pybind11;

// What a controller is told. It is a copy, so that Python may keep it.
struct StateHandle {
  double time = 0.0;
  double step = 0.0;
  WorldRobot robot;
  Vector3 gravity_W = Vector3::Zero();
};

struct ControllerHandle {
  Controller controller;
  bool asks_python = false;  // it calls Python functions: the GIL is taken for them
};

struct MotionHandle {
  JointMotion motion;
  bool asks_python = false;
};

// A controller of C++ as it is, or a callable that takes a ControlState and returns the efforts, as
// an array of them. The callable is called with the GIL, and what it raises ends the run. Whatever
// is not an array of numbers throws InputError; another number of them does not: it ends the run
// with an outcome.
ControllerHandle controller_of(const py::object& controller);

// A motion of C++ as it is, the values where it stands still, or a callable that takes a time and
// returns them; one number for each of `dofs`. Throws InputError for another number of them, also
// when it is called.
MotionHandle motion_of(const py::object& motion, Eigen::Index dofs);

// Refuses robots with another number of degrees of freedom, for which it was not made.
Controller made_for(const RobotModel& model, Controller controller);

}  // namespace prehend::python
