#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>

#include <nlohmann/json.hpp>

#include "planner/main/option_values.h"
#include "planner/main/shared_options.h"
#include "planner/results/contacts_file.h"
#include "planner/show/exports/ply.h"
#include "planner/show/report/contacts_report.h"
#include "planner/show/report/report_html.h"
#include "sim/base/input_error.h"
#include "sim/base/json/json_pose.h"
#include "sim/base/output_file.h"
#include "sim/quality/measures.h"
#include "sim/quality/ranges.h"
#include "sim/quality/wrench_slice.h"

namespace prehend {
namespace {

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

void declare(CLI::App& command, QualityCommand& options) {
  add_examples(command,
               {"quality contacts.json",
                "quality contacts.json --space Linf --cone pyramid:16 --project tx=0,ty=0,tz=0"});
  command
      .add_option("contacts", options.contacts, "contacts file (docs/reference/contacts-file.md)")
      ->required();
  command.add_option("--space", options.space, "what is unit: sum of forces, or each")
      ->check(CLI::IsMember({"L1", "Linf"}))
      ->capture_default_str();
  command.add_option("--cone", options.cone, "friction cones: pyramid:EDGES or exact")
      ->capture_default_str();
  command.add_option("--force", options.force, "unit forces: at_most or exactly")
      ->check(CLI::IsMember({"at_most", "exactly"}));
  command.add_option("--measures", options.measures, "more measures by name, with commas");
  command.add_option("--project", options.project,
                     "write a section: force, torque, or three like tx=0,ty=0,fz=0.5");
  command.add_option("--out", options.out, "folder to write to")->capture_default_str();
  command.add_option("--seed", options.seed, "seed of the robust measures")
      ->check(complaint_about_seed)
      ->capture_default_str();
  add_no_report(command, options.no_report);
}

using Json = nlohmann::ordered_json;

// pyramid, pyramid:EDGES or exact.
void read_cone(const std::string& word, WrenchSpaceOptions& space) {
  const std::string prefix = "pyramid:";
  if (word == "exact") {
    space.cone = FrictionCone::exact;
    return;
  }
  space.cone = FrictionCone::pyramid;
  if (word == "pyramid") return;
  std::istringstream number(word.rfind(prefix, 0) == 0 ? word.substr(prefix.size()) : "");
  // eof: nothing may follow the number.
  if (!(number >> space.edges) || !number.eof() || space.edges < kFewestEdges ||
      space.edges > kMostEdges) {
    throw InputError({.field = "--cone",
                      .problem = "pyramid:EDGES with 3 to 1024 edges, or exact",
                      .value = word});
  }
}

WrenchSpaceOptions read_space(const QualityCommand& command) {
  WrenchSpaceOptions space;
  const bool linf = command.space == "Linf";
  space.norm = linf ? WrenchNorm::linf : WrenchNorm::l1;
  const std::string force = command.force.empty() ? (linf ? "at_most" : "exactly") : command.force;
  space.force = force == "at_most" ? UnitForce::at_most : UnitForce::exactly;
  read_cone(command.cone, space);
  return space;
}

// What --project fixes. "force": the torques are 0, which leaves the forces; "torque": the forces
// are 0. Else three of fx fy fz tx ty tz with their values, as in "tx=0,ty=0,fz=0.5".
FixedCoordinates read_fixed(const std::string& words) {
  if (words == "force") return {{3, 4, 5}, Eigen::Vector3d::Zero()};
  if (words == "torque") return {{0, 1, 2}, Eigen::Vector3d::Zero()};
  static constexpr std::string_view kNames = "fx fy fz tx ty tz";
  FixedCoordinates fixed;
  std::istringstream list(words);
  std::string word;
  std::size_t count = 0;
  while (std::getline(list, word, ',')) {
    // Names start at multiples of three; other places where two letters are found are no names.
    const auto at = kNames.find(word.substr(0, 2));
    std::istringstream number(word.size() > 3 && word[2] == '=' ? word.substr(3) : "");
    double value = 0.0;
    // eof: nothing may follow the number.
    const bool is_number = (number >> value) && number.eof() && std::isfinite(value);
    const bool is_name = at != std::string_view::npos && at % 3 == 0;
    const auto known = fixed.coordinates.begin() + static_cast<std::ptrdiff_t>(count);
    const bool is_fixed =
        is_name && std::find(fixed.coordinates.begin(), known, static_cast<int>(at / 3)) != known;
    if (!is_name || !is_number || is_fixed || count == 3) {
      throw InputError({.field = "--project",
                        .problem = "force, torque, or three like tx=0,ty=0,fz=0.5",
                        .value = words});
    }
    fixed.coordinates[count] = static_cast<int>(at / 3);
    fixed.values[static_cast<Eigen::Index>(count++)] = value;
  }
  if (count != 3)
    throw InputError(
        {.field = "--project", .problem = "three coordinates are fixed", .value = words});
  return fixed;
}

Json interval_json(const Interval& interval) {
  return {{"lower", interval.lower}, {"upper", interval.upper}};
}

// As in a grasp file: the torque times the scale.
Json wrench_json(const Wrench& wrench) {
  return {{"force", vector_to_json(wrench.head<3>())},
          {"torque", vector_to_json(wrench.tail<3>())}};
}

Json forces_json(const ContactsFile& file, const WrenchSpaceOptions& space) {
  ForceOptions options;
  options.cone = space.cone;
  options.edges = space.edges;
  options.measure =
      space.norm == WrenchNorm::l1 ? ForceMeasure::sum_of_normals : ForceMeasure::largest_normal;
  const ContactForces found =
      file.hand ? balancing_forces(file.contacts, file.frame, *file.external, *file.hand, options)
                : balancing_forces(file.contacts, file.frame, *file.external, options);
  Json json{{"outcome", name_of(found.outcome)}};
  if (found.outcome == ForceOutcome::impossible) {
    json["separating_wrench"] = wrench_json(found.separating);
    return json;
  }
  json["largest_normal"] = found.largest_normal;
  json["sum_of_normals"] = found.sum_of_normals;
  json["lowest"] = found.lowest;
  json["residual"] = found.residual;
  json["gap"] = found.gap;
  json["contacts"] = Json::array();
  for (Eigen::Index i = 0; i < found.forces.cols(); ++i) {
    json["contacts"].push_back({{"force", vector_to_json(found.forces.col(i))},
                                {"normal", found.components(0, i)},
                                {"torsion", found.components(3, i)}});
  }
  return json;
}

void add_measures(const QualityCommand& command, const ContactsFile& file,
                  const MeasureOptions& options, Json& json) {
  std::istringstream list(command.measures);
  std::string name;
  while (std::getline(list, name, ',')) {
    const NamedMeasure* measure = find_measure(name);
    if (measure == nullptr) {
      std::ostringstream message;
      message << "unknown measure " << name << " (known:";
      for (const NamedMeasure& known : measures()) message << " " << known.name;
      throw InputError({.field = "--measures", .problem = message.str() + ")"});
    }
    if (json.contains(name)) continue;
    json[name] = interval_json(measure->measure(file.contacts, file.frame, options));
  }
}

// Writes the section as a mesh file. Its axes x, y, z are the three coordinates that are not fixed,
// in their order.
void write_slice(const QualityCommand& command, const ContactsFile& file,
                 const MeasureOptions& options, Interrupts& interrupts) {
  const FixedCoordinates fixed = read_fixed(command.project);
  if (file.contacts.empty())
    throw InputError({.field = "--project", .problem = "there are no contacts"});
  const SetHull hull =
      set_hull(*wrench_space(file.contacts, file.frame, options.space), options.hull);
  if (hull.hull.status != PointHullStatus::solid) {
    throw InputError({.field = "--project", .problem = "the wrench space is flat"});
  }
  const WrenchSlice slice = wrench_slice(hull.hull, fixed);
  if (slice.empty())
    throw InputError(
        {.field = "--project", .problem = "the section is empty", .value = command.project});
  make_folder(command.out);
  interrupts.write(command.out / "slice.ply", ply_text(slice.vertices, slice.triangles));
}

// Messages go to stderr, because the output of the command on stdout is JSON.
void write_report(const QualityCommand& command, const std::string& report,
                  Interrupts& interrupts) {
  if (report.empty()) {
    remove_file(command.out / "report.html");
    return;
  }
  make_folder(command.out);
  interrupts.write(command.out / "report.html", report);
  std::cerr << "wrote " + command.out.string() + ": report.html\n";
}

Json quality_json(const QualityCommand& command, const ContactsFile& file,
                  const MeasureOptions& options, const JudgedContacts& judged) {
  const EpsilonBracket& bracket = judged.epsilon;
  Json json;
  json["epsilon"] = {
      {"lower", bracket.lower}, {"upper", bracket.upper}, {"status", name_of(bracket.status)}};
  json["force_closure"] = bracket.force_closure();
  json["volume"] = judged.volume.lower;
  json["volume_bracket"] = interval_json(judged.volume);
  json["weakest_wrench"] = wrench_json(bracket.weakest);
  add_measures(command, file, options, json);
  if (file.external) json["forces"] = forces_json(file, options.space);
  return json;
}

int run_quality(const QualityCommand& command, Interrupts& interrupts) {
  require_writable(command.out);
  const ContactsFile file = load_contacts(command.contacts);
  MeasureOptions options;
  options.space = read_space(command);
  options.task = file.task;
  options.surface = file.surface;
  options.noise.seed = command.seed;
  if (file.hand) options.jacobian = file.hand->jacobian;
  try {
    const JudgedContacts judged{
        options.space,
        grasp_epsilon(file.contacts, file.frame, options.space, epsilon_options(options.space)),
        find_measure("volume")->measure(file.contacts, file.frame, options)};
    const Json json = quality_json(command, file, options, judged);
    std::string report;
    if (!command.no_report) {
      const std::string name = command.contacts.stem().string();
      report = report_html(contacts_report(name, file, judged, command.seed));
    }
    if (!command.project.empty()) write_slice(command, file, options, interrupts);
    write_report(command, report, interrupts);
    std::cout << json.dump(1) << "\n";
  } catch (const InputError& error) {
    // Errors in an option name the option. All others are about the contents of the contacts file,
    // which the functions that throw do not know.
    if (error.field().starts_with("--")) throw;
    throw error.in_file(command.contacts.string());
  }
  return 0;
}

}  // namespace

void add_quality(CLI::App& app, CommandRequest& request) {
  add_command(app, request, "quality", "judge contacts without a scene (JSON)", declare,
              run_quality);
}

}  // namespace prehend
