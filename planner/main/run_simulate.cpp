#include <iostream>
#include <optional>
#include <utility>

#include "planner/main/print_notes.h"
#include "planner/main/requested_scene.h"
#include "planner/main/shared_options.h"
#include "planner/results/simulation_file.h"
#include "planner/show/exports/result_files.h"
#include "planner/show/motion_frames.h"
#include "planner/show/motion_picture.h"
#include "planner/show/posed_grasp.h"
#include "planner/show/report/report_html.h"
#include "planner/show/report/simulation_report.h"
#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/json/json_field.h"
#include "sim/base/output_file.h"
#include "sim/base/parallel/parallel.h"
#include "sim/manipulation/simulate.h"
#include "sim/manipulation/test_procedure_file.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"
#include "sim/trial/run_trial.h"

namespace prehend {
namespace {

// Arguments of `simulate`.
struct SimulateCommand {
  std::string scene;  // name, scene file or file of grasps
  int grasp = 1;      // of a file of grasps: which one
  std::string hand;
  std::optional<double> friction;  // of the object; empty: as of the file                     // of
                                   // a scene; empty: its own
  std::string procedure;           // name or file; empty: the hand closes
  std::string test;                // of the protocol; empty: the first
  double seconds = 5.0;            // for which the hand closes, without a protocol
  std::optional<double> step;      // s; empty: the protocol's
  double every = 0.01;             // s between recorded states
  std::vector<std::string> quantities;  // of states.csv; "all": all; empty: no such file
  int frames = 0;                       // pictures of moments
  std::vector<std::string> packages;    // of a hand or platform: NAME=FOLDER
  CommonOptions common = {.out = "out/simulate"};
};

void declare(CLI::App& command, SimulateCommand& options) {
  add_examples(command, {"simulate mug --seconds 2",
                         "simulate out/grasps.json --grasp 2 --protocol acronym"});
  command.add_option("scene", options.scene, "scene name, scene file or grasp file")->required();
  command.add_option("--grasp", options.grasp, "number of the grasp of a grasp file")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--hand", options.hand, "robot of the library or robot file");
  add_friction(command, options.friction);
  command.add_option("--protocol", options.procedure,
                     "what the hand does, by a protocol's name or file; without it, it closes");
  command.add_option("--test", options.test, "test of the protocol; without it the first");
  command.add_option("--seconds", options.seconds, "for how long a hand without protocol closes")
      ->check(CLI::Range(1e-3, 1000.0))
      ->capture_default_str();
  command.add_option("--step", options.step, "longest step of the simulation, in s")
      ->check(CLI::Range(1e-6, 0.1));
  command.add_option("--every", options.every, "time between two recorded states, in s")
      ->check(CLI::Range(1e-6, 1000.0))
      ->capture_default_str();
  command
      .add_option("--csv", options.quantities,
                  "write states.csv: quantities by name, with commas, or all")
      ->delimiter(',');
  command.add_option("--frames", options.frames, "pictures of moments to draw (PNG)")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  add_packages(command, options.packages);
  add_common(command, options.common);
  add_no_report(command, options.common.no_report);
}

constexpr PictureSize kMomentPicture{800, 640};

struct AskedSimulation {
  CompiledScene scene;
  std::string name;
  SimulationStart start;
};

// The grasp of a file is tried first: how the hand comes to it is what is simulated.
AskedSimulation grasp_of_file(const SimulateCommand& command, const JsonFile& file) {
  LoadedScene loaded = load_asked_scene(file, {"", command.hand, "", true, {}, command.friction});
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
         "cannot be simulated: its trial ends as " + std::string(name_of(trial.outcome))});
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
  source.friction = command.friction;
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
  std::cout << std::string(name_of(simulation.end)) << " after "
            << formatted("%.3f s: ", simulation.frames.back().time) << effort.steps << " steps, "
            << effort.shortened << " shortened, " << effort.not_converged << " not converged\n";
  std::cout << "wrote " << folder.string() << ": ";
  for (std::size_t i = 0; i < written.size(); ++i) std::cout << (i > 0 ? ", " : "") << written[i];
  std::cout << "\n";
}

int run_simulate(const SimulateCommand& command, Interrupts& interrupts) {
  require_writable(command.common.out);
  const AskedSimulation asked = asked_of(command);
  const TestProcedure procedure = protocol_of(command, asked.scene);
  SimulateOptions options;
  options.every = command.every;
  options.test = command.test;
  const RunContext context{command.common.threads, interrupts.cancellation(), {}, {}};
  interrupts.end_at_once("nothing is written");
  const Simulation simulation = simulate(asked.scene, asked.start, procedure, options, context);
  const std::vector<std::string> quantities =
      wants_all(command.quantities) ? std::vector<std::string>{} : command.quantities;
  require_quantities(simulation.start, quantities);

  make_folder(command.common.out);
  std::vector<std::string> written = {"simulation.json"};
  interrupts.write(command.common.out / written.front(),
                   [&](std::ostream& stream) { write_simulation(stream, asked.name, simulation); });
  remove_regular_files(command.common.out, [&](const std::string& name) {
    return is_simulation_file(name) && name != written.front();
  });
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

}  // namespace

void add_simulate(CLI::App& app, CommandRequest& request) {
  add_command(app, request, "simulate", "simulate what a hand does to an object", declare,
              run_simulate);
}

}  // namespace prehend
