#include "planner/live/grasp_score.h"

#include <stdexcept>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/quality/wrench_hull.h"
#include "sim/quality/wrench_space.h"
#include "sim/trial/close_and_score.h"
#include "sim/trial/payload_margin.h"

namespace prehend {
namespace {

// Epsilon of the contacts without those of a link.
double epsilon_without_link(const CompiledScene& scene, const std::vector<GraspContact>& contacts,
                            LinkId link, int edges) {
  std::vector<Contact> others;
  for (const GraspContact& contact : contacts) {
    if (contact.link != link) others.push_back(contact.point);
  }
  if (others.empty()) return 0.0;
  return epsilon_l1(contact_wrenches(others, scene.wrench_frame, edges)).lower;
}

void find_limit(const CompiledScene& scene, int edges, GraspScore& judged) {
  for (std::size_t i = 0; i < judged.contacts.size(); ++i) {
    const LinkId link = judged.contacts[i].link;
    // Contacts are ordered by link.
    if (i > 0 && judged.contacts[i - 1].link == link) continue;
    const double without = epsilon_without_link(scene, judged.contacts, link, edges);
    if (!judged.limiting_link.empty() && without >= judged.epsilon_without) continue;
    judged.limiting_link = scene.links[index(link)].name;
    judged.epsilon_without = without;
  }
}

// What takes the hull of the wrenches, which is most of the work: volume and sections.
void measure_space(const CompiledScene& scene, int edges, bool sections, GraspScore& judged) {
  const bool is_stable = judged.outcome == Outcome::stable;
  if (judged.contacts.empty() || !(is_stable || sections)) return;
  const std::vector<Contact> contacts = contacts_of(judged.contacts);
  WrenchHull hull;
  try {
    hull = wrench_hull(contact_wrenches(contacts, scene.wrench_frame, edges));
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error&) {
    if (is_stable) throw;
    return;  // qhull failed on a space that holds nothing: there is no picture of it
  }
  if (is_stable) judged.volume = hull.volume;
  if (sections && hull.status == HullStatus::solid) judged.sections = wrench_sections(hull.points);
}

}  // namespace

GraspScore judge_grasp_of(const CompiledScene& scene, const Trial& trial,
                          const TrialOptions& options, bool sections) {
  ScoringWorkspace workspace;
  Trial judged = trial;
  score_contacts(scene, options, workspace, judged);
  GraspScore judgement;
  judgement.outcome = judged.outcome;
  judgement.contacts = std::move(judged.contacts);
  judgement.epsilon = judged.epsilon;
  measure_space(scene, options.cone_edges, sections, judgement);
  if (judgement.outcome == Outcome::stable) find_limit(scene, options.cone_edges, judgement);
  return judgement;
}

ContactForces forces_for(const CompiledScene& scene, const Trial& trial, const Vector3& force_O,
                         const Vector3& torque_O, bool joint_limits) {
  Wrench external = Wrench::Zero();
  external << force_O, scene.wrench_frame.torque_scale * torque_O;
  const std::vector<Contact> contacts = contacts_of(trial.contacts);
  if (!joint_limits) return balancing_forces(contacts, scene.wrench_frame, external);
  return balancing_forces(contacts, scene.wrench_frame, external, hand_torques(scene, trial));
}

std::vector<Overlap> overlaps_of(const CompiledScene& scene, const Pose& X_OH,
                                 const std::vector<double>& joints) {
  std::vector<Pose> X_HL;
  link_poses(scene.scene.hand, joints, X_HL);
  std::vector<Overlap> found;
  for (std::size_t l = 0; l < scene.links.size(); ++l) {
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      const Pose X_BL = scene.pose_in(BodyId::at(b), X_OH * X_HL[l]);
      if (!bodies_overlap(scene.bodies[b], scene.links[l], X_BL)) continue;
      found.push_back({scene.links[l].name, scene.bodies[b].name});
    }
  }
  for (const LinkPair& pair : scene.self_pairs) {
    const Pose X_AB = X_HL[index(pair.a)].inverse() * X_HL[index(pair.b)];
    if (!bodies_overlap(scene.links[index(pair.a)], scene.links[index(pair.b)], X_AB)) continue;
    found.push_back({scene.links[index(pair.a)].name, scene.links[index(pair.b)].name});
  }
  return found;
}

std::vector<Overlap> arm_overlaps(const CompiledArm& arm, const std::vector<double>& joints) {
  std::vector<Pose> X_BL;
  arm_link_poses(arm, joints, X_BL);
  std::vector<Overlap> found;
  for (const ArmPair& pair : arm.arm_pairs) {
    if (!pair_meets(arm, pair, X_BL)) continue;
    found.push_back({first_name(arm, pair), second_name(arm, pair)});
  }
  return found;
}

}  // namespace prehend
