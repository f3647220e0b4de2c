#include "planner/results/simulation_file.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "planner/results/json_shake.h"
#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/base/json/json_pose.h"
#include "sim/manipulation/simulate.h"

namespace prehend {
namespace {

using Json = nlohmann::ordered_json;

Json numbers(const Eigen::VectorXd& values) {
  return std::vector<double>(values.data(), values.data() + values.size());
}

Json motion_json(const RigidMotion& motion) {
  Json json = pose_to_json(motion.X_WB);
  json["linear"] = vector_to_json(motion.linear);
  json["angular"] = vector_to_json(motion.angular);
  return json;
}

Json robot_json(const WorldRobot& robot, const WorldFrame::OfRobot& state) {
  const Eigen::Index dofs = robot.model->dofs();
  const Eigen::VectorXd joints = robot.model->joints_of * state.x + robot.model->offset;
  return {{"base", pose_to_json(state.X_WB)},
          {"dofs", numbers(state.x.head(dofs))},
          {"rates", numbers(state.rate.head(dofs))},
          {"efforts", numbers(state.efforts)},
          {"joints", numbers(joints)}};
}

Json force_json(const World& world, const WorldFrame::Force& force) {
  return {{"a", solid_name(world, force.a)},
          {"b", solid_name(world, force.b)},
          {"position", vector_to_json(force.p_W)},
          {"normal", vector_to_json(force.normal_W)},
          {"force", vector_to_json(force.force_W)},
          {"gap", force.gap},
          {"slip", force.slip}};
}

Json state_json(const World& world, const WorldFrame& frame) {
  Json json{{"time", frame.time}};
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (world.bodies[i].is_fixed) continue;
    json["bodies"][world.bodies[i].name] = motion_json(frame.bodies[i]);
  }
  for (std::size_t r = 0; r < world.robots.size(); ++r) {
    json["robots"][world.robots[r].name] = robot_json(world.robots[r], frame.robots[r]);
  }
  json["contacts"] = Json::array();
  for (const WorldFrame::Force& force : frame.forces) {
    json["contacts"].push_back(force_json(world, force));
  }
  return json;
}

Json event_json(const ObjectEvent& event) {
  Json json{{"time", event.time}, {"event", name_of(event.kind)}};
  if (!event.link.empty()) json["link"] = event.link;
  return json;
}

Json names_json(const WorldRobot& robot) {
  Json dofs = Json::array();
  Json joints = Json::array();
  for (const DegreeOfFreedom& dof : robot.model->robot.dofs) dofs.push_back(dof.name);
  for (const Joint& joint : robot.model->robot.joints) joints.push_back(joint.name);
  return {{"dofs", dofs}, {"joints", joints}};
}

std::vector<std::size_t> places_of(const World& world, const std::vector<std::string>& names) {
  const std::vector<std::string> known = quantity_names(world);
  std::vector<std::size_t> places;
  for (const std::string& name : names) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) {
      std::string like;
      for (const std::string& other : known) {
        const std::string start = name.substr(0, name.find_first_of("./"));
        if (other.starts_with(start)) add_part(like, other);
      }
      throw InputError({.field = "--csv",
                        .problem = like.empty() ? "no such quantity; all are written without names"
                                                : "no such quantity; there are " + like,
                        .value = name});
    }
    places.push_back(static_cast<std::size_t>(found - known.begin()));
  }
  if (!names.empty()) return places;
  for (std::size_t i = 0; i < known.size(); ++i) places.push_back(i);
  return places;
}

}  // namespace

void write_simulation(std::ostream& stream, const std::string& scene,
                      const Simulation& simulation) {
  Json json{{"scene", scene}, {"protocol", simulation.procedure}, {"end", name_of(simulation.end)}};
  json["events"] = Json::array();
  for (const ObjectEvent& event : simulation.events) json["events"].push_back(event_json(event));
  json["tests"] = Json::array();
  for (const ShakeTestReport& test : simulation.tests) {
    json["tests"].push_back(shake_test_to_json(test));
  }
  json["simulation"] = effort_to_json(simulation.effort);
  for (const WorldRobot& robot : simulation.start.robots) {
    json["robots"][robot.name] = names_json(robot);
  }
  // States are written one by one: there may be many.
  std::string head = json.dump(1, ' ', false, Json::error_handler_t::replace);
  head.resize(head.rfind('\n'));
  stream << head << ",\n \"states\": [";
  for (const WorldFrame& frame : simulation.frames) {
    const Json state = state_json(simulation.start, frame);
    stream << (&frame == simulation.frames.data() ? "\n  " : ",\n  ")
           << state.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  stream << "\n ]\n}\n";
}

void require_quantities(const World& world, const std::vector<std::string>& names) {
  (void)places_of(world, names);
}

void write_quantities(std::ostream& stream, const Simulation& simulation,
                      const std::vector<std::string>& names) {
  const std::vector<std::size_t> places = places_of(simulation.start, names);
  const std::vector<std::string> all = quantity_names(simulation.start);
  const auto line = [&](const auto& cell) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      stream << (i > 0 ? "," : "") << cell(places[i]);
    }
    stream << "\n";
  };
  line([&](std::size_t place) { return all[place]; });
  for (const WorldFrame& frame : simulation.frames) {
    const std::vector<double> values = quantities(simulation.start, frame);
    line([&](std::size_t place) { return formatted("%.9g", values[place]); });
  }
}

}  // namespace prehend
