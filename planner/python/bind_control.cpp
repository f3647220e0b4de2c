#include <chrono>
#include <pybind11/stl.h>
#include <utility>
#include <vector>

#include "planner/python/arrays.h"
#include "planner/python/controller_handle.h"
#include "planner/python/world_handle.h"
#include "sim/base/input_error.h"
#include "sim/base/run_context.h"
#include "sim/motion/control/joint_motion.h"
#include "sim/motion/control/run_controlled.h"
#include "sim/motion/control/stated_gains.h"
#include "sim/motion/control/wrist_impedance.h"

namespace prehend::python {
namespace {

Doubles row(const Eigen::VectorXd& values) {
  return Doubles(static_cast<py::ssize_t>(values.size()), values.data());
}

Eigen::VectorXd vector_from(const Doubles& array) {
  const std::vector<double> numbers = numbers_of(array);
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

const WorldRobot& robot_of(WorldHandle& world, std::size_t robot) {
  return world.now().robots.at(robot);
}

py::tuple gains_tuple(const PdGains& gains) {
  return py::make_tuple(row(gains.stiffness), row(gains.damping));
}

ControllerHandle pd(WorldHandle& world, std::size_t robot, const Doubles& stiffness,
                    const Doubles& damping, const py::object& motion) {
  const RobotModel& model = *robot_of(world, robot).model;
  const MotionHandle follows = motion_of(motion, model.dofs());
  const PdGains gains{vector_from(stiffness), vector_from(damping)};
  return {made_for(model, pd_controller(model, gains, follows.motion)), follows.asks_python};
}

ControllerHandle torque(WorldHandle& world, std::size_t robot, const py::object& motion,
                        double frequency) {
  const RobotModel& model = *robot_of(world, robot).model;
  const MotionHandle follows = motion_of(motion, model.dofs());
  return {made_for(model, computed_torque(follows.motion, frequency)), follows.asks_python};
}

ControllerHandle impedance(WorldHandle& world, std::size_t robot, int joint, const Doubles& X_WT,
                           double stiffness, double turning_stiffness, double damping_ratio) {
  const RobotModel& model = *robot_of(world, robot).model;
  const WristImpedance springs{stiffness, turning_stiffness, damping_ratio};
  return {made_for(model, wrist_impedance(model, joint, pose_of(X_WT), springs)), false};
}

ControllerHandle sum(const std::vector<py::object>& parts) {
  std::vector<Controller> controllers;
  bool asks_python = false;
  for (const py::object& part : parts) {
    ControllerHandle handle = controller_of(part);
    asks_python = asks_python || handle.asks_python;
    // A sum of efforts of different sizes has none.
    controllers.push_back([controller = std::move(handle.controller)](const ControlState& state) {
      Eigen::VectorXd efforts = controller(state);
      if (efforts.size() == state.robot.model->dofs()) return efforts;
      throw InputError(
          {.field = state.robot.name + ": controller",
           .problem = "must answer with " + std::to_string(state.robot.model->dofs()) + " efforts",
           .value = std::to_string(efforts.size())});
    });
  }
  return {sum_of(std::move(controllers)), asks_python};
}

MotionHandle along(WorldHandle& world, std::size_t robot, const std::vector<std::string>& joints,
                   const Doubles& times, const Doubles& positions, const Doubles& velocities,
                   const Doubles& rest) {
  Trajectory trajectory;
  trajectory.joints = joints;
  trajectory.times = numbers_of(times);
  const auto rows = [&](const Doubles& array) {
    const Eigen::MatrixXd matrix = matrix_of(array);
    if (matrix.rows() != static_cast<Eigen::Index>(trajectory.times.size()) ||
        matrix.cols() != static_cast<Eigen::Index>(joints.size())) {
      throw std::invalid_argument("another number of samples");
    }
    std::vector<std::vector<double>> list;
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      const Eigen::VectorXd sample = matrix.row(i);
      list.emplace_back(sample.begin(), sample.end());
    }
    return list;
  };
  trajectory.positions = rows(positions);
  trajectory.velocities = rows(velocities);
  return {motion_along(trajectory, robot_of(world, robot).model->robot, vector_from(rest)), false};
}

// Between two steps: lets Python handle signals now and then, and asks whether to stop.
class Watcher {
 public:
  Watcher(WorldHandle& handle, const py::object& stops) : handle_(handle), stops_(stops) {}

  bool stops(double time) {
    // How long a signal may wait.
    constexpr std::chrono::milliseconds kLongestWait(20);
    const auto now = std::chrono::steady_clock::now();
    const bool is_asked = stops_.ptr() != Py_None;
    if (!is_asked && now - looked_ < kLongestWait) return false;
    looked_ = now;
    const Asking asking(handle_);
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    return is_asked && py::bool_(stops_(time));
  }

