#include <cmath>
#include <limits>
#include <pybind11/stl.h>

#include "planner/python/arrays.h"
#include "planner/python/options_class.h"
#include "planner/python/scene_handle.h"
#include "planner/python/world_handle.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/motion/energy.h"
#include "sim/motion/scene_bodies.h"
#include "sim/motion/step_world.h"
#include "sim/shape/mesh_checks.h"

namespace prehend::python {
namespace {

Doubles head(const Eigen::VectorXd& values, Eigen::Index count) {
  return Doubles(static_cast<py::ssize_t>(count), values.data());
}

// Python has checked the number of values with the name of the argument.
Eigen::VectorXd values_of(const Doubles& array, Eigen::Index count) {
  if (array.ndim() != 1 || array.shape(0) != count) {
    throw std::invalid_argument("another number of values");
  }
  return Eigen::Map<const Eigen::VectorXd>(array.data(), count);
}

int add_robot(WorldHandle& self, const Robot& robot, const std::string& name, const Doubles& X_WB,
              const Doubles& dofs) {
  World& world = self.extended();
  auto model = std::make_shared<const RobotModel>(make_robot_model(robot));
  (void)values_of(dofs, model->dofs());
  world.robots.push_back(make_world_robot(name, std::move(model), pose_of(X_WB), numbers_of(dofs)));
  return static_cast<int>(world.robots.size()) - 1;
}

// Without a mass it does not move.
int add_body(WorldHandle& self, const std::string& name, const Doubles& vertices,
             const Integers& faces, const Doubles& X_WB, const std::string& material,
             std::optional<double> mass, double restitution) {
  if (mass && !(*mass > 0.0 && std::isfinite(*mass))) {
    throw InputError(
        {.field = "mass", .problem = "must be positive", .value = std::to_string(*mass)});
  }
  World& world = self.extended();
  const TriangleMesh mesh = cleaned_mesh(vertices, faces);
  WorldBody body{.name = name,
                 .shape = make_collision_body(name, mesh, check_mesh(mesh).solid()),
                 .material = material_named(material)};
  body.is_fixed = !mass;
  if (mass) body.inertial = inertial_of_mass(mesh, *mass);
  body.motion.X_WB = pose_of(X_WB);
  body.restitution = restitution;
  world.bodies.push_back(std::move(body));
  return static_cast<int>(world.bodies.size()) - 1;
}

void set_friction(WorldHandle& self, const std::string& a, const std::string& b, double friction,
                  std::optional<double> kinetic) {
  ContactLaws& laws = self.now().laws;
  const Material one = material_named(a);
  const Material other = material_named(b);
  laws.friction.set(one, other, friction);
  if (kinetic && !laws.kinetic) laws.kinetic = laws.friction;
  if (laws.kinetic) laws.kinetic->set(one, other, kinetic.value_or(friction));
}

void set_positions(WorldHandle& self, std::size_t robot, const Doubles& dofs) {
  WorldRobot& moved = self.moved().robots.at(robot);
  (void)values_of(dofs, moved.model->dofs());
  moved.x = coordinates_at(*moved.model, numbers_of(dofs));
}

void set_rates(WorldHandle& self, std::size_t robot, const Doubles& rates) {
  WorldRobot& moved = self.now().robots.at(robot);
  const Eigen::VectorXd values = values_of(rates, moved.model->dofs());
  moved.rate.setZero();
  moved.rate.head(values.size()) = values;
}

void set_drives(WorldHandle& self, std::size_t robot, const std::vector<Drive>& drives) {
  WorldRobot& driven = self.now().robots.at(robot);
  for (std::size_t k = 0; k < drives.size(); ++k) {
    if (drives[k].dof < driven.model->dofs()) continue;
    throw InputError({.field = "drives[" + std::to_string(k) + "].dof",
                      .problem = "must be below " + std::to_string(driven.model->dofs()),
                      .value = std::to_string(drives[k].dof)});
  }
  driven.drives = drives;
}

Doubles efforts(const WorldRobot& robot) {
  if (robot.effort.size() > 0) return head(robot.effort, robot.effort.size());
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(robot.model->dofs());
  return head(none, none.size());
}

std::string solid_name(const World& world, const SolidId& id) {
  if (id.robot < 0) return world.bodies[index(id.index)].name;
  const WorldRobot& robot = world.robots[index(id.robot)];
  return robot.name + "/" + robot.model->robot.links[index(id.index)].name;
}

// Names of the two, where, normal, force on the first, gap and slip of each contact.
py::list contacts(WorldHandle& self) {
  const World& world = self.now();
  py::list list;
  for (const WorldContact& contact : world.contacts) {
    const Vector3 force = contact.impulse_W / world.last_step;
    list.append(py::make_tuple(solid_name(world, contact.a), solid_name(world, contact.b),
                               to_array(contact.position_W), to_array(contact.normal_W),
                               to_array(force), contact.gap, contact.slip));
  }
  return list;
}

py::tuple step(WorldHandle& self, double longest) {
  StepOptions options;
  options.step = longest;
  self.require_sound(options);
  StepResult result;
  {
    Stepping stepping(self);
    result = step_world(stepping.world(), options);
  }
  return py::make_tuple(std::string(name_of(result.outcome)), result.time, result.crossings,
                        result.violation);
}

using Class = py::class_<WorldHandle, std::shared_ptr<WorldHandle>>;

void bind_robots(Class& type) {
  const auto robot = [](WorldHandle& self, std::size_t i) -> WorldRobot& {
    return self.now().robots.at(i);
  };
  type.def("add_robot", &add_robot)
      .def("robots", [](WorldHandle& self) { return self.now().robots.size(); })
      .def("robot_name", [=](WorldHandle& self, std::size_t i) { return robot(self, i).name; })
      .def("robot", [=](WorldHandle& self, std::size_t i) { return robot(self, i).model->robot; })
      .def("positions",
           [=](WorldHandle& self, std::size_t i) {
             const WorldRobot& of = robot(self, i);
             return head(of.x, of.model->dofs());
           })
      .def("set_positions", &set_positions)
      .def("rates",
           [=](WorldHandle& self, std::size_t i) {
             const WorldRobot& of = robot(self, i);
             return head(of.rate, of.model->dofs());
           })
      .def("set_rates", &set_rates)
      .def("joints",
           [=](WorldHandle& self, std::size_t i) {
             const Eigen::VectorXd joints = joints_of(robot(self, i));
             return head(joints, joints.size());
           })
      .def("base", [=](WorldHandle& self, std::size_t i) { return to_array(robot(self, i).X_WB); })
      .def("set_base", [](WorldHandle& self, std::size_t i,
                          const Doubles& X_WB) { self.moved().robots.at(i).X_WB = pose_of(X_WB); })
      .def("efforts", [=](WorldHandle& self,
                          std::size_t i) { return prehend::python::efforts(robot(self, i)); })
      .def("set_efforts",
           [=](WorldHandle& self, std::size_t i, const Doubles& values) {
             WorldRobot& of = robot(self, i);
             of.effort = values_of(values, of.model->dofs());
           })
      .def("max_efforts",
           [=](WorldHandle& self, std::size_t i) {
             const Eigen::VectorXd& most = robot(self, i).model->effort;
             return head(most, most.size());
           })
      .def("drives", [=](WorldHandle& self, std::size_t i) { return robot(self, i).drives; })
      .def("set_drives", &set_drives);
}

void bind_bodies_of_world(Class& type) {
  const auto body = [](WorldHandle& self, std::size_t i) -> WorldBody& {
    return self.now().bodies.at(i);
  };
  type.def("add_body", &add_body)
      .def("add_bodies",
           [](WorldHandle& self, const SceneHandle& scene) {
             World& world = self.extended();
             World of_scene;
             prehend::add_bodies(scene.scene, of_scene);
             for (WorldBody& added : of_scene.bodies) world.bodies.push_back(std::move(added));
             world.laws = of_scene.laws;
           })
      .def("bodies", [](WorldHandle& self) { return self.now().bodies.size(); })
      .def("body_name", [=](WorldHandle& self, std::size_t i) { return body(self, i).name; })
      .def("body_mass",
           [=](WorldHandle& self, std::size_t i) -> std::optional<double> {
             const WorldBody& of = body(self, i);
             if (of.is_fixed) return std::nullopt;
             return of.inertial.mass;
           })
      .def("body_pose",
           [=](WorldHandle& self, std::size_t i) { return to_array(body(self, i).motion.X_WB); })
      .def("set_body_pose",
           [](WorldHandle& self, std::size_t i, const Doubles& X_WB) {
             self.moved().bodies.at(i).motion.X_WB = pose_of(X_WB);
           })
      .def("body_velocity",
           [=](WorldHandle& self, std::size_t i) {
             const RigidMotion& motion = body(self, i).motion;
             return py::make_tuple(to_array(motion.linear), to_array(motion.angular));
           })
      .def("set_body_velocity",
           [](WorldHandle& self, std::size_t i, const Doubles& linear, const Doubles& angular) {
             RigidMotion& motion = self.moved().bodies.at(i).motion;
             motion.linear = vector_of(linear);
             motion.angular = vector_of(angular);
           })
      .def("body_force",
           [=](WorldHandle& self, std::size_t i) { return to_array(body(self, i).force_W); })
      .def("set_body_force", [](WorldHandle& self, std::size_t i, const Doubles& force_W) {
        const Vector3 force = vector_of(force_W);
        World& world = self.now();
        world.bodies.at(i).force_W = force;
        for (WorldBody& of : world.bodies) of.asleep = false;
      });
}

}  // namespace

void bind_world(py::module_& core) {
  bind_settings<Drive>(core);
  Class type(core, "_World");
  type.def(py::init<>())
      .def("copy", [](WorldHandle& self) { return std::make_shared<WorldHandle>(self.now()); })
      .def("gravity", [](WorldHandle& self) { return to_array(self.now().gravity); })
      .def("set_gravity",
           [](WorldHandle& self, const Doubles& gravity) {
             const Vector3 changed = vector_of(gravity);
             self.moved().gravity = changed;
           })
      .def("set_friction", &set_friction)
      .def("energy", [](WorldHandle& self) { return energy_of(self.now()); })
      .def("contacts", &contacts)
      .def("step", &step);
  bind_robots(type);
  bind_bodies_of_world(type);
}

}  // namespace prehend::python
