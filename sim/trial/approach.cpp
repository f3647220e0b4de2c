#include "sim/trial/approach.h"

#include <algorithm>

#include "sim/base/index.h"
#include "sim/trial/gap_tracker.h"
#include "sim/trial/swallow.h"

namespace prehend {
namespace {

// One link against the object or an obstacle.
struct Pairing {
  int link = 0;
  int obstacle = -1;
  GapTracker tracker;
  double asked_at = 0.0;
  double safe_until = 0.0;  // proven free of contact up to this travel
};

std::vector<Pairing> pairings(const CompiledScene& scene) {
  std::vector<Pairing> all;
  for (std::size_t l = 0; l < scene.links.size(); ++l) {
    const int link = static_cast<int>(l);
    all.push_back({link, -1, GapTracker(scene.object, scene.links[l].mesh)});
    for (std::size_t o = 0; o < scene.obstacles.size(); ++o) {
      all.push_back(
          {link, static_cast<int>(o), GapTracker(scene.obstacles[o].mesh, scene.links[l].mesh)});
    }
  }
  return all;
}

// The link's pose in the frame of the object (obstacle -1) or the obstacle.
Pose pose_in(const CompiledScene& scene, int obstacle, const Pose& X_OL) {
  return obstacle < 0 ? X_OL : scene.obstacles[index(obstacle)].X_OB.inverse() * X_OL;
}

}  // namespace

Pose ApproachMotion::at(double travel) const {
  return translation((travel - distance) * approach_O) * X_OH_end;
}

ApproachResult approach(const CompiledScene& scene, const std::vector<double>& joints,
                        const ApproachMotion& motion, const TrialOptions& options,
                        const RunContext& context) {
  std::vector<Pose> X_HL;
  link_poses(scene.scene.hand, joints, X_HL);
  ApproachResult result;
  result.object_clearance.assign(scene.links.size(), 0.0);
  std::vector<Pairing> all = pairings(scene);
  for (const Pairing& pairing : all) {
    const Pose X_OL = motion.at(0.0) * X_HL[index(pairing.link)];
    if (is_swallowed(scene, scene.links[index(pairing.link)], pairing.obstacle,
                     pose_in(scene, pairing.obstacle, X_OL))) {
      result.end = ApproachEnd::starts_in_collision;
      result.link = pairing.link;
      result.obstacle = pairing.obstacle;
      return result;
    }
  }
  const auto earlier = [](const Pairing& a, const Pairing& b) {
    return a.safe_until < b.safe_until;
  };
  while (true) {
    context.cancellation.check();
    Pairing& next = *std::min_element(all.begin(), all.end(), earlier);
    if (next.safe_until >= motion.distance && next.tracker.queries() > 0) {
      result.travel = motion.distance;
      break;
    }
    const double travel = std::min(next.safe_until, motion.distance);
    const Pose X_TL = pose_in(scene, next.obstacle, motion.at(travel) * X_HL[index(next.link)]);
    const double left = motion.distance - travel + options.contact.threshold;
    const Gap gap = next.tracker.query(X_TL, travel - next.asked_at, left);
    next.asked_at = travel;
    const bool first = next.tracker.queries() == 1;
    if (gap.upper <= options.closed_gap() || next.tracker.queries() > options.max_gap_queries) {
      const bool free = gap.lower > 0.0;
      result.end = first && !free      ? ApproachEnd::starts_in_collision
                   : next.obstacle < 0 ? ApproachEnd::touched_object
                                       : ApproachEnd::touched_obstacle;
      result.link = next.link;
      result.obstacle = next.obstacle;
      result.travel = travel;
      next.safe_until = travel;
      break;
    }
    next.safe_until = travel + safe_step(gap, options);
  }
  for (const Pairing& pairing : all) {
    if (pairing.obstacle < 0) {
      result.object_clearance[index(pairing.link)] =
          std::max(0.0, pairing.safe_until - result.travel);
    }
  }
  return result;
}

}  // namespace prehend
