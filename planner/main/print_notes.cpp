#include "planner/main/print_notes.h"

#include <iostream>

#include "sim/base/index.h"
#include "sim/base/input_error.h"

namespace prehend {

void print_notes(const Robot& robot) {
  for (const std::string& note : robot.notes) {
    std::cerr << "note: " << on_one_line(robot.name + ": " + note) << "\n";
  }
}

void print_notes(const Scene& scene) {
  for (const std::string& note : scene.notes) {
    std::cerr << "warning: " << on_one_line(scene.name + ": " + note) << "\n";
  }
  if (scene.carrier) {
    const std::vector<MountedRobot>& robots = scene.carrier->platform.robots;
    for (std::size_t r = 0; r < robots.size(); ++r) {
      if (r != index(scene.carrier->hand)) print_notes(robots[r].robot);
    }
  }
  print_notes(scene.hand);
}

}  // namespace prehend
