#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>

#include <CLI/CLI.hpp>

#include "planner/main/commands.h"
#include "sim/base/input_error.h"
#include "sim/mesh_files/mesh_file.h"

namespace {

// Exit statuses besides 0, and those of interrupted programs (Interrupts::exit_status).
constexpr int kCallersMistake = 2;
constexpr int kFailure = 1;

using prehend::CommonOptions;

void add_common(CLI::App& command, CommonOptions& common) {
  command.add_option("--threads", common.threads, "threads to use, 0: all processors")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command.add_option("--seed", common.seed, "seed of everything random")->capture_default_str();
  command.add_option("--out", common.out, "folder to write to")->capture_default_str();
  command.add_flag("--progress", common.progress, "say on stderr how far the run is, in lines");
}

void add_no_report(CLI::App& command, bool& no_report) {
  command.add_flag("--no-report", no_report, "do without report.html");
}

void add_contacts(CLI::App& command, CommonOptions& common) {
  command
      .add_option_function<std::string>(
          "--contacts",
          [&common](const std::string& kind) { common.hard_contacts = kind == "hard"; },
          "of rubber: soft fingers that pass on torque, or hard points")
      ->check(CLI::IsMember({"soft", "hard"}))
      ->default_str("soft");
}

void add_scene_words(CLI::App& command, std::string& scene, std::string& hand, std::string& unit) {
  command.add_option("--scene", scene, "scene or mesh file, in place of the one the file names");
  command.add_option("--hand", hand, "robot of the library or robot file, in place of the file's");
  command.add_option("--unit", unit, "unit of a mesh file: m, cm, mm, in");
}

// The commands, their words, and what to call once they are parsed.
struct Program {
  CLI::App app{"prehend plans robot grasps: a mesh and a hand in, ranked grasps out."};
  prehend::PlanCommand plan;
  prehend::EvaluateCommand evaluate;
  prehend::RenderCommand render;
  prehend::InspectCommand inspect;
  prehend::QualityCommand quality;
  // Set while the command line is parsed and called after it, outside of CLI11.
  std::function<int(prehend::Interrupts&)> chosen;

  Program() {
    app.require_subcommand(1);
    add_plan();
    add_evaluate();
    add_render();
    add_inspect();
    add_quality();
  }

  void add_plan() {
    CLI::App& command = *app.add_subcommand("plan", "plan grasps of an object and rank them");
    command.add_option("scene", plan.scene, "scene name, scene file or mesh file")
        ->capture_default_str();
    command.add_option("--hand", plan.hand, "robot of the library or robot file");
    command.add_option("--unit", plan.unit, "unit of a mesh file: m, cm, mm, in")
        ->capture_default_str();
    command.add_option("--top", plan.top, "grasps to return")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command.add_flag("--path", plan.path, "plan the arm's way to each grasp as well");
    command.add_option("--path-planner", plan.path_planner, "how ways are searched for")
        ->check(CLI::IsMember({"rrt_connect", "roadmap", "rrt_star"}))
        ->capture_default_str();
    command
        .add_option("--export", plan.exports, "more files, with commas: csv, isaac, moveit, gltf")
        ->delimiter(',')
        ->check(CLI::IsMember({"json", "csv", "isaac", "moveit", "gltf"}));
    add_common(command, plan.common);
    add_contacts(command, plan.common);
    add_no_report(command, plan.common.no_report);
    command.callback([this] {
      chosen = [this](prehend::Interrupts& interrupts) {
        return prehend::run_plan(plan, interrupts);
      };
    });
  }

  void add_evaluate() {
    CLI::App& command = *app.add_subcommand("evaluate", "simulate and score given grasps");
    command.add_option("grasps", evaluate.grasps, "grasp file (docs/grasps-file.md)")->required();
    add_scene_words(command, evaluate.scene, evaluate.hand, evaluate.unit);
    evaluate.common.out = "out/evaluate";
    add_common(command, evaluate.common);
    add_contacts(command, evaluate.common);
    add_no_report(command, evaluate.common.no_report);
    command.callback([this] {
      chosen = [this](prehend::Interrupts& interrupts) {
        return prehend::run_evaluate(evaluate, interrupts);
      };
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
    add_scene_words(command, render.scene, render.hand, render.unit);
    render.common.out = "out/render";
    command.add_option("--out", render.common.out, "folder to write to")->capture_default_str();
    command.callback([this] {
      chosen = [this](prehend::Interrupts& interrupts) {
        return prehend::run_render(render, interrupts);
      };
    });
  }

  void add_inspect() {
    CLI::App& command =
        *app.add_subcommand("inspect", "say what prehend sees in a mesh, robot or scene");
    command.add_option("file", inspect.file, "mesh, robot or scene file, or a library name")
        ->required();
    command.add_option("--unit", inspect.unit, "unit of a mesh file: m, cm, mm, in")
        ->capture_default_str();
    command.add_option("--save", inspect.save, "of a scene: write it to this file");
    command.callback([this] {
      chosen = [this](prehend::Interrupts& interrupts) {
        return prehend::run_inspect(inspect, interrupts);
      };
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
        ->capture_default_str();
    add_no_report(command, quality.no_report);
    command.callback([this] {
      chosen = [this](prehend::Interrupts& interrupts) {
        return prehend::run_quality(quality, interrupts);
      };
    });
  }
};

}  // namespace

int main(int argc, char** argv) {
  try {
    Program program;
    try {
      program.app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      // --help is reported as an error with the exit code 0.
      if (error.get_exit_code() == 0) return program.app.exit(error);
      std::cerr << "prehend: " << error.what() << " (see --help)\n";
      return kCallersMistake;
    }
    // Made before any other thread, as its constructor demands.
    prehend::Interrupts interrupts;
    return program.chosen(interrupts);
  } catch (const prehend::InputError& error) {
    std::cerr << "prehend: " << error.what() << "\n";
    return kCallersMistake;
  } catch (const std::exception& error) {
    std::cerr << "prehend: internal error: " << error.what() << "\n";
    return kFailure;
  }
}
