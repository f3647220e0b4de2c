// Scenes one after the other as an animated 3-D file: bodies and robots that move, appear and
// disappear.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "planner/show/picture/animated_glb.h"
#include "sim/scene/scene.h"

namespace prehend {

// A scene at one moment, and names of what its bodies look like: bodies of equal names have equal
// meshes, robots of equal names also equal joints.
struct SceneMoment {
  const Scene& scene;                   // without an object: with an empty mesh there
  std::string object;                   // name of its surface
  std::vector<std::string> obstacles;   // one for each
  std::string robots;                   // of the hand and of what carries it
  Pose X_WH = Pose::Identity();         // the hand's base
  std::vector<double> joints;           // of the hand [rad or m]
  std::vector<double> arm_joints = {};  // of the assembled platform; empty: where it starts
};

// Nodes and their poses at all moments so far. The object and each obstacle are a node with its
// name. A hand is a node with its name, where its base is; below it stands a node a joint, which
// turns or slides as the joint does, and at these and at the base the links, with their meshes. The
// platform that carries the hand (Scene::carrier) is the same again, without the hand.
// A body that a moment does not have, or has with another name or surface, is hidden there.
class SceneFilm {
 public:
  // Meshes are copied: nothing of the moment has to outlive the call.
  void add(const SceneMoment& moment);

  const std::vector<AnimatedNode>& nodes() const { return nodes_; }
  std::size_t moment_count() const { return moment_count_; }
  // The nodes as a file, with `seconds` (> 0) from one moment to the next, the first at 0. There
  // must be a moment.
  std::string glb(const std::string& name, double seconds) const;

 private:
  struct ShownRobot;

  // The node of this id, made where there is none yet, with this pose from now on.
  int place(const std::string& id, const AnimatedNode& node, const Pose& X_PN);
  void place_body(const std::string& kind, const std::string& name, const std::string& surface,
                  const TriangleMesh& mesh, const Color& color, const Pose& X_WB);
  void place_robot(const ShownRobot& shown);
  void place_arm(const SceneMoment& moment);

  std::vector<AnimatedNode> nodes_;
  std::vector<bool> is_fixed_;          // by node: it has one pose for all moments
  std::map<std::string, int> numbers_;  // of nodes that move, by id
  std::size_t moment_count_ = 0;
};

}  // namespace prehend
