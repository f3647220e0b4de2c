#include "planner/plan/reach_memory.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace prehend {
namespace {

// So many of the nearest orientations decide, if they are no farther than this [rad]. With fewer
// neighbours, or farther ones, too many poses are put off that the arm reaches.
constexpr std::size_t kNeighbours = 4;
constexpr double kNear = 0.6;

}  // namespace

void ReachMemory::add(const Pose& X_OH, bool reached) {
  known_.push_back({quaternion_of(X_OH), reached});
}

bool ReachMemory::seems_out_of_reach(const Pose& X_OH) const {
  if (known_.size() < kNeighbours) return false;
  const Eigen::Quaterniond rotation = quaternion_of(X_OH);
  // The largest |cosine| of half the angle is the nearest orientation; sorted, nearest first.
  struct Near {
    double cosine = -1.0;
    bool reached = false;
  };
  std::array<Near, kNeighbours> nearest;
  for (const Known& known : known_) {
    const Near one{std::abs(rotation.dot(known.rotation)), known.reached};
    if (one.cosine <= nearest.back().cosine) continue;
    const auto place =
        std::upper_bound(nearest.begin(), nearest.end(), one,
                         [](const Near& a, const Near& b) { return a.cosine > b.cosine; });
    std::move_backward(place, nearest.end() - 1, nearest.end());
    *place = one;
  }
  const double least = std::cos(0.5 * kNear);
  return std::all_of(nearest.begin(), nearest.end(),
                     [&](const Near& near) { return near.cosine >= least && !near.reached; });
}

}  // namespace prehend
