// What the command `plan` is asked for, and what it loads.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planner/main/shared_options.h"
#include "planner/plan/stopwatch.h"
#include "planner/results/grasps_file.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/scene_file.h"

namespace prehend {

// Arguments of `plan`.
struct PlanCommand {
  std::string scene = "mug";  // name, scene file or mesh file
  std::string hand;           // empty: the scene's
  std::string unit;           // empty: the likely one
  bool repair = true;         // of an object's mesh file
  int top = 10;
  std::optional<int> trials;  // empty: those of the accuracy
  std::optional<int> enough;  // grasps that hold, after which the search ends; as above
  std::string approach;       // directions in which hands may move; empty: all
  std::string model;          // file of a model that orders the candidates; empty: none
  bool path = false;          // paths of the arm as well
  std::string path_planner = "rrt_connect";
  bool no_second_check = false;               // of paths
  std::optional<double> primitive_tolerance;  // mm; empty: that of DecomposeOptions
  std::vector<std::string> exports;           // formats besides grasps.json
  std::string shake;                          // protocol: name or file; empty: none
  bool uncertainty = false;                   // grasps are tried again on disturbed poses
  std::string rank = "epsilon";               // "shake", "probability", "success"
  bool dynamic = false;                       // hands close in time, on an object that gives way
  bool still = false;                         // hands are judged on an object that stands still
  std::vector<std::string> packages;          // of a hand or platform: NAME=FOLDER
  ChoiceWords choice;
  std::optional<double> friction;  // of the object; empty: that of the materials
  bool any = false;                // all objects of the scene, each among the others
  std::optional<bool> picture;     // of the best grasp; empty: where there is a report
  CommonOptions common;
};

// A scene, and how it was asked for.
struct PlanTask {
  CompiledScene scene;
  RunRecord record;
};

// Where the command's scene is loaded from, with this choice of object and regions. Throws
// InputError.
SceneSource source_of(const PlanCommand& command, const ObjectChoice& choice);

// Loads and compiles the command's scene, with laps for both. Throws InputError.
PlanTask load_task(const PlanCommand& command, const ObjectChoice& choice, Stopwatch& watch);
// Of a scene that was loaded already.
PlanTask make_task(const PlanCommand& command, const ObjectChoice& choice, Scene loaded,
                   Stopwatch& watch);

// The command with --any: plans each object of the scene among the others.
int run_plan_any(const PlanCommand& command, Interrupts& interrupts);

}  // namespace prehend
