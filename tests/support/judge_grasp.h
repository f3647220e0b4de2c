// What is promised of a grasp, looked at by other means than those that found it: postures by
// second_opinion.h, contacts by all triangles (brute_force.h), epsilon by exact arithmetic
// (judge_epsilon.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/trial/grasp_contacts.h"
#include "sim/trial/trial.h"
#include "sim/trial/trial_options.h"
#include "tests/support/judge_epsilon.h"
#include "tests/support/second_opinion.h"

namespace prehend::test {

// Something that does not hold: its kind in a word, and what it is.
struct Fault {
  std::string kind;
  std::string words;
};

// What the judge is told by whoever made the scene, instead of asking the library.
struct KnownScene {
  Scene scene;
  TrialOptions options;
  std::map<std::string, double> friction;  // of the object with each material of the hand
  // The object's mesh bounds a solid, so that it has an inside.
  bool solid = true;
  std::size_t most_facets = 20000;  // of the exact hull
};

struct GraspJudgement {
  std::vector<Fault> faults;
  int contacts = 0;
  double gap = std::numeric_limits<double>::infinity();  // smallest of hand and object [m]
  double penetration = 0.0;                              // [m]
  bool epsilon_compared = false;
  double epsilon_difference = 0.0;  // relative
};

// The robots that carry the hand of the scene; a hand that flies is its own carrier, and stands
// where the trial says.
inline Carrier carrier_of(const Scene& scene, const Pose& X_OH) {
  if (scene.carrier) return *scene.carrier;
  Carrier carrier;
  carrier.platform.robots.push_back({.name = "hand", .robot = scene.hand});
  carrier.X_WB = scene.object.X_WO * X_OH;
  return carrier;
}

class GraspJudge {
 public:
  GraspJudge(const KnownScene& known, const Surroundings& around, const Trial& trial)
      : known_(known),
        around_(around),
        trial_(trial),
        carrier_(carrier_of(known.scene, trial.X_OH)),
        machine_(carrier_) {}

  GraspJudgement judge() {
    if (!check_joints()) return judgement_;
    frames_ = machine_.frames(posture_);
    const Matrix4 wanted = (known_.scene.object.X_WO * trial_.X_OH).matrix();
    if (!((machine_.hand_base(frames_) - wanted).cwiseAbs().maxCoeff() <= 1e-6)) {
      fault("pose", "the hand is not at X_OH");
    }
    place_links();
    check_collisions();
    for (std::size_t i = 0; i < trial_.contacts.size(); ++i) check_contact(i);
    check_epsilon();
    return judgement_;
  }

 private:
  static constexpr double kSlack = 1e-9;  // rounding of limits [rad or m] and of poses [m]

  void fault(const std::string& kind, const std::string& words) {
    judgement_.faults.push_back({kind, words});
  }

  const Robot& hand() const { return known_.scene.hand; }

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  void set_joint(const std::string& robot, const Joint& joint, double value) {
    posture_[robot + "/" + joint.name] = value;
    if (!(value >= joint.lower - kSlack && value <= joint.upper + kSlack)) {
      fault("limits", robot + "/" + joint.name + " at " + std::to_string(value));
    }
  }

  // Every joint within its limits, and the posture; false where values are missing.
  bool check_joints() {
    if (trial_.joints.size() != hand().joints.size() || trial_.dofs.size() != hand().dofs.size()) {
      fault("limits", "values of joints are missing");
      return false;
    }
    std::size_t first_dof = 0;
    for (std::size_t r = 0; r < carrier_.platform.robots.size(); ++r) {
      const MountedRobot& mounted = carrier_.platform.robots[r];
      const bool is_hand = static_cast<int>(r) == carrier_.hand;
      for (std::size_t j = 0; j < mounted.robot.joints.size(); ++j) {
        const Joint& joint = mounted.robot.joints[j];
        const std::size_t dof = first_dof + at(joint.dof);
        if (!is_hand && dof >= trial_.arm_dofs.size()) {
          fault("limits", "the posture of the arm is missing");
          return false;
        }
        set_joint(mounted.name, joint,
                  is_hand ? trial_.joints[j] : joint.ratio * trial_.arm_dofs[dof] + joint.offset);
      }
      first_dof += mounted.robot.dofs.size();
    }
    for (std::size_t d = 0; d < trial_.dofs.size(); ++d) {
      const DegreeOfFreedom& dof = hand().dofs[d];
      if (!(trial_.dofs[d] >= dof.lower - kSlack && trial_.dofs[d] <= dof.upper + kSlack)) {
        fault("limits", dof.name + " at " + std::to_string(trial_.dofs[d]));
      }
    }
    return true;
  }

  // The links of the hand in the world, and the object.
  void place_links() {
    const std::string& name = carrier_.platform.robots[at(carrier_.hand)].name;
    const Pose X_WH = known_.scene.object.X_WO * trial_.X_OH;
    for (const Link& link : hand().links) {
      const Pose X =
          link.joint < 0 ? X_WH : Pose(frames_.at(name + "/" + hand().joints[at(link.joint)].name));
      links_.push_back(soup(link.mesh, X));
    }
    object_ = around_.things.front().triangles;
  }

