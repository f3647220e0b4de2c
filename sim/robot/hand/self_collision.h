// Collisions between links of a robot in a posture.
#pragma once

#include <utility>
#include <vector>

#include "sim/robot/robot.h"
#include "sim/shape/proximity.h"

namespace prehend {

// Asks about the pairs of checked_pairs (link_pairs.h). Keeps a reference to the robot.
class SelfCollision {
 public:
  // Throws InputError for a link without triangles.
  explicit SelfCollision(const Robot& robot);

  // The pairs whose surfaces touch or cross, for one value per degree of freedom [rad or m].
  std::vector<std::pair<int, int>> colliding(const std::vector<double>& dofs) const;
  bool any(const std::vector<double>& dofs) const;

  // Whether one of the links `a` touches one of the links `b`; exempt pairs count as well.
  bool meet(const std::vector<int>& a, const std::vector<int>& b,
            const std::vector<double>& dofs) const;

  // No longer asks about this pair.
  void leave_out(const std::pair<int, int>& pair);
  const std::vector<std::pair<int, int>>& pairs() const { return pairs_; }
  const ProximityMesh& mesh(int link) const { return meshes_[static_cast<std::size_t>(link)]; }

 private:
  std::vector<Pose> poses_at(const std::vector<double>& dofs) const;
  bool cross(int a, int b, const std::vector<Pose>& X_BL) const;

  const Robot& robot_;
  std::vector<ProximityMesh> meshes_;
  std::vector<std::pair<int, int>> pairs_;
};

}  // namespace prehend
