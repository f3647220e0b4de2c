#include <iostream>

#include "planner/bulk/design/design_series.h"
#include "planner/main/bulk/bulk_commands.h"
#include "planner/main/other_programs.h"
#include "planner/main/print_notes.h"
#include "planner/main/progress_bar.h"
#include "planner/main/requested_scene.h"
#include "planner/main/shared_options.h"
#include "sim/base/output_file.h"
#include "sim/scene/scene_file.h"

namespace prehend {
namespace {

// Arguments of `design`.
struct DesignCommand {
  std::string hand;
  std::vector<std::string> objects = {"mug", "hammer", "wet_glass"};
  std::string vary;
  CommonOptions common = {.out = "out/design", .accuracy = "draft"};
};

void declare_design(CLI::App& command, DesignCommand& options) {
  add_examples(command, {"design barrett --vary finger.length=0.8:1.2",
                         "design gripper.urdf mug.obj can.obj --vary left_finger.length=0.5:2:7",
                         "design franka_hand --vary hand.friction=0.2:1"});
  command.add_option("hand", options.hand, "a name of the library or a robot file")->required();
  command.add_option("objects", options.objects, "scenes without arms, or mesh files")
      ->capture_default_str();
  command
      .add_option("--vary", options.vary,
                  "PART.MEASURE=FROM:TO[:COUNT]: length (factor) of a link or of each \"finger\", "
                  "lower or upper limit of a degree of freedom (rad, m), size (factor) or friction "
                  "of the \"hand\"")
      ->required();
  add_common(command, options.common);
  add_accuracy(command, options.common);
  add_contacts(command, options.common);
  command.add_flag("--no-report", options.common.no_report, "do without design.html");
}

int run_design(const DesignCommand& command, Interrupts& interrupts) {
  const HandVariation variation = hand_variation(command.vary);
  require_writable(command.common.out);
  PlanOptions options = requested_accuracy(command.common.accuracy);
  options.seed = command.common.seed;
  if (command.common.contacts) options.trial.contacts = *command.common.contacts;
  std::vector<Scene> scenes;
  for (const std::string& object : command.objects) {
    scenes.push_back(load_scene(object, {.hand = command.hand}));
    print_notes(scenes.back());
  }
  ProgressBar bar(command.common.progress);
  const RunContext context{command.common.threads,
                           interrupts.cancellation(),
                           [&](const Progress& progress) { bar.show(progress); },
                           {}};
  interrupts.cancel_first();
  std::vector<DesignPoint> points;
  try {
    points = design_series(scenes, variation, options, context);
  } catch (const Cancelled&) {
    bar.clear();
    std::cerr << "prehend: " << interrupts.reason() << ", nothing is written\n";
    return interrupts.exit_status();
  }
  bar.clear();
  interrupts.end_at_once("not all files are written");
  const std::filesystem::path& folder = command.common.out;
  make_folder(folder);
  interrupts.write(folder / "design.csv", design_csv(points, variation));
  if (command.common.no_report) {
    remove_file(folder / "design.html");
  } else {
    interrupts.write(folder / "design.html",
                     design_page(points, variation, scenes.front().hand.name));
  }
  std::cout << design_table(points, variation) << "wrote " << folder.string() << ": design.csv"
            << (command.common.no_report ? "" : ", design.html") << "\n";
  return 0;
}

}  // namespace

void add_design(CLI::App& app, CommandRequest& request) {
  add_command(app, request, kDesign.name, kDesign.summary, declare_design, run_design);
}

}  // namespace prehend
