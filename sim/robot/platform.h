// Platforms: robots mounted on robots, such as a hand on an arm on a mobile base, and their
// assembly into one robot.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/robot/robot.h"

namespace prehend {

// One robot of a platform, and where it is attached.
struct MountedRobot {
  std::string name;  // unique in its platform
  Robot robot;
  int parent = -1;  // index of the robot that carries it, which comes before it; -1: none
  int chain = 0;    // of the parent: the robot is attached to the frame M after its last joint
  Pose X_MR = Pose::Identity();  // the robot's base in M; without a parent, in the platform's base
  std::optional<Link> mount = {};  // a link between the two robots, fixed to that frame
};

// Robots that carry each other, such as a hand on an arm.
struct Platform {
  std::string name;
  std::vector<MountedRobot> robots;
  // Links of different robots, each as ROBOT/LINK, that are never checked for collision with each
  // other (Robot::exempt_pairs has those of one robot). Names that no link has count for nothing.
  std::vector<std::pair<std::string, std::string>> exempt_pairs = {};
};

// Where one robot of a platform is found in the assembled robot.
struct PlatformPart {
  int joint = -1;                // it sits on the frame after this one, -1: the base
  Pose X_JR = Pose::Identity();  // its base in that frame
  int first_joint = 0;
  int first_dof = 0;
  int first_link = 0;  // its base link; the mount, if any, stands before it
};

// A platform as one robot. Names of joints, degrees of freedom, chains, links and frames get the
// name of their robot as a prefix; the drivers' names of joints stay.
struct AssembledPlatform {
  Robot robot;                      // joints, degrees of freedom and links are called ROBOT/NAME
  std::vector<PlatformPart> parts;  // as the platform's robots
};

// The robots joined into one tree: the joints and links that stand on a robot's base follow the
// joint that carries it. Throws InputError for a robot whose joints are no tree (require_sound).
AssembledPlatform assemble(const Platform& platform);

// The initial values of all degrees of freedom, in the order of the assembled platform [rad or m].
std::vector<double> initial_dofs(const Platform& platform);

// The only robot of the platform that is a hand.
// Throws InputError when there is none or more than one.
int hand_of(const Platform& platform);

}  // namespace prehend
