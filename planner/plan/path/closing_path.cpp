#include "planner/plan/path/closing_path.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "sim/base/index.h"
#include "sim/robot/joint_course.h"

namespace prehend {
namespace {

// Stops within this time count as one: a motion of its own between two that are nanoseconds apart
// would have samples so close to each other that a controller which divides by the time between
// them gets noise [s of the closing velocities].
constexpr double kTogether = 1e-3;

// Of sorted times above 0 those at which a posture is needed: the last of each group.
std::vector<double> apart(const std::vector<double>& stops) {
  std::vector<double> kept;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const double before = kept.empty() ? 0.0 : kept.back();
    const bool last = i + 1 == stops.size();
    const bool near_next = !last && stops[i + 1] - stops[i] < kTogether;
    if (last || (!near_next && stops[i] - before >= kTogether)) kept.push_back(stops[i]);
  }
  return kept;
}

// Over the time of the closing velocities: at one rate, from `turn` on at another one, until
// `stop`.
struct JointWay {
  double from = 0.0;
  double to = 0.0;
  double rate = 0.0;
  double turn = std::numeric_limits<double>::infinity();
  double second = 0.0;
  double stop = 0.0;

  double at(double time) const {
    if (time >= stop) return to;
    if (time <= turn) return from + time * rate;
    return from + turn * rate + (time - turn) * second;
  }
};

// A joint without closing velocity, or one that was pushed against its closing direction, would
// never arrive at its closing rate: it goes straight there in the first second.
JointWay straight_way(double from, double to, double rate) {
  const double way = to - from;
  if (rate * way <= 0.0) rate = way;
  return {.from = from, .to = to, .rate = rate, .stop = way == 0.0 ? 0.0 : way / rate};
}

// Of a joint across one that gave way, which stopped at the time `turn`: as before until then, and
// on to its end as the linkage closes further; nothing where that does not lead there.
std::optional<JointWay> way_across(const Joint& joint, const Joint& stopped, double velocity,
                                   double from, double to, double turn) {
  JointWay way{.from = from, .to = to, .rate = joint.ratio * velocity, .turn = turn};
  way.second = way.rate + joint.ahead * stopped.ratio * velocity;
  const double left = to - from - turn * way.rate;
  if (!(left * way.second > 0.0)) return std::nullopt;
  way.stop = turn + left / way.second;
  return way;
}

}  // namespace

// The final joint values do not say when each joint stopped. The motion is reconstructed from the
// closing velocities: a joint moves from `from` at the rate ratio * closing_velocity, arrives after
// (to - from) / rate, and rests from then on while others still move.
ClosingPath closing_path(const Robot& hand, const std::vector<double>& from,
                         const std::vector<double>& to) {
  std::vector<JointWay> ways;
  const auto velocity = [&](std::size_t j) {
    return hand.dofs[index(hand.joints[j].dof)].closing_velocity;
  };
  for (std::size_t j = 0; j < from.size(); ++j) {
    ways.push_back(straight_way(from[j], to[j], hand.joints[j].ratio * velocity(j)));
  }
  for (std::size_t j = 0; j < from.size(); ++j) {
    const int across = hand.joints[j].across;
    if (across < 0 || !gives_way(hand, across)) continue;
    const auto way = way_across(hand.joints[j], hand.joints[index(across)], velocity(j), from[j],
                                to[j], ways[index(across)].stop);
    if (way) ways[j] = *way;
  }
  std::vector<double> stops;
  for (const JointWay& way : ways) {
    if (way.stop > 0.0) stops.push_back(way.stop);
  }
  // Between two neighbouring stops every joint either moves at constant rate or rests, so postures
  // at the stops alone describe the motion; of stops that are taken as one the earlier joints
  // arrive with the last.
  std::sort(stops.begin(), stops.end());
  ClosingPath path{{from}, {0.0}};
  for (const double time : apart(stops)) {
    std::vector<double> joints;
    for (const JointWay& way : ways) joints.push_back(way.at(time));
    path.postures.push_back(std::move(joints));
    path.times.push_back(time);
  }
  return path;
}

}  // namespace prehend
