#include "planner/plan/path/closing_path.h"

#include <algorithm>
#include <utility>

namespace prehend {

// The final joint values do not say when each joint stopped. The motion is reconstructed from the
// closing velocities: a joint moves from `from` at the rate ratio * closing_velocity, arrives after
// (to - from) / rate, and rests from then on while others still move.
ClosingPath closing_path(const Robot& hand, const std::vector<double>& from,
                         const std::vector<double>& to) {
  std::vector<double> rate(from.size(), 0.0);
  std::vector<double> stop(from.size(), 0.0);  // in seconds of the closing velocities
  std::vector<double> stops;
  for (std::size_t j = 0; j < from.size(); ++j) {
    const Joint& joint = hand.joints[j];
    rate[j] = joint.ratio * hand.dofs[static_cast<std::size_t>(joint.dof)].closing_velocity;
    const double way = to[j] - from[j];
    // A joint without closing velocity, or one that was pushed against its closing direction, would
    // never arrive at its closing rate: it goes straight there in the first second.
    if (rate[j] * way <= 0.0) rate[j] = way;
    stop[j] = way == 0.0 ? 0.0 : way / rate[j];
    stops.push_back(stop[j]);
  }
  // Between two neighbouring stops every joint either moves at constant rate or rests, so postures
  // at the stops alone describe the motion exactly.
  std::sort(stops.begin(), stops.end());
  stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
  ClosingPath path{{from}, {0.0}};
  for (const double time : stops) {
    if (time <= 0.0) continue;
    std::vector<double> joints = from;
    for (std::size_t j = 0; j < from.size(); ++j) {
      joints[j] = time >= stop[j] ? to[j] : from[j] + time * rate[j];
    }
    path.postures.push_back(std::move(joints));
    path.times.push_back(time);
  }
  return path;
}

}  // namespace prehend
