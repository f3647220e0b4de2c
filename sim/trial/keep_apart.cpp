#include "sim/trial/keep_apart.h"

#include <algorithm>
#include <cstddef>

#include "sim/base/index.h"
#include "sim/shape/proximity.h"

namespace prehend {
namespace {

// Of the distance to keep, the part that the way may fall short of it: steps end at it, where the
// distance alone would make them smaller and smaller.
constexpr double kSlack = 0.05;

double gap(const PlacedBody& body, const CompiledLink& link, const Pose& X_OL) {
  return find_gap(body.mesh, link.mesh, body.X_RB.inverse() * X_OL).lower;
}

// Whether a link that moves with the hand comes nearer to a body than `apart` on the way.
bool comes_near(const PlacedBody& body, const CompiledLink& link, const Pose& X_BL,
                const HandWay& way, double apart) {
  double travel = 0.0;
  while (true) {
    const double room = gap(body, link, way.motion.at(travel) * X_BL) - apart;
    if (room < -kSlack * apart) return true;
    if (travel >= way.travel) return false;
    travel = std::min(way.travel, travel + std::max(room, 0.0) + kSlack * apart);
  }
}

}  // namespace

std::optional<HandContact> too_near(const CompiledScene& scene, const HandWay& way,
                                    HandCollisionWorkspace& workspace) {
  const std::vector<StaticBody>& obstacles = scene.scene.obstacles;
  if (std::all_of(obstacles.begin(), obstacles.end(),
                  [](const StaticBody& body) { return body.apart <= 0.0; })) {
    return std::nullopt;
  }
  RobotPoses& closed = workspace.poses;
  RobotPoses open;
  robot_poses(scene.scene.hand, way.closed_joints, closed);
  robot_poses(scene.scene.hand, way.open_joints, open);
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const double apart = obstacles[i].apart;
    if (apart <= 0.0) continue;
    const BodyId id = BodyId::obstacle(static_cast<int>(i));
    const PlacedBody& body = scene.body(id);
    for (std::size_t l = 0; l < scene.links.size(); ++l) {
      const CompiledLink& link = scene.links[l];
      if (gap(body, link, way.X_OH * closed.X_BL[l]) < apart ||
          comes_near(body, link, open.X_BL[l], way, apart)) {
        return HandContact{link_id(l), id};
      }
    }
  }
  return std::nullopt;
}

}  // namespace prehend
