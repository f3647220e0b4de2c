// What the simulation says of grasps that people made with a real Barrett hand (Goins et al.,
// OSUrobotics/NearContactStudy; arXiv 1607.03366): how far the fingers close, which of them break
// away, and which links touch.
//
//   osu FOLDER [--give-way MM]
//
// FOLDER holds grasps.json and the meshes. The hand is put where it was, with its spread, gives way
// to overlaps of up to 20 mm (the poses are off by 10 to 20 mm), and closes: on an object that
// stands still, and on one that is free. Joints are compared of fingers that touch in both.
// Breakaway: the distal joint is more than 0.02 rad beyond a third of the proximal one.
// What errors of the poses do by themselves is told by closing at poses moved by 10 to 20 mm,
// compared in the same way with our own closing where the hand was; and what they can't explain, by
// how far all fingers must be opened from the joints as measured until the hand fits the object:
// some shift of it by at most 30 mm lets nothing overlap.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "benchmarks/support/percentile.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/parallel/parallel.h"
#include "sim/base/random.h"
#include "sim/motion/dynamic_grasp/scene_world.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/make_scene.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/trial/close_dynamic.h"
#include "sim/trial/resolve_overlap.h"
#include "sim/trial/run_trial.h"

namespace prehend::bench {
namespace {

constexpr double kBreaks = 0.02;       // rad
constexpr double kPalmAhead = 0.0764;  // of our base, along z of the frame of the data [m]
constexpr std::array kPoseError = {0.01, 0.02};  // of the data [m]
constexpr double kLongestShift = 0.03;           // m
constexpr int kMostOpened = 40;                  // degrees
constexpr std::array kFingers = {"finger_1", "finger_2", "thumb"};

using FingerJoints = std::array<std::array<double, 2>, 3>;  // proximal, distal [rad]

struct RealGrasp {
  std::string object;
  Candidate candidate;
  FingerJoints joints{};
  std::set<std::string> links;  // that touch, by our names
};

// Our base lies on the palm's face, half a turn about z from the frame of the data.
Pose hand_of(const nlohmann::json& matrix) {
  Pose X_OD = Pose::Identity();
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) X_OD.linear()(i, j) = matrix[index(i)][index(j)];
    X_OD.translation()[i] = matrix[index(i)][3];
  }
  const Eigen::Quaterniond rotation(X_OD.linear());
  X_OD.linear() = rotation.normalized().toRotationMatrix();
  Matrix3 turned = Matrix3::Identity();
  turned(0, 0) = -1.0;
  turned(1, 1) = -1.0;
  return X_OD * pose_from(turned, {0.0, 0.0, kPalmAhead});
}

std::string our_link(const std::string& link) {
  if (!link.starts_with("finger_")) return link;
  const std::string number = link.substr(7, 1);
  if (link.ends_with("med")) return "proximal_" + number;
  if (link.ends_with("dist")) return "distal_" + number;
  return "knuckle_" + number;
}

RealGrasp read_grasp(const nlohmann::json& row, const Hand& hand) {
  RealGrasp grasp;
  grasp.object = row["mesh"];
  grasp.candidate.X_OH = hand_of(row["X_object_hand"]);
  grasp.candidate.approach_O = grasp.candidate.X_OH.linear() * hand.approach;
  const double spread =
      std::clamp(0.5 * (double(row["spread"][0]) + double(row["spread"][1])), 0.0, 3.14159);
  grasp.candidate.dofs = {spread, 0.0, 0.0, 0.0};
  for (std::size_t f = 0; f < 3; ++f) {
    const nlohmann::json& finger = row["f" + std::to_string(f + 1)];
    grasp.joints.at(f) = {double(finger[0]), double(finger[1])};
  }
  for (const std::string link : row["contact_links"]) {
    if (link != "contact") grasp.links.insert(our_link(link));
  }
  return grasp;
}

RealGrasp moved(RealGrasp grasp, std::uint64_t seed) {
  Random random(seed);
  grasp.candidate.X_OH.translation() += random.vector(kPoseError[0], kPoseError[1]);
  return grasp;
}

// How the hand ended, in the words of the data.
struct Ended {
  bool closed = false;
  FingerJoints joints{};
  std::set<std::string> links;
};

