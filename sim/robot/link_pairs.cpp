#include "sim/robot/link_pairs.h"

#include <algorithm>
#include <set>

namespace prehend {
namespace {

// Whether the path `a` from the base is the beginning of the longer path `b`.
bool begins(const std::vector<int>& a, const std::vector<int>& b) {
  return a.size() < b.size() && std::equal(a.begin(), a.end(), b.begin());
}

}  // namespace

std::vector<std::pair<int, int>> checked_pairs(const Robot& robot) {
  const std::set<std::pair<int, int>> exempt(robot.exempt_pairs.begin(), robot.exempt_pairs.end());
  std::vector<std::vector<int>> paths;
  for (const Link& link : robot.links) paths.push_back(joints_to(robot, link.joint));
  // There may be several joints between neighbours (a universal joint has no links of its own).
  const auto neighbours = [&](const std::vector<int>& a, const std::vector<int>& b) {
    const auto between = [&](const std::vector<int>& c) { return begins(a, c) && begins(c, b); };
    return begins(a, b) && std::none_of(paths.begin(), paths.end(), between);
  };
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t a = 0; a < paths.size(); ++a) {
    for (std::size_t b = a + 1; b < paths.size(); ++b) {
      const std::pair<int, int> pair(static_cast<int>(a), static_cast<int>(b));
      if (exempt.contains(pair) || paths[a] == paths[b]) continue;
      if (neighbours(paths[a], paths[b]) || neighbours(paths[b], paths[a])) continue;
      pairs.push_back(pair);
    }
  }
  return pairs;
}

}  // namespace prehend
