#include "planner/plan/propose/pose_set.h"

#include <algorithm>
#include <cmath>

namespace prehend {

void PoseSet::refine(double distance, double angle) {
  // The cubes need a size, also where only equal poses are the same.
  distance_ = std::max(distance, 1e-9);
  angle_ = angle;
  cells_.clear();
  for (std::size_t i = 0; i < entries_.size(); ++i) cells_[cell_of(entries_[i].pose)].push_back(i);
}

bool PoseSet::add(const Pose& pose, int preshape) {
  if (holds(pose, preshape)) return false;
  cells_[cell_of(pose)].push_back(entries_.size());
  entries_.push_back({pose, preshape});
  return true;
}

PoseSet::Cell PoseSet::cell_of(const Pose& pose) const {
  Cell cell{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double at = pose.translation()[static_cast<Vector3::Index>(k)] / distance_;
    cell[k] = static_cast<std::int64_t>(std::floor(at));
  }
  return cell;
}

// What is within the distance is in the same cube or in one beside it.
bool PoseSet::holds(const Pose& pose, int preshape) const {
  const Cell middle = cell_of(pose);
  for (int i = 0; i < 27; ++i) {
    const Cell cell{middle[0] + i % 3 - 1, middle[1] + i / 3 % 3 - 1, middle[2] + i / 9 - 1};
    const auto found = cells_.find(cell);
    if (found == cells_.end()) continue;
    for (const std::size_t e : found->second) {
      const Entry& entry = entries_[e];
      if (entry.preshape != preshape) continue;
      if ((entry.pose.translation() - pose.translation()).norm() > distance_) continue;
      const Eigen::AngleAxisd turn(entry.pose.linear().transpose() * pose.linear());
      if (std::abs(turn.angle()) <= angle_) return true;
    }
  }
  return false;
}

}  // namespace prehend
