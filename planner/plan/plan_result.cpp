#include "planner/plan/plan_result.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace prehend {

void count_blockers(PlanResult& result) {
  std::map<std::tuple<Outcome, std::string, std::string>, int> blocked;
  for (const Tried& tried : result.tried) {
    const CollisionNames& why = tried.collision_of;
    if (!why.by.empty()) ++blocked[{tried.outcome, why.link, why.by}];
  }
  result.blockers.clear();
  for (const auto& [what, count] : blocked) {
    const auto& [outcome, link, by] = what;
    result.blockers.push_back({outcome, link, by, count});
  }
  std::stable_sort(
      result.blockers.begin(), result.blockers.end(),
      [](const CollisionCount& a, const CollisionCount& b) { return a.count > b.count; });
}

}  // namespace prehend
