// Scenes built in code and a small hand, for tests of trials; and their gaps and collisions by
// brute force, as reference.
#pragma once

#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "sim/robot/files/robot_file.h"
#include "sim/scene/compiled_scene.h"
#include "sim/shape/basic_shapes.h"
#include "sim/trial/trial.h"
#include "sim/trial/trial_options.h"
#include "tests/support/brute_force.h"

namespace prehend::test {

inline const TrialOptions kDefaultTrial;

// A scene of a free hand and a plastic object at the world's origin.
inline Scene scene_with(Robot hand, TriangleMesh object, std::vector<StaticBody> obstacles = {}) {
  Scene scene;
  scene.name = "test";
  scene.object = make_graspable("object", std::move(object), Material::plastic);
  scene.hand = std::move(hand);
  scene.obstacles = std::move(obstacles);
  return scene;
}

// The same scene, ready for trials.
inline CompiledScene compiled(Robot hand, TriangleMesh object,
                              std::vector<StaticBody> obstacles = {}) {
  return compile(scene_with(std::move(hand), std::move(object), std::move(obstacles)));
}

// An obstacle whose frame is at `p_W` in the world, not rotated.
inline StaticBody obstacle(TriangleMesh mesh, const Vector3& p_W) {
  StaticBody body;
  body.name = "obstacle";
  body.mesh = std::move(mesh);
  body.X_WB = translation(p_W);
  return body;
}

// A box of `size` [m] around `center` [m].
inline TriangleMesh block(const Vector3& size, const Vector3& center) {
  return transformed(make_box(size), translation(center));
}

// A hand with one finger: two bars of 50 mm in sequence along x, each turning about z from the x
// axis towards +y, and a palm behind them. One degree of freedom drives both joints, the distal one
// `distal_ratio` times as far; `coupling` says what happens when one of them is stopped.
inline Robot finger_hand(Coupling coupling, double distal_ratio = 0.5) {
  Robot robot;
  robot.name = "finger";
  robot.chains = {{.name = "finger", .first_joint = 0, .joint_count = 2}};
  const double half_turn = std::numbers::pi;
  const Pose tip = translation({0.05, 0.0, 0.0});
  robot.joints = {
      {.name = "proximal", .X_JA = tip, .lower = 0.0, .upper = half_turn},
      {.name = "distal", .X_JA = tip, .lower = 0.0, .upper = half_turn, .ratio = distal_ratio}};
  robot.joints[1].parent = 0;
  robot.dofs = {{.name = "bend", .upper = 1.5, .closing_velocity = 1.0, .coupling = coupling}};
  const TriangleMesh bar = block({0.044, 0.01, 0.02}, {-0.025, 0.0, 0.0});
  robot.links = {{"palm", "plastic", -1, block({0.03, 0.03, 0.03}, {-0.03, 0.0, 0.0})},
                 {"proximal", "plastic", 0, bar},
                 {"distal", "plastic", 1, bar}};
  robot.hand = Hand{.approach = Vector3::UnitX(),
                    .closing = Vector3::UnitY(),
                    .preshapes = {{.name = "straight", .dofs = {0.0}, .max_width = 0.05}}};
  return robot;
}

// X_OL of every link, with the hand's base at `X_OH` and these joint values.
inline std::vector<Pose> link_poses_in_object(const CompiledScene& scene, const Pose& X_OH,
                                              const std::vector<double>& joints) {
  std::vector<Pose> poses;
  link_poses(scene.scene.hand, joints, poses);
  for (Pose& pose : poses) pose = X_OH * pose;
  return poses;
}

// Each link's triangles in the object's frame.
inline std::vector<std::vector<Corners>> link_soups(const CompiledScene& scene, const Pose& X_OH,
                                                    const std::vector<double>& joints) {
  const std::vector<Pose> poses = link_poses_in_object(scene, X_OH, joints);
  std::vector<std::vector<Corners>> soups;
  for (std::size_t l = 0; l < poses.size(); ++l) {
    soups.push_back(soup(scene.links[l].mesh.mesh(), poses[l]));
  }
  return soups;
}

// The gap of each link to the object [m], 0 where they intersect; by brute force.
inline std::vector<double> object_gaps(const CompiledScene& scene, const Pose& X_OH,
                                       const std::vector<double>& joints) {
  const std::vector<Corners> object = soup(scene.object().mesh.mesh());
  std::vector<double> gaps;
  for (const auto& link : link_soups(scene, X_OH, joints)) {
    gaps.push_back(surface_gap(object, link));
  }
  return gaps;
}

// The first collision found, as "LINK meets BODY" or "LINK is inside BODY"; "" without one. Each of
// `links` (triangles in the object's frame, which is the world's here) is checked against the
// object and all obstacles, and each pair that the scene lists for self-collision.
inline std::string what_collides(const std::vector<std::vector<Corners>>& links,
                                 const CompiledScene& scene) {
  const std::vector<Corners> object = soup(scene.object().mesh.mesh());
  std::vector<std::pair<std::string, std::vector<Corners>>> others = {{"object", object}};
  for (const PlacedBody& o : scene.obstacles()) {
    others.emplace_back(o.name, soup(o.mesh.mesh(), o.X_RB));
  }
  for (std::size_t l = 0; l < links.size(); ++l) {
    for (const auto& [name, other] : others) {
      if (surfaces_meet(links[l], other)) return scene.links[l].name + " meets " + name;
      if (one_holds_the_other(links[l], other)) return scene.links[l].name + " is inside " + name;
    }
  }
  for (const LinkPair& pair : scene.self_pairs) {
    const auto a = static_cast<std::size_t>(pair.a);
    const auto b = static_cast<std::size_t>(pair.b);
    if (surfaces_meet(links[a], links[b])) {
      return scene.links[a].name + " meets " + scene.links[b].name;
    }
  }
  return "";
}

// The same for the hand's base at `X_OH` and these joint values.
inline std::string collision(const CompiledScene& scene, const Pose& X_OH,
                             const std::vector<double>& joints) {
  return what_collides(link_soups(scene, X_OH, joints), scene);
}

}  // namespace prehend::test
