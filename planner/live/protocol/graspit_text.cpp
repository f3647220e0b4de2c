#include "planner/live/protocol/graspit_text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "planner/live/protocol/graspit_bodies.h"
#include "planner/live/protocol/graspit_words.h"
#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/motion/solids.h"
#include "sim/robot/robot.h"
#include "sim/trial/grasp_contacts.h"

namespace prehend {
namespace {

using Lines = std::vector<std::string>;

// Units of GraspIt!: lengths are mm, forces 1e-6 N, torques 1e-6 N mm.
constexpr double kLength = 1e3;
constexpr double kForce = 1e6;
constexpr double kTorque = 1e9;
// How far moveToContacts looks for something to touch [m].
constexpr double kWay = 0.03;
// The numbers of the hand among robots: its own, and that which it has in programs for GraspIt!'s
// hand on an arm on a mobile base.
constexpr int kRobot = 0;
constexpr int kCarriedRobot = 2;

// Gestures of moveDOFs are numbered so that no two that follow each other have the same.
constexpr std::uint64_t kMostGestures = 1U << 30U;

std::string number_text(double value) { return formatted("%.9g", value); }

std::string vector_text(const Vector3& v) {
  return number_text(v.x()) + " " + number_text(v.y()) + " " + number_text(v.z());
}

// A contact as one of the two bodies has it, in its frame and in the units of GraspIt!.
struct BodyContact {
  Vector3 force = Vector3::Zero();
  Vector3 torque = Vector3::Zero();  // about the contact
  Vector3 position = Vector3::Zero();
  double gap = 0.0;
};

std::string wrench_text(const BodyContact& contact) {
  return vector_text(contact.force) + " " + vector_text(contact.torque);
}

std::vector<BodyContact> contacts_of(const MovingWorld& moving, const Solids& solids,
                                     const SolidId& id) {
  std::vector<BodyContact> found;
  const World& world = moving.world();
  for (const WorldContact& contact : world.contacts) {
    if (contact.a != id && contact.b != id) continue;
    const Pose X_SW = solids.at(id).X_WS.inverse();
    const double rate = (contact.a == id ? 1.0 : -1.0) / world.last_step;
    found.push_back({kForce * rate * (X_SW.linear() * contact.impulse_W),
                     kTorque * rate * contact.spin_impulse * (X_SW.linear() * contact.normal_W),
                     kLength * (X_SW * contact.position_W), kLength * contact.gap});
  }
  return found;
}

// Of a hand that rests, before time runs: without forces.
std::vector<BodyContact> resting_contacts_of(const Session& session, const SolidId& id) {
  std::vector<BodyContact> found;
  const SessionState& state = session.state();
  if (!state.world->is_ready() || (id != kObjectSolid && id.robot < 0)) return found;
  std::vector<Pose> X_HL;
  link_poses(state.world->scene().hand, state.hand.joints, X_HL);
  for (const GraspContact& contact : session.contacts()) {
    if (id != kObjectSolid && index(contact.link) != index(id.index)) continue;
    const Pose X_OS =
        id == kObjectSolid ? Pose::Identity() : state.hand.X_OH * X_HL[index(contact.link)];
    found.push_back({.position = kLength * (X_OS.inverse() * contact.point.position),
                     .gap = kLength * contact.gap});
  }
  return found;
}

BodyContact average(const std::vector<BodyContact>& contacts) {
  BodyContact mean;
  if (contacts.empty()) return mean;
  for (const BodyContact& contact : contacts) {
    mean.force += contact.force;
    mean.torque += contact.torque;
    mean.position += contact.position;
  }
  const double share = 1.0 / static_cast<double>(contacts.size());
  return {share * mean.force, share * mean.torque, share * mean.position};
}

// One line, taken apart and carried out.
class GraspitLine {
 public:
  GraspitLine(Session& session, const std::string& line) : session_(session), words_(line) {}

  Lines carry_out() {
    const std::string_view name = words_.word("a command");
    const Function function = function_of(name);
    if (function == nullptr) {
      throw InputError("unknown command " + std::string(name.substr(0, 40)) + ".");
    }
    (this->*function)();
    return std::move(lines_);
  }

  static bool knows(std::string_view command) { return function_of(command) != nullptr; }

 private:
  using Function = void (GraspitLine::*)();

