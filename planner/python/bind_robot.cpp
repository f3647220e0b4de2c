#include <pybind11/stl.h>

#include "planner/python/arrays.h"
#include "sim/base/index.h"
#include "sim/robot/files/platform_file.h"
#include "sim/robot/files/robot_file.h"
#include "sim/robot/inverse_kinematics.h"

namespace prehend::python {
namespace {

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& list) {
  std::vector<std::string> names;
  for (const Named& item : list) names.push_back(item.name);
  return names;
}

// The joint that carries the robot's tip: the last of its first chain; -1: nothing moves.
int tip_joint(const Robot& robot) {
  if (robot.chains.empty()) return -1;
  const Chain& chain = robot.chains.front();
  return chain.first_joint + chain.joint_count - 1;
}

Doubles dof_limits(const Robot& robot) {
  std::vector<std::vector<double>> limits;
  for (const DegreeOfFreedom& dof : robot.dofs) limits.push_back({dof.lower, dof.upper});
  return to_array(limits, 2);
}

py::list preshapes(const Robot& robot) {
  py::list list;
  if (!robot.hand) return list;
  for (const Preshape& shape : robot.hand->preshapes) {
    list.append(py::make_tuple(shape.name, to_array(shape.dofs), shape.min_width, shape.max_width));
  }
  return list;
}

std::vector<std::string> strategies(const Robot& robot) {
  std::vector<std::string> names;
  if (!robot.hand) return names;
  for (const ClosingStrategy& strategy : robot.hand->strategies) names.push_back(strategy.name);
  return names;
}

// Values of joints or degrees of freedom. Python has checked their number with the name of the
// argument; the functions below would read beyond the end.
std::vector<double> sized(const Doubles& values, std::size_t size) {
  std::vector<double> numbers = numbers_of(values);
  if (numbers.size() != size) throw std::invalid_argument("another number of values");
  return numbers;
}

std::vector<IkTarget> targets_of(const Robot& robot, const std::vector<int>& joints,
                                 const Doubles& X_JT, const Doubles& X_BT) {
  const std::vector<Pose> in_joint = poses_of(X_JT);
  const std::vector<Pose> in_base = poses_of(X_BT);
  if (in_joint.size() != joints.size() || in_base.size() != joints.size() || joints.empty()) {
    throw std::invalid_argument("another number of targets");
  }
  std::vector<IkTarget> targets;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i] < 0 || index(joints[i]) >= robot.joints.size()) {
      throw std::invalid_argument("no such joint");
    }
    targets.push_back({joints[i], in_joint[i], in_base[i]});
  }
  return targets;
}

py::object solve_near_in_python(const Robot& robot, const std::vector<int>& joints,
                                const Doubles& X_JT, const Doubles& X_BT, const Doubles& start,
                                const IkOptions& options) {
  const std::vector<IkTarget> targets = targets_of(robot, joints, X_JT, X_BT);
  const DofValues from = sized(start, robot.dofs.size());
  std::optional<DofValues> found;
  {
    const py::gil_scoped_release no_gil;
    found = solve_near(robot, targets, from, options);
  }
  return found ? py::object(to_array(*found)) : py::none();
}

Doubles solve_all_in_python(const Robot& robot, const std::vector<int>& joints, const Doubles& X_JT,
                            const Doubles& X_BT, const Doubles& start, const IkOptions& options) {
  const std::vector<IkTarget> targets = targets_of(robot, joints, X_JT, X_BT);
  const DofValues from = sized(start, robot.dofs.size());
  std::vector<DofValues> found;
  {
    const py::gil_scoped_release no_gil;
    found = solve_all(robot, targets, from, options);
  }
  return to_array(found, robot.dofs.size());
}

// The public attributes of the class. bind_robot adds those with an underscore, which only the
// package itself uses.
py::class_<Robot> bind_robot_class(py::module_& core) {
  return py::class_<Robot>(
             core, "Robot",
             "A hand, an arm, or several robots as one, as data. Made by find_robot() and "
             "find_platform().")
      .def_readonly("name", &Robot::name, "What its file calls it.")
      .def_property_readonly(
          "is_hand", [](const Robot& self) { return self.hand.has_value(); },
          "Whether it can grasp.")
      .def_property_readonly(
          "joints", [](const Robot& self) { return names_of(self.joints); },
          "Names of the J joints.")
      .def_property_readonly(
          "dofs", [](const Robot& self) { return names_of(self.dofs); },
          "Names of the D degrees of freedom.")
      .def_property_readonly(
          "links", [](const Robot& self) { return names_of(self.links); },
          "Names of the L links, the base first.")
      .def_property_readonly("dof_limits", &dof_limits,
                             "(D, 2): lower and upper limits [rad or m].")
      .def_property_readonly(
          "initial", [](const Robot& self) { return to_array(initial_dofs(self)); },
          "(D,): where the degrees of freedom start [rad or m].")
      .def_readonly("notes", &Robot::notes,
                    "What the reader of its file assumed, left out or repaired: one line each.")
      .def_property_readonly("tip_joint", &tip_joint,
                             "Number of the last joint of the first chain, which carries the tip.")
      .def("__repr__", [](const Robot& self) {
        return "<prehend.Robot " + self.name + ": " + std::to_string(self.dofs.size()) +
               " degrees of freedom>";
      });
}

}  // namespace

void bind_robot(py::module_& core) {
  bind_robot_class(core)
      .def_property_readonly("_preshapes", &preshapes)
      .def_property_readonly("_strategies", &strategies)
      .def_property_readonly(
          "_approach",
          [](const Robot& self) {
            return to_array(self.hand ? self.hand->approach : Vector3(Vector3::UnitZ()));
          })
      .def("_joint_values",
           [](const Robot& self, const Doubles& dofs) {
             return to_array(joint_values(self, sized(dofs, self.dofs.size())));
           })
      .def("_link_poses",
           [](const Robot& self, const Doubles& joints) {
             std::vector<Pose> poses;
             link_poses(self, sized(joints, self.joints.size()), poses);
             return to_array(poses);
           })
      .def("_joint_poses",
           [](const Robot& self, const Doubles& joints) {
             std::vector<Pose> poses;
             joint_poses(self, sized(joints, self.joints.size()), poses);
             return to_array(poses);
           })
      .def("_link_mesh", [](const Robot& self, std::size_t link) {
        const TriangleMesh& mesh = self.links.at(link).mesh;
        return py::make_tuple(to_array(mesh.vertices), to_array(mesh.triangles));
      });
  core.def("find_robot", [](const std::string& name) { return find_robot(name); });
  core.def("find_platform",
           [](const std::string& name) { return assemble(find_platform(name)).robot; });
  core.def("library_robot_names", &library_robot_names);
  core.def("library_platform_names", &library_platform_names);
  core.def("solve_near", &solve_near_in_python);
  core.def("solve_all", &solve_all_in_python);
}

}  // namespace prehend::python
