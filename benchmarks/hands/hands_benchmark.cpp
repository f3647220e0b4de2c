// How well hands are derived that come without a description of how they grasp. Each is read as a
// bare file would give it (no hand, no closing velocities, no strategies, no exempt pairs), and
// plans with what is derived beside what is stated; of a file that states nothing, only the former.
//
//   hands_benchmark [--trials N] [--object MESH]... [HAND...]
//   hands_benchmark --catalogue LIST --folder FOLDER --page FILE [--trials N] [--object MESH]...
//
// HAND: names of the library or robot files; none: all hands of the library. The second line writes
// a page (Markdown, and pictures in a folder `hands` beside it) of the files of others that LIST
// names: a JSON array of {"name", "file" below FOLDER, "source"}.
#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/report/catalogue_page.h"
#include "planner/plan/plan.h"
#include "planner/show/robot_picture.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/json/json_field.h"
#include "sim/base/output_file.h"
#include "sim/robot/files/robot_file.h"
#include "sim/robot/hand/derive_hand.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/shape/object_generator.h"

namespace prehend::bench {
namespace {

struct Arguments {
  int trials = 300;
  std::filesystem::path catalogue;
  std::filesystem::path folder;
  std::filesystem::path page;
  std::vector<std::string> objects;
  std::vector<std::string> hands;
};

Arguments read_arguments(int count, char** words) {
  Arguments arguments;
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    if (word == "--trials" && k + 1 < count) {
      arguments.trials = std::stoi(words[++k]);
    } else if (word == "--object" && k + 1 < count) {
      arguments.objects.emplace_back(words[++k]);
    } else if (word == "--catalogue" && k + 1 < count) {
      arguments.catalogue = words[++k];
    } else if (word == "--folder" && k + 1 < count) {
      arguments.folder = words[++k];
    } else if (word == "--page" && k + 1 < count) {
      arguments.page = words[++k];
    } else {
      arguments.hands.push_back(word);
    }
  }
  if (arguments.hands.empty()) {
    for (const std::string& name : library_robot_names()) {
      if (find_robot(name).hand) arguments.hands.push_back(name);
    }
  }
  if (arguments.objects.empty()) arguments.objects = {"mug", "cylinder", "box"};
  return arguments;
}

GraspableBody object_of(const std::string& name) {
  const std::vector<std::string> known = generated_object_names();
  if (std::find(known.begin(), known.end(), name) != known.end()) {
    return make_graspable(name, generate_object(name, 2000), Material::plastic);
  }
  return load_scene(name).object;
}

Robot bare(Robot robot) {
  robot.hand.reset();
  robot.exempt_pairs.clear();
  for (DegreeOfFreedom& dof : robot.dofs) dof.closing_velocity = 0.0;
  return robot;
}

struct Planned {
  double epsilon = 0.0;
  double holds = 0.0;  // part of the trials
  std::string preshape;
};

Planned plan_with(const Robot& hand, const GraspableBody& object, int trials) {
  Scene scene;
  scene.name = object.name;
  scene.object = object;
  scene.hand = hand;
  PlanOptions options;
  options.search.trials = trials;
  options.volumes = false;
  // Else the first grasp is the one that moves a free object least, not that of the best epsilon.
  options.free_closing = 0;
  const PlanResult result = plan(compile(scene), options);
  Planned planned;
  int made = 0;
  for (const Outcome outcome : kAll<Outcome>) made += result.outcomes[outcome];
  if (made > 0) planned.holds = static_cast<double>(result.outcomes[Outcome::stable]) / made;
  if (result.grasps.empty()) return planned;
  planned.epsilon = result.grasps.front().trial.epsilon.lower;
  const std::optional<int> preshape = result.grasps.front().candidate.preshape;
  if (preshape) planned.preshape = hand.hand->preshapes[index(*preshape)].name;
  return planned;
}

// The preshape that opens widest.
const Preshape& widest(const Robot& robot) {
  return *std::max_element(
      robot.hand->preshapes.begin(), robot.hand->preshapes.end(),
      [](const Preshape& a, const Preshape& b) { return a.max_width < b.max_width; });
}

double ratio(double part, double whole) { return whole > 0.0 ? 100.0 * part / whole : 0.0; }

void print_axes(const std::string& name, const Robot& derived, const std::optional<Robot>& stated) {
  const Preshape& wide = widest(derived);
  std::printf("%s: aperture %.1f mm, depth %.1f mm, %zu preshapes", name.c_str(),
              1e3 * wide.max_width, 1e3 * wide.depth, derived.hand->preshapes.size());
  if (!stated) {
    std::printf("\n");
    return;
  }
  const Preshape& its = widest(*stated);
  const double approach = derived.hand->approach.dot(stated->hand->approach);
  const double closing = std::abs(derived.hand->closing.dot(stated->hand->closing));
  constexpr double kDegrees = 57.29577951308232;
  std::printf("; stated %.1f mm, %.1f mm, %zu; axes off by %.0f and %.0f deg; closing of",
              1e3 * its.max_width, 1e3 * its.depth, stated->hand->preshapes.size(),
              kDegrees * std::acos(std::clamp(approach, -1.0, 1.0)),
              kDegrees * std::acos(std::min(closing, 1.0)));
  int other = 0;
  for (std::size_t d = 0; d < derived.dofs.size(); ++d) {
    const double a = derived.dofs[d].closing_velocity;
    const double b = stated->dofs[d].closing_velocity;
    if ((a > 0.0) == (b > 0.0) && (a < 0.0) == (b < 0.0)) continue;
    std::printf(" %s", derived.dofs[d].name.c_str());
    ++other;
  }
  std::printf(other > 0 ? " differs\n" : " all as stated\n");
}

void try_hand(const std::string& name, const std::vector<GraspableBody>& objects, int trials) {
  const Robot read = find_robot(name);
  std::optional<Robot> stated;
  if (read.hand && !read.hand->preshapes.empty()) stated = read;
  const Robot derived = with_hand(stated ? bare(read) : read);
  print_axes(name, derived, stated);
  for (const GraspableBody& object : objects) {
    const Planned ours = plan_with(derived, object, trials);
    std::printf("  %-22s eps %.4f (%s), holds %.1f %%", object.name.c_str(), ours.epsilon,
                ours.preshape.c_str(), 100.0 * ours.holds);
    if (stated) {
      const Planned its = plan_with(*stated, object, trials);
      std::printf("; stated %.4f (%s), %.1f %%: eps %.0f %%", its.epsilon, its.preshape.c_str(),
                  100.0 * its.holds, ratio(ours.epsilon, its.epsilon));
    }
    std::printf("\n");
    std::fflush(stdout);
  }
}

std::string picture_of(const Robot& hand, const std::string& name,
                       const std::filesystem::path& folder) {
  std::string file;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) file += c;
  }
  constexpr int kPostures = 300;  // of the survey of where the tips get
  const Image image = robot_picture(hand, telling_postures(hand), survey_postures(hand, kPostures),
                                    {.width = 900, .height = 500});
  std::filesystem::create_directories(folder / "hands");
  write_file(folder / "hands" / (file + ".png"), png_bytes(image));
  return "hands/" + file + ".png";
}

