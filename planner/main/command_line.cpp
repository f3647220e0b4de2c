#include "planner/main/command_line.h"

#include <filesystem>
#include <functional>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "planner/main/batch_options.h"
#include "planner/main/cluster_commands.h"
#include "planner/main/option_values.h"
#include "planner/main/shared_options.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

// CLI11 says of an unknown command only that one is required.
void check_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::string known;
  for (const CLI::App* command : app.get_subcommands(nullptr)) {
    if (command->get_name() == argv[1]) return;
    known += (known.empty() ? "" : ", ") + command->get_name();
  }
  throw InputError({.problem = "unknown command, known are " + known, .value = argv[1]});
}

}  // namespace

// The commands, their words, and what to call once they are parsed.
struct CommandLine::Options {
  CLI::App app{"prehend plans robot grasps: a mesh and a hand in, ranked grasps out."};
  PlanCommand plan;
  EvaluateCommand evaluate;
  SimulateCommand simulate;
  RenderCommand render;
  InspectCommand inspect;
  QualityCommand quality;
  ValidateCommand truth;
  ConvertCommand convert;
  LearnCommand learn;
  ReplayCommand replay;
  ServeCommand serve;
  StudioCommand studio;
  BatchCommand batch;
  ClusterCommands cluster;
  Limits limits;
  // Set while the command line is parsed and called after it, outside of CLI11.
  std::function<int(Interrupts&)> chosen;

  Options() {
    app.require_subcommand(1);
    app.set_version_flag("--version", "prehend " PREHEND_VERSION);
    add_plan();
    add_evaluate();
    add_simulate();
    add_render();
    add_inspect();
    add_quality();
    add_truth();
    add_convert();
    add_learn();
    add_replay();
    add_serve();
    add_studio();
    add_batches();
  }

  void add_plan() {
    CLI::App& command = *app.add_subcommand("plan", "plan grasps of an object and rank them");
    command.add_option("scene", plan.scene, "scene name, scene file or mesh file")
        ->capture_default_str();
    command.add_option("--hand", plan.hand, "robot of the library or robot file");
    add_mesh_options(command, plan.unit, plan.repair);
    command.add_option("--top", plan.top, "grasps to return")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command
        .add_option("--trials", plan.trials, "candidates to try at most, 800 for accuracy standard")
        ->check(CLI::Range(1, 1000000));
    command.add_option("--enough", plan.enough, "grasps that hold after which the search ends")
        ->check(CLI::Range(1, 1000000));
    command.add_option("--model", plan.model,
                       "file of a model that orders the candidates (docs/learning.md)");
    command.add_option("--primitive-tolerance", plan.primitive_tolerance,
                       "how far the object's surface may be from its primitives, in mm");
    command.add_flag("--path", plan.path, "plan the arm's way to each grasp as well");
    command.add_option("--path-planner", plan.path_planner, "how ways are searched for")
        ->check(CLI::IsMember({"rrt_connect", "roadmap", "rrt_star"}))
        ->capture_default_str();
    command
        .add_option("--export", plan.exports,
                    "more files, with commas: csv, isaac, moveit, gltf, mjcf")
        ->delimiter(',')
        ->check(CLI::IsMember({"json", "csv", "isaac", "moveit", "gltf", "mjcf"}));
    add_shake(command, plan.shake);
    command
        .add_option("--rank", plan.rank,
                    "what comes first: larger epsilon, more survived of the tests of --shake, or "
                    "more held of the trials of --uncertainty, or how probably they lift")
        ->check(CLI::IsMember({"epsilon", "shake", "probability", "success"}))
        ->capture_default_str();
    add_uncertainty(command, plan.uncertainty);
    add_dynamic(command, plan.dynamic);
    add_packages(command, plan.packages);
    add_common(command, plan.common);
    add_accuracy(command, plan.common);
    add_contacts(command, plan.common);
    add_no_report(command, plan.common.no_report);
    add_limits(command, limits);
    command.callback(
        [this] { chosen = [this](Interrupts& interrupts) { return run_plan(plan, interrupts); }; });
  }

