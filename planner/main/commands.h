// The program's commands with their parsed arguments.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "planner/main/interrupts.h"
#include "planner/main/live_server.h"
#include "planner/show/report/plan_report.h"
#include "primitives/decompose.h"
#include "sim/base/deadline.h"
#include "sim/robot/files/package_folders.h"

namespace prehend {

// Options that several commands have.
struct CommonOptions {
  std::filesystem::path out = "out";
  int threads = 0;  // 0: all processors
  std::uint64_t seed = 1;
  std::string accuracy = "standard";  // a name, or a file of settings
  bool hard_contacts = false;
  bool no_report = false;
  bool progress = false;  // lines on stderr that say how far the run is
  Deadline deadline;      // the end of the budget
};

// Arguments of `plan`.
struct PlanCommand {
  std::string scene = "mug";  // name, scene file or mesh file
  std::string hand;           // empty: the scene's
  std::string unit;           // empty: the likely one
  bool repair = true;         // of an object's mesh file
  int top = 10;
  std::optional<int> trials;  // empty: those of the accuracy
  std::optional<int> enough;  // grasps that hold, after which the search ends; as above
  std::string model;          // file of a model that orders the candidates; empty: none
  bool path = false;          // paths of the arm as well
  std::string path_planner = "rrt_connect";
  std::optional<double> primitive_tolerance;  // mm; empty: that of DecomposeOptions
  std::vector<std::string> exports;           // formats besides grasps.json
  std::string shake;                          // protocol: name or file; empty: none
  bool uncertainty = false;                   // grasps are tried again on disturbed poses
  std::string rank = "epsilon";               // "shake", "probability", "success"
  bool dynamic = false;                       // hands close in time, on an object that gives way
  std::vector<std::string> packages;          // of a hand or platform: NAME=FOLDER
  CommonOptions common;
};

// Arguments of `evaluate`.
struct EvaluateCommand {
  std::filesystem::path grasps;
  std::string scene;  // empty: the file's
  std::string hand;
  std::string unit;
  bool repair = true;
  std::string shake;                    // protocol: name or file; empty: none
  bool uncertainty = false;             // grasps are tried again on disturbed poses
  bool dynamic = false;                 // hands close in time, on an object that gives way
  std::size_t volumes = kMostDetailed;  // of so many grasps: those that the report shows in detail
  CommonOptions common;
};

// Arguments of `simulate`.
struct SimulateCommand {
  std::string scene;                    // name, scene file or file of grasps
  int grasp = 1;                        // of a file of grasps: which one
  std::string hand;                     // of a scene; empty: its own
  std::string procedure;                // name or file; empty: the hand closes
  std::string test;                     // of the protocol; empty: the first
  double seconds = 5.0;                 // for which the hand closes, without a protocol
  std::optional<double> step;           // s; empty: the protocol's
  double every = 0.01;                  // s between recorded states
  std::vector<std::string> quantities;  // of states.csv; "all": all; empty: no such file
  int frames = 0;                       // pictures of moments
  std::vector<std::string> packages;    // of a hand or platform: NAME=FOLDER
  CommonOptions common;
};

// Arguments of `render`.
struct RenderCommand {
  std::filesystem::path grasps;
  int grasp = 0;   // 1 is the first, 0: all
  int frames = 8;  // of the approach
  std::string scene;
  std::string hand;
  std::string unit;
  bool repair = true;
  CommonOptions common;
};

// Arguments of `inspect`.
struct InspectCommand {
  std::string file;
  std::string unit;                           // empty: the likely one
  bool repair = true;                         // of an object's mesh file
  std::optional<double> primitive_tolerance;  // mm; empty: that of DecomposeOptions
  std::filesystem::path save;                 // of a scene: write it there; empty: do not
  std::filesystem::path picture;              // of a robot: draw it there (PNG); empty: do not
  std::vector<std::string> packages;          // of a robot: NAME=FOLDER
  std::filesystem::path srdf;                 // of a robot; empty: that beside it
};

// Arguments of `quality`.
struct QualityCommand {
  std::filesystem::path contacts;
  std::string space = "L1";        // L1 or Linf
  std::string cone = "pyramid:8";  // pyramid:EDGES or exact
  std::string force;               // at_most or exactly; empty: exactly for L1, at_most for Linf
  std::string measures;            // names, with commas
  std::string project;             // see run_quality.cpp; empty: no section
  std::filesystem::path out = "out/quality";
  std::uint64_t seed = 1;
  bool no_report = false;
};

// Arguments of `truth`.
struct ValidateCommand {
  std::filesystem::path file;
  bool volumes = true;   // the volume of each grasp is a score as well
  int resamples = 2000;  // of the bootstrap
  std::string groups;    // object, session, both or each; empty: natural_grouping
  CommonOptions common;
};

// Arguments of `convert`.
struct ConvertCommand {
  std::string source;
  std::filesystem::path target;
  std::string unit = "m";             // of a mesh file that is read
  std::vector<std::string> packages;  // NAME=FOLDER
  std::filesystem::path srdf;         // empty: beside the URDF file, if it is there
};

// Arguments of `replay`.
struct ReplayCommand {
  std::filesystem::path file;
  std::filesystem::path out = "out/replay.json";
  std::filesystem::path gltf;                  // an animation to write; empty: none
  std::vector<std::filesystem::path> folders;  // whose files the recorded commands may name
  int threads = 0;                             // of plans; 0: all processors
};

// Arguments of `learn`.
struct LearnCommand {
  std::vector<std::filesystem::path> sets;  // data sets, and folders with such files
  std::filesystem::path model;              // file to write
  bool any_hand = false;                    // it may be used for hands that it was not trained on
  std::uint64_t seed = 1;
};

// Arguments of `serve`.
struct ServeCommand {
  std::uint16_t tcp = 4700;                   // port; 0: any free one
  std::optional<std::uint16_t> graspit = {};  // port of GraspIt!'s text protocol; 0: any free one
  std::string scene = {};                     // to begin with; empty: a hand alone
  LiveOptions session;
};

// Arguments of `studio`.
struct StudioCommand {
  std::string scene = "mug";         // scene name, scene file or mesh file
  bool empty = false;                // without it
  std::uint16_t port = 4701;         // of the page; 0: any free one
  std::optional<std::uint16_t> tcp;  // of JSON lines beside it
  bool open = false;                 // in the browser of the desktop
  LiveOptions session;
};

// The options of readers of robots from NAME=FOLDER and the name of an SRDF file. Throws InputError
// for words without "=".
ForeignRobotOptions foreign_options(const std::vector<std::string>& packages,
                                    const std::filesystem::path& srdf);

// Each prints to stdout and returns the exit status. Throws InputError for a caller's mistake,
// before anything is written. Interrupted, `plan` writes the grasps that it has found; the others
// end at once. At the end of the budget `plan` and `evaluate` write all files about what was tried
// until then.
int run_plan(const PlanCommand& command, Interrupts& interrupts);
int run_evaluate(const EvaluateCommand& command, Interrupts& interrupts);
int run_simulate(const SimulateCommand& command, Interrupts& interrupts);
int run_render(const RenderCommand& command, Interrupts& interrupts);
int run_inspect(const InspectCommand& command, Interrupts& interrupts);
int run_quality(const QualityCommand& command, Interrupts& interrupts);
int run_validate(const ValidateCommand& command, Interrupts& interrupts);
int run_convert(const ConvertCommand& command, Interrupts& interrupts);
int run_learn(const LearnCommand& command, Interrupts& interrupts);
int run_replay(const ReplayCommand& command, Interrupts& interrupts);
int run_serve(const ServeCommand& command, Interrupts& interrupts);
int run_studio(const StudioCommand& command, Interrupts& interrupts);

}  // namespace prehend
