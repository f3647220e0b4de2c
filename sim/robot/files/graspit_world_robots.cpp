#include "sim/robot/files/graspit_world_robots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_file.h"
#include "sim/robot/files/graspit_body.h"
#include "sim/robot/files/graspit_notes.h"
#include "sim/robot/files/graspit_robot.h"
#include "sim/robot/files/graspit_transform.h"
#include "sim/robot/files/robot_file.h"

namespace prehend {
namespace {

constexpr const char* kGraspitVariable = "GRASPIT";

Pose pose_in(const XmlElement& element) {
  const auto transform = element.child("transform");
  return transform ? read_graspit_transform(*transform) : Pose::Identity();
}

// The flags behind the value of a breakaway degree of freedom: for each of its joints 0, or 1 and
// the value at which it has been stopped.
std::size_t skip_breakaway(const XmlElement& element, const std::vector<double>& values,
                           std::size_t at, std::ptrdiff_t joints, bool& stopped) {
  for (std::ptrdiff_t joint = 0; joint < joints; ++joint) {
    if (at >= values.size())
      element.fail("too few values: each degree of freedom needs its own", element.content());
    if (values[at] != 0.0 && values[at] != 1.0) {
      element.fail("a joint of a breakaway degree of freedom needs 0, or 1 and a value",
                   element.content());
    }
    const bool is_stopped = values[at] == 1.0;
    stopped = stopped || is_stopped;
    at += is_stopped ? 2 : 1;
  }
  return at;
}

// Values that are typed with few digits may be beyond a limit by so much [rad or m].
constexpr double kTypedValue = 1e-4;

double inside_limits(const XmlElement& element, const DegreeOfFreedom& dof, double value,
                     std::vector<std::string>& notes) {
  const double inside = std::clamp(value, dof.lower, dof.upper);
  if (std::abs(inside - value) > kTypedValue) {
    notes.push_back(
        note_of(element, dof.name + " is outside its limits, and starts at the nearest"));
  }
  return inside;
}

std::vector<double> read_dof_values(const XmlElement& element, const XmlFile& robot_file,
                                    const Robot& robot, std::vector<std::string>& notes) {
  const std::vector<double> values = element.content_numbers();
  const std::vector<XmlElement> dofs = robot_file.root().children("dof");
  std::vector<double> read;
  std::size_t at = 0;
  bool stopped = false;
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    if (at >= values.size())
      element.fail("too few values: each degree of freedom needs its own", element.content());
    std::vector<const Joint*> driven;
    for (const Joint& joint : robot.joints) {
      if (joint.dof == static_cast<int>(d)) driven.push_back(&joint);
    }
    const double unit = driven.front()->type == JointType::revolute ? 1.0 : kGraspitLength;
    read.push_back(inside_limits(element, robot.dofs[d], unit * values[at], notes));
    ++at;
    if (dofs[d].text_or("type", "r") == "b") {
      at = skip_breakaway(element, values, at, std::ssize(driven), stopped);
    }
  }
  if (at < values.size()) element.fail("too many values", element.content());
  if (stopped) {
    notes.push_back(note_of(element, "joints that a contact had stopped start engaged again"));
  }
  return read;
}

GraspitWorldRobot read_world_robot(const XmlElement& element, std::vector<std::string>& notes) {
  constexpr std::array<std::string_view, 3> kKnown{"filename", "dofValues", "transform"};
  note_unknown(element, kKnown, notes);
  const XmlElement filename = element["filename"];
  GraspitWorldRobot own;
  own.file = graspit_world_file(filename);
  const XmlFile file(own.file);
  if (!is_graspit_robot(file)) filename.fail("not a GraspIt! robot", own.file.string());
  // With what a file beside it says.
  own.robot = with_field_errors(filename, [&] { return load_robot(own.file); });
  own.name = own.robot.name;
  own.X_WR = pose_in(element);
  if (const auto values = element.child("dofValues")) {
    own.dofs = read_dof_values(*values, file, own.robot, notes);
  } else {
    own.dofs = initial_dofs(own.robot);
  }
  return own;
}

int read_index(const XmlElement& element, std::size_t count, const std::string& what) {
  const double value = element.content_number();
  if (!(value >= 0.0 && value < static_cast<double>(count) && value == std::floor(value))) {
    element.fail("must be the number of a " + what + " that is there", element.content());
  }
  return static_cast<int>(value);
}

// The mount is fixed to the base of the robot that stands on it.
Link read_world_mount(const XmlElement& element, const Pose& X_MR,
                      std::vector<std::string>& notes) {
  const std::filesystem::path file = graspit_world_file(element);
  const GraspitBody body = with_field_errors(element, [&] { return load_graspit_body(file); });
  notes.insert(notes.end(), body.notes.begin(), body.notes.end());
  return {.name = body.name,
          .material = std::string(name_of(body.material)),
          .joint = -1,
          .mesh = transformed(body.mesh, X_MR),
          .inertial = transformed(inertial_of(body), X_MR)};
}

bool carries(const std::vector<GraspitWorldRobot>& robots, int carrier, int robot) {
  for (; robot >= 0; robot = robots[index(robot)].parent) {
    if (robot == carrier) return true;
  }
  return false;
}

void read_connection(const XmlElement& element, std::vector<GraspitWorldRobot>& robots,
                     std::vector<std::string>& notes) {
  constexpr std::array<std::string_view, 5> kKnown{"parentRobot", "parentChain", "childRobot",
                                                   "mountFilename", "transform"};
  note_unknown(element, kKnown, notes);
  const int parent = read_index(element["parentRobot"], robots.size(), "robot");
  const int child = read_index(element["childRobot"], robots.size(), "robot");
  GraspitWorldRobot& own = robots[index(child)];
  if (own.parent >= 0) element.fail("the robot is connected already", own.name);
  if (carries(robots, child, parent))
    element.fail("robots must not carry each other in a circle", own.name);
  own.parent = parent;
  own.chain =
      read_index(element["parentChain"], robots[index(parent)].robot.chains.size(), "chain");
  own.X_MR = pose_in(element);
  if (const auto mount = element.child("mountFilename")) {
    own.mount = read_world_mount(*mount, own.X_MR, notes);
  }
}

}  // namespace

