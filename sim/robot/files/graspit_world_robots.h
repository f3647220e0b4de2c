// The robots of GraspIt! world files, and where the files that worlds name are.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/xml/xml_file.h"
#include "sim/robot/platform.h"

namespace prehend {

// The file that an element <filename> or <mountFilename> of a world names, a path from the root of
// a GraspIt! folder ("models/objects/mug.xml"): looked for in the folder of the world and in those
// above it, then in the folder that the environment variable GRASPIT names. Throws InputError with
// the line that says where it was looked for.
std::filesystem::path graspit_world_file(const XmlElement& element);

// A robot of a world. Connected robots stand on the last link of a chain of another.
struct GraspitWorldRobot {
  std::string name;  // of its file, numbered where another has it, too
  std::filesystem::path file;
  Robot robot;
  std::vector<double> dofs;        // as the world has them [rad or m]
  Pose X_WR = Pose::Identity();    // of its base, for a robot that no other carries
  int parent = -1;                 // index of the robot that carries it, -1: none
  int chain = 0;                   // of that robot
  Pose X_MR = Pose::Identity();    // its base in the frame after the last joint of the chain
  std::optional<Link> mount = {};  // in that frame
};

// All robots of a world, in the order of the file. `notes` gets those of their files, and what was
// left out. Throws InputError with the line: for files that are missing or broken, values of
// degrees of freedom that are no numbers, too few or too many, and connections of robots or chains
// that are not there, of a robot that is carried already, or in a circle.
std::vector<GraspitWorldRobot> read_graspit_world_robots(const XmlElement& world,
                                                         std::vector<std::string>& notes);

// The hand among them: the first with a hand (Robot::hand); -1: none.
int graspit_hand_of(const std::vector<GraspitWorldRobot>& robots);

// Robots that are connected, as a platform, and where it is.
struct GraspitPlatform {
  Platform platform;
  std::vector<int> members;      // of each robot of the platform, its index in the world
  std::vector<double> start;     // of all degrees of freedom [rad or m]
  Pose X_WB = Pose::Identity();  // of the robot that carries all others
};

// The robots that carry robot `of`, and all others that these carry.
GraspitPlatform graspit_platform_with(const std::vector<GraspitWorldRobot>& robots, int of);

// The platform of the hand of a world file: what carries it, and the hand. Throws InputError as
// above, and for a world without a hand.
Platform read_graspit_platform(const XmlFile& world);

}  // namespace prehend