 private:
  WorldHandle& handle_;
  const py::object& stops_;
  std::chrono::steady_clock::time_point looked_ = std::chrono::steady_clock::now();
};

py::tuple run(WorldHandle& self, const std::vector<std::pair<int, py::object>>& controllers,
              double seconds, double step, const py::object& stops,
              const std::optional<Cancellation>& cancellation) {
  std::vector<ControlledRobot> robots;
  for (const auto& [robot, object] : controllers) {
    const ControllerHandle handle = controller_of(object);
    Controller controller = handle.controller;
    if (handle.asks_python) {
      controller = [&self, asked = handle.controller](const ControlState& state) {
        const Asking asking(self);
        return asked(state);
      };
    }
    robots.push_back({robot, std::move(controller)});
  }
  Watcher watcher(self, stops);
  ControlledRunOptions options{.seconds = seconds};
  options.step.step = step;
  options.stops = [&](double time, const World&) { return watcher.stops(time); };
  RunContext context;
  if (cancellation) context.cancellation = *cancellation;
  ControlledRun done;
  {
    Stepping stepping(self);
    done = run_controlled(stepping.world(), robots, options, context);
  }
  return py::make_tuple(std::string(name_of(done.outcome)), done.time, done.steps,
                        done.not_converged, done.why);
}

void bind_state(py::module_& core) {
  py::class_<StateHandle>(
      core, "ControlState",
      "What a controller knows of its robot when it is asked: a copy, which may "
      "be kept. Also WorldRobot.state().")
      .def_readonly("time", &StateHandle::time, "Since the run began [s].")
      .def_readonly("step", &StateHandle::step, "For how long the efforts will act, at most [s].")
      .def_property_readonly(
          "positions",
          [](const StateHandle& self) { return row(self.robot.x.head(self.robot.model->dofs())); },
          "(D,): of the degrees of freedom [rad or m].")
      .def_property_readonly(
          "rates",
          [](const StateHandle& self) {
            return row(self.robot.rate.head(self.robot.model->dofs()));
          },
          "(D,): of the degrees of freedom [rad/s or m/s].")
      .def_property_readonly(
          "joints", [](const StateHandle& self) { return row(joints_of(self.robot)); },
          "(J,): values of the joints, with what clutches have slipped [rad or m].")
      .def_property_readonly(
          "X_WB", [](const StateHandle& self) { return to_array(self.robot.X_WB); },
          "(4, 4): the robot's base in the world.")
      .def_property_readonly(
          "gravity", [](const StateHandle& self) { return to_array(self.gravity_W); },
          "(3,), world [m/s^2].");
}

void bind_controllers(py::module_& core) {
  py::class_<ControllerHandle>(
      core, "Controller",
      "A controller of prehend: called with a ControlState, it returns the "
      "efforts (D,) of the degrees of freedom [N m or N].")
      .def("__call__", [](const ControllerHandle& self, const StateHandle& state) {
        return row(self.controller({state.time, state.step, state.robot, state.gravity_W}));
      });
  py::class_<MotionHandle>(core, "Motion",
                           "A motion to be followed: called with a time [s], it returns the values "
                           "(D,) of the degrees of freedom [rad or m]. Made by motion_along().")
      .def("__call__",
           [](const MotionHandle& self, double time) { return row(self.motion(time)); });
  core.def("pd_controller", &pd);
  core.def("gravity_compensation", [] { return ControllerHandle{gravity_compensation(), false}; });
  core.def("computed_torque", &torque);
  core.def("wrist_impedance", &impedance);
  core.def("sum_of", &sum);
  core.def("motion_along", &along);
}

}  // namespace

void bind_control(py::module_& core) {
  bind_state(core);
  bind_controllers(core);
  core.def("control_state", [](WorldHandle& world, std::size_t robot, double time, double step) {
    return StateHandle{time, step, robot_of(world, robot), world.now().gravity};
  });
  core.def("critically_damped", [](WorldHandle& world, std::size_t robot, double frequency) {
    return gains_tuple(critically_damped(robot_of(world, robot), frequency));
  });
  core.def("stated_gains", [](WorldHandle& world, std::size_t robot, double frequency) {
    return gains_tuple(stated_gains(robot_of(world, robot), frequency));
  });
  core.def("set_points", [](const Robot& robot, const std::string& preshape) {
    return row(set_points(robot, preshape));
  });
  core.def("pd_drives", [](WorldHandle& world, std::size_t robot, const Doubles& stiffness,
                           const Doubles& damping, const Doubles& values) {
    const PdGains gains{vector_from(stiffness), vector_from(damping)};
    return pd_drives(*robot_of(world, robot).model, gains, vector_from(values));
  });
  core.def("run_controlled", &run);
}

}  // namespace prehend::python
