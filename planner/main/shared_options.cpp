#include "planner/main/shared_options.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

#include "planner/main/option_values.h"
#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/base/range.h"
#include "sim/scene/color_region.h"
#include "sim/shape/files/text_scan.h"

namespace prehend {

void add_examples(CLI::App& command, const std::vector<std::string>& examples) {
  const auto line = [](const std::string& words) { return "  prehend " + words; };
  command.footer("Examples:\n" + joined(examples, "\n", line));
}

void add_limits(CLI::App& command, Limits& limits) {
  command.add_option("--budget", limits.budget,
                     "time after which to stop and keep what there is: 500ms, 2s, 1.5min");
  command.add_option("--memory-limit", limits.memory, "MB of memory to use at most, 0: no limit")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 40))
      ->capture_default_str();
}

void add_common(CLI::App& command, CommonOptions& common) {
  command.add_option("--threads", common.threads, "threads to use, 0: all processors")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command.add_option("--seed", common.seed, "seed of everything random")
      ->check(complaint_about_seed)
      ->capture_default_str();
  command.add_option("--out", common.out, "folder to write to")->capture_default_str();
  command.add_flag("--progress", common.progress, "say on stderr how far the run is, in lines");
}

void add_uncertainty(CLI::App& command, bool& uncertainty) {
  command.add_flag("--uncertainty", uncertainty,
                   "try each grasp again with errors of pose, friction and centre of mass");
}

void add_shake(CLI::App& command, std::string& protocol) {
  command.add_option("--shake", protocol,
                     "close, lift and shake each grasp: a protocol's name or file");
}

void add_dynamic(CLI::App& command, bool& dynamic) {
  command.add_flag("--dynamic", dynamic,
                   "simulate how each hand closes: the object has weight and gives way");
}

void add_second_check(CLI::App& command, bool& no_second_check) {
  command.add_flag("--no-second-check", no_second_check,
                   "paths without the second opinion of another engine (FCL)");
}

void add_no_report(CLI::App& command, bool& no_report) {
  command.add_flag("--no-report", no_report, "do without report.html");
}

void add_accuracy(CLI::App& command, CommonOptions& common) {
  command
      .add_option(
          "--accuracy", common.accuracy,
          "draft, standard or fine, or a file of settings (docs/reference/accuracy-file.md)")
      ->capture_default_str();
}

void add_contacts(CLI::App& command, CommonOptions& common) {
  command
      .add_option_function<std::string>(
          "--contacts",
          [&common](const std::string& kind) { common.contacts = value_named<ContactKind>(kind); },
          "of rubber: soft fingers that pass on torque, hard points, or pads of finite elements")
      ->check(CLI::IsMember(texts(enum_names(ContactKind{}))))
      ->default_str("soft");
}

void add_unit(CLI::App& command, std::string& unit) {
  CLI::Option* name = command.add_option(
      "--unit", unit, "unit of a mesh file: m, cm, mm, in; without it the likely one by its size");
  command
      .add_option("--scale", unit, "another unit than these: its length in metres, such as 0.0254")
      ->check(CLI::PositiveNumber)
      ->excludes(name);
}

void add_mesh_options(CLI::App& command, std::string& unit, bool& repair) {
  add_unit(command, unit);
  command.add_flag("!--no-repair", repair, "take the surface of a mesh file as it is");
}

void add_choice(CLI::App& command, ChoiceWords& words) {
  command.add_option("--object", words.object, "which of the scene's objects to grasp, by name");
  command.add_option("--keep-out", words.keep_out,
                     "part of the object that no finger may touch: its name in the mesh file, its "
                     "colour there (#cc3311, or #cc3311/0.1 for nearer ones alone), or two corners "
                     "of a box, x,y,z:x,y,z in mm; may be repeated");
  command.add_option("--prefer", words.preferred,
                     "the same of parts: grasps that touch nothing else come first");
  command
      .add_option("--apart", words.apart,
                  "how far the hand keeps from the other objects, in metres; 0: fingers that close "
                  "may end at them, which touches them lightly")
      ->capture_default_str();
}

