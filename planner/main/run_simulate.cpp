#include <iostream>
#include <optional>
#include <utility>

#include "planner/main/commands.h"
#include "planner/main/print_notes.h"
#include "planner/main/requested_scene.h"
#include "planner/results/result_files.h"
#include "planner/results/simulation_file.h"
#include "planner/show/motion_frames.h"
#include "planner/show/motion_picture.h"
#include "planner/show/report/report_html.h"
#include "planner/show/report/simulation_report.h"
#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/json/json_field.h"
#include "sim/base/output_file.h"
#include "sim/base/parallel/parallel.h"
#include "sim/manipulation/test_procedure_file.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"

namespace prehend {
namespace {

constexpr GraspPictureOptions kMomentPicture{800, 640};

struct AskedSimulation {
  CompiledScene scene;
  std::string name;
  SimulationStart start;
};

// The grasp of a file is tried first: how the hand comes to it is what is simulated.
AskedSimulation grasp_of_file(const SimulateCommand& command, const JsonFile& file) {
  LoadedScene loaded = load_asked_scene(file, {"", command.hand, "", true});
  const GraspFile read = read_grasps(file, loaded.scene);
  const std::vector<ScoredGrasp>& grasps = read.result.grasps;
  if (command.grasp > static_cast<int>(grasps.size())) {
    throw InputError({file.path().string(), "--grasp",
                      "there are " + std::to_string(grasps.size()) + " grasps",
                      std::to_string(command.grasp)});
  }
  const ScoredGrasp& grasp = grasps[static_cast<std::size_t>(command.grasp - 1)];
  Trial trial = grasp.trial;
  if (trial.contacts.empty()) trial = run_trial(loaded.scene, grasp.candidate);
  if (is_blocked(trial.outcome) || (loaded.scene.arm && trial.arm_line.empty())) {
    throw InputError(
        {file.path().string(), "grasp " + std::to_string(command.grasp),
         "cannot be simulated: its trial ends as " + std::string(outcome_name(trial.outcome))});
  }
  SimulationStart start = start_of(loaded.scene, grasp.candidate, trial);
  return {std::move(loaded.scene), loaded.record.scene, std::move(start)};
}

AskedSimulation asked_of(const SimulateCommand& command) {
  const std::filesystem::path file = find_scene(command.scene);
  if (file.extension() == ".json") {
    const JsonFile json(file);
    if (json.root().has("grasps")) return grasp_of_file(command, json);
  }
  SceneSource source;
  source.hand = command.hand;
  source.foreign = foreign_options(command.packages, {});
  Scene scene = load_scene(command.scene, source);
  print_notes(scene);
  CompiledScene compiled = compile(std::move(scene));
  SimulationStart start = start_of(compiled);
  return {std::move(compiled), scene_reference(command.scene), std::move(start)};
}

TestProcedure protocol_of(const SimulateCommand& command, const CompiledScene& scene) {
  TestProcedure procedure = command.procedure.empty()
                                ? closing_procedure(scene, command.seconds)
                                : read_test_procedure(find_test_procedure(command.procedure));
  if (command.step) procedure.step = *command.step;
  return procedure;
}

bool wants_all(const std::vector<std::string>& names) {
  return names.size() == 1 && names.front() == "all";
}

std::vector<std::string> write_moments(const SimulateCommand& command, const AskedSimulation& asked,
                                       const Simulation& simulation, Interrupts& interrupts) {
  const GraspMotion motion = motion_of(asked.scene, simulation);
  const std::vector<NamedFrame> frames = named_frames(motion, command.frames);
  if (frames.empty()) return {};
  std::vector<MotionFrame> moments;
  for (const NamedFrame& frame : frames) moments.push_back(frame.frame);
  const MotionView view =
      motion_view(asked.scene, moments, posed_at(motion.frames.front()), kMomentPicture);
  std::vector<std::string> names(frames.size());
  for_each_in_parallel(frames.size(), command.common.threads, [&](std::size_t i) {
    PosedGrasp moment = posed_at(frames[i].frame);
    moment.title = frames[i].segment + formatted("   %.3f s", frames[i].frame.time);
    names[i] = formatted("moment_%03zu.png", i + 1);
    interrupts.write(command.common.out / names[i],
                     png_bytes(motion_picture(asked.scene, moment, view, kMomentPicture)));
  });
  return names;
}

void print_simulation(const Simulation& simulation, const std::vector<std::string>& written,
                      const std::filesystem::path& folder) {
  for (const std::string& line : event_lines(simulation)) std::cout << line << "\n";
  const SimulationEffort& effort = simulation.effort;
  std::cout << std::string(object_end_name(simulation.end)) << " after "
            << formatted("%.3f s: ", simulation.frames.back().time) << effort.steps << " steps, "
            << effort.shortened << " shortened, " << effort.not_converged << " not converged\n";
  std::cout << "wrote " << folder.string() << ": ";
  for (std::size_t i = 0; i < written.size(); ++i) std::cout << (i > 0 ? ", " : "") << written[i];
  std::cout << "\n";
}

}  // namespace

int run_simulate(const SimulateCommand& command, Interrupts& interrupts) {
  require_writable(command.common.out);
  const AskedSimulation asked = asked_of(command);
  const TestProcedure procedure = protocol_of(command, asked.scene);
  SimulateOptions options;
  options.every = command.every;
  options.test = command.test;
  const RunContext context{
      command.common.threads, interrupts.cancellation(), {}, command.common.deadline};
  interrupts.end_at_once("nothing is written");
  const Simulation simulation = simulate(asked.scene, asked.start, procedure, options, context);
  const std::vector<std::string> quantities =
      wants_all(command.quantities) ? std::vector<std::string>{} : command.quantities;
  require_quantities(simulation.start, quantities);

  make_folder(command.common.out);
  remove_regular_files(command.common.out, is_simulation_file);
  std::vector<std::string> written = {"simulation.json"};
  interrupts.write(command.common.out / written.front(),
                   [&](std::ostream& stream) { write_simulation(stream, asked.name, simulation); });
  if (!command.quantities.empty()) {
    written.emplace_back("states.csv");
    interrupts.write(command.common.out / written.back(), [&](std::ostream& stream) {
      write_quantities(stream, simulation, quantities);
    });
  }
  if (!command.common.no_report) {
    written.emplace_back("report.html");
    interrupts.write(command.common.out / written.back(),
                     report_html(simulation_report(asked.scene, simulation)));
  }
  for (const std::string& name : write_moments(command, asked, simulation, interrupts)) {
    written.push_back(name);
  }
  print_simulation(simulation, written, command.common.out);
  return 0;
}

}  // namespace prehend
