#include "sim/trial/trial.h"

#include <algorithm>

#include "sim/contact/contact_region.h"
#include "sim/contact/soft_patch.h"
#include "sim/trial/approach.h"
#include "sim/trial/close_hand.h"
#include "sim/trial/self_centering.h"
#include "sim/trial/swallow.h"

namespace prehend {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// The link that overlaps the object or an obstacle where the hand stands, -1 for none.
int colliding_link(const CompiledScene& scene, const Pose& X_OH, const std::vector<double>& joints,
                   int& obstacle) {
  std::vector<Pose> X_HL;
  link_poses(scene.scene.hand, joints, X_HL);
  for (std::size_t l = 0; l < scene.links.size(); ++l) {
    const CompiledLink& link = scene.links[l];
    const Pose X_OL = X_OH * X_HL[l];
    const auto collides = [&](const ProximityMesh& body, const Pose& X_BL) {
      return surfaces_cross(body, link.mesh, X_BL) || is_swallowed(scene, link, obstacle, X_BL);
    };
    obstacle = -1;
    if (collides(scene.object, X_OL)) return static_cast<int>(l);
    for (const CompiledObstacle& other : scene.obstacles) {
      ++obstacle;
      if (collides(other.mesh, other.X_OB.inverse() * X_OL)) return static_cast<int>(l);
    }
  }
  obstacle = -1;
  return -1;
}

class TrialRun {
 public:
  TrialRun(const CompiledScene& scene, const Candidate& candidate, const TrialOptions& options)
      : scene_(scene),
        options_(options),
        motion_{candidate.X_OH, candidate.approach_O, candidate.approach_distance} {
    const Robot& hand = scene.scene.hand;
    if (candidate.preshape >= 0) {
      start_.dofs = hand.hand->preshapes[index(candidate.preshape)].dofs;
      start_.self_clearance = scene.preshape_gaps[index(candidate.preshape)];
    } else {
      start_.dofs = candidate.dofs;
      start_.joints = candidate.joints;
    }
    start_joints_ = start_.joints.empty() ? joint_values(hand, start_.dofs) : start_.joints;
  }

  Trial run() {
    Trial trial;
    const ApproachResult reached = approach(scene_, start_joints_, motion_, options_);
    trial.X_OH = motion_.at(reached.travel);
    trial.travel = reached.travel;
    trial.dofs = start_.dofs;
    trial.joints = start_joints_;
    if (reached.end == ApproachEnd::starts_in_collision ||
        reached.end == ApproachEnd::touched_obstacle) {
      trial.outcome = reached.end == ApproachEnd::touched_obstacle ? Outcome::approach_blocked
                                                                   : Outcome::hand_blocked;
      trial.link = reached.link;
      trial.obstacle = reached.obstacle;
      return trial;
    }
    close_at(reached.travel, reached.object_clearance, trial);
    for (int back = 1; back <= options_.back_off_tries && trial.outcome != Outcome::stable;
         ++back) {
      const double retreat = back * options_.back_off_step;
      if (retreat > reached.travel) break;
      // Backing off changes every gap by at most the retreat.
      std::vector<double> clearance = reached.object_clearance;
      for (double& c : clearance) c = std::max(0.0, c - retreat);
      Trial again = trial;
      close_at(reached.travel - retreat, clearance, again);
      again.back_offs = back;
      if (again.outcome == Outcome::stable) trial = again;
    }
    return trial;
  }

 private:
  void close_at(double travel, const std::vector<double>& clearance, Trial& trial) {
    trial.link = trial.obstacle = -1;
    start_.X_OH = motion_.at(travel);
    start_.object_clearance = clearance;
    ClosedHand closed = close_hand(scene_, start_, options_);
    trial.X_OH = start_.X_OH;
    trial.travel = travel;
    if (center_hand(scene_, trial.X_OH, closed)) {
      trial.link = colliding_link(scene_, trial.X_OH, closed.joints, trial.obstacle);
    }
    trial.dofs = closed.dofs;
    trial.joints = closed.joints;
    trial.epsilon = {};
    trial.contacts.clear();
    if (trial.link >= 0) {
      trial.outcome = Outcome::hand_blocked;
      return;
    }
    trial.contacts = grasp_contacts(scene_, trial.X_OH, trial.joints, options_);
    score(trial);
  }

  void score(Trial& trial) const {
    if (trial.contacts.empty()) {
      trial.outcome = Outcome::no_contact;
      return;
    }
    trial.epsilon = epsilon_l1(
        contact_wrenches(contacts_of(trial.contacts), scene_.wrench_frame, options_.cone_edges));
    trial.outcome = trial.epsilon.lower > 0.0 ? Outcome::stable : Outcome::not_force_closure;
  }

  const CompiledScene& scene_;
  const TrialOptions& options_;
  ApproachMotion motion_;
  ClosingStart start_;
  std::vector<double> start_joints_;
};

}  // namespace

Trial run_trial(const CompiledScene& scene, const Candidate& candidate,
                const TrialOptions& options) {
  return TrialRun(scene, candidate, options).run();
}

std::vector<GraspContact> grasp_contacts(const CompiledScene& scene, const Pose& X_OH,
                                         const std::vector<double>& joints,
                                         const TrialOptions& options) {
  std::vector<Pose> X_HL;
  link_poses(scene.scene.hand, joints, X_HL);
  ContactWorkspace workspace;
  std::vector<GraspContact> contacts;
  for (std::size_t l = 0; l < scene.links.size(); ++l) {
    const CompiledLink& link = scene.links[l];
    const Pose X_OL = X_OH * X_HL[l];
    const auto touching = find_contacts(scene.object, link.mesh, X_OL, options.contact, workspace);
    for (const SurfaceContact& c : touching) {
      contacts.push_back({static_cast<int>(l), {c.position, c.normal, link.friction}, c.gap});
    }
    if (!options.soft_fingers || link.compliant_depth <= 0.0 || touching.empty()) continue;
    for (const SoftPatch& patch :
         soft_patches(scene.object, link.mesh, X_OL, link.compliant_depth, workspace)) {
      contacts.push_back(
          {static_cast<int>(l),
           {patch.position, patch.normal, link.friction, ContactModel::soft_finger, patch.torsion},
           patch.gap});
    }
  }
  return contacts;
}

std::vector<Contact> contacts_of(const std::vector<GraspContact>& contacts) {
  std::vector<Contact> points;
  points.reserve(contacts.size());
  for (const GraspContact& contact : contacts) points.push_back(contact.point);
  return points;
}

}  // namespace prehend
