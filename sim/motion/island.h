// Groups of bodies and robots that touch each other, and the velocities of one group at the end of
// a step.
#pragma once

#include <vector>

#include "sim/motion/solids.h"
#include "sim/motion/step_options.h"

namespace prehend {

// Movers (Solids) that contacts connect, and the pairs of the memory whose contacts do.
struct Island {
  std::vector<int> movers;         // ascending
  std::vector<std::size_t> pairs;  // of ContactMemory, ascending
};

// All islands, in the order of their first movers. Each mover is in one of them.
std::vector<Island> islands_of(const Solids& solids, const ContactMemory& memory);

// What an earlier try of a step found: where the search begins.
struct EarlierTry {
  std::vector<Eigen::VectorXd> velocities = {};  // of each mover; empty: as they are
  // Of each robot, over the time, in the order of WorldRobot::joint_impulses; empty: those.
  std::vector<std::vector<double>> joint_impulses = {};
};

// A condition of a joint: whose, and its place in WorldRobot::joint_impulses.
struct JointOf {
  int mover = 0;
  std::size_t place = 0;
};

// What the step of an island ended with.
struct IslandMotion {
  ContactSolution solution;
  std::vector<int> first;       // of each mover: where its velocities begin in the solution
  std::vector<JointOf> joints;  // of the first impulses; those of contacts follow
  std::vector<WorldContact> contacts;
  // Only forces act. They have acted for half of the step, and act for the other half once it has
  // moved, which makes such motions exact to second order. Where contacts or joints act as well,
  // the velocities stay those at which their laws hold.
  bool is_free = false;
};

// The velocities at the end of a step of `time`. Impulses that contacts and joints had are where
// the search for the new ones begins; they are replaced.
IslandMotion solve_island(const World& world, const Solids& solids, const Island& island,
                          double time, const StepOptions& options, const EarlierTry& earlier = {});

}  // namespace prehend
