#include "sim/manipulation/recording.h"

#include "sim/base/index.h"

namespace prehend {
namespace {

// Drives stand first among what acts in the joints of a robot.
Eigen::VectorXd efforts_of(const WorldRobot& robot) {
  const Eigen::Index dofs = robot.model->dofs();
  Eigen::VectorXd efforts =
      robot.effort.size() > 0 ? robot.effort : Eigen::VectorXd(Eigen::VectorXd::Zero(dofs));
  if (robot.joint_impulses.size() < robot.drives.size()) return efforts;
  for (std::size_t d = 0; d < robot.drives.size(); ++d) {
    efforts[robot.drives[d].dof] += robot.joint_impulses[d];
  }
  return efforts;
}

void add_body_names(const std::string& name, std::vector<std::string>& names) {
  for (const char* part :
       {"x", "y", "z", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "wx", "wy", "wz"}) {
    names.push_back(name + "." + part);
  }
}

void add_body(const WorldBody& body, const RigidMotion& motion, std::vector<double>& values) {
  const Eigen::Quaterniond q(motion.X_WB.linear());
  const auto add = [&](const auto& v) {
    for (int i = 0; i < v.size(); ++i) values.push_back(v[i]);
  };
  add(center_in_world(body.inertial, motion.X_WB));
  add(Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()));
  add(motion.linear);
  add(motion.angular);
}

// All that may press on the object: bodies, then links.
std::vector<SolidId> others(const World& world) {
  std::vector<SolidId> solids;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const SolidId id{-1, static_cast<int>(i)};
    if (id != kObjectSolid) solids.push_back(id);
  }
  for (std::size_t r = 0; r < world.robots.size(); ++r) {
    for (std::size_t l = 0; l < world.robots[r].model->shapes.size(); ++l) {
      solids.push_back({static_cast<int>(r), static_cast<int>(l)});
    }
  }
  return solids;
}

double force_on_object(const WorldFrame& frame, const SolidId& by) {
  double sum = 0.0;
  for (const WorldFrame::Force& force : frame.forces) {
    const bool acts =
        (force.a == kObjectSolid && force.b == by) || (force.b == kObjectSolid && force.a == by);
    if (acts) sum += force.normal_W.dot(force.force_W);
  }
  return sum;
}

}  // namespace

WorldFrame frame_of(const World& world, double time) {
  WorldFrame frame{.time = time, .bodies = {}, .robots = {}, .forces = {}};
  for (const WorldBody& body : world.bodies) frame.bodies.push_back(body.motion);
  for (const WorldRobot& robot : world.robots) {
    frame.robots.push_back({robot.X_WB, robot.x, robot.rate, efforts_of(robot)});
  }
  if (!(world.last_step > 0.0)) return frame;
  for (const WorldContact& contact : world.contacts) {
    if (contact.impulse_W.isZero(0.0)) continue;
    frame.forces.push_back({contact.a, contact.b, contact.position_W, contact.normal_W,
                            contact.impulse_W / world.last_step, contact.gap, contact.slip});
  }
  return frame;
}

// Steps that are shortened end a little before their time.
void Recorder::look(const World& world, double time) {
  constexpr double kEarly = 1e-9;  // [s]
  if (frames_.empty() || time - frames_.back().time >= every_ - kEarly) keep(world, time);
}

void Recorder::keep(const World& world, double time) {
  if (!frames_.empty() && frames_.back().time == time) return;
  frames_.push_back(frame_of(world, time));
}

std::string solid_name(const World& world, const SolidId& solid) {
  if (solid.robot < 0) return world.bodies[index(solid.index)].name;
  const WorldRobot& robot = world.robots[index(solid.robot)];
  return robot.name + "/" + robot.model->robot.links[index(solid.index)].name;
}

std::vector<std::string> quantity_names(const World& world) {
  std::vector<std::string> names = {"time"};
  for (const WorldBody& body : world.bodies) {
    if (!body.is_fixed) add_body_names(body.name, names);
  }
  for (const WorldRobot& robot : world.robots) {
    for (const DegreeOfFreedom& dof : robot.model->robot.dofs) {
      const std::string name = robot.name + "/" + dof.name;
      for (const char* part : {"", ".rate", ".effort"}) names.push_back(name + part);
    }
  }
  for (const SolidId& solid : others(world)) names.push_back(solid_name(world, solid) + ".force");
  names.emplace_back("contacts");
  return names;
}

std::vector<double> quantities(const World& world, const WorldFrame& frame) {
  std::vector<double> values = {frame.time};
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (!world.bodies[i].is_fixed) add_body(world.bodies[i], frame.bodies[i], values);
  }
  for (const WorldFrame::OfRobot& robot : frame.robots) {
    for (Eigen::Index d = 0; d < robot.efforts.size(); ++d) {
      for (const double value : {robot.x[d], robot.rate[d], robot.efforts[d]}) {
        values.push_back(value);
      }
    }
  }
  for (const SolidId& solid : others(world)) values.push_back(force_on_object(frame, solid));
  values.push_back(static_cast<double>(frame.forces.size()));
  return values;
}

}  // namespace prehend
