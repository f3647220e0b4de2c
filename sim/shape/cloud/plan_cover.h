// The parts of a support that lie below a seen surface.
#pragma once

#include <array>
#include <vector>

#include "sim/shape/cloud/object_view.h"

namespace prehend {

// A plan of the support, frame P, in cells.
class PlanCover {
 public:
  PlanCover(const Vector3& lower, double edge, int columns, int rows);

  void add(const Eigen::Vector3f& p_P);  // a point of a surface
  void finish();                         // once all are added

  // How far a point is from the space below the surface, an estimate [m]: negative within it.
  float distance(const Eigen::Vector3f& p_P) const;

 private:
  int column(float x) const;
  int row(float y) const;

  Eigen::Vector3f lower_;
  float edge_;
  int columns_;
  int rows_;
  std::vector<float> top_;    // height of the surface; very low: there is none
  std::vector<float> aside_;  // distance from the covered part, negative within it [m]
};

}  // namespace prehend
