#include "sim/trial/cup_contacts.h"

#include <algorithm>

#include "sim/base/index.h"
#include "sim/quality/suction_cup.h"
#include "sim/scene/compiled_scene.h"
#include "sim/shape/proximity.h"

namespace prehend {
namespace {

CupLip lip_of(const SuctionCup& cup, const Pose& X_OH) {
  return {X_OH * cup.position, X_OH.linear() * cup.axis, cup.radius, cup.travel, cup.strain};
}

bool is_cup(const Hand& hand, std::size_t link) {
  return std::any_of(hand.cups.begin(), hand.cups.end(),
                     [&](const SuctionCup& cup) { return index(cup.link) == link; });
}

// How far the hand may move on, at most `most`, before a link that is no cup can touch anything.
double clearance(const CompiledScene& scene, const Pose& X_OH, const std::vector<double>& joints,
                 double most) {
  RobotPoses poses;
  robot_poses(scene.scene.hand, joints, poses);
  double least = most;
  for (std::size_t l = 0; l < scene.links.size(); ++l) {
    if (is_cup(*scene.scene.hand.hand, l)) continue;
    const Pose X_OL = X_OH * poses.X_BL[l];
    for (std::size_t b = 0; b < scene.bodies.size() && least > 0.0; ++b) {
      const BodyId body = BodyId::at(b);
      const Gap gap =
          find_gap(scene.body(body).mesh, scene.links[l].mesh, scene.pose_in(body, X_OL));
      least = std::min(least, gap.lower);
    }
  }
  return least;
}

}  // namespace

std::vector<CupSeal> cup_seals(const CompiledScene& scene, const Pose& X_OH) {
  std::function<bool(const Vector3&)> leaks;
  if (!scene.porous.empty()) {
    leaks = [&](const Vector3& p_O) { return scene.porous.contain(p_O); };
  }
  std::vector<CupSeal> seals;
  for (const SuctionCup& cup : scene.scene.hand.hand->cups) {
    seals.push_back(cup_seal(scene.object().mesh, lip_of(cup, X_OH), leaks));
  }
  return seals;
}

std::vector<GraspContact> cup_contacts(const CompiledScene& scene, const Pose& X_OH,
                                       const std::vector<double>& joints) {
  const Hand& hand = *scene.scene.hand.hand;
  const std::vector<CupSeal> seals = cup_seals(scene, X_OH);
  double farthest = 0.0;
  for (std::size_t c = 0; c < seals.size(); ++c) {
    const bool within = seals[c].end == SealEnd::sealed && seals[c].press <= hand.cups[c].travel;
    if (within) farthest = std::max(farthest, seals[c].press);
  }
  std::vector<GraspContact> contacts;
  if (std::none_of(seals.begin(), seals.end(),
                   [](const CupSeal& seal) { return seal.end == SealEnd::sealed; })) {
    return contacts;
  }
  const double free = clearance(scene, X_OH, joints, farthest);
  for (std::size_t c = 0; c < seals.size(); ++c) {
    const SuctionCup& cup = hand.cups[c];
    const CupSeal& seal = seals[c];
    if (seal.end != SealEnd::sealed || seal.press > std::min(free, cup.travel)) continue;
    const Vector3 axis_O = X_OH.linear() * cup.axis;
    contacts.push_back(
        {link_id(index(cup.link)),
         cup_contact(seal.center, axis_O, cup.radius, scene.links[index(cup.link)].friction,
                     cup.pull, cup.lip_stiffness, cup.strain),
         std::max(0.0, seal.press)});
  }
  return contacts;
}

}  // namespace prehend