  void add_evaluate() {
    CLI::App& command = *app.add_subcommand("evaluate", "simulate and score given grasps");
    command
        .add_option("grasps", evaluate.grasps,
                    "grasp file (docs/grasps-file.md), or a set of grasps (docs/datasets.md)")
        ->required();
    add_scene_options(command, evaluate.scene, evaluate.hand, evaluate.unit, evaluate.repair);
    evaluate.common.out = "out/evaluate";
    command
        .add_option("--volumes", evaluate.volumes,
                    "for how many grasps the volume and the weight that they hold are computed, "
                    "much slower than the rest")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    add_shake(command, evaluate.shake);
    add_uncertainty(command, evaluate.uncertainty);
    add_dynamic(command, evaluate.dynamic);
    add_common(command, evaluate.common);
    add_accuracy(command, evaluate.common);
    add_contacts(command, evaluate.common);
    add_no_report(command, evaluate.common.no_report);
    add_limits(command, limits);
    command.callback([this] {
      chosen = [this](Interrupts& interrupts) { return run_evaluate(evaluate, interrupts); };
    });
  }

  void add_simulate() {
    CLI::App& command = *app.add_subcommand("simulate", "simulate what a hand does to an object");
    command.add_option("scene", simulate.scene, "scene name, scene file or grasp file")->required();
    command.add_option("--grasp", simulate.grasp, "number of the grasp of a grasp file")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command.add_option("--hand", simulate.hand, "robot of the library or robot file");
    command.add_option("--protocol", simulate.procedure,
                       "what the hand does, by a protocol's name or file; without it, it closes");
    command.add_option("--test", simulate.test, "test of the protocol; without it the first");
    command
        .add_option("--seconds", simulate.seconds, "for how long a hand without protocol closes")
        ->check(CLI::Range(1e-3, 1000.0))
        ->capture_default_str();
    command.add_option("--step", simulate.step, "longest step of the simulation, in s")
        ->check(CLI::Range(1e-6, 0.1));
    command.add_option("--every", simulate.every, "time between two recorded states, in s")
        ->check(CLI::Range(1e-6, 1000.0))
        ->capture_default_str();
    command
        .add_option("--csv", simulate.quantities,
                    "write states.csv: quantities by name, with commas, or all")
        ->delimiter(',');
    command.add_option("--frames", simulate.frames, "pictures of moments to draw (PNG)")
        ->check(CLI::Range(0, 1000))
        ->capture_default_str();
    simulate.common.out = "out/simulate";
    add_packages(command, simulate.packages);
    add_common(command, simulate.common);
    add_no_report(command, simulate.common.no_report);
    add_limits(command, limits);
    command.callback([this] {
      chosen = [this](Interrupts& interrupts) { return run_simulate(simulate, interrupts); };
    });
  }

  void add_render() {
    CLI::App& command = *app.add_subcommand("render", "draw grasps of a grasp file (PNG)");
    command.add_option("grasps", render.grasps, "grasp file")->required();
    command.add_option("--grasp", render.grasp, "number of the one to draw, 0: all")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    command
        .add_option("--frames", render.frames,
                    "pictures of its approach (for all: of the first), 0: none")
        ->check(CLI::Range(0, 1000))
        ->capture_default_str();
    add_scene_options(command, render.scene, render.hand, render.unit, render.repair);
    render.common.out = "out/render";
    command.add_option("--out", render.common.out, "folder to write to")->capture_default_str();
    add_limits(command, limits);
    command.callback([this] {
      chosen = [this](Interrupts& interrupts) { return run_render(render, interrupts); };
    });
  }