std::filesystem::path graspit_world_file(const XmlElement& element) {
  const std::filesystem::path name = element.content();
  if (name.empty()) element.fail("names no file");
  const std::filesystem::path world = std::filesystem::absolute(element.file()).lexically_normal();
  std::filesystem::path folder = world;
  do {
    folder = folder.parent_path();
    if (is_file(folder / name)) return folder / name;
  } while (folder.has_relative_path());
  const char* const root = std::getenv(kGraspitVariable);
  if (root && is_file(std::filesystem::path(root) / name)) {
    return std::filesystem::path(root) / name;
  }
  element.fail(
      "no such file in the folder of the world or in one above it, nor in that of the "
      "environment variable GRASPIT (" +
          (root ? std::string(root) : "not set") + ")",
      name.string());
}

std::vector<GraspitWorldRobot> read_graspit_world_robots(const XmlElement& world,
                                                         std::vector<std::string>& notes) {
  if (world.name() != "world")
    world.fail("not a GraspIt! world, whose outermost element is <world>");
  std::vector<GraspitWorldRobot> robots;
  for (const XmlElement& element : world.children("robot")) {
    GraspitWorldRobot own = read_world_robot(element, notes);
    const auto namesakes = std::count_if(robots.begin(), robots.end(), [&](const auto& other) {
      return other.file == own.file || other.name == own.name;
    });
    if (namesakes > 0) own.name += "_" + std::to_string(namesakes + 1);
    robots.push_back(std::move(own));
  }
  for (const XmlElement& element : world.children("connection")) {
    read_connection(element, robots, notes);
  }
  return robots;
}

int graspit_hand_of(const std::vector<GraspitWorldRobot>& robots) {
  const auto found = std::find_if(robots.begin(), robots.end(), [](const GraspitWorldRobot& own) {
    return own.robot.hand.has_value();
  });
  return found == robots.end() ? -1 : static_cast<int>(found - robots.begin());
}

GraspitPlatform graspit_platform_with(const std::vector<GraspitWorldRobot>& robots, int of) {
  GraspitPlatform made;
  int root = of;
  while (robots[index(root)].parent >= 0) root = robots[index(root)].parent;
  made.X_WB = robots[index(root)].X_WR;
  // Each after the one that carries it.
  made.members.push_back(root);
  for (std::size_t m = 0; m < made.members.size(); ++m) {
    for (std::size_t r = 0; r < robots.size(); ++r) {
      if (robots[r].parent == made.members[m]) made.members.push_back(static_cast<int>(r));
    }
  }
  for (const int member : made.members) {
    const GraspitWorldRobot& own = robots[index(member)];
    const auto parent = std::find(made.members.begin(), made.members.end(), own.parent);
    const bool carried = parent != made.members.end();
    made.platform.robots.push_back(
        {.name = own.name,
         .robot = own.robot,
         .parent = carried ? static_cast<int>(parent - made.members.begin()) : -1,
         .chain = own.chain,
         .X_MR = own.X_MR,
         .mount = own.mount});
    made.platform.name += (made.platform.name.empty() ? "" : "+") + own.name;
    made.start.insert(made.start.end(), own.dofs.begin(), own.dofs.end());
  }
  return made;
}

Platform read_graspit_platform(const XmlFile& world) {
  std::vector<std::string> notes;
  const std::vector<GraspitWorldRobot> robots = read_graspit_world_robots(world.root(), notes);
  const int hand = graspit_hand_of(robots);
  if (hand < 0) world.root().fail("no robot here is a hand, which has an <approachDirection>");
  Platform platform = graspit_platform_with(robots, hand).platform;
  std::vector<std::string>& own = platform.robots.front().robot.notes;
  own.insert(own.end(), notes.begin(), notes.end());
  return platform;
}

}  // namespace prehend
