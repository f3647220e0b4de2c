// A contact between a finger and an object, as the wrench space sees it.
#pragma once

#include <Eigen/Core>

namespace prehend {

// A hard point contact with Coulomb friction. `normal` is unit and points into the object;
// `position` and `normal` are in one frame, usually the object's. friction >= 0.
struct PointContact {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double friction = 0.0;
};

}  // namespace prehend
