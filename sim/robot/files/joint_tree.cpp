#include "sim/robot/files/joint_tree.h"

#include <cmath>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/range.h"
#include "sim/robot/files/shape_mesh.h"
#include "sim/robot/sound_robot.h"

namespace prehend {
namespace {

[[noreturn]] void fail_at(const JointTree& tree, const std::string& place,
                          const std::string& problem, const std::string& value) {
  throw InputError({.file = tree.file, .field = place, .problem = problem, .value = value});
}

// Links that are reached from `root`.
std::vector<bool> reached_from(const JointTree& tree, int root) {
  const std::vector<std::vector<int>> below = joints_below(tree);
  std::vector<bool> reached(tree.links.size(), false);
  std::vector<int> todo = {root};
  while (!todo.empty()) {
    const int link = todo.back();
    todo.pop_back();
    reached[index(link)] = true;
    for (const int joint : below[index(link)]) todo.push_back(tree.joints[index(joint)].child);
  }
  return reached;
}

// The one that `mimic`, of joint `at`, leads to. A row longer than there are joints is a circle.
Mimic followed(const JointTree& tree, int at) {
  const TreeJoint& own = tree.joints[index(at)];
  Mimic total{.joint = at};
  if (own.mimic) {
    total.across = own.mimic->across;
    total.ahead = own.mimic->ahead;
  }
  for (std::size_t step = 0; tree.joints[index(total.joint)].mimic; ++step) {
    const Mimic& next = *tree.joints[index(total.joint)].mimic;
    if (step > tree.joints.size())
      fail_at(tree, own.place, "mimics itself: it must follow a joint that does not follow it",
              own.name);
    total.offset += total.ratio * next.offset;
    total.ratio *= next.ratio;
    total.joint = next.joint;
  }
  const bool rests = total.ratio == 0.0 && total.across >= 0;
  if (!rests && !kRatioSize.contains(std::abs(total.ratio))) {
    fail_at(tree, own.place, "the size of its multiplier " + kRatioSize.words(), own.name);
  }
  if (!kCoordinate.contains(total.offset)) {
    fail_at(tree, own.place, "its offset " + kCoordinate.words(), own.name);
  }
  return total;
}

}  // namespace

std::vector<int> carriers_of(const JointTree& tree) {
  std::vector<int> carriers(tree.links.size(), -1);
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    carriers[index(tree.joints[j].child)] = static_cast<int>(j);
  }
  return carriers;
}

std::vector<std::vector<int>> joints_below(const JointTree& tree) {
  std::vector<std::vector<int>> below(tree.links.size());
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    below[index(tree.joints[j].parent)].push_back(static_cast<int>(j));
  }
  return below;
}

void scale_lengths(JointTree& tree, double factor) {
  for (TreeLink& link : tree.links) {
    link.mesh = scaled(std::move(link.mesh), Vector3::Constant(factor));
    link.inertial.center_of_mass *= factor;
    link.inertial.inertia *= factor * factor;
  }
  for (TreeJoint& joint : tree.joints) {
    joint.X_LJ.translation() *= factor;
    if (joint.type != TreeJointType::prismatic) continue;
    joint.lower *= factor;
    joint.upper *= factor;
    joint.max_velocity *= factor;
    joint.max_acceleration *= factor;
    joint.spring.rest *= factor;
    if (joint.initial) *joint.initial *= factor;
    if (joint.mimic) joint.mimic->offset *= factor;
  }
}

int root_of(const JointTree& tree) {
  if (tree.links.empty()) throw InputError({.file = tree.file, .problem = "there is no link"});
  std::vector<int> carried_by(tree.links.size(), -1);
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    const TreeJoint& joint = tree.joints[j];
    int& carrier = carried_by[index(joint.child)];
    if (carrier >= 0) {
      fail_at(tree, joint.place,
              "link " + tree.links[index(joint.child)].name + " hangs on joint " +
                  tree.joints[index(carrier)].name + " already",
              joint.name);
    }
    carrier = static_cast<int>(j);
  }
  int root = -1;
  for (std::size_t l = 0; l < tree.links.size(); ++l) {
    if (carried_by[l] >= 0) continue;
    if (root >= 0) {
      fail_at(
          tree, tree.links[l].place,
          "hangs on no joint, nor does " + tree.links[index(root)].name + ": a robot has one root",
          tree.links[l].name);
    }
    root = static_cast<int>(l);
  }
  const auto in_circle = [&](std::size_t l) {
    fail_at(tree, tree.links[l].place,
            "its joints form a circle: each link must hang on one joint, but for one",
            tree.links[l].name);
  };
  if (root < 0) in_circle(0);
  const std::vector<bool> reached = reached_from(tree, root);
  for (std::size_t l = 0; l < reached.size(); ++l) {
    if (!reached[l]) in_circle(l);
  }
  return root;
}

std::vector<Mimic> resolved_mimics(const JointTree& tree) {
  std::vector<Mimic> resolved;
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    const TreeJoint& joint = tree.joints[j];
    const Mimic mimic = followed(tree, static_cast<int>(j));
    const TreeJoint& leader = tree.joints[index(mimic.joint)];
    if (leader.type != joint.type) {
      fail_at(tree, joint.place,
              "mimics " + leader.name +
                  ", a joint of another type: one drive moves joints of one "
                  "type only",
              joint.name);
    }
    resolved.push_back(mimic);
  }
  return resolved;
}

}  // namespace prehend