  // That of a command; null where there is none of this name.
  static Function function_of(std::string_view command) {
    static constexpr std::pair<std::string_view, Function> kCommands[] = {
        {"getContacts", &GraspitLine::get_contacts},
        {"getAverageContacts", &GraspitLine::get_average_contacts},
        {"getBodyName", &GraspitLine::get_body_name},
        {"getRobotName", &GraspitLine::get_robot_name},
        {"getDOFVals", &GraspitLine::get_dofs},
        {"moveDOFs", &GraspitLine::move_dofs},
        {"setDOFForces", &GraspitLine::set_forces},
        {"moveDynamicBodies", &GraspitLine::move_bodies},
        {"computeNewVelocities", &GraspitLine::compute_velocities},
        {"moveToContacts", &GraspitLine::move_to_contacts},
        {"render", &GraspitLine::render}};
    for (const auto& [known, function] : kCommands) {
      if (command == known) return function;
    }
    return nullptr;
  }

  const Scene& scene() const { return session_.state().world->scene(); }
  const Robot& hand() const { return scene().hand; }

  void say(std::string line) { lines_.push_back(std::move(line)); }

  std::vector<NumberedBody> bodies() {
    const GraspitWords::List list = words_.list();
    words_.end();
    std::vector<NumberedBody> all = graspit_bodies(scene());
    if (list.all) {
      say(std::to_string(all.size()));
      return all;
    }
    std::vector<NumberedBody> listed;
    for (const int number : list.numbers) {
      if (number < 0 || index(number) >= all.size()) {
        throw InputError("Cannot find body " + std::to_string(number));
      }
      listed.push_back(all[index(number)]);
    }
    return listed;
  }

  // How many times the list names the hand.
  std::size_t robots() {
    const GraspitWords::List list = words_.list();
    if (list.all) {
      say("1");
      return 1;
    }
    for (const int number : list.numbers) {
      if (number == kRobot || number == kCarriedRobot) continue;
      throw InputError("Cannot find robot " + std::to_string(number));
    }
    return list.numbers.size();
  }

  // Contacts of the last step of time for each body, or of the hand that rests, then `tell` of
  // them.
  template <typename Tell>
  void tell_contacts(const std::vector<NumberedBody>& bodies, const Tell& tell) {
    std::optional<Solids> solids;
    if (session_.is_moving()) solids.emplace(session_.time().world());
    for (const NumberedBody& body : bodies) {
      std::vector<BodyContact> contacts;
      if (body.solid.index >= 0) {
        contacts = solids ? contacts_of(session_.time(), *solids, body.solid)
                          : resting_contacts_of(session_, body.solid);
      }
      tell(contacts);
    }
  }

  void get_contacts() {
    const int kinds = words_.integer("what of each contact");
    tell_contacts(bodies(), [&](const std::vector<BodyContact>& contacts) {
      say(std::to_string(contacts.size()));
      for (const BodyContact& contact : contacts) {
        say(wrench_text(contact));
        if (kinds > 1) say(vector_text(contact.position));
        if (kinds > 2) say(number_text(contact.gap));
      }
    });
  }

  void get_average_contacts() {
    tell_contacts(bodies(), [&](const std::vector<BodyContact>& contacts) {
      const BodyContact mean = average(contacts);
      say(wrench_text(mean));
      say(vector_text(mean.position));
    });
  }

  void get_body_name() {
    for (const NumberedBody& body : bodies()) say(body.name);
  }

  void get_robot_name() {
    const std::size_t count = robots();
    words_.end();
    for (std::size_t r = 0; r < count; ++r) say(hand().name);
  }

  // One of a degree of freedom that slides in mm.
  double unit_of(std::size_t dof) const { return slides(hand(), dof) ? kLength : 1.0; }

  void say_dofs() {
    const std::vector<double> dofs =
        session_.is_moving() ? session_.time().posture().dofs : session_.state().hand.dofs;
    for (std::size_t d = 0; d < dofs.size(); ++d) say(number_text(unit_of(d) * dofs[d]));
  }

  void get_dofs() {
    const std::size_t count = robots();
    words_.end();
    for (std::size_t r = 0; r < count; ++r) {
      say(std::to_string(hand().dofs.size()));
      say_dofs();
    }
  }

  std::vector<double> dof_numbers(const char* what) {
    return words_.numbers(hand().dofs.size(), what);
  }

  void require_dof_count() {
    const int count = words_.integer("the number of DOF");
    if (count >= 0 && index(count) == hand().dofs.size()) return;
    throw InputError("robot has " + std::to_string(hand().dofs.size()) + " DOF.");
  }