CatalogueHand catalogue_hand(const JsonField& entry, const std::vector<GraspableBody>& objects,
                             const Arguments& arguments) {
  const std::string file = entry["file"].text();
  CatalogueHand row{.name = entry["name"].text(),
                    .source = entry["source"].text() + ", " + file,
                    .refusal = "",
                    .picture = ""};
  try {
    const auto start = std::chrono::steady_clock::now();
    const Robot hand = with_hand(find_robot((arguments.folder / file).string()));
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    row.joints = static_cast<int>(hand.joints.size());
    row.drives = static_cast<int>(hand.dofs.size());
    row.preshapes = static_cast<int>(hand.hand->preshapes.size());
    row.notes = static_cast<int>(hand.notes.size());
    row.aperture = widest(hand).max_width;
    row.picture = picture_of(hand, row.name, arguments.page.parent_path());
    for (const GraspableBody& object : objects) {
      const Planned planned = plan_with(hand, object, arguments.trials);
      row.grasps.push_back({object.name, planned.epsilon, planned.holds});
    }
  } catch (const InputError& error) {
    row.refusal = error.problem();
  }
  return row;
}

void write_catalogue(const std::vector<GraspableBody>& objects, const Arguments& arguments) {
  const JsonFile list(arguments.catalogue);
  std::vector<CatalogueHand> rows;
  for (const JsonField& entry : list.root().items()) {
    rows.push_back(catalogue_hand(entry, objects, arguments));
    std::printf("%s\n", rows.back().name.c_str());
    std::fflush(stdout);
  }
  write_file(arguments.page, catalogue_page(rows, arguments.trials));
}

void run(const Arguments& arguments) {
  std::vector<GraspableBody> objects;
  for (const std::string& name : arguments.objects) objects.push_back(object_of(name));
  if (!arguments.catalogue.empty()) {
    write_catalogue(objects, arguments);
    return;
  }
  for (const std::string& name : arguments.hands) {
    try {
      try_hand(name, objects, arguments.trials);
    } catch (const InputError& error) {
      std::printf("%s: refused: %s\n", name.c_str(), error.what());
    }
  }
}

}  // namespace
}  // namespace prehend::bench

int main(int count, char** words) {
  try {
    prehend::bench::run(prehend::bench::read_arguments(count, words));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hands_benchmark: %s\n", error.what());
    return 1;
  }
}
