#include "sim/scene/json_carrier.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <vector>

#include "sim/base/input_file.h"
#include "sim/base/json/json_field.h"
#include "sim/base/json/json_pose.h"
#include "sim/robot/files/robot_file.h"
#include "sim/robot/hand/derive_hand.h"
#include "sim/scene/make_scene.h"

namespace prehend {
namespace {

// The degree of freedom called ROBOT/NAME; its place among all of the platform.
struct NamedDof {
  DegreeOfFreedom* dof = nullptr;
  std::size_t index = 0;
};

NamedDof find_dof(const JsonField& field, const std::string& name, Platform& platform) {
  std::size_t index = 0;
  for (MountedRobot& mounted : platform.robots) {
    for (DegreeOfFreedom& dof : mounted.robot.dofs) {
      if (mounted.name + "/" + dof.name == name) return {&dof, index};
      ++index;
    }
  }
  field.fail("no degree of freedom is called " + name + " in " + platform.name);
}

// Limits of a scene may only be narrower than the robot's own. The initial value moves into them.
void narrow_limits(const JsonField& limits, Platform& platform) {
  for (const std::string& name : limits.keys()) {
    const JsonField field = limits[name];
    DegreeOfFreedom& dof = *find_dof(field, name, platform).dof;
    const std::vector<double> range = field.numbers(2);
    if (range[0] > range[1]) field.fail("the lower limit must be at most the upper one");
    if (range[0] < dof.lower || range[1] > dof.upper) {
      field.fail("must be within the robot's own limits " + std::to_string(dof.lower) + " to " +
                 std::to_string(dof.upper));
    }
    dof.lower = range[0];
    dof.upper = range[1];
    dof.initial = std::clamp(dof.initial, dof.lower, dof.upper);
  }
}

std::vector<double> read_start(const JsonField& robot, Platform& platform) {
  std::vector<double> start = initial_dofs(platform);
  if (!robot.has("start")) return start;
  for (const std::string& name : robot["start"].keys()) {
    const JsonField field = robot["start"][name];
    const NamedDof named = find_dof(field, name, platform);
    start[named.index] = field.number();
    if (start[named.index] < named.dof->lower || start[named.index] > named.dof->upper) {
      field.fail("outside the limits " + std::to_string(named.dof->lower) + " to " +
                 std::to_string(named.dof->upper) + " rad or m");
    }
  }
  return start;
}

}  // namespace

std::string read_robot_source(const JsonField& field) {
  const std::filesystem::path beside = field.file().parent_path() / field.text();
  return robot_source(is_file(beside) ? beside.string() : field.text());
}

Carrier read_carrier(const JsonField& field, const std::string& hand,
                     const ForeignRobotOptions& foreign) {
  field.allow_only({"platform", "hand", "pose", "start", "limits", "stands_on"});
  Carrier carrier = with_field_errors(field["platform"], [&] {
    return find_carrier(read_robot_source(field["platform"]), foreign);
  });
  MountedRobot& mounted = carrier.platform.robots[static_cast<std::size_t>(carrier.hand)];
  if (!hand.empty()) {
    const auto find = [&] { return with_hand(find_robot(hand, foreign)); };
    // The field is to blame only if the hand is the one that it names, not one that the caller
    // asked for in its place.
    const bool asked_here = field.has("hand") && hand == read_robot_source(field["hand"]);
    mounted.robot = asked_here ? with_field_errors(field["hand"], find) : find();
  }
  if (field.has("pose")) carrier.X_WB = read_pose(field["pose"]);
  if (field.has("limits")) narrow_limits(field["limits"], carrier.platform);
  carrier.start = read_start(field, carrier.platform);
  return carrier;
}

}  // namespace prehend
