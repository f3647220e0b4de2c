#include "sim/shape/cloud/plan_cover.h"

#include <algorithm>
#include <cmath>

#include "sim/shape/cloud/distance_transform.h"

namespace prehend {
namespace {

constexpr float kNone = -1e6F;

}  // namespace

PlanCover::PlanCover(const Vector3& lower, double edge, int columns, int rows)
    : lower_(lower.cast<float>()),
      edge_(static_cast<float>(edge)),
      columns_(columns),
      rows_(rows),
      top_(index(columns) * index(rows), kNone) {}

int PlanCover::column(float x) const {
  return std::clamp(static_cast<int>(std::floor((x - lower_.x()) / edge_ + 0.5F)), 0, columns_ - 1);
}

int PlanCover::row(float y) const {
  return std::clamp(static_cast<int>(std::floor((y - lower_.y()) / edge_ + 0.5F)), 0, rows_ - 1);
}

void PlanCover::add(const Eigen::Vector3f& p_P) {
  float& top = top_[index(row(p_P.y())) * index(columns_) + index(column(p_P.x()))];
  top = std::max(top, p_P.z());
}

void PlanCover::finish() {
  // Cells between those of neighbouring readings are covered as they are.
  std::vector<float> grown = top_;
  const auto at = [&](int x, int y) { return index(y) * index(columns_) + index(x); };
  for (int y = 1; y + 1 < rows_; ++y) {
    for (int x = 1; x + 1 < columns_; ++x) {
      for (int k = 0; k < 9; ++k) {
        grown[at(x, y)] = std::max(grown[at(x, y)], top_[at(x + k % 3 - 1, y + k / 3 - 1)]);
      }
    }
  }
  std::vector<char> from(top_.size());
  const std::array<int, 3> size = {columns_, rows_, 1};
  for (std::size_t i = 0; i < from.size(); ++i) from[i] = grown[i] > kNone ? 1 : 0;
  const std::vector<float> outside = distance_transform(from, size, 1e4F);
  for (char& is : from) is = is != 0 ? 0 : 1;
  const std::vector<float> inside = distance_transform(from, size, 1e4F);
  aside_.resize(top_.size());
  for (std::size_t i = 0; i < top_.size(); ++i) {
    // The edge is one cell within what was grown, less half a cell.
    aside_[i] = edge_ * (from[i] != 0 ? outside[i] + 0.5F : 1.5F - inside[i]);
  }
  top_ = std::move(grown);
}

float PlanCover::distance(const Eigen::Vector3f& p_P) const {
  const std::size_t i = index(row(p_P.y())) * index(columns_) + index(column(p_P.x()));
  return top_[i] > kNone ? std::max(aside_[i], p_P.z() - top_[i]) : aside_[i];
}

}  // namespace prehend