  void add_inspect() {
    CLI::App& command =
        *app.add_subcommand("inspect", "say what prehend sees in a mesh, robot or scene");
    command.add_option("file", inspect.file, "mesh, robot or scene file, or a library name")
        ->required();
    add_mesh_options(command, inspect.unit, inspect.repair);
    command.add_option("--primitive-tolerance", inspect.primitive_tolerance,
                       "how far the object's surface may be from its primitives, in mm");
    command.add_option("--save", inspect.save, "of a scene: write it to this file");
    command.add_option("--picture", inspect.picture, "of a robot: draw it in this file (PNG)");
    add_foreign(command, inspect.packages, inspect.srdf);
    add_limits(command, limits);
    command.callback([this] {
      chosen = [this](Interrupts& interrupts) { return run_inspect(inspect, interrupts); };
    });
  }

  void add_convert() {
    CLI::App& command = *app.add_subcommand("convert", "write a robot or a mesh in another format");
    command.add_option("source", convert.source, "robot or mesh file, or a robot of the library")
        ->required();
    command
        .add_option("target", convert.target,
                    "file to write: .json or .urdf for a robot, .obj .stl .ply .off for a mesh")
        ->required();
    command.add_option("--unit", convert.unit, "unit of a mesh file that is read: m, cm, mm, in")
        ->capture_default_str();
    add_foreign(command, convert.packages, convert.srdf);
    add_limits(command, limits);
    command.callback([this] {
      chosen = [this](Interrupts& interrupts) { return run_convert(convert, interrupts); };
    });
  }

  void add_learn() {
    CLI::App& command = *app.add_subcommand("learn", "learn from data sets what to try first");
    command.add_option("sets", learn.sets, "data sets (.h5), or folders with such files")
        ->required();
    command.add_option("-o,--out", learn.model, "model to write (docs/learning.md)")->required();
    command.add_flag("--any-hand", learn.any_hand,
                     "the model may be used for hands that it was not trained on");
    command.add_option("--seed", learn.seed, "of the training")->capture_default_str();
    add_limits(command, limits);
    command.callback([this] {
      chosen = [this](Interrupts& interrupts) { return run_learn(learn, interrupts); };
    });
  }

  void add_replay() {
    CLI::App& command = *app.add_subcommand("replay", "carry out a recorded session again");
    command.add_option("file", replay.file, "recording, one command a line (docs/protocol.md)")
        ->required();
    command.add_option("--out", replay.out, "file to write what comes of it to")
        ->capture_default_str();
    command.add_option("--gltf", replay.gltf,
                       "write the session as an animation to this file (.glb)");
    add_session(command, replay.folders, replay.threads);
    add_limits(command, limits);
    command.callback([this] {
      chosen = [this](Interrupts& interrupts) { return run_replay(replay, interrupts); };
    });
  }

  void add_serve() {
    CLI::App& command = *app.add_subcommand("serve", "take the commands of other programs");
    command.add_option("--tcp", serve.tcp, "port for JSON lines (docs/protocol.md), 0: a free one")
        ->capture_default_str();
    command
        .add_option("--graspit", serve.graspit,
                    "port for GraspIt!'s text protocol (docs/graspit-protocol.md); 4765")
        ->expected(0, 1)
        ->default_str("4765");
    command.add_option("--scene", serve.scene,
                       "scene name, scene file or mesh file to begin with; a hand alone");
    add_live(command, serve.session);
    add_limits(command, limits);
    command.callback([this] {
      chosen = [this](Interrupts& interrupts) { return run_serve(serve, interrupts); };
    });
  }

  void add_studio() {
    CLI::App& command = *app.add_subcommand("studio", "take hold of a scene in the browser");
    command.add_option("scene", studio.scene, "scene name, scene file or mesh file to begin with")
        ->capture_default_str();
    command.add_flag("--empty", studio.empty, "begin with a hand alone");
    command.add_option("--port", studio.port, "port of the page, 0: a free one")
        ->capture_default_str();
    command.add_option("--tcp", studio.tcp, "port for JSON lines of other programs beside it");
    command.add_flag("--open", studio.open, "open the page in the browser");
    add_live(command, studio.session);
    add_limits(command, limits);
    command.callback([this] {
      chosen = [this](Interrupts& interrupts) { return run_studio(studio, interrupts); };
    });
  }