Ended ended(const Robot& hand, const Trial& trial) {
  Ended ended;
  ended.closed = !trial.contacts.empty();
  for (std::size_t j = 0; j < hand.joints.size(); ++j) {
    for (std::size_t f = 0; f < kFingers.size(); ++f) {
      const std::string finger = kFingers.at(f);
      if (hand.joints[j].name == finger + "_proximal") ended.joints.at(f)[0] = trial.joints[j];
      if (hand.joints[j].name == finger + "_distal") ended.joints.at(f)[1] = trial.joints[j];
    }
  }
  for (const GraspContact& contact : trial.contacts) {
    ended.links.insert(hand.links[index(contact.link)].name);
  }
  return ended;
}

// By how many degrees the proximal joints must at least be opened until a shift of at most
// kLongestShift frees the hand.
int opening_that_fits(const CompiledScene& scene, const Candidate& candidate,
                      const FingerJoints& fingers) {
  const Robot& hand = scene.scene.hand;
  std::vector<double> joints = joint_values(hand, candidate.dofs);
  GiveWayWorkspace workspace;
  const OverlapOptions options{.object = kLongestShift, .obstacle = 0.0};
  for (int opened = 0; opened < kMostOpened; ++opened) {
    for (std::size_t j = 0; j < joints.size(); ++j) {
      for (std::size_t f = 0; f < kFingers.size(); ++f) {
        const std::string finger = kFingers.at(f);
        const double proximal = fingers.at(f)[0] - opened * std::numbers::pi / 180.0;
        if (hand.joints[j].name == finger + "_proximal") joints[j] = std::max(proximal, 0.0);
        if (hand.joints[j].name == finger + "_distal") joints[j] = fingers.at(f)[1];
      }
    }
    if (resolve_overlap(scene, candidate.X_OH, joints, options, workspace)) return opened;
  }
  return kMostOpened;
}

bool touches(const std::set<std::string>& links, std::size_t finger) {
  const std::string number = std::to_string(finger + 1);
  return links.contains("proximal_" + number) || links.contains("distal_" + number);
}

bool breaks(const std::array<double, 2>& joints) { return joints[1] > joints[0] / 3.0 + kBreaks; }

struct Figures {
  int grasps = 0;
  int closed = 0;
  std::array<std::vector<double>, 2> errors;  // degrees, of touching fingers
  std::array<std::vector<double>, 2> early;   // the same with their signs: real less ours
  int broke = 0;
  int broke_predicted = 0;
  int held = 0;
  int held_predicted = 0;
  int both = 0;
  int ours = 0;
  int theirs = 0;
};

void add(const RealGrasp& real, const Ended& ended, Figures& figures) {
  ++figures.grasps;
  if (!ended.closed) return;
  ++figures.closed;
  for (std::size_t f = 0; f < 3; ++f) {
    if (!touches(real.links, f) || !touches(ended.links, f)) continue;
    for (std::size_t k = 0; k < 2; ++k) {
      const double error =
          (real.joints.at(f).at(k) - ended.joints.at(f).at(k)) * 180.0 / std::numbers::pi;
      figures.errors.at(k).push_back(std::abs(error));
      figures.early.at(k).push_back(error);
    }
    const bool real_breaks = breaks(real.joints.at(f));
    const bool predicted = breaks(ended.joints.at(f));
    (real_breaks ? figures.broke : figures.held) += 1;
    (real_breaks ? figures.broke_predicted : figures.held_predicted) += predicted ? 1 : 0;
  }
  for (const std::string& link : ended.links) figures.both += real.links.contains(link) ? 1 : 0;
  figures.ours += static_cast<int>(ended.links.size());
  figures.theirs += static_cast<int>(real.links.size());
}

double median(std::vector<double> values) {
  return values.empty() ? 0.0 : benchmark::percentile(std::move(values), 0.5);
}

double share(int part, int whole) { return whole > 0 ? 100.0 * part / whole : 0.0; }

void print(const char* name, const Figures& figures) {
  const double precision = figures.ours > 0 ? double(figures.both) / figures.ours : 0.0;
  const double recall = figures.theirs > 0 ? double(figures.both) / figures.theirs : 0.0;
  std::printf("%s: %d of %d closed; %zu fingers\n", name, figures.closed, figures.grasps,
              figures.errors[0].size());
  std::printf("  median error: proximal %.1f degrees, distal %.1f\n", median(figures.errors[0]),
              median(figures.errors[1]));
  std::printf("  real less ours: proximal %+.1f degrees, distal %+.1f\n", median(figures.early[0]),
              median(figures.early[1]));
  std::printf("  breakaway: %.0f %% of %d that broke away predicted, %.0f %% of %d others\n",
              share(figures.broke_predicted, figures.broke), figures.broke,
              share(figures.held_predicted, figures.held), figures.held);
  std::printf("  links: precision %.2f, recall %.2f, F1 %.2f\n", precision, recall,
              precision + recall > 0.0 ? 2.0 * precision * recall / (precision + recall) : 0.0);
}