namespace {

// #rrggbb, or #rrggbb/DISTANCE.
SurfaceRegion color_of_words(const char* option, const std::string& words) {
  const std::size_t slash = words.find('/');
  const std::optional<Vector3> color = color_in_text(std::string_view(words).substr(0, slash));
  require(color.has_value(), {.field = option, .problem = kColorWords, .value = words});
  if (slash == words.npos) return {.color = ColorRange{*color}};
  const std::optional<double> within = number_in(std::string_view(words).substr(slash + 1));
  require(within && *within >= 0.0 && *within <= ColorRange::kFarthest,
          {.field = option,
           .problem = "a colour's distance must be from 0 to 2, as in #cc3311/0.1",
           .value = words});
  return {.color = ColorRange{*color, *within}};
}

SurfaceRegion region_of_words(const char* option, const std::string& words) {
  if (words.starts_with('#')) return color_of_words(option, words);
  // A name has letters, a box none.
  const bool is_box = words.find(':') != std::string::npos &&
                      words.find_first_not_of("0123456789+-.,:eE") == std::string::npos;
  if (!is_box) {
    require(!words.empty(), {.field = option, .problem = "must not be empty"});
    return {.part = words};
  }
  constexpr double kMetresPerMillimetre = 1e-3;
  Bounds box{Vector3::Zero(), Vector3::Zero()};
  const std::size_t colon = words.find(':');
  const bool sound = three_numbers(std::string_view(words).substr(0, colon), box.lower) &&
                     three_numbers(std::string_view(words).substr(colon + 1), box.upper);
  const Vector3 size = kMetresPerMillimetre * (box.upper - box.lower).cwiseAbs();
  require(sound && size.minCoeff() > 0.0 && size.maxCoeff() <= kFarthest,
          {.field = option,
           .problem = "a box is two corners in mm that differ in each coordinate, such as "
                      "-10,-10,0:10,10,50",
           .value = words});
  return {.inside = {Box{size}, translation(kMetresPerMillimetre * box.center())}};
}

}  // namespace

ObjectChoice object_choice(const ChoiceWords& words) {
  ObjectChoice choice{.object = words.object, .apart = words.apart};
  for (const std::string& one : words.keep_out) {
    choice.keep_out.push_back(region_of_words("--keep-out", one));
  }
  for (const std::string& one : words.preferred) {
    choice.preferred.push_back(region_of_words("--prefer", one));
  }
  return choice;
}

void add_friction(CLI::App& command, std::optional<double>& friction) {
  command
      .add_option("--friction", friction,
                  "coefficient of friction of the object, in place of those of the materials")
      ->check(CLI::Range(0.0, kLargestFriction));
}

void add_scene_options(CLI::App& command, std::string& scene, std::string& hand, std::string& unit,
                       bool& repair) {
  command.add_option("--scene", scene, "scene or mesh file, in place of the one the file names");
  command.add_option("--hand", hand, "robot of the library or robot file, in place of the file's");
  add_mesh_options(command, unit, repair);
}

void add_packages(CLI::App& command, std::vector<std::string>& packages) {
  command.add_option("--package", packages,
                     "NAME=FOLDER: where a package is that a URDF file names; may be repeated");
}

void add_foreign(CLI::App& command, std::vector<std::string>& packages,
                 std::filesystem::path& srdf) {
  add_packages(command, packages);
  command.add_option("--srdf", srdf, "SRDF file of a URDF file, in place of the one beside it");
}

ForeignRobotOptions foreign_options(const std::vector<std::string>& packages,
                                    const std::filesystem::path& srdf) {
  ForeignRobotOptions options{.srdf = srdf};
  for (const std::string& words : packages) {
    const std::size_t sign = words.find('=');
    require(sign != std::string::npos && sign > 0 && sign + 1 < words.size(),
            {.field = "--package", .problem = "must be NAME=FOLDER", .value = words});
    options.packages[words.substr(0, sign)] = words.substr(sign + 1);
  }
  return options;
}

}  // namespace prehend