  void add_batches() {
    CLI::App& command =
        add_batch(app, batch, limits, [this](auto run) { chosen = std::move(run); });
    add_cluster_commands(command, cluster, [this](std::function<int()> run) {
      chosen = [run = std::move(run)](Interrupts&) { return run(); };
    });
  }

  void add_quality() {
    CLI::App& command = *app.add_subcommand("quality", "judge contacts without a scene (JSON)");
    command.add_option("contacts", quality.contacts, "contacts file (docs/contacts-file.md)")
        ->required();
    command.add_option("--space", quality.space, "what is unit: sum of forces, or each")
        ->check(CLI::IsMember({"L1", "Linf"}))
        ->capture_default_str();
    command.add_option("--cone", quality.cone, "friction cones: pyramid:EDGES or exact")
        ->capture_default_str();
    command.add_option("--force", quality.force, "unit forces: at_most or exactly")
        ->check(CLI::IsMember({"at_most", "exactly"}));
    command.add_option("--measures", quality.measures, "more measures by name, with commas");
    command.add_option("--project", quality.project,
                       "write a section: force, torque, or three like tx=0,ty=0,fz=0.5");
    command.add_option("--out", quality.out, "folder to write to")->capture_default_str();
    command.add_option("--seed", quality.seed, "seed of the robust measures")
        ->check(complaint_about_seed)
        ->capture_default_str();
    add_no_report(command, quality.no_report);
    add_limits(command, limits);
    command.callback([this] {
      chosen = [this](Interrupts& interrupts) { return run_quality(quality, interrupts); };
    });
  }

  void add_truth() {
    CLI::App& command = *app.add_subcommand("truth", "compare scores with executed grasps");
    command.add_option("file", truth.file, "file of executed grasps (docs/truth-file.md)")
        ->required();
    command.add_flag("!--no-volumes", truth.volumes, "do without the volume: half of the time");
    command.add_option("--resamples", truth.resamples, "how many samples make the intervals")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command
        .add_option("--groups", truth.groups,
                    "what is drawn whole: object (where there are several), session, both or each")
        ->check(CLI::IsMember({"object", "session", "both", "each"}));
    truth.common.out = "out/truth";
    add_common(command, truth.common);
    add_accuracy(command, truth.common);
    add_contacts(command, truth.common);
    command.add_flag("--no-report", truth.common.no_report, "do without truth.html");
    add_limits(command, limits);
    command.callback([this] {
      chosen = [this](Interrupts& interrupts) { return run_validate(truth, interrupts); };
    });
  }
};

CommandLine::CommandLine() : words_(std::make_unique<Options>()) {}
CommandLine::~CommandLine() = default;

bool CommandLine::read(int argc, char** argv) {
  check_command(words_->app, argc, argv);
  try {
    words_->app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // --help and --version are reported as errors with the exit code 0.
    if (error.get_exit_code() != 0) {
      throw InputError(std::string(error.what()) + " (see --help)");
    }
    words_->app.exit(error);
    return false;
  }
  return true;
}

const Limits& CommandLine::limits() const { return words_->limits; }

void CommandLine::limit_time(Interrupts& interrupts) {
  if (words_->limits.budget.empty()) return;
  const double seconds = seconds_of(words_->limits.budget);
  words_->plan.common.deadline = Deadline::in(seconds);
  words_->evaluate.common.deadline = words_->plan.common.deadline;
  words_->batch.common.deadline = words_->plan.common.deadline;
  interrupts.limit_time(seconds);
}

int CommandLine::run(Interrupts& interrupts) const { return words_->chosen(interrupts); }

}  // namespace prehend
