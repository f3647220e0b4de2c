#include "planner/live/grasp_score.h"

#include <stdexcept>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/quality/cup_balance.h"
#include "sim/quality/set_hull.h"
#include "sim/quality/wrench_hull.h"
#include "sim/quality/wrench_space.h"
#include "sim/trial/close_and_score.h"
#include "sim/trial/payload_margin.h"

namespace prehend {
namespace {

WrenchSpaceOptions space_of(const JudgeOptions& judge) {
  return {.norm = judge.norm, .edges = judge.edges};
}

EpsilonBracket epsilon_of(const CompiledScene& scene, const std::vector<Contact>& contacts,
                          const JudgeOptions& judge) {
  if (judge.norm == WrenchNorm::l1) {
    return epsilon_l1(contact_wrenches(contacts, scene.wrench_frame, judge.edges));
  }
  return grasp_epsilon(contacts, scene.wrench_frame, space_of(judge));
}

// Epsilon of the contacts without those of a link.
double epsilon_without_link(const CompiledScene& scene, const std::vector<GraspContact>& contacts,
                            LinkId link, const JudgeOptions& judge) {
  std::vector<Contact> others;
  for (const GraspContact& contact : contacts) {
    if (contact.link != link) others.push_back(contact.point);
  }
  return others.empty() ? 0.0 : epsilon_of(scene, others, judge).lower;
}

void find_limit(const CompiledScene& scene, const JudgeOptions& judge, GraspScore& judged) {
  for (std::size_t i = 0; i < judged.contacts.size(); ++i) {
    const LinkId link = judged.contacts[i].link;
    // Contacts are ordered by link.
    if (i > 0 && judged.contacts[i - 1].link == link) continue;
    const double without = epsilon_without_link(scene, judged.contacts, link, judge);
    if (!judged.limiting_link.empty() && without >= judged.epsilon_without) continue;
    judged.limiting_link = scene.links[index(link)].name;
    judged.epsilon_without = without;
  }
}

struct SpaceHull {
  double volume = 0.0;
  PointHull points;
};

// The hull of the wrench space. Of other spaces than pyramids of few edges with the L1 norm, one
// inside it with few points.
SpaceHull space_hull_of(const CompiledScene& scene, const std::vector<Contact>& contacts,
                        const JudgeOptions& judge) {
  const bool few = judge.edges <= kMostHullEdges && !has_cup(contacts);
  if (judge.norm == WrenchNorm::l1 && few) {
    WrenchHull hull = wrench_hull(contact_wrenches(contacts, scene.wrench_frame, judge.edges));
    return {hull.volume, std::move(hull.points)};
  }
  constexpr int kFewPoints = 200;
  SetHull hull = set_hull(*wrench_space(contacts, scene.wrench_frame, space_of(judge)),
                          {.max_points = kFewPoints});
  return {hull.volume_lower, std::move(hull.hull)};
}

// What takes the hull of the wrenches, which is most of the work: volume and sections.
void measure_space(const CompiledScene& scene, const JudgeOptions& judge, bool sections,
                   GraspScore& judged) {
  const bool is_stable = judged.outcome == Outcome::stable;
  if (judged.contacts.empty() || !(is_stable || sections)) return;
  SpaceHull hull;
  try {
    hull = space_hull_of(scene, contacts_of(judged.contacts), judge);
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error&) {
    if (is_stable) throw;
    return;  // qhull failed on a space that holds nothing: there is no picture of it
  }
  if (is_stable) judged.volume = hull.volume;
  if (!sections || hull.points.status != PointHullStatus::solid) return;
  judged.sections = wrench_sections(hull.points);
  if (judge.fixed) judged.chosen = wrench_slice(hull.points, *judge.fixed);
}

}  // namespace

bool JudgeOptions::operator==(const JudgeOptions& other) const {
  if (norm != other.norm || edges != other.edges || fixed.has_value() != other.fixed.has_value()) {
    return false;
  }
  return !fixed ||
         (fixed->coordinates == other.fixed->coordinates && fixed->values == other.fixed->values);
}

GraspScore judge_grasp_of(const CompiledScene& scene, const Trial& trial, TrialOptions options,
                          const JudgeOptions& judge, bool sections) {
  options.cone_edges = judge.edges;
  ScoringWorkspace workspace;
  Trial judged = trial;
  score_contacts(scene, options, workspace, judged);
  GraspScore judgement;
  judgement.outcome = judged.outcome;
  judgement.contacts = std::move(judged.contacts);
  judgement.epsilon = judged.epsilon;
  // Whether the origin is inside does not depend on the norm.
  if (judge.norm != WrenchNorm::l1 && judgement.outcome == Outcome::stable) {
    judgement.epsilon = epsilon_of(scene, contacts_of(judgement.contacts), judge);
  }
  measure_space(scene, judge, sections, judgement);
  if (judgement.outcome == Outcome::stable) find_limit(scene, judge, judgement);
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
