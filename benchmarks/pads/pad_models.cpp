// What contacts of rubber are made of, against pads of finite elements, on published grasps of the
// Franka hand (shared data/grasps): pad_models SHARED_DIR [GRASPS_AN_OBJECT]. Writes a table in
// Markdown to stdout. Times are processor times of one thread.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/robot/files/robot_file.h"
#include "sim/scene/make_scene.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/soft/press_pad.h"
#include "sim/trial/run_trial.h"
#include "tests/support/published_grasps.h"

namespace prehend {
namespace {

enum class Model { hard, soft, nodes, limit_surface };
constexpr auto enum_names(Model /*of*/) {
  return std::to_array<std::string_view>({"hard", "soft", "fem, nodes", "fem, limit surface"});
}

TrialOptions options_of(Model model) {
  TrialOptions options;
  options.contacts = model == Model::hard   ? ContactKind::hard
                     : model == Model::soft ? ContactKind::soft
                                            : ContactKind::fem;
  options.pads.patch =
      model == Model::limit_surface ? PadPatchModel::limit_surface : PadPatchModel::nodes;
  return options;
}

double processor_seconds() {
  timespec now = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Tried {
  Trial trial;
  double seconds = 0.0;
};
using TriedByModel = EnumArray<Model, Tried>;

// The largest torsion among the soft fingers of each link.
std::map<LinkId, double> torsions(const Trial& trial) {
  std::map<LinkId, double> largest;
  for (const GraspContact& contact : trial.contacts) {
    if (contact.point.model != ContactModel::soft_finger) continue;
    double& value = largest[contact.link];
    value = std::max(value, contact.point.torsion);
  }
  return largest;
}

double quantile(std::vector<double> values, double part) {
  if (values.empty()) return 0.0;
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

void print_held(const std::vector<TriedByModel>& all) {
  std::printf(
      "| contacts | held | as soft says | ms a trial, median | 95 %% |\n|---|--:|--:|--:|--:|\n");
  for (const Model model : kAll<Model>) {
    int held = 0;
    int alike = 0;
    std::vector<double> seconds;
    for (const TriedByModel& tried : all) {
      const bool holds = tried[model].trial.outcome == Outcome::stable;
      held += holds ? 1 : 0;
      alike += holds == (tried[Model::soft].trial.outcome == Outcome::stable) ? 1 : 0;
      seconds.push_back(tried[model].seconds);
    }
    std::printf("| %s | %d of %zu | %d | %.2f | %.2f |\n", std::string(name_of(model)).c_str(),
                held, all.size(), alike, 1e3 * quantile(seconds, 0.5),
                1e3 * quantile(seconds, 0.95));
  }
}

void print_epsilon(const std::vector<TriedByModel>& all) {
  std::printf("\n| ε over that of soft, both hold | 10 %% | median | 90 %% |\n|---|--:|--:|--:|\n");
  for (const Model model : {Model::hard, Model::nodes, Model::limit_surface}) {
    std::vector<double> ratios;
    for (const TriedByModel& tried : all) {
      const double soft = tried[Model::soft].trial.epsilon.lower;
      const double other = tried[model].trial.epsilon.lower;
      if (soft > 0.0 && other > 0.0) ratios.push_back(other / soft);
    }
    std::printf("| %s | %.2f | %.2f | %.2f |\n", std::string(name_of(model)).c_str(),
                quantile(ratios, 0.1), quantile(ratios, 0.5), quantile(ratios, 0.9));
  }
}

void print_torsion(const std::vector<TriedByModel>& all) {
  struct Bin {
    double upper;  // of the torsion of the elastic foundation [m]
    std::vector<double> ratios;
  };
  std::array<Bin, 4> bins{{{2e-3, {}}, {4e-3, {}}, {6e-3, {}}, {1.0, {}}}};
  for (const TriedByModel& tried : all) {
    const auto soft = torsions(tried[Model::soft].trial);
    const auto fem = torsions(tried[Model::limit_surface].trial);
    for (const auto& entry : soft) {
      const double torsion = entry.second;
      const auto found = fem.find(entry.first);
      if (found == fem.end() || torsion <= 0.0) continue;
      const auto bin = std::ranges::find_if(bins, [&](const Bin& b) { return torsion <= b.upper; });
      bin->ratios.push_back(found->second / torsion);
    }
  }
  std::printf(
      "\n| torsion of the elastic foundation | pads | fem over it: 10 %% | median | 90 %% |\n"
      "|---|--:|--:|--:|--:|\n");
  for (const Bin& bin : bins) {
    std::printf("| up to %g mm | %zu | %.2f | %.2f | %.2f |\n", 1e3 * bin.upper, bin.ratios.size(),
                quantile(bin.ratios, 0.1), quantile(bin.ratios, 0.5), quantile(bin.ratios, 0.9));
  }
}

// Both pads of the Franka hand pressed with 70 N each on a plate, which all of their nodes touch,
// and on the edge of a bar.
void print_press() {
  Scene scene;
  scene.object = make_graspable("cube", make_box({0.05, 0.05, 0.05}), Material::plastic);
  scene.hand = find_robot("franka_hand");
  const CompiledScene compiled = compile(std::move(scene));
  const auto link =
      std::ranges::find_if(compiled.links, [](const CompiledLink& l) { return l.pad != nullptr; });
  const double start = processor_seconds();
  const auto pad = link->pad->get({});
  std::printf("\nA pad of %zu nodes is prepared in %.2f s, once.\n\n", pad->nodes_L.size(),
              processor_seconds() - start);
  Vector3 center_L = Vector3::Zero();
  for (const Vector3& p : pad->nodes_L) {
    center_L += p / static_cast<double>(pad->nodes_L.size());
  }
  Pose X_OL(Eigen::Quaterniond::FromTwoVectors(pad->outward_L, Vector3::UnitZ()));
  X_OL.translation() = Vector3(0.0, 0.0, -0.02) - X_OL.linear() * center_L;
  std::printf("| two pads with 70 N each | nodes that bear | ms, median of 101 |\n|---|--:|--:|\n");
  const std::array<std::pair<std::string_view, TriangleMesh>, 2> objects{
      {{"on a plate", make_box({0.1, 0.1, 0.0399})},
       {"on a bar of 10 mm", transformed(make_box({0.01, 0.1, 0.0399}),
                                         Pose(Eigen::AngleAxisd(0.3, Vector3::UnitZ())))}}};
  for (const auto& [name, mesh] : objects) {
    const ProximityMesh object(mesh);
    PadWorkspace workspace;
    PadPatch patch;
    std::vector<double> seconds;
    for (int i = 0; i < 101; ++i) {
      const double before = processor_seconds();
      for (int side = 0; side < 2; ++side) {
        press_pad(object, *pad, X_OL, Vector3::UnitZ(), 70.0, workspace, patch);
      }
      seconds.push_back(processor_seconds() - before);
    }
    std::printf("| %s | %zu | %.2f |\n", std::string(name).c_str(), patch.points.size(),
                1e3 * quantile(seconds, 0.5));
  }
}

std::vector<TriedByModel> try_all(const std::filesystem::path& shared, std::size_t most) {
  constexpr std::string_view kPrefix = "dexycb_franka_";
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(shared / "data/grasps")) {
    if (entry.path().filename().string().starts_with(kPrefix)) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  std::vector<TriedByModel> all;
  for (const std::filesystem::path& file : files) {
    const std::string object = file.stem().string().substr(kPrefix.size());
    Scene scene;
    scene.object = make_graspable(object, load_mesh(shared / "data/ycb" / (object + ".obj")).mesh,
                                  Material::plastic);
    scene.hand = find_robot("franka_hand");
    const CompiledScene compiled = compile(std::move(scene));
    for (const CompiledLink& link : compiled.links) {
      if (link.pad) (void)link.pad->get({});  // its preparation is no part of a trial
    }
    std::vector<Candidate> grasps = test::published_grasps(file, compiled);
    grasps.resize(std::min(grasps.size(), most));
    for (const Candidate& grasp : grasps) {
      TriedByModel tried;
      for (const Model model : kAll<Model>) {
        const double start = processor_seconds();
        tried[model].trial = run_trial(compiled, grasp, options_of(model));
        tried[model].seconds = processor_seconds() - start;
      }
      all.push_back(std::move(tried));
    }
  }
  return all;
}

}  // namespace
}  // namespace prehend

int main(int count, char** arguments) {
  if (count < 2) {
    std::fputs("usage: pad_models SHARED_DIR [GRASPS_AN_OBJECT]\n", stderr);
    return 2;
  }
  try {
    const std::size_t most = count > 2 ? std::strtoul(arguments[2], nullptr, 10) : 20;
    const auto all = prehend::try_all(arguments[1], most);
    prehend::print_held(all);
    prehend::print_epsilon(all);
    prehend::print_torsion(all);
    prehend::print_press();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
