#include "planner/live/protocol/graspit_bodies.h"

#include <algorithm>

#include "sim/base/index.h"
#include "sim/motion/dynamic_grasp/scene_world.h"

namespace prehend {
namespace {

constexpr std::size_t kFirstOfHand = 3;

NumberedBody no_body() { return {.name = "none"}; }

// The links that the joints of each chain move; those of the base come first, alone.
std::vector<std::vector<int>> links_of_chains(const Robot& hand) {
  std::vector<std::vector<int>> parts(hand.chains.size() + 1);
  for (std::size_t l = 0; l < hand.links.size(); ++l) {
    const int joint = hand.links[l].joint;
    std::size_t part = 0;
    for (std::size_t c = 0; c < hand.chains.size(); ++c) {
      const int place = joint - hand.chains[c].first_joint;
      if (place >= 0 && place < hand.chains[c].joint_count) part = c + 1;
    }
    parts[part].push_back(static_cast<int>(l));
  }
  return parts;
}

}  // namespace

std::vector<NumberedBody> graspit_bodies(const Scene& scene) {
  std::vector<NumberedBody> bodies;
  const bool has_object = !scene.object.mesh.empty();
  bodies.push_back(has_object ? NumberedBody{scene.object.name, kObjectSolid} : no_body());
  for (std::size_t b = 0; b < scene.obstacles.size(); ++b) {
    bodies.push_back({scene.obstacles[b].name, {-1, static_cast<int>(b) + 1}});
  }
  bodies.resize(std::max(bodies.size(), kFirstOfHand), no_body());
  const std::vector<std::vector<int>> parts = links_of_chains(scene.hand);
  std::size_t longest = 0;
  for (std::size_t p = 1; p < parts.size(); ++p) longest = std::max(longest, parts[p].size());
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (p > 0) bodies.resize(bodies.size() + longest - parts[p].size(), no_body());
    for (const int link : parts[p]) {
      bodies.push_back({scene.hand.links[index(link)].name, {0, link}});
    }
  }
  return bodies;
}

}  // namespace prehend
