#include <algorithm>
#include <iostream>
#include <utility>

#include <nlohmann/json.hpp>

#include "planner/main/plan_command.h"
#include "planner/main/plan_output.h"
#include "planner/main/progress_bar.h"
#include "planner/main/result_table.h"
#include "planner/plan/grasp_text.h"
#include "planner/plan/plan_any.h"
#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/base/output_file.h"

namespace prehend {
namespace {

namespace fs = std::filesystem;

// A scene for each of the objects, whose name is that of a folder of the results.
std::vector<Scene> scenes_to_plan(const PlanCommand& command) {
  std::vector<Scene> scenes = load_each_scene(command.scene, source_of(command, {}));
  require(!scenes.empty(),
          {.file = command.scene,
           .field = "objects",
           .problem = "missing; --any needs a scene file that lists its objects there, or what "
                      "depth cameras saw"});
  for (const Scene& scene : scenes) {
    const std::string& name = scene.object.name;
    const bool fits = !name.empty() && name != "." && name != ".." &&
                      name.find('/') == std::string::npos && name != "any.json";
    require(fits, {.file = command.scene,
                   .field = "objects",
                   .problem = "--any makes a folder of each name, so it must be one of a folder",
                   .value = name});
  }
  return scenes;
}

bool has_candidates(const PlanResult& result) {
  return result.status != PlanStatus::object_too_large &&
         result.status != PlanStatus::no_candidates;
}

class AnyProgram {
 public:
  AnyProgram(const PlanCommand& command, Interrupts& interrupts)
      : command_(command), interrupts_(interrupts), folder_(command.common.out) {}

  int run() {
    require_writable(folder_);
    for (Scene& scene : scenes_to_plan(command_)) {
      const std::string name = scene.object.name;
      outputs_.emplace_back(command_, interrupts_, folder_ / name);
      PlanTask task =
          make_task(command_, {.object = name}, std::move(scene), outputs_.back().watch());
      scenes_.push_back(std::move(task.scene));
      records_.push_back(std::move(task.record));
    }
    plan_all();
    const bool nothing = std::all_of(any_.results.begin(), any_.results.end(),
                                     [](const PlanResult& result) { return result.tried.empty(); });
    if (nothing && has_candidates(any_.results.front())) {
      if (time_is_up_) interrupts_.use_up_budget();
      return say_interrupted("nothing is written");
    }
    write_all();
    if (nothing) {
      write_reports();
      throw InputError(no_candidates_text(scenes_.front(), any_.results.front()));
    }
    print_all();
    interrupts_.end_at_once("the grasps are written, not the reports and the pictures");
    if (interrupts_.cancellation().requested() && !time_is_up_) {
      return say_interrupted("no reports, no pictures");
    }
    write_reports();
    std::cout << "wrote " << folder_.string() << ": any.json, and a folder for each object\n";
    return 0;
  }

 private:
  void plan_all() {
    ProgressBar bar(command_.common.progress);
    interrupts_.cancel_first();
    any_ =
        plan_any(scenes_, records_.front().options,
                 {command_.common.threads, interrupts_.cancellation(),
                  [&](const Progress& progress) { bar.show(progress); }, interrupts_.deadline()});
    bar.clear();
    time_is_up_ = interrupts_.unlimit_time();
    for (std::size_t s = 0; s < scenes_.size(); ++s) {
      PlanResult& result = any_.results[s];
      if (time_is_up_ && result.status == PlanStatus::cancelled) {
        result.status = PlanStatus::out_of_time;
      }
      outputs_[s].watch().add(result.times);
    }
  }

  void write_all() {
    for (std::size_t s = 0; s < scenes_.size(); ++s) {
      outputs_[s].write_grasps(scenes_[s], any_.results[s], records_[s]);
    }
    interrupts_.write(folder_ / "any.json", any_json());
  }

  // With their pictures.
  void write_reports() {
    for (std::size_t s = 0; s < scenes_.size(); ++s) {
      outputs_[s].write_report(scenes_[s], any_.results[s], records_[s]);
      (void)outputs_[s].write_pictures(scenes_[s], any_.results[s]);
      outputs_[s].write_timings(any_.results[s]);
    }
  }

  const std::string& name_of_object(std::size_t s) const { return scenes_[s].scene.object.name; }

  const ScoredGrasp& grasp_at(const AnyGrasp& one) const {
    return any_.results[index(one.scene)].grasps[index(one.grasp)];
  }

  std::string any_json() const {
    using Json = nlohmann::ordered_json;
    Json objects = Json::array();
    for (std::size_t s = 0; s < scenes_.size(); ++s) {
      const PlanResult& result = any_.results[s];
      objects.push_back({{"name", name_of_object(s)},
                         {"file", name_of_object(s) + "/grasps.json"},
                         {"status", std::string(name_of(result.status))},
                         {"grasps", result.grasps.size()},
                         {"first", any_.first[s]}});
    }
    Json ranked = Json::array();
    for (const AnyGrasp& one : any_.ranked) {
      ranked.push_back({{"object", name_of_object(index(one.scene))},
                        {"grasp", one.grasp + 1},
                        {"epsilon", grasp_at(one).trial.epsilon.lower}});
    }
    const Json file{{"format", "prehend any 1"},
                    {"scene", records_.front().scene},
                    {"objects", objects},
                    {"ranked", ranked}};
    return file.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
  }

  void print_all() const {
    std::size_t width = 6;
    for (std::size_t s = 0; s < scenes_.size(); ++s) {
      width = std::max(width, name_of_object(s).size());
    }
    const int column = static_cast<int>(width);
    std::cout << formatted("%4s  %-*s  %5s  %8s  %s\n", "rank", column, "object", "grasp",
                           "epsilon", "primitive");
    const std::size_t rows = std::min(any_.ranked.size(), index(command_.top));
    for (std::size_t i = 0; i < rows; ++i) {
      const AnyGrasp& one = any_.ranked[i];
      std::cout << formatted("%4zu  %-*s  %5d  %8.4f  %s\n", i + 1, column,
                             name_of_object(index(one.scene)).c_str(), one.grasp + 1,
                             grasp_at(one).trial.epsilon.lower,
                             origin_text(grasp_at(one), any_.results[index(one.scene)]).c_str());
    }
    for (std::size_t s = 0; s < scenes_.size(); ++s) print_object(s);
    std::cout << std::flush;
  }

  void print_object(std::size_t s) const {
    const PlanResult& result = any_.results[s];
    std::cout << name_of_object(s) << ": " << result.grasps.size() << " grasps; "
              << outcome_line(result) << "\n"
              << untested_line(result) << blocker_line(result);
    if (!any_.first[s].empty()) {
      std::cout << "  " << joined(any_.first[s], " and ")
                << " must go first: then it has a grasp\n";
    } else if (!has_candidates(result)) {
      std::cout << "  " << no_candidates_text(scenes_[s], result) << "\n";
    } else if (result.grasps.empty()) {
      std::cout << advice_lines(result);
    }
  }

  int say_interrupted(const std::string& words) const {
    std::cerr << "prehend: " << interrupts_.reason() << ", " << words << "\n";
    return interrupts_.exit_status();
  }

  const PlanCommand& command_;
  Interrupts& interrupts_;
  fs::path folder_;
  std::vector<PlanOutput> outputs_;  // of each object
  std::vector<CompiledScene> scenes_;
  std::vector<RunRecord> records_;
  AnyPlan any_;
  bool time_is_up_ = false;
};

}  // namespace

int run_plan_any(const PlanCommand& command, Interrupts& interrupts) {
  return AnyProgram(command, interrupts).run();
}

}  // namespace prehend