  void move_dofs() {
    const int robot = words_.at_end() ? -1 : words_.integer("the robot");
    if (robot != kRobot && robot != kCarriedRobot) throw InputError("Robot does not exist.");
    require_dof_count();
    std::vector<double> targets = dof_numbers("a value");
    std::vector<double> steps = dof_numbers("a step");
    words_.end();
    for (std::size_t d = 0; d < targets.size(); ++d) {
      const DegreeOfFreedom& dof = hand().dofs[d];
      targets[d] = std::clamp(targets[d] / unit_of(d), dof.lower, dof.upper);
      steps[d] /= unit_of(d);
    }
    stop_time();
    move_in_step(targets, steps);
    say_dofs();
  }

  // All degrees of freedom at once, each as much faster than the others as its step is longer,
  // until a link touches: straight between the moments at which some of them arrive. Those without
  // a step come first. One step of undo.
  void move_in_step(const std::vector<double>& targets, const std::vector<double>& steps) {
    const std::vector<double> from = session_.state().hand.dofs;
    std::vector<double> counts;  // of steps until each arrives
    for (std::size_t d = 0; d < from.size(); ++d) {
      const double way = std::abs(targets[d] - from[d]);
      counts.push_back(steps[d] > 0.0 ? way / steps[d] : 0.0);
    }
    std::vector<double> moments = counts;
    std::sort(moments.begin(), moments.end());
    moments.erase(std::unique(moments.begin(), moments.end()), moments.end());
    const int gesture = -1 - static_cast<int>(session_.revision() % kMostGestures);
    for (const double moment : moments) {
      std::vector<double> dofs = targets;
      for (std::size_t d = 0; d < dofs.size(); ++d) {
        if (counts[d] > moment) dofs[d] = from[d] + moment / counts[d] * (targets[d] - from[d]);
      }
      if (dofs == session_.state().hand.dofs) continue;
      if (session_.set_dofs(dofs, gesture).end != MotionEnd::arrived) return;
    }
  }

  void set_forces() {
    const std::size_t count = robots();
    std::vector<double> forces;
    for (std::size_t r = 0; r < count; ++r) {
      require_dof_count();
      forces = dof_numbers("a force");
    }
    words_.end();
    if (count == 0) return;
    start_time();
    std::vector<double> units(forces.size(), kTorque);
    for (std::size_t d = 0; d < forces.size(); ++d) {
      if (unit_of(d) != 1.0) units[d] = kForce;
      session_.moving().drive(d, {.effort = forces[d] / units[d]});
    }
    for (std::size_t r = 0; r < count; ++r) {
      for (std::size_t d = 0; d < forces.size(); ++d) {
        say(number_text(units[d] * session_.time().drives()[d].effort.value_or(0.0)));
      }
    }
  }

  // Of a step of the world: it solves for the velocities and moves everything with them.
  void move_bodies() {
    double seconds = words_.at_end() ? -1.0 : words_.number("the time step");
    words_.end();
    if (seconds > kLiveAdvance.upper) throw InputError("the time step is longer than 1 s.");
    start_time();
    MovingWorld& moving = session_.moving();
    if (seconds <= 0.0) seconds = moving.options().step;
    const double before = moving.time();
    if (moving.advance(seconds) >= StepOutcome::blocked) {
      throw InputError("Timestep failsafe reached.");
    }
    say(number_text(moving.time() - before));
  }

  // What it asks for the step has done already.
  void compute_velocities() {
    (void)words_.number("the time step");
    words_.end();
    start_time();
    say(session_.time().last() == StepOutcome::moved ? "0" : "-1");
  }

  void move_to_contacts() {
    words_.end();
    stop_time();
    session_.approach(kWay);
  }

  void render() { words_.end(); }

  void start_time() {
    if (!session_.is_moving()) session_.start_time({.gravity = !scene().obstacles.empty()});
  }

  void stop_time() {
    if (session_.is_moving()) session_.stop_time(true);
  }

  Session& session_;
  GraspitWords words_;
  Lines lines_;
};

}  // namespace

std::string graspit_error_line(const std::string& problem) {
  return "Error: " + on_one_line(problem);
}

bool is_graspit_command(const std::string& line) {
  GraspitWords words(line);
  return !words.at_end() && GraspitLine::knows(words.word("a command"));
}

std::vector<std::string> graspit_reply(Session& session, const std::string& line) {
  try {
    return GraspitLine(session, line).carry_out();
  } catch (const InputError& error) {
    return {graspit_error_line(error.what())};
  }
}

}  // namespace prehend