  // How deep points of the triangles of `inner`, kParts to an edge, are inside `outer` [m].
  static double depth(const std::vector<Corners>& inner, const std::vector<Corners>& outer) {
    constexpr int kParts = 4;
    const Bounds box = box_of(outer);
    double deepest = 0.0;
    for (const Corners& t : inner) {
      if (!boxes_meet(bounds_of(t), box)) continue;
      for (int i = 0; i <= kParts; ++i) {
        for (int j = 0; i + j <= kParts; ++j) {
          const Vector3 p = t[0] + (static_cast<double>(i) / kParts) * (t[1] - t[0]) +
                            (static_cast<double>(j) / kParts) * (t[2] - t[0]);
          if (winding(p, outer) > 0) deepest = std::max(deepest, point_to_surface(p, outer));
        }
      }
    }
    return deepest;
  }

  void check_collisions() {
    const std::string met = what_meets(machine_, around_, frames_);
    if (!met.empty()) {
      for (const auto& link : links_) {
        for (const Surroundings::Thing& thing : around_.things) {
          judgement_.penetration = std::max(
              {judgement_.penetration, depth(link, thing.triangles), depth(thing.triangles, link)});
        }
      }
      fault("penetration", met + ", " + std::to_string(1e6 * judgement_.penetration) + " um deep");
      return;
    }
    // Surfaces that do not meet: one may still hold the other.
    for (std::size_t l = 0; l < links_.size(); ++l) {
      for (std::size_t t = 0; t < around_.things.size(); ++t) {
        if (t == 0 && !known_.solid) continue;
        const Surroundings::Thing& thing = around_.things[t];
        if (winding(links_[l].front().front(), thing.triangles) > 0 ||
            winding(thing.triangles.front().front(), links_[l]) > 0) {
          fault("penetration", hand().links[l].name + " and " + thing.name + " hold one another");
        }
      }
    }
  }

  void check_contact(std::size_t i) {
    const GraspContact& contact = trial_.contacts[i];
    ++judgement_.contacts;
    const std::string name = "contact " + std::to_string(i);
    const std::size_t link = index(contact.link);
    if (link >= links_.size()) return fault("contact", name + " is of no link");
    const Vector3 p = known_.scene.object.X_WO * contact.point.position;
    const Vector3 normal = known_.scene.object.X_WO.linear() * contact.point.normal;
    const bool soft = contact.point.model == ContactModel::soft_finger;
    const double touching = known_.options.contact.threshold + kSlack;
    const double from_object = point_to_surface(p, object_);
    const double from_link = point_to_surface(p, links_[link]);
    const double depth = known_.scene.compliant_depths.of(Material::rubber) + kSlack;
    if (!(from_object <= (soft ? kSlack + 1e-7 : touching))) {
      fault("contact", name + " is " + std::to_string(1e6 * from_object) + " um off the object");
    }
    if (!(from_link <= (soft ? std::max(depth, touching) : touching))) {
      fault("contact", name + " is " + std::to_string(1e6 * from_link) + " um off its link");
    }
    if (!(contact.gap >= 0.0 && contact.gap <= (soft ? depth : touching))) {
      fault("contact", name + " has a gap of " + std::to_string(1e6 * contact.gap) + " um");
    }
    judgement_.gap = std::min(judgement_.gap, contact.gap);
    if (!(std::abs(normal.norm() - 1.0) <= 1e-9)) fault("contact", name + ": normal not unit");
    if (!(contact.point.torsion >= 0.0)) fault("contact", name + ": torsion");
    // On the link's side of the surface is free space.
    if (known_.solid && !soft && winding(p - 1e-5 * normal, object_) != 0) {
      fault("contact", name + ": the normal points out of the object");
    }
    check_friction(name, hand().links[link].material, contact.point);
  }

  void check_friction(const std::string& name, const std::string& material, const Contact& point) {
    const double told = known_.friction.at(material);
    if (point.friction != told) {
      fault("friction",
            name + " has " + std::to_string(point.friction) + ", not " + std::to_string(told));
    }
    const bool rubber = material == "rubber" || known_.scene.object.material == Material::rubber;
    const bool may_be_soft = rubber && known_.options.contacts != ContactKind::hard;
    if (point.model == ContactModel::frictionless ||
        (point.model == ContactModel::soft_finger && !may_be_soft)) {
      fault("friction", name + " is " + std::string(name_of(point.model)));
    }
  }

  void check_epsilon() {
    if (trial_.outcome == Outcome::stable && !trial_.epsilon.force_closure()) {
      fault("epsilon", "stable without force closure");
    }
    const exact::Columns wrenches = judged_wrenches(
        contacts_of(trial_.contacts), torque_frame(known_.scene.object), known_.options.cone_edges);
    const EpsilonVerdict verdict = judge_epsilon(trial_.epsilon, wrenches, known_.most_facets);
    if (!verdict.fault.empty()) fault("epsilon", verdict.fault);
    judgement_.epsilon_compared = true;
    judgement_.epsilon_difference = verdict.difference.value_or(0.0);
  }

  const KnownScene& known_;
  const Surroundings& around_;
  const Trial& trial_;
  Carrier carrier_;
  Machine machine_;
  Posture posture_;
  Frames frames_;
  std::vector<std::vector<Corners>> links_;  // world
  std::vector<Corners> object_;              // world
  GraspJudgement judgement_;
};

}  // namespace prehend::test
