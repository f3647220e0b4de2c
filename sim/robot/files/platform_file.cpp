#include "sim/robot/files/platform_file.h"

#include <utility>

#include "sim/base/input_file.h"
#include "sim/base/json/json_field.h"
#include "sim/robot/files/foreign_robot.h"
#include "sim/robot/files/robot_file.h"
#include "sim/robot/files/robot_file_parts.h"

namespace prehend {
namespace {

// A robot file beside the platform, else a name of the library or a path.
Robot read_named_robot(const JsonField& field) {
  const std::filesystem::path beside = field.file().parent_path() / field.text();
  if (is_file(beside)) return load_robot(beside);
  return with_field_errors(field, [&] { return find_robot(field.text()); });
}

int find_parent(const JsonField& field, const Platform& platform) {
  for (std::size_t r = 0; r < platform.robots.size(); ++r) {
    if (platform.robots[r].name == field.text()) return static_cast<int>(r);
  }
  field.fail("must be the name of a robot that stands before it");
}

int find_chain(const JsonField& field, const Robot& robot) {
  for (std::size_t c = 0; c < robot.chains.size(); ++c) {
    if (robot.chains[c].name == field.text()) return static_cast<int>(c);
  }
  field.fail("no chain of this name in " + robot.name);
}

Link read_mount(const JsonField& field, const FileUnits& units, ShapeBudget& budget) {
  field.allow_only({"name", "driver_name", "material", "geometry", "mass", "density",
                    "center_of_mass", "inertia"});
  return read_link(field, units, {}, budget, -1);
}

MountedRobot read_mounted(const JsonField& field, const FileUnits& units, const Platform& platform,
                          ShapeBudget& budget) {
  field.allow_only({"name", "robot", "on", "mount"});
  MountedRobot mounted;
  mounted.name = field["name"].text();
  for (const MountedRobot& other : platform.robots) {
    if (other.name == mounted.name) field["name"].fail("name used twice");
  }
  mounted.robot = read_named_robot(field["robot"]);
  if (field.has("on")) {
    const JsonField on = field["on"];
    on.allow_only({"robot", "chain", "pose"});
    mounted.parent = find_parent(on["robot"], platform);
    mounted.chain =
        find_chain(on["chain"], platform.robots[static_cast<std::size_t>(mounted.parent)].robot);
    if (on.has("pose")) mounted.X_MR = read_pose(on["pose"], units);
  } else if (!platform.robots.empty()) {
    field.fail("every robot but the first needs \"on\"");
  }
  if (field.has("mount")) mounted.mount = read_mount(field["mount"], units, budget);
  return mounted;
}

void read_platform_exempt_pairs(const JsonField& field, Platform& platform) {
  const auto link_called = [&](const JsonField& name) {
    for (const MountedRobot& mounted : platform.robots) {
      for (const Link& link : mounted.robot.links) {
        if (mounted.name + "/" + link.name == name.text()) return name.text();
      }
      if (mounted.mount && mounted.name + "/" + mounted.mount->name == name.text()) {
        return name.text();
      }
    }
    name.fail("no link is called so; links are named as ROBOT/LINK");
  };
  for (const JsonField& pair : field.items()) {
    const std::vector<JsonField> names = pair.items();
    if (names.size() != 2) pair.fail("must be the names of two links");
    platform.exempt_pairs.emplace_back(link_called(names[0]), link_called(names[1]));
  }
}

}  // namespace

Platform load_platform(const std::filesystem::path& file, const ForeignRobotOptions& options) {
  if (auto foreign = read_foreign_robot(file, options)) return std::move(*foreign);
  return read_platform(JsonFile(file));
}

Platform read_platform(const JsonFile& file) {
  const JsonField root = file.root();
  Platform platform;
  if (!root.has("robots")) {
    Robot robot = read_robot(file);
    platform.name = robot.name;
    platform.robots.push_back({.name = platform.name, .robot = std::move(robot)});
    return platform;
  }
  root.allow_only({"name", "units", "robots", "exempt_collisions"});
  platform.name = root["name"].text();
  const FileUnits units = read_units(root);
  ShapeBudget budget;
  for (const JsonField& field : root["robots"].items()) {
    platform.robots.push_back(read_mounted(field, units, platform, budget));
  }
  if (root.has("exempt_collisions"))
    read_platform_exempt_pairs(root["exempt_collisions"], platform);
  if (platform.robots.empty()) root["robots"].fail("a platform needs at least one robot");
  return platform;
}

}  // namespace prehend
