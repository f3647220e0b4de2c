#include <cstdio>
#include <iostream>

#include "planner/grasp_picture.h"
#include "planner/main/asked_scene.h"
#include "planner/main/commands.h"
#include "planner/output_file.h"
#include "sim/geometry/input_error.h"

namespace prehend {
namespace {

// The posture that the file gives: where the fingers ended if it says so, else the preshape.
std::vector<double> posture(const JsonField& grasp, const Candidate& candidate,
                            const Robot& robot) {
  if (grasp.has("joints")) return grasp["joints"].numbers(robot.joints.size());
  if (!candidate.joints.empty()) return candidate.joints;
  const bool named = candidate.preshape >= 0;
  if (named && grasp.has("dofs")) {
    return joint_values(robot, grasp["dofs"].numbers(robot.dofs.size()));
  }
  const auto p = static_cast<std::size_t>(named ? candidate.preshape : 0);
  return joint_values(robot, named ? robot.hand->preshapes[p].dofs : candidate.dofs);
}

Wrench weakest_of(const JsonField& grasp) {
  Wrench wrench = Wrench::Zero();
  if (!grasp.has("weakest_wrench")) return wrench;
  wrench.head<3>() = grasp["weakest_wrench"]["force"].vector3();
  wrench.tail<3>() = grasp["weakest_wrench"]["torque"].vector3();
  return wrench;
}

std::string title_of(const JsonField& grasp, std::size_t number) {
  std::string title = "grasp " + std::to_string(number);
  if (grasp.has("epsilon")) {
    char epsilon[32];
    std::snprintf(epsilon, sizeof epsilon, "   epsilon %.4f", grasp["epsilon"].number());
    title += epsilon;
  }
  if (grasp.has("outcome")) title += "   " + grasp["outcome"].text();
  return title;
}

}  // namespace

int run_render(const RenderCommand& command) {
  const JsonFile file(command.grasps);
  const LoadedScene loaded = load_asked_scene(file, {command.scene, command.hand, command.unit});
  const std::vector<AskedGrasp> asked = asked_grasps(file, loaded.scene);
  const std::vector<JsonField> fields = file.root()["grasps"].items();
  if (asked.empty()) throw InputError(command.grasps.string() + ": grasps: there is none to draw");
  if (command.grasp > static_cast<int>(asked.size())) {
    throw InputError(command.grasps.string() + ": --grasp: there are " +
                     std::to_string(asked.size()) + " grasps (" + std::to_string(command.grasp) +
                     ")");
  }
  make_folder(command.common.out);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (command.grasp > 0 && i + 1 != static_cast<std::size_t>(command.grasp)) continue;
    const Robot& robot = loaded.scene.scene.hand;
    const PosedGrasp posed{asked[i].candidate.X_OH, posture(fields[i], asked[i].candidate, robot),
                           asked[i].contacts, weakest_of(fields[i]), title_of(fields[i], i + 1)};
    char name[32];
    std::snprintf(name, sizeof name, "grasp_%03zu.png", i + 1);
    write_png(command.common.out / name,
              grasp_from_four_sides(loaded.scene, posed, {.width = 1400, .height = 1100}));
    std::cout << "wrote " << (command.common.out / name).string() << "\n";
  }
  return 0;
}

}  // namespace prehend