// As if people had seen what we say.
RealGrasp as_real(RealGrasp grasp, const Ended& ended) {
  grasp.joints = ended.joints;
  grasp.links = ended.links;
  return grasp;
}

// On an object that stands still, and on one that is free.
std::array<Ended, 2> close(const CompiledScene& scene,
                           const std::shared_ptr<const RobotModel>& hand,
                           const Candidate& candidate, const TrialOptions& options) {
  std::array<Ended, 2> ends;
  const Trial trial = run_trial(scene, candidate, options);
  ends[0] = ended(scene.scene.hand, trial);
  if (!ends[0].closed) return ends;
  ends[1] = ended(scene.scene.hand, closed_freely(scene, hand, candidate, trial, options));
  return ends;
}

void run(const std::filesystem::path& folder, double give_way) {
  std::ifstream stream(folder / "grasps.json");
  const nlohmann::json file = nlohmann::json::parse(stream);
  TrialOptions options;
  options.resolve_overlap.object = give_way;
  std::array<Figures, 2> figures;
  std::array<Figures, 2> figures_moved;
  std::vector<double> real_opened;  // degrees
  std::vector<double> our_opened;
  std::set<std::string> objects;
  for (const nlohmann::json& row : file["grasps"]) objects.insert(row["mesh"]);
  for (const std::string& object : objects) {
    TriangleMesh mesh = load_mesh(folder / object).mesh;
    double scale = 1.0;
    for (const nlohmann::json& row : file["grasps"]) {
      if (row["mesh"] == object) scale = row["mesh_scale_to_m"];
    }
    for (Vector3& vertex : mesh.vertices) vertex *= scale;
    const CompiledScene scene =
        compile(make_scene(make_graspable(object, mesh, Material::plastic, 0.3), "barrett"));
    std::vector<RealGrasp> grasps;
    for (const nlohmann::json& row : file["grasps"]) {
      if (row["mesh"] == object) grasps.push_back(read_grasp(row, *scene.scene.hand.hand));
    }
    const std::shared_ptr<const RobotModel> hand = hand_model(scene);
    std::vector<std::array<Ended, 2>> ends(grasps.size());
    std::vector<std::array<Ended, 2>> ends_moved(grasps.size());
    std::vector<std::array<int, 2>> opened(grasps.size(), {-1, -1});
    for_each_in_parallel(grasps.size(), 0, [&](std::size_t i) {
      ends[i] = close(scene, hand, grasps[i].candidate, options);
      const Candidate elsewhere = moved(grasps[i], i).candidate;
      ends_moved[i] = close(scene, hand, elsewhere, options);
      if (!ends[i][0].closed) return;
      opened[i][0] = opening_that_fits(scene, grasps[i].candidate, grasps[i].joints);
      opened[i][1] = opening_that_fits(scene, elsewhere, ends[i][0].joints);
    });
    for (std::size_t i = 0; i < grasps.size(); ++i) {
      if (opened[i][0] >= 0) real_opened.push_back(opened[i][0]);
      if (opened[i][1] >= 0) our_opened.push_back(opened[i][1]);
      for (std::size_t k = 0; k < 2; ++k) {
        add(grasps[i], ends[i].at(k), figures.at(k));
        if (!ends[i].at(k).closed) continue;
        add(as_real(grasps[i], ends[i].at(k)), ends_moved[i].at(k), figures_moved.at(k));
      }
    }
  }
  print("object stands still", figures[0]);
  print("object is free", figures[1]);
  print("object stands still, moved by 10 to 20 mm, beside our own", figures_moved[0]);
  print("object is free, moved by 10 to 20 mm, beside our own", figures_moved[1]);
  std::printf(
      "the hand fits, in the median, when opened from the real joints by %.0f degrees, from "
      "our own and moved by %.0f\n",
      median(real_opened), median(our_opened));
}

}  // namespace
}  // namespace prehend::bench

int main(int argc, char** argv) {
  if (argc != 2 && !(argc == 4 && std::string(argv[2]) == "--give-way")) {
    std::fprintf(stderr, "usage: osu FOLDER [--give-way MM]\n");
    return 2;
  }
  try {
    prehend::bench::run(argv[1], argc == 4 ? 1e-3 * std::stod(argv[3]) : 0.02);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "osu: %s\n", error.what());
    return 2;
  }
  return 0;
}
