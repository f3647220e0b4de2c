#include <iostream>
#include <mutex>
#include <utility>

#include "planner/main/requested_scene.h"
#include "planner/main/shared_options.h"
#include "planner/results/grasps_file.h"
#include "planner/show/contact_sheet.h"
#include "planner/show/exports/result_files.h"
#include "planner/show/motion_frames.h"
#include "planner/show/motion_picture.h"
#include "planner/show/posed_grasp.h"
#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/json/json_field.h"
#include "sim/base/output_file.h"
#include "sim/base/parallel/parallel.h"

namespace prehend {
namespace {

// Arguments of `render`.
struct RenderCommand {
  std::filesystem::path grasps;
  int grasp = 0;   // 1 is the first, 0: all
  int frames = 8;  // of the approach
  std::string scene;
  std::string hand;
  std::string unit;
  bool repair = true;
  std::filesystem::path out = "out/render";
};

void declare(CLI::App& command, RenderCommand& options) {
  add_examples(command, {"render out/grasps.json", "render out/grasps.json --grasp 1 --frames 20"});
  command.add_option("grasps", options.grasps, "grasp file")->required();
  command.add_option("--grasp", options.grasp, "number of the one to draw, 0: all")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command
      .add_option("--frames", options.frames,
                  "pictures of its approach (for all: of the first), 0: none")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  add_scene_options(command, options.scene, options.hand, options.unit, options.repair);
  command.add_option("--out", options.out, "folder to write to")->capture_default_str();
}

constexpr std::size_t kSheetGrasps = 10;
constexpr PictureSize kFramePicture{800, 640};

struct DrawnGrasp {
  std::size_t number = 0;  // in the file, from 1
  ScoredGrasp result;
  PosedGrasp posed;
  std::string numbers;  // lines for the contact sheet
};

std::string title_of(const ScoredGrasp& grasp, bool judged, std::size_t number) {
  std::string title = "grasp " + std::to_string(number);
  if (!judged) return title;
  title += formatted("   epsilon %.4f", grasp.trial.epsilon.lower);
  return title + "   " + std::string(name_of(grasp.trial.outcome));
}

// What the file knows of it, in lines that are short enough for a cell.
std::string numbers_of(const ScoredGrasp& grasp, bool judged, std::size_t number) {
  std::string text = "grasp " + std::to_string(number);
  if (judged) text += formatted("   epsilon %.4f", grasp.trial.epsilon.lower);
  std::string second;
  if (grasp.volume) second += formatted("volume %.3g", *grasp.volume);
  const std::size_t contacts = grasp.trial.contacts.size();
  if (judged || contacts > 0) {
    second += (second.empty() ? "" : "   ") + std::to_string(contacts) + " contacts";
  }
  if (!second.empty()) text += "\n" + second;
  const bool failed = judged && grasp.trial.outcome != Outcome::stable;
  return failed ? text + "\n" + std::string(name_of(grasp.trial.outcome)) : text;
}

// All of them, or the one that was asked for.
std::vector<DrawnGrasp> drawn_grasps(const JsonFile& file, const CompiledScene& scene, int asked) {
  const GraspFile read = read_grasps(file, scene);
  const std::vector<ScoredGrasp>& grasps = read.result.grasps;
  if (grasps.empty()) throw InputError({file.path().string(), "grasps", "there is none to draw"});
  if (asked > static_cast<int>(grasps.size())) {
    throw InputError({file.path().string(), "--grasp",
                      "there are " + std::to_string(grasps.size()) + " grasps",
                      std::to_string(asked)});
  }
  std::vector<DrawnGrasp> drawn;
  for (std::size_t i = 0; i < grasps.size(); ++i) {
    if (asked > 0 && i + 1 != static_cast<std::size_t>(asked)) continue;
    const bool judged = read.judged[i];
    drawn.push_back({i + 1, grasps[i],
                     posed_grasp(scene, grasps[i], title_of(grasps[i], judged, i + 1)),
                     numbers_of(grasps[i], judged, i + 1)});
  }
  return drawn;
}

void print_written(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  std::cout << "wrote " << (folder / names.front()).string();
  if (names.size() > 1) std::cout << " ... " << names.back();
  std::cout << "\n";
}

// With `alone`, pictures of earlier grasps are removed once the first is written.
void write_each(const std::filesystem::path& folder, const CompiledScene& scene,
                const std::vector<DrawnGrasp>& grasps, bool alone, Interrupts& interrupts) {
  std::vector<std::string> names(grasps.size());
  std::mutex writing;
  bool is_first = alone;
  for_each_in_parallel(grasps.size(), 0, [&](std::size_t i) {
    names[i] = formatted("grasp_%03zu.png", grasps[i].number);
    const std::string picture =
        png_bytes(grasp_from_four_sides(scene, grasps[i].posed, {1400, 1100}));
    const std::lock_guard lock(writing);
    interrupts.write(folder / names[i], picture);
    if (!std::exchange(is_first, false)) return;
    remove_regular_files(folder, [&](const std::string& name) {
      return is_rendered_file(name) && name != names[i];
    });
  });
  print_written(folder, names);
}

void write_sheet(const std::filesystem::path& folder, const CompiledScene& scene,
                 const std::vector<DrawnGrasp>& grasps, Interrupts& interrupts) {
  std::vector<PosedGrasp> best;
  for (const DrawnGrasp& grasp : grasps) {
    if (best.size() == kSheetGrasps) break;
    best.push_back(grasp.posed);
    best.back().title = grasp.numbers;
  }
  interrupts.write(folder / "contact_sheet.png", png_bytes(contact_sheet(scene, best)));
  print_written(folder, {"contact_sheet.png"});
}

std::string frame_title(const DrawnGrasp& grasp, const NamedFrame& frame, std::size_t number,
                        std::size_t count) {
  return "grasp " + std::to_string(grasp.number) + "   frame " + std::to_string(number) + " of " +
         std::to_string(count) + "\n" + frame.segment + formatted("   %.2f s", frame.frame.time);
}

void write_frames(const std::filesystem::path& folder, const CompiledScene& scene,
                  const DrawnGrasp& grasp, int count, Interrupts& interrupts) {
  const std::string start = formatted("approach_%03zu_frame_", grasp.number);
  // An earlier run may have written more frames of this grasp than this one will.
  remove_regular_files(folder, [&](const std::string& name) {
    return is_rendered_file(name) && name.starts_with(start);
  });
  if (count == 0) return;
  const ScoredGrasp& result = grasp.result;
  const GraspMotion motion =
      grasp_motion(scene, result.candidate, result.trial, result.path ? &*result.path : nullptr);
  const std::vector<NamedFrame> frames = named_frames(motion, count);
  if (frames.empty()) {
    std::cout << "no frames: the file does not say how the hand comes to grasp " << grasp.number
              << "\n";
    return;
  }
  std::vector<MotionFrame> postures;
  for (const NamedFrame& frame : frames) postures.push_back(frame.frame);
  // One view for all frames, so that only the robot moves from one picture to the next.
  const MotionView view = motion_view(scene, postures, grasp.posed, kFramePicture);
  std::vector<std::string> names(frames.size());
  for_each_in_parallel(frames.size(), 0, [&](std::size_t i) {
    PosedGrasp moment = posed_at(frames[i].frame);
    moment.title = frame_title(grasp, frames[i], i + 1, frames.size());
    // Before the grasp nothing touches, and afterwards it is elsewhere.
    if (frames[i].frame.time == motion.frames[motion.grasp()].time) {
      moment.contacts = grasp.posed.contacts;
    }
    // Fixed width, so that the names sort in the order of the frames.
    names[i] = start + formatted(count < 100 ? "%02zu.png" : "%04zu.png", i + 1);
    interrupts.write(folder / names[i],
                     png_bytes(motion_picture(scene, moment, view, kFramePicture)));
  });
  print_written(folder, names);
}

int run_render(const RenderCommand& command, Interrupts& interrupts) {
  require_writable(command.out);
  const JsonFile file(command.grasps);
  const LoadedScene loaded =
      load_asked_scene(file, {command.scene, command.hand, command.unit, command.repair, {}, {}});
  const std::vector<DrawnGrasp> grasps = drawn_grasps(file, loaded.scene, command.grasp);
  const std::filesystem::path& folder = command.out;
  make_folder(folder);
  interrupts.end_at_once("pictures that were drawn are written");
  // All grasps are drawn: pictures of others must not stand beside them.
  write_each(folder, loaded.scene, grasps, command.grasp == 0, interrupts);
  if (command.grasp == 0) write_sheet(folder, loaded.scene, grasps, interrupts);
  write_frames(folder, loaded.scene, grasps.front(), command.frames, interrupts);
  return 0;
}

}  // namespace

void add_render(CLI::App& app, CommandRequest& request) {
  add_command(app, request, "render", "draw grasps of a grasp file (PNG)", declare, run_render);
}

}  // namespace prehend
